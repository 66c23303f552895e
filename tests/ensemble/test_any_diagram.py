"""Ensembles of any diagram: members are closed forms, or the runs that python-control makes."""

import control
import numpy as np
import pytest
from engine_runs import Each
from error_sentences import says
from sampled_runs import TIMES, lag, spring, springs, system, two_shapes, unread

import clpt_control as clpt

LAST = TIMES[-1]


@pytest.fixture(params=["native", "python"])
def engine(request, monkeypatch):
    monkeypatch.setenv("CLPT_CONTROL_ENGINE", request.param)


def test_a_lag_swept_over_its_time_constant_is_its_closed_form():
    taus = np.geomspace(0.1, 10, 9)
    given = {
        "timepts": TIMES,
        "inputs": 2.0,
        "trajectories": True,
        "rtol": 1e-10,
        "atol": 1e-12,
    }
    data = clpt.run_ensemble(lag(), {"tau": taus}, **given)
    assert list(data.unstack().y_final.dims) == ["tau"]
    assert list(data.data_vars) == sorted(data.data_vars)
    y = 2 * (1 - np.exp(-TIMES / taus[:, None]))
    rms = np.sqrt(np.trapezoid(y**2, TIMES) / LAST)
    for name, wanted in {
        "y": y,
        "y_final": y[:, -1],
        "y_rms": rms,
        "y_max": y[:, -1],
    }.items():
        np.testing.assert_allclose(data[name], wanted, rtol=0, atol=1e-8, err_msg=name)


def test_a_discrete_loop_is_python_controls():
    cubic = lambda t, x, u, p: p["a"] * x + u - 0.1 * x**3  # noqa: E731
    plant = system(
        cubic, params={"a": 0.9}, dt=0.1, inputs="u", states="y", name="plant"
    )
    error = control.summing_junction(["r", "-y"], "e", name="error", dt=0.1)

    def loop_of(B):
        own = control.ss(
            0.5, B, 0.1, 0.2, 0.1, inputs="e", outputs="u", name="regulator"
        )
        return control.interconnect([plant, own, error], inputs="r", outputs=["y", "u"])

    t = np.arange(0, 3.01, 0.1)
    vary = {
        "a": [0.5, 0.9, 1.2],
        "regulator.B": [[[0.5]], [[1.0]]],
        "plant_y": [0.0, 1.0],
    }
    data = clpt.run_ensemble(
        loop_of(1.0), vary, timepts=t, inputs=1.0, trajectories=True
    )
    assert data.sizes["member"] == 12
    for m in range(12):
        one = data.isel(member=m)
        again, x0 = loop_of(one["regulator.B"].values), [float(one.plant_y), 0]
        params = {"a": float(one.a)}
        wanted = control.input_output_response(
            again, t, np.ones_like(t), x0, params=params
        )
        np.testing.assert_allclose(one.y, wanted.outputs[0], rtol=0, atol=1e-12)
        assert float(one.y_rms) == pytest.approx(
            np.sqrt(np.mean(wanted.outputs[0] ** 2))
        )


def test_members_that_a_guard_stops_have_all_samples_until_then():
    fall = clpt.Block(
        "fall",
        update=lambda t, x, u, p: [-p.rate],
        states={"h": 1},
        parameters={"rate": 1.0},
        guard=clpt.Guard(lambda t, x, u, p: x[0], "stop"),
    )
    times = np.arange(21) * 0.2
    rates = [0.3, 1.0, 1.15]
    data = clpt.run_ensemble(
        fall,
        {"fall.rate": rates},
        timepts=times,
        initial_state=[2.7],
        trajectories=True,
    )
    for m, rate in enumerate(rates):
        height = 2.7 - rate * times
        wanted = np.where(height > 0, height, np.nan)
        np.testing.assert_allclose(data.h[m], wanted, rtol=0, atol=1e-12)


# --- names ------------------------------------------------------------------------------------


def pulled_by(f, x0, K):
    """Return where a spring ends."""
    x0, f, K = (np.array(one, dtype=float) for one in (x0, f, K))
    return x0 * np.exp(-K * LAST) + f / K * (1 - np.exp(-K * LAST))


