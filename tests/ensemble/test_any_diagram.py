"""Ensembles of any diagram: members are the runs that python-control makes of it, one by one."""

import importlib.util
import random
import warnings

import control
import numpy as np
import pytest
from adaptive_loop import mrac
from ensemble_stores import assert_identical, files
from random_diagrams import random_diagram
from scipy import stats

import clpt_control as clpt
from clpt_control.diagrams.varied import place_of
from clpt_control.ensemble.drawn_values import distribution, read_varies, read_vary
from clpt_control.ensemble.members import Ensemble
from clpt_control.ensemble.of_diagrams import VariedDiagram
from clpt_control.equations.declaration import ports_of
from clpt_control.errors import ClptError, DataError, DiagramError

TIMES = np.linspace(0.0, 5.0, 51)
TIGHT = {"rtol": 1e-10, "atol": 1e-12}


def lag():
    return control.nlsys(
        lambda t, x, u, p: (u - x) / p["tau"],
        None,
        inputs=1,
        states=1,
        outputs=1,
        params={"tau": 1.0},
        name="lag",
    )


def figures(times, y):
    """Return what an ensemble keeps of an output."""
    squares = np.trapezoid(y**2, times, axis=0) / (times[-1] - times[0])
    return {"final": y[-1], "rms": np.sqrt(squares), "max": np.abs(y).max(axis=0)}


def assert_figures(data, m, port, times, y, tolerance):
    for what, wanted in figures(times, y).items():
        found = data[f"{port}_{what}"].values[m]
        np.testing.assert_allclose(found, wanted, rtol=0, atol=tolerance, err_msg=f"{port}_{what}")


def test_a_lag_swept_over_its_time_constant_is_its_closed_form():
    taus = np.geomspace(0.1, 10, 9)
    given = {"timepts": TIMES, "inputs": 2.0, "trajectories": True, **TIGHT}
    data = clpt.run_ensemble(lag(), {"tau": taus}, **given)
    assert list(data.unstack().y_final.dims) == ["tau"]
    for m, tau in enumerate(taus):
        y = 2 * (1 - np.exp(-TIMES / tau))
        np.testing.assert_allclose(data.y[m], y, rtol=0, atol=1e-8)
        assert_figures(data, m, "y", TIMES, y, 1e-8)


def test_mrac_swept_over_two_parameters_is_python_controls():
    loop, t = mrac(), np.linspace(0, 10, 101)
    gains, poles = [0.5, 3.0], [-2.0, -0.5, 0.5]
    vary = {"gain": gains, "plant.a": poles}
    data = clpt.run_ensemble(loop, vary, timepts=t, inputs=1.0, trajectories=True, **TIGHT)
    assert (data.status == 1).all()
    grid = data.unstack()
    assert grid.y_rms.dims == ("gain", "plant.a")
    for gain in gains:
        for pole in poles:
            wanted = control.input_output_response(
                loop, t, 1.0, params={"gain": gain, "a": pole}, solve_ivp_kwargs=TIGHT
            )
            own = grid.sel({"gain": gain, "plant.a": pole})
            for k, port in enumerate(("y", "e")):
                np.testing.assert_allclose(own[port], wanted.outputs[k], rtol=0, atol=1e-8)
                for what, value in figures(t, wanted.outputs[k]).items():
                    assert float(own[f"{port}_{what}"]) == pytest.approx(value, abs=1e-8)


def test_a_discrete_loop_is_python_controls():
    plant = control.nlsys(
        lambda t, x, u, p: p["a"] * x + u - 0.1 * x**3,
        None,
        params={"a": 0.9},
        dt=0.1,
        **{"inputs": "u", "outputs": "y", "states": "y", "name": "plant"},
    )
    regulator = control.ss(0.5, 1.0, 0.1, 0.2, 0.1, inputs="e", outputs="u", name="regulator")
    error = control.summing_junction(["r", "-y"], "e", name="error", dt=0.1)
    loop = control.interconnect([plant, regulator, error], inputs="r", outputs=["y", "u"])
    t = np.arange(0, 3.01, 0.1)
    vary = {"a": [0.5, 0.9, 1.2], "regulator.B": [[[0.5]], [[1.0]]], "plant_y": [0.0, 1.0]}
    data = clpt.run_ensemble(loop, vary, timepts=t, inputs=1.0, trajectories=True)
    assert data.sizes["member"] == 12
    for m in range(12):
        one = data.isel(member=m)
        B = one["regulator.B"].values
        other = control.ss(0.5, B, 0.1, 0.2, 0.1, inputs="e", outputs="u", name="regulator")
        again = control.interconnect([plant, other, error], inputs="r", outputs=["y", "u"])
        x0, a = [float(one.plant_y), 0], float(one.a)
        wanted = control.input_output_response(again, t, np.ones_like(t), x0, params={"a": a})
        np.testing.assert_allclose(one.y, wanted.outputs[0], rtol=0, atol=1e-12)
        assert float(one.y_rms) == pytest.approx(np.sqrt(np.mean(wanted.outputs[0] ** 2)))