def tanks():
    """A plain name reaches every system that reads it; with the system's name it reaches one."""
    rate, k = (lambda t, x, u, p: -p["k"] * x), {"k": 1.0}
    made = [
        system(rate, params=k, outputs=name, states=name, name=f"tank_{name}")
        for name in "ab"
    ]
    return control.interconnect(made, connections=False, outputs=["a", "b"])


def listed():
    """A parameter that is a list, and one that is not declared."""

    def rate(t, x, u, p):
        return [-p["K"][0] * x[0], -p["K"][1] * x[1] * p.get("slow", 1.0)]

    return system(rate, params={"K": [1, 2]}, outputs=2, states=2)


def nested():
    inner = clpt.connect(
        [spring("spring", [1.0, 1.0], "a")], external="f", name="inner"
    )
    ports = {"inputs": ["r[0]", "r[1]"], "outputs": ["f[0]", "f[1]"], "name": "gain"}
    gain = control.ss([], [], [], 2 * np.eye(2), **ports)
    return clpt.connect([gain, inner], external="r", name="outer")


def reads_any():
    """Whatever is named could be one that `total` asks its params for."""
    asked = lambda t, x, u, p: [{k.upper(): v for k, v in p.items()}["A"] * u[0]]  # noqa: E731
    gain = control.nlsys(
        None, asked, inputs="y", outputs="v", params={"a": 2.0}, name="total"
    )
    return clpt.connect(
        [control.ss(-1, 1, 1, 0, inputs="r", outputs="y", name="lag"), gain], "r"
    )


def turns():
    """Whole numbers stay whole."""
    rate = lambda t, x, u, p: [-p["k"] * p["c"][0] * x[0] * len(range(p["n"]))]  # noqa: E731
    return system(rate, name="turns", params={"k": 1.0, "n": 3, "c": [1, 2]})


def jump_times(p, t0, t1):
    """Return the multiples of the period."""
    times = p.period * np.arange(1, int(t1 / p.period) + 2)
    return times[(times > t0) & (times <= t1)]


def stairs():
    ports = {"outputs": {"y": 1}, "states": {"x": 1}, "breakpoints": jump_times}
    rate, ports["parameters"] = (
        lambda t, x, u, p: [p.interval],
        {"period": 1.0, "interval": -1.0},
    )
    return clpt.Block("stairs", update=rate, output=lambda t, x, u, p: x.x[0], **ports)


def climbed(period):
    k = int(LAST / period)
    return period * k * (k - 1) / 2 + k * (LAST - k * period)


def not_read(sampled):
    """A function that is not read could read any name; it was requested none."""
    rate = lambda t, x, u, p: [-p["k"] * float(str(x[0])) + u[0]]  # noqa: E731
    names = {"inputs": ["r"], "states": ["y"], "outputs": ["y"], "name": "decay"}
    decay = control.nlsys(rate, params={"k": 2.0}, **names)
    after = control.tf(1, [1, 1], inputs="y", outputs="z", name="lag")
    return clpt.connect([decay, after], external="r") if sampled else decay


E5, E10 = np.exp([-5.0, -10.0])
R3, R10 = (1 - E10) / 2, np.array([1.0, 3.0]) * E10
TWO = [pulled_by(1, 1, K) for K in ([1, 2], [3, 0.5])]
SLOW = [[E5, np.exp(-5 * k * slow)] for k in (0.5, 1.0) for slow in (0.1, 0.2)]
PULLED = [[2 / K * (1 - np.exp(-5 * K)), 2 * (1 - E5)] for K in (0.5, 2.0)]
PERIODS, ODD = [0.4, 0.7, 1.3], system(unread, params={"a": 1.0}, name="odd")
HELD = [pulled_by(1, 1, [1, 2])] * 2  # equal numbers of the other block stay
FINALS = [  # a diagram, what varies, the initial state, outputs at the end by their closed forms
    (springs(), {"one.K": [[1.0, 2.0], [3.0, 0.5]]}, 1, {"a": TWO, "b": HELD}),
    (
        springs(),
        {"one.K[1]": [0.5]},
        1,
        {"a": [pulled_by(1, 1, [1, 0.5])], "b": HELD[:1]},
    ),
    (
        springs(),
        {"one_x[0]": [4.0]},
        1,
        {"a": [pulled_by(1, [4, 1], [1, 2])], "b": HELD[:1]},
    ),
    (
        springs(),
        {"one_x": [[2.0, 3.0]]},
        1,
        {"a": [pulled_by(1, [2, 3], [1, 2])], "b": HELD[:1]},
    ),
    (springs(), {"f[1]": [4.0]}, 1, {"a": [pulled_by([1, 4], 1, [1, 2])]}),
    (springs(), {"f": [[1.0, 2.0]]}, 1, {"a": [pulled_by([1, 2], 1, [1, 2])]}),
    (tanks(), {"k": [0.3]}, 1, {"a": [np.exp(-1.5)], "b": [np.exp(-1.5)]}),
    (tanks(), {"tank_a.k": [0.3]}, 1, {"a": [np.exp(-1.5)], "b": [E5]}),
    (listed(), {"K[1]": [0.5, 1.0], "slow": [0.1, 0.2]}, 1, {"y": SLOW}),
    (two_shapes(np.array([1.0, 2.0])), {"K[1]": [1.0, 2.0]}, 1, {"y": [E5, E10]}),
    (two_shapes([1, 2]), {"K[1]": [1.0, 2.0]}, 1, {"y": [E5, E10]}),
    (nested(), {"spring.K[0]": [0.5, 2.0]}, 0, {"a": PULLED}),
    (nested(), {"inner.spring.K[0]": [0.5, 2.0]}, 0, {"a": PULLED}),
    (reads_any(), {"lag.A": [[[-2.0]], [[-1.0]]]}, 0, {"v": [1 - E10, 2 * (1 - E5)]}),
    (turns(), {"k": [1, 2]}, 1, {"y": np.exp([-15.0, -30.0])}),
    (turns(), {"n": [1, 2]}, 1, {"y": [E5, E10]}),
    (turns(), {"c[0]": [1, 2]}, 1, {"y": np.exp([-15.0, -30.0])}),
    (stairs(), {"stairs.period": PERIODS}, 0, {"y": [*map(climbed, PERIODS)]}),
    (ODD, {"a": [1.0, 2.0]}, 1, {"y": [E5, E10]}),
    (not_read(True), {"r": [1.0, 3.0]}, 0, {"y": [R3, 3 * R3]}),
    (not_read(False), {"y": [1.0, 3.0]}, 0, {"y": R10 + R3}),
    (not_read(True), {"decay_y": [1.0, 3.0]}, 0, {"y": R10 + R3}),
]


@pytest.mark.usefixtures("engine")
@pytest.mark.filterwarnings("ignore:.*runs in Python")
@pytest.mark.parametrize(("diagram", "vary", "start", "wanted"), FINALS)
def test_members_end_as_closed_forms_do(diagram, vary, start, wanted):
    given = {"initial_state": float(start), "inputs": 1.0 if diagram.ninputs else None}
    data = clpt.run_ensemble(diagram, vary, timepts=TIMES, **given)
    for port, values in wanted.items():
        np.testing.assert_allclose(data[f"{port}_final"], values, rtol=1e-6, atol=1e-8)


def stopped(policy):
    return clpt.Block(
        "b",
        update=lambda t, x, u, p: [-p.v],
        states={"depth": 1},
        parameters={"v": 1.0},
        guard=clpt.Guard(lambda t, x, u, p: x[0], policy, lambda t, u, p: "surfaced"),
    )