# --- names ------------------------------------------------------------------------------------


def pulled(t, x, u, p):
    """x' = -K x + u: two numbers."""
    return -p.K * x.x + u.f


def springs():
    """Two blocks of one kind, with equal numbers, and a nonlinear system beside them."""
    made = [
        clpt.Block(
            name,
            update=pulled,
            output=lambda t, x, u, p: x.x,
            inputs={"f": 2},
            outputs={port: 2},
            states={"x": 2},
            parameters={"K": np.array([1.0, 2.0]), "turns": 3},
        )
        for name, port in (("one", "a"), ("two", "b"))
    ]
    return clpt.connect(made, external="f", name="springs")


def decay(K, x0, f):
    """Return what a spring does."""
    return x0 * np.exp(-np.outer(TIMES, K)) + f / K * (1 - np.exp(-np.outer(TIMES, K)))


@pytest.mark.parametrize(
    ("key", "levels", "case"),
    [
        ("one.K", [[1.0, 2.0], [3.0, 0.5]], lambda v: (v, [1, 1], [1, 1])),
        ("one.K[1]", [2.0, 0.5], lambda v: ([1.0, v], [1, 1], [1, 1])),
        ("one_x[0]", [1.0, 4.0], lambda v: ([1.0, 2.0], [v, 1], [1, 1])),
        ("one_x", [[1.0, 4.0], [2.0, 3.0]], lambda v: ([1.0, 2.0], v, [1, 1])),
        ("f[1]", [0.0, 4.0], lambda v: ([1.0, 2.0], [1, 1], [1, v])),
        ("f", [[0.0, 4.0], [1.0, 2.0]], lambda v: ([1.0, 2.0], [1, 1], v)),
    ],
)
def test_every_number_may_vary(key, levels, case):
    given = {"timepts": TIMES, "inputs": 1.0, "initial_state": 1.0, "trajectories": True}
    data = clpt.run_ensemble(springs(), {key: levels}, **given, **TIGHT)
    for m, value in enumerate(levels):
        K, x0, f = (np.array(one, dtype=float) for one in case(value))
        y = decay(K, x0, f)
        np.testing.assert_allclose(data.a[m], y, rtol=0, atol=1e-8)
        assert_figures(data, m, "a", TIMES, y, 1e-8)
        same = np.array([1.0, 2.0])  # equal numbers of another block stay as they are
        if not key.startswith("f"):
            np.testing.assert_allclose(data.b[m], decay(same, 1.0, 1.0), rtol=0, atol=1e-8)


def test_a_name_reaches_what_python_control_reaches():
    """A plain name reaches every system that reads it; with the system's name it reaches one."""
    systems = [
        control.nlsys(
            lambda t, x, u, p: -p["k"] * x,
            None,
            params={"k": 1.0},
            **{"inputs": 0, "outputs": name, "states": name, "name": f"tank_{name}"},
        )
        for name in ("a", "b")
    ]
    loop = control.interconnect(systems, connections=False, outputs=["a", "b"])
    given = {"timepts": TIMES, "initial_state": 1.0}
    slow, fast = np.exp(-5 * 1.0), np.exp(-5 * 0.3)
    data = clpt.run_ensemble(loop, {"k": [0.3]}, **given)
    np.testing.assert_allclose([data.a_final[0], data.b_final[0]], [fast, fast], atol=1e-9)
    data = clpt.run_ensemble(loop, {"tank_a.k": [0.3]}, **given)
    np.testing.assert_allclose([data.a_final[0], data.b_final[0]], [fast, slow], atol=1e-9)


def test_params_that_are_lists_or_not_declared_vary_too():
    system = control.nlsys(
        lambda t, x, u, p: [-p["K"][0] * x[0], -p["K"][1] * x[1] * p.get("slow", 1.0)],
        None,
        params={"K": [1, 2]},
        **{"inputs": 0, "outputs": 2, "states": 2, "name": "two"},
    )
    vary = {"K[1]": [0.5, 1.0], "slow": [0.1, 0.2]}
    data = clpt.run_ensemble(system, vary, timepts=TIMES, initial_state=1.0).unstack()
    for k in (0.5, 1.0):
        for slow in (0.1, 0.2):
            own = data.sel({"K[1]": k, "slow": slow}).y_final
            np.testing.assert_allclose(own, np.exp([-5, -5 * k * slow]), atol=1e-9)