@pytest.mark.usefixtures("engine")
def test_a_guard_that_stops_a_member_is_an_end_of_its_own(recwarn):
    """depth = 12 - v t stops at t = 12/v; samples are 10 s apart."""
    given = {
        "timepts": np.linspace(0, 30, 4),
        "initial_state": [12.0],
        "summary": {"time": lambda run: run.time[-1]},
    }
    vary = {"b.v": [1.0, 2.0, 0.1]}
    data = clpt.run_ensemble(stopped("stop"), vary, **given)
    assert not [one for one in recwarn if "did not finish" in str(one.message)]
    words = data.status.attrs["flag_meanings"].split()
    assert [words[k] for k in data.status.values] == ["stopped", "stopped", "finished"]
    np.testing.assert_allclose(data.end, [12, 6, 30], rtol=1e-9)
    np.testing.assert_allclose(data["time"], [12, 6, 30], rtol=1e-9)
    np.testing.assert_allclose(data.depth_final, [0, 0, 9], atol=1e-9)
    np.testing.assert_allclose(data.depth_max, [12, 12, 12])
    with pytest.warns(UserWarning, match="2 of 3 members did not finish.*surfaced"):
        failed = clpt.run_ensemble(stopped("raise"), vary, **given)
    assert failed.status.values.tolist() == [4, 4, 1]


def test_a_guard_stops_a_member_without_states():
    """y = k r with r = t/20 stops where r = 1, at t = 20."""
    gain = clpt.Block(
        "gain",
        output=lambda t, x, u, p: [u.r * p.k],
        inputs={"r": 1},
        outputs={"y": 1},
        parameters={"k": 1.0},
        guard=clpt.Guard(lambda t, x, u, p: 1 - u.r, "stop"),
    )
    times = np.linspace(0, 30, 4)
    given = {"timepts": times, "inputs": times / 20}
    data = clpt.run_ensemble(gain, {"gain.k": [1.0, 2.0]}, **given)
    np.testing.assert_allclose(data.end, 20.0)
    np.testing.assert_allclose(data.y_final, [1.0, 2.0])


def test_the_largest_of_an_output_is_its_absolute_value():
    still = control.nlsys(lambda t, x, u, p: 0 * x, inputs=0, states="y", outputs="y")
    data = clpt.run_ensemble(still, {"y": [-1.0, -2.0]}, timepts=[0, 1])
    assert data.y_max.values.tolist() == [1, 2]
    assert data.y_max.attrs["long_name"] == "y, largest absolute value"


# --- what is not compiled, what fails ---------------------------------------------------------


def test_units_given_to_a_system_are_those_of_runs_ensembles_and_files(tmp_path):
    lag = control.nlsys(
        lambda t, x, u, p: p["rate"] * (u - x),
        inputs="u",
        outputs="y",
        states="y",
        params={"rate": 2.0},
        name="lag",
    )
    times = [0.0, 1.0]
    assert clpt.simulate(lag, times, 1.0).y.attrs == {}
    lag.units = {"u": "V", "y": "rad", "rate": "1/s"}
    run = clpt.simulate(lag, times, 1.0)
    assert (run.y.attrs["units"], run.u.attrs["units"]) == ("rad", "V")
    clpt.save_run(run, tmp_path / "lag.nc")
    assert clpt.load_run(tmp_path / "lag.nc").y.attrs["units"] == "rad"
    vary = {"rate": [1.0, 2.0], "y": [0.0, 1.0]}
    data = clpt.run_ensemble(lag, vary, timepts=times, inputs=1.0)
    found = {name: data[name].attrs["units"] for name in ("rate", "y", "y_rms")}
    assert found == {"rate": "1/s", "y": "rad", "y_rms": "rad"}
    lag.units = {"z": "rad"}
    with pytest.raises(clpt.BlockError, match="'z', which is no port and no param"):
        clpt.simulate(lag, times, 1.0)
    source = control.tf(1, [1, 1], name="source", inputs="r", outputs="u")
    source.units = {"u": "m"}
    lag.units = {"u": "V"}
    loop = [source, lag]
    with pytest.raises(clpt.DiagramError, match="'u' is in 'm' at source and in 'V'"):
        clpt.simulate(clpt.connect(loop, external="r"), times)


def test_what_cannot_be_compiled_says_so():
    with pytest.warns(UserWarning, match="odd runs in Python, not as machine code: "):
        clpt.run_ensemble(ODD, {"a": [1.0, 2.0]}, timepts=TIMES, threads=2)