def test_nested_diagrams_are_reached_by_their_path():
    inner = clpt.connect(
        [
            clpt.Block(
                "spring",
                update=pulled,
                inputs={"f": 2},
                states={"x": 2},
                parameters={"K": np.ones(2)},
            )
        ],
        external="f",
        name="inner",
    )
    gain = control.ss([], [], [], 2 * np.eye(2), name="gain", inputs=["r[0]", "r[1]"])
    gain.set_outputs(["f[0]", "f[1]"])
    loop = clpt.connect([gain, inner], external="r", name="outer")
    for key in ("spring.K[0]", "inner.spring.K[0]"):
        data = clpt.run_ensemble(loop, {key: [0.5, 2.0]}, timepts=TIMES, inputs=[1.0, 1.0])
        for m, K in enumerate((0.5, 2.0)):
            assert float(data.x_final[m, 0]) == pytest.approx(2 / K * (1 - np.exp(-5 * K)))


def jump_times(p, t0, t1):
    """Return the multiples of the period."""
    k = np.arange(1, int(t1 / p.period) + 2)
    times = p.period * k
    return times[(times > t0) & (times <= t1)]


def test_breakpoints_may_move_from_member_to_member():
    stairs = clpt.Block(
        "stairs",
        update=lambda t, x, u, p: p.interval * np.ones(1),
        inputs={},
        states={"x": 1},
        parameters={"period": 1.0, "interval": -1.0},
        breakpoints=jump_times,
    )
    loop = clpt.connect([stairs], name="stair")
    periods = [0.4, 0.7, 1.3]
    t = np.array([0.0, 3.0, 5.0])
    data = clpt.run_ensemble(loop, {"stairs.period": periods}, timepts=t, trajectories=True)
    for m, period in enumerate(periods):
        alone = clpt.simulate(loop, t, params={"stairs.period": period})
        np.testing.assert_allclose(data.x[m], alone.x, rtol=0, atol=1e-12)
        k = int(5.0 / period)
        wanted = period * k * (k - 1) / 2 + k * (5.0 - k * period)
        assert float(data.x_final[m]) == pytest.approx(wanted)


# --- what is not compiled, what fails ---------------------------------------------------------


@pytest.mark.parametrize("key", ["n", "a"])
def test_what_cannot_be_compiled_runs_in_python_and_says_so(key):
    """A loop of n turns is read for one n; a number asked of a signal is not read at all."""

    def turns(t, x, u, p):
        found = 0.0 * x[0]
        for _ in range(int(p["n"])):
            found = found - 0.1 * x[0]
        return [found]

    def unread(t, x, u, p):
        return [-p["a"] * float(str(x[0]))]

    system = control.nlsys(
        turns if key == "n" else unread,
        None,
        params={"n": 2.0, "a": 1.0},
        **{"inputs": 0, "outputs": "y", "states": "x", "name": "odd"},
    )
    rates = {"n": [0.1, 0.3, 0.5], "a": [1.0, 2.0, 3.0]}[key]
    levels = {"n": [1, 3, 5], "a": rates}[key]
    with pytest.warns(UserWarning, match="odd runs in Python, not as machine code: "):
        data = clpt.run_ensemble(system, {key: levels}, timepts=TIMES, initial_state=1.0, threads=2)
    np.testing.assert_allclose(data.y_final, np.exp(-5 * np.array(rates)), rtol=0, atol=1e-9)


def test_a_slash_in_a_name_is_kept_in_files(tmp_path):
    """A team's diagram has the ports west/x and east/x."""
    system = control.nlsys(
        lambda t, x, u, p: -x, None, name="west/lag", inputs=0, outputs=["west/y[0]", "west/y[1]"],
        states=["west/x[0]", "west/x[1]"],
    )  # fmt: skip
    run = clpt.simulate(system, TIMES, 0, [1.0, 2.0])
    clpt.save_run(run, tmp_path / "run.nc")
    assert clpt.load_run(tmp_path / "run.nc").equals(run)
    assert clpt.simulate(clpt.load_diagram(tmp_path / "run.nc")).equals(run)
    vary, folder = {"west/x": [[1.0, 2.0], [2.0, 1.0]]}, tmp_path / "e.zarr"
    given = {"timepts": TIMES, "trajectories": True}
    here, there, again = (
        clpt.run_ensemble(system, vary, out=out, **given) for out in (None, folder, folder)
    )
    assert here.equals(there)
    assert here.equals(again)
    np.testing.assert_array_equal(here["west/y"].isel(member=0), run["west/y"])
    for name in (" y", "<y>", "y" * 300):
        run = clpt.simulate(control.ss(-1, 1, 1, 0, outputs=name), TIMES, 1.0)
        with pytest.raises(ClptError, match=r"run.nc: NetCDF has no name '.*call that signal othe"):
            clpt.save_run(run, tmp_path / "run.nc")


@pytest.mark.parametrize(
    ("key", "rates"), [("k", [3.0, 6.0]), ("n", [1.0, 2.0]), ("c[0]", [3.0, 6.0])]
)
def test_whole_numbers_stay_whole_in_python(key, rates, monkeypatch):
    def update(t, x, u, p):
        return [-p["k"] * p["c"][0] * x[0] * len(range(p["n"]))]

    params = {"k": 1.0, "n": 3, "c": [1, 2]}
    system = control.nlsys(update, None, name="turns", states=1, inputs=0, outputs=1, params=params)
    for engine in ("native", "python"):
        monkeypatch.setenv("CLPT_CONTROL_ENGINE", engine)
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "turns runs in Python")
            data = clpt.run_ensemble(system, {key: [1, 2]}, timepts=TIMES, initial_state=1.0)
        np.testing.assert_allclose(data.y_final, np.exp(-np.array(rates) * TIMES[-1]), atol=1e-8)


def test_what_is_read_otherwise_is_found_before_members_run():
    class Counting:
        """Read as a constant, which the second call is not."""

        rate = 1.0

        def __call__(self, t, x, u, p):
            return [-p["a"] * self.rate * x[0]]

    made = Counting()
    system = control.nlsys(
        made, None, params={"a": 1.0}, **{"inputs": 0, "outputs": "y", "states": "x", "name": "odd"}
    )
    first = clpt.run_ensemble(system, {"a": [1.0, 2.0]}, timepts=TIMES, initial_state=1.0)
    made.rate = 2.0  # counts at the next run
    second = clpt.run_ensemble(system, {"a": [1.0, 2.0]}, timepts=TIMES, initial_state=1.0)
    np.testing.assert_allclose(first.y_final, np.exp([-5, -10]), atol=1e-9)
    np.testing.assert_allclose(second.y_final, np.exp([-10, -20]), atol=1e-9)


def test_a_member_that_fails_is_nan_and_said():
    system = control.nlsys(
        lambda t, x, u, p: x**2,
        None,
        **{"inputs": 0, "outputs": "y", "states": "x", "name": "escaping"},
    )
    with pytest.warns(UserWarning, match="1 of 3 members did not finish; the first is member 2"):
        data = clpt.run_ensemble(system, {"x": [-1.0, 0.1, 1.0]}, timepts=TIMES, trajectories=True)
    np.testing.assert_allclose(data.y_final[:2], [-1 / 6, 0.2], atol=1e-8)
    assert list(data.status[:2]) == [1, 1]
    assert int(data.status[2]) > 1
    assert 0.8 <= float(data.end[2]) <= 1.0  # x = 1 / (1 - t)
    assert np.isnan([data[f"y_{what}"][2] for what in ("final", "rms", "max")]).all()
    np.testing.assert_allclose(data.y[2, :5], 1 / (1 - TIMES[:5]))


# --- to the last bit --------------------------------------------------------------------------


def drawn(seed):
    """Return a random diagram, its inputs, and some of its names, all in a small range."""
    draw = random.Random(seed)
    diagram = random_diagram(draw)
    varied = VariedDiagram(diagram, (), TIMES[:5], 0.1)
    names = sorted(name for name in varied.names if varied.why_not(name))
    places = {n: place_of(n, varied.names, varied.given) for n in names}
    free = [n for n, at in places.items() if at and np.ndim(varied._value(at)) == 0]
    picked = draw.sample(free, min(3, len(free)))
    return diagram, dict.fromkeys(picked, "0.5:0.9")


@pytest.mark.parametrize(
    "first", [0, *(pytest.param(k, marks=pytest.mark.slow) for k in range(4, 24, 4))]
)
def test_threads_and_chunks_do_not_matter_to_any_diagram(first):
    compared = 0
    for seed in range(first, first + 4):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                diagram, vary = drawn(seed)
                given = {"members": 11, "timepts": TIMES[:5], "inputs": 0.1, "trajectories": True}
                whole = clpt.run_ensemble(diagram, vary, threads=1, **given)
                cut = clpt.run_ensemble(diagram, vary, threads=3, chunk=4, **given)
        except ClptError:  # a loop of functions, or nothing that is left to vary
            continue
        assert_identical(whole, cut)
        compared += 1
    assert compared >= 2