@pytest.mark.usefixtures("engine")
def test_samples_at_jumps_that_vary_are_taken_after_them():
    """0.2 k and the multiples of 0.1 among the samples are one time, and not one float."""
    ports = {"states": {"n": 1}, "parameters": {"period": 0.5, "interval": -1.0}}
    ports |= {
        "breakpoints": Each("period"),
        "jump": lambda t, x, u, p: p.interval + 0.0 * x,
    }
    count = clpt.Block("count", update=lambda t, x, u, p: 0.0 * x, **ports)
    times, periods = np.linspace(0, 2.3, 24), [0.5, 0.3, 0.2, 0.1, 0.05, 1.1]
    data = clpt.run_ensemble(
        count, {"count.period": periods}, timepts=times, trajectories=True
    )
    expected = np.floor(times / np.array(periods)[:, None] + 1e-9)
    np.testing.assert_allclose(data.n, expected, atol=1e-12)
    np.testing.assert_allclose(data.n_final, expected[:, -1], atol=1e-12)


def test_a_slash_in_a_name_is_kept_in_files(tmp_path):
    """A team's diagram has the ports west/x and east/x."""
    names = {
        "outputs": ["west/y[0]", "west/y[1]"],
        "states": ["west/x[0]", "west/x[1]"],
    }
    west = system(lambda t, x, u, p: -x, name="west/lag", **names)
    run = clpt.simulate(west, TIMES, 0, [1.0, 2.0])
    clpt.save_run(run, tmp_path / "run.nc")
    assert clpt.load_run(tmp_path / "run.nc").equals(run)
    given = {
        "vary": {"west/x": [[1.0, 2.0], [2.0, 1.0]]},
        "timepts": TIMES,
        "trajectories": True,
    }
    here, there, again = (
        clpt.run_ensemble(west, out=out, **given)
        for out in (None, *[tmp_path / "e.zarr"] * 2)
    )
    assert here.equals(there)
    assert here.equals(again)
    np.testing.assert_array_equal(here["west/y"].isel(member=0), run["west/y"])
    odd = clpt.simulate(control.ss(-1, 1, 1, 0, outputs="<y>"), TIMES, 1.0)
    with pytest.raises(
        clpt.ClptError, match=r"run.nc: NetCDF has no name '.*Rename it"
    ):
        clpt.save_run(odd, tmp_path / "run.nc")


class Counting:
    """Read as a constant, which the second call is not."""

    def __call__(self, t, x, u, p):
        return [-p["a"] * self.rate * x[0]]


def test_what_is_read_otherwise_is_found_before_members_run():
    made = Counting()
    odd, given = (
        system(made, params={"a": 1.0}),
        {"timepts": TIMES, "initial_state": 1.0},
    )
    for made.rate in (1.0, 2.0):
        found = clpt.run_ensemble(odd, {"a": [1.0, 2.0]}, **given)
        np.testing.assert_allclose(
            found.y_final, np.exp([-5, -10]) ** made.rate, atol=1e-9
        )


def test_a_member_that_fails_is_nan_and_said():
    given = {"vary": {"x": [-1.0, 0.1, 1.0]}, "timepts": TIMES, "trajectories": True}
    with pytest.warns(
        UserWarning, match="1 of 3 members did not finish; the first is member 2"
    ):
        data = clpt.run_ensemble(system(lambda t, x, u, p: x**2), **given)
    np.testing.assert_allclose(data.y_final[:2], [-1 / 6, 0.2], atol=1e-8)
    assert (data.status > 1).values.tolist() == [False, False, True]
    assert list(data.status[:2]) == [1, 1]
    assert 0.8 <= float(data.end[2]) <= 1.0  # x = 1 / (1 - t)
    assert np.isnan([data[f"y_{what}"][2] for what in ("final", "rms", "max")]).all()
    np.testing.assert_allclose(data.y[2, :5], 1 / (1 - TIMES[:5]))