@pytest.mark.parametrize("seed", [13, 15, 34, 42, 44])
def test_members_are_what_python_runs_block_by_block(seed):
    draw = random.Random(seed)
    diagram = random_diagram(draw)
    first = VariedDiagram(diagram, (), TIMES[:5], 0.1, 0.2)
    names = [name for name in sorted(first.names) if place_of(name, first.names, first.given)]
    vary = dict.fromkeys(draw.sample(names, min(4, len(names))), "0.4:0.9")
    varied = VariedDiagram(diagram, read_varies(vary), TIMES[:5], 0.1, 0.2)
    given = {"timepts": TIMES[:5], "inputs": 0.1, "initial_state": 0.2, "trajectories": True}
    data = clpt.run_ensemble(diagram, vary, 5, **given)
    python = Ensemble(varied, vary, "python")
    for m in range(5):
        own = {key: data[key].values[m] for key in vary}
        parameters, start, inputs = varied.member(own)
        alone = python.native.with_parameters(parameters)
        solution = alone.run(start, TIMES[:5], inputs=inputs, method="dop853")
        signals = alone.signals(solution, inputs)
        every = np.vstack([signals.T, inputs.along(solution.t)])
        wanted = (varied.wiring.output_map @ every).T
        for port, places in ports_of(varied.outputs).items():
            found = data[port if port in data else f"{port}_"].values[m].reshape(5, -1)
            size = 1 + np.abs(wanted[:, places]).max()
            np.testing.assert_allclose(found, wanted[:, places], rtol=0, atol=1e-6 * size)


def test_a_folder_goes_on_and_refuses_another_diagram(tmp_path):
    out = tmp_path / "e.zarr"
    given = {"vary": "tau=0.5:2", "members": 30, "timepts": TIMES, "inputs": 1.0, "chunk": 10}

    def stop(done):
        if done >= 10:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        clpt.run_ensemble(lag(), out=out, progress=stop, threads=1, **given)
    counts = []
    data = clpt.run_ensemble(lag(), out=out, progress=counts.append, **given)
    assert 0 < counts[0] < 30
    assert_identical(data, clpt.run_ensemble(lag(), **given))
    before = files(out)
    other = control.nlsys(lambda t, x, u, p: (u - 2 * x) / p["tau"], None, inputs=1, states=1,
                          outputs=1, params={"tau": 1.0}, name="lag")  # fmt: skip
    for system, more in ((other, {}), (lag(), {"inputs": 2.0}), (lag(), {"rtol": 1e-9})):
        with pytest.raises(DataError, match="holds an ensemble of another diagram; give another"):
            clpt.run_ensemble(system, out=out, **given | more)
    assert files(out) == before
    with pytest.raises(DataError, match="is an ensemble of a diagram, not of a scenario"):
        clpt.report(out, tmp_path / "page.html")


def test_a_folder_cannot_tell_what_cannot_be_read(tmp_path):
    system = control.nlsys(lambda t, x, u, p: [-p["a"] * float(str(x[0]))], None, inputs=0,
                           outputs=1, states=1, params={"a": 1.0}, name="odd")  # fmt: skip
    out = tmp_path / "e.zarr"
    with pytest.raises(DiagramError, match=r"^out: odd\.update: "):
        clpt.run_ensemble(system, {"a": [1.0]}, timepts=TIMES, out=out)
    assert not list(tmp_path.iterdir())


@pytest.mark.processes
@pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="Dask is not installed")
def test_processes_get_a_diagram(tmp_path):
    given = {"vary": {"gain": [0.5, 1.0], "plant.a": [-1.0, 0.0]}, "timepts": TIMES, "inputs": 1.0}
    here = clpt.run_ensemble(mrac(), chunk=2, **given)
    there = clpt.run_ensemble(
        mrac(), out=tmp_path / "e.zarr", dask="local", threads=1, chunk=2, **given
    )
    for name in here.data_vars:
        assert here[name].values.tobytes() == there[name].values.tobytes(), name


# --- forms and mistakes -----------------------------------------------------------------------


def test_distributions_are_those_of_scipy():
    frozen = stats.gamma(2.0, scale=0.5)
    data = clpt.run_ensemble(lag(), {"tau": frozen}, 400, timepts=TIMES[:2])
    assert stats.kstest(data.tau.values, frozen.cdf).pvalue > 0.9  # a Latin hypercube
    (text,) = data.attrs["vary"] if isinstance(data.attrs["vary"], list) else [data.attrs["vary"]]
    assert text == "tau~gamma(2.0, scale=0.5)"
    again = clpt.run_ensemble(lag(), text, 400, timepts=TIMES[:2])
    assert_identical(again, data)
    assert read_vary(text).text == text
    assert distribution("uniform(0.5, 1)").ppf(0.5) == 1.0


def test_a_dict_says_the_same_of_a_scenario():
    scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    given = {"samples": 20, "seed": 1}
    texts = ["learning.gain=0.2:2.0", "flow.parameters~normal:0.1"]
    asked = {"learning.gain": "0.2:2.0", "flow.parameters": "~normal:0.1"}
    assert_identical(
        clpt.run_ensemble(scenario, asked, 4, **given),
        clpt.run_ensemble(scenario, texts, 4, **given),
    )
    vary = {"learning.gain": [0.4, 0.8], "vehicle.max_speed": stats.uniform(2, 1)}
    limited = scenario.with_values({"vehicle.max_speed": 3.0})
    assert clpt.run_ensemble(limited, vary, 4, **given)["vehicle.max_speed"].values.min() >= 2
    vary = {"learning.gain": np.array([0.4, 0.8]), "reference.dwell": [5.0, 10.0, 20.0]}
    grid = clpt.run_ensemble(scenario, vary, **given)
    assert set(vary) <= set(grid.coords)
    assert dict(grid.unstack().clpe_rms_whole.sizes) == {"learning.gain": 2, "reference.dwell": 3}


MISTAKES = [
    ({"vary": {"tua": [1.0]}}, "unknown name tua; did you mean tau\\? May vary: tau, lag.tau, x"),
    ({"vary": {"tau[0]": [1.0]}}, r"tau\[0\] is no element: tau has shape \(\), counted from 0"),
    ({"vary": {"tau": 2.0}}, "tau = 2.0: must be a list of values, a range '0.2:2.0', or a dis"),
    ({"vary": {"tau": []}}, "must be a list of values"),
    ({"vary": {"tau": ["a"]}}, "must be a list of values"),
    ({"vary": {"tau": [[1.0, 2.0]]}}, "each value must be a number"),
    ({"vary": {"tau": [np.inf]}}, "member 0: tau = inf: must be finite"),
    ({"vary": {"tau": stats.uniform(0.5, 1)}}, "members: is required where values are drawn"),
    ({"vary": "tau~nothing(1)", "members": 3}, r"nothing\(1\) is no distribution of scipy.stats"),
    ({"vary": "tau~norm(1, a)", "members": 3}, "is no distribution of scipy.stats with numbers"),
    ({"vary": {"tau": stats.norm([0, 1], 1)}, "members": 3}, "must be a list of values"),
    ({"vary": {"tau": [1.0, 2.0]}, "members": 3}, "this grid must have 2 members"),
    ({"vary": {"u": [1.0]}, "inputs": lambda t: 1.0}, "an input cannot vary where inputs are a f"),
    ({"timepts": None}, "timepts: is required to run a diagram many times"),
    ({"timepts": [0.0]}, "timepts: must be at least two increasing times"),
    ({"samples": 100}, "samples: is for a scenario; a diagram has timepts; leave it out"),
    ({"times": [1.0]}, "times: is for a scenario"),
    ({"method": "euler"}, "method = 'euler': must be one of auto, dop853, dopri5, rodas5p"),
    ({"rtol": -1.0}, "rtol = -1.0: must be a number, 0 or more"),
    ({"params": {"tua": 1.0}}, "unknown parameter 'tua'"),
    ({"initial_state": [1.0, 2.0]}, "initial_state: must have 1 numbers"),
]


@pytest.mark.parametrize(("given", "sentence"), MISTAKES)
def test_mistakes_are_one_sentence(tmp_path, given, sentence):
    whole = {"vary": {"tau": [1.0]}, "timepts": TIMES, "out": tmp_path / "e.zarr", **given}
    with pytest.raises(ClptError, match=sentence) as error:
        clpt.run_ensemble(lag(), **whole)
    assert "\n" not in str(error.value)
    assert not list(tmp_path.iterdir())