def test_a_summary_of_the_user_is_python_controls_step_info():
    """Settling time of a lag by python-control's own step_info, and the closed form of the peak."""
    times, taus = np.linspace(0, 20, 2001), [0.5, 1.0, 2.0]

    def settling(run):
        return control.step_info(run.y.values, run.time.values)["SettlingTime"]

    data = clpt.run_ensemble(
        lag(),
        {"tau": taus},
        timepts=times,
        inputs=1.0,
        summary={"settling": settling, "half": lambda run: run.y.sel(time=10.0)},
    )
    # within 2 % of the final value from t = tau ln 50
    expected = np.array(taus) * np.log(50)
    np.testing.assert_allclose(data.settling, expected, atol=0.02)
    np.testing.assert_allclose(data.half, 1 - np.exp(-10 / np.array(taus)), atol=1e-7)


def test_inputs_without_times_are_answered_with_what_is_missing():
    with pytest.raises(
        clpt.ScenarioError, match=r"^inputs: needs timepts\. Give these too$"
    ):
        clpt.run_ensemble(control.ss(-1, 1, 1, 0), {"x0.x[0]": [1, 2]}, inputs=1.0)


def test_a_summary_is_refused_where_it_is_not_computed(tmp_path):
    given = {"vary": {"tau": [1.0, 2.0]}, "timepts": TIMES}
    for summary, options, said in (
        ({"a": lambda run: 1.0}, {"out": tmp_path / "a.zarr"}, "result in memory"),
        ({"a": lambda run: run.y}, {}, "summary: a returned .* Return one number"),
        ({"a": lambda t, y: y}, {}, "summary: a: must be a function of one run"),
        ({"y_final": lambda run: 1.0}, {}, "y_final is used twice as a name"),
    ):
        says(
            clpt.ScenarioError,
            said,
            lambda **more: clpt.run_ensemble(lag(), **given, **more),
            summary=summary,
            **options,
        )
    says(
        clpt.ScenarioError,
        "summary: is for a diagram",
        lambda: clpt.run_ensemble(
            clpt.paper_scenario(), "learning.gain=0.5:1", 2, summary={"a": len}
        ),
    )


def test_a_failed_member_has_no_summary():
    given = {"vary": {"x": [0.1, 1.0]}, "timepts": TIMES}
    with pytest.warns(UserWarning, match="1 of 2 members did not finish"):
        data = clpt.run_ensemble(
            system(lambda t, x, u, p: x**2), summary={"one": lambda run: 1.0}, **given
        )
    np.testing.assert_array_equal(data.one, [1.0, np.nan])


def test_a_loop_runs_as_its_scenario_says():
    scenario = clpt.paper_scenario().with_values({"run.rtol": 1e-4, "run.atol": 1e-5})
    loop, start = (
        clpt.closed_loop(scenario, external="delta"),
        clpt.initial_state(scenario),
    )
    given = {"timepts": [0, 20, 40], "inputs": np.zeros((2, 3)), "initial_state": start}
    run = clpt.simulate(loop, **given)
    exact = clpt.simulate(loop, rtol=1e-10, **given)
    found = clpt.run_ensemble(
        loop, {"adaptation.gain": [0.8, 1.6]}, trajectories=True, **given
    )
    assert np.allclose(found.e[0], run.clpe, rtol=0, atol=1e-12)
    assert np.abs(found.e[0] - exact.clpe).max() > 1e-9


@pytest.mark.long
def test_members_that_grow_and_turn_ever_faster_end_early():
    def rates(t, x, u, p):
        return [p["growth"] * x[0], x[0] * x[2], -x[0] * x[1]]

    plant = system(
        rates, params={"growth": 1.0}, states=3, outputs=["a", "b", "c"], name="plant"
    )
    given = {"initial_state": [1.0, 0.0, 1.0], "timepts": np.linspace(0.0, 20.0, 5)}
    with pytest.warns(
        UserWarning, match=r"1 of 2 members .* diverges: .*: the states grow while"
    ):
        data = clpt.run_ensemble(plant, {"growth": [-1.0, 2.0]}, **given)
    assert data.status.values.tolist() == [1, 8]
    assert 5.0 <= float(data.end[1]) < 10.0
    np.testing.assert_allclose(data.b_final[0], np.sin(1.0 - np.exp(-20.0)), atol=1e-7)