def test_more_mistakes():
    with pytest.raises(ClptError, match=r"vary: one\.K\[0\] and one\.K are one number; name it"):
        clpt.run_ensemble(springs(), {"one.K": [[1, 2]], "one.K[0]": [1]}, timepts=TIMES)
    with pytest.raises(ClptError, match=r"plant\.a and a are one number"):
        clpt.run_ensemble(mrac(), {"a": [1], "plant.a": [1]}, timepts=TIMES)
    with pytest.raises(ClptError, match=r"unknown name plant\.aa; did you mean plant\.a\?"):
        clpt.run_ensemble(mrac(), {"plant.aa": [1]}, timepts=TIMES)
    with pytest.raises(ClptError, match=r"unknown name lag\.tua; did you mean lag\.tau\?"):
        clpt.run_ensemble(lag(), {"lag.tua": [1]}, timepts=TIMES)
    with pytest.raises(ClptError, match=r"one\.turns = 3 cannot vary: a whole number is fixed"):
        clpt.run_ensemble(springs(), {"one.turns": [1.0]}, timepts=TIMES)
    with pytest.raises(ClptError, match=r"one\.K\[2\] is no element: one\.K has shape \(2,\)"):
        clpt.run_ensemble(springs(), {"one.K[2]": [1.0]}, timepts=TIMES)
    with pytest.raises(ClptError, match="timepts: is for a diagram, with timepts; leave it out"):
        clpt.run_ensemble(clpt.paper_scenario(), "learning.gain=1:2", 2, timepts=TIMES)
    system = control.nlsys(lambda t, x, u, p: -p["x"] * x, None, inputs=0, outputs=1, states=["x"],
                           params={"x": 1.0}, name="same")  # fmt: skip
    with pytest.raises(ClptError, match="x is more than one of a parameter, an initial state and"):
        clpt.run_ensemble(system, {"x": [1.0]}, timepts=TIMES)
    for name in ("time", "member", "status", "end", "y_final", "y_index"):
        system = control.nlsys(lambda t, x, u, p: -x, None, inputs=0, outputs=["y[0]", "y[1]"],
                               states=2, params={name: 1.0}, name="same")  # fmt: skip
        with pytest.raises(ClptError, match=f"vary: {name} is a name of the result; rename it"):
            clpt.run_ensemble(system, {name: [1.0]}, timepts=TIMES)


@pytest.mark.parametrize("two", [np.array([1.0, 2.0]), [1, 2]])
def test_one_name_for_two_shapes_has_the_shape_that_python_control_hands_down(two):
    given = {"inputs": 0, "outputs": 1, "states": 1}
    systems = [
        control.nlsys(lambda t, x, u, p: -x, None, params={"K": 1.0}, name="a", **given),
        control.nlsys(
            lambda t, x, u, p: -p["K"][1] * x, None, params={"K": two}, name="b", **given
        ),
    ]
    loop = control.interconnect(systems, connections=False, outlist=["b.y[0]"], outputs=["y"])
    with pytest.raises(ClptError, match=r"K = 1\.0: each value must be an array of shape \(2,\)"):
        clpt.run_ensemble(loop, {"K": [1.0, 2.0]}, timepts=TIMES)
    data = clpt.run_ensemble(loop, {"K[1]": [1.0, 2.0]}, timepts=TIMES, initial_state=1.0)
    np.testing.assert_allclose(data.y_final, np.exp([-5, -10]), atol=1e-9)


def test_states_and_inputs_bring_their_units():
    sail = clpt.Block(
        "sail",
        update=lambda t, x, u, p: u.v - x.s,
        inputs={"v": 1},
        states={"s": 1},
        units={"v": "m/s", "s": "m"},
    )
    loop = clpt.connect([sail], external="v", name="sailing")
    data = clpt.run_ensemble(loop, {"v": [1.0, 2.0], "sail_s[0]": [0.0, 1.0]}, timepts=TIMES)
    assert data.v.attrs["units"] == "m/s"
    assert data["sail_s[0]"].attrs["units"] == "m"
    assert data.s_rms.attrs["units"] == "m"
    axes = data.unstack().s_rms.plot.contourf().axes
    assert axes.get_xlabel() == "sail_s[0] [m]"


def test_the_accessor_says_what_it_is():
    data = clpt.run_ensemble(lag(), {"tau": [0.5, 1.0]}, timepts=TIMES)
    assert data.clpt.kind == "ensemble"
    assert repr(data.clpt) == "<clpt of a dataset: ensemble Ensemble of lag>"
    for ask in (data.clpt.plot, lambda: data.clpt.report("page.html")):
        with pytest.raises(ClptError, match=r"is an ensemble of a diagram.*plot\.contourf"):
            ask()


def test_a_state_whose_label_is_a_word_of_the_function_varies():
    def rate(t, x, u, p):
        own = dict(zip(("s", "i"), x, strict=True))
        return [-own["s"] * own["i"], own["s"] * own["i"] - p.get("k", 0.3) * own["i"]]

    spread = control.nlsys(rate, None, inputs=0, states=["s", "i"], outputs=["s", "i"], name="e")
    found = clpt.run_ensemble(
        spread, {"s": [0.8, 0.9]}, timepts=TIMES, initial_state=[0.5, 0.1], trajectories=True
    )
    assert found.s_.values[:, 0].tolist() == [0.8, 0.9]
    assert found.s_final.equals(found.s_[:, -1].drop_vars("time"))
    one = clpt.simulate(spread, TIMES, initial_state=[0.9, 0.1])
    np.testing.assert_allclose(found.i_final.values[-1], one.i.values[-1], rtol=1e-7)


@pytest.mark.parametrize("key", ["r", "y", "decay_y"])
def test_states_and_inputs_vary_where_python_runs(key):
    """A function that is not read could read any name; it is asked for none."""

    def rate(t, x, u, p):
        return [-p["k"] * float(str(x[0])) + u[0]]

    decay = control.nlsys(
        rate, None, inputs=["r"], states=["y"], outputs=["y"], params={"k": 2.0}, name="decay"
    )
    if key != "y":
        lag = control.tf(1, [1, 1], inputs="y", outputs="z", name="lag")
        decay = clpt.connect([decay, lag], external="r")
    with pytest.warns(UserWarning, match="runs in Python"):
        found = clpt.run_ensemble(decay, {key: [1.0, 3.0]}, timepts=TIMES)
    last = np.exp(-2.0 * TIMES[-1])
    end = (1.0 - last) / 2.0 if key == "r" else last
    np.testing.assert_allclose(found.y_final, [end, 3.0 * end], rtol=1e-6)


def test_an_interrupt_waits_for_one_member_that_python_runs():
    begun = set()

    def rate(t, x, u, p):
        begun.add(p["k"])
        return [-p["k"] * float(str(x[0]))]

    def stop(done):
        if done:
            raise KeyboardInterrupt

    decay = control.nlsys(rate, None, inputs=0, states=1, outputs=1, params={"k": 2.0}, name="d")
    given = {"timepts": TIMES, "threads": 1, "progress": stop}
    with pytest.warns(UserWarning, match="runs in Python"), pytest.raises(KeyboardInterrupt):
        clpt.run_ensemble(decay, "k=1:2", 200, **given)
    assert len(begun) < 20  # those that are tried before, and one or two


def test_an_output_named_as_a_summary_of_another_is_refused():
    system = control.nlsys(lambda t, x, u, p: -p["k"] * x, lambda t, x, u, p: [x[0], 7.0],
                           inputs=0, states=1, outputs=["y", "y_final"], params={"k": 1.0},
                           name="two")  # fmt: skip
    given = {"vary": {"k": [1.0]}, "timepts": TIMES, "initial_state": 1.0}
    with pytest.raises(ClptError, match="trajectories: y_final is a name of the result"):
        clpt.run_ensemble(system, trajectories=True, **given)
    assert clpt.run_ensemble(system, **given).y_final_final.values == 7.0


@pytest.mark.parametrize("times", [5.0, np.array(["2020-01-01", "2020-01-02"], "datetime64[ns]")])
def test_times_that_are_none_are_one_sentence(times):
    with pytest.raises(ClptError, match=r"timepts = .*: must be a list of numbers, an array of"):
        clpt.run_ensemble(lag(), {"tau": [0.5]}, timepts=times)


@pytest.mark.parametrize("label", ["\\", "a\\b", "[0]"])
def test_a_name_that_zarr_does_not_have_is_told(label, tmp_path):
    block = control.nlsys(
        lambda t, x, u, p: -x, None, states=[label], outputs=[label], inputs=["u"], name="lag"
    )
    for out in (None, tmp_path / "e.zarr"):
        with pytest.raises(clpt.DataError, match=r"Zarr has no name .* call that signal otherwise"):
            clpt.run_ensemble(block, {"u": [1.0, 2.0]}, timepts=TIMES, out=out, trajectories=True)
        assert not (tmp_path / "e.zarr").exists()


def test_variables_stand_in_order():
    data = clpt.run_ensemble(lag(), {"tau": [0.5, 1.0]}, timepts=TIMES, trajectories=True)
    assert list(data.data_vars) == sorted(data.data_vars)


def test_a_loop_runs_as_its_scenario_says_or_as_it_ran(tmp_path):
    scenario = clpt.paper_scenario().with_values({"run.rtol": 1e-4, "run.atol": 1e-5})
    loop = clpt.closed_loop(scenario, external="delta")
    still = np.zeros((2, 3))
    run = clpt.simulate(loop, [0, 20, 40], still, clpt.initial_state(scenario))
    clpt.save_run(run, tmp_path / "run.nc")
    exact = {"timepts": [0, 20, 40], "inputs": still, "initial_state": clpt.initial_state(scenario)}
    for system in (loop, clpt.load_diagram(tmp_path / "run.nc")):
        given = {"timepts": [0, 20, 40], "inputs": still, "trajectories": True}
        start = clpt.initial_state(scenario)
        found = clpt.run_ensemble(
            system, {"adaptation.gain": [0.8, 1.6]}, initial_state=start, **given
        )
        assert np.allclose(found.e[0], run.clpe, rtol=0, atol=1e-12)
        assert np.abs(found.e[0] - clpt.simulate(loop, rtol=1e-10, **exact).clpe).max() > 1e-9
