"""The numbers of a block in a run: its own, those of diagrams around it, of a call and a sweep.

python-control hands a system's params on in this order: its own, the inner diagram's, the outer
diagram's, the call's; the last has priority.  Every verb has the same numbers.
"""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy.core.function import AppliedUndef
from test_export import InC, needs_cc
from test_fmu import Importer

import clpt_control as clpt
from clpt_control import parts

TIMES = np.linspace(0.0, 2.0, 9)
START = [0.4, -0.3]
NAMES = "lag.gain", "lag.lag", "k"
COMPILED = "as_of_compiled_c", "as_of_fmu"
QUICK = 2  # cases that `make test` runs
CASES = [
    *range(QUICK),
    *(pytest.param(k, marks=pytest.mark.long) for k in range(QUICK, 200)),
]


def rates(t, x, u, p):
    return [u[0] - p["k"] * x[0]]


def nested(own, inner, outer, connect):
    """Return r -> lag -> decay, nested twice; params of diagrams as python-control or we wire."""
    lag = parts.lag(own["lag.lag"], gain=own["lag.gain"], u="r", y="v")
    plant = control.nlsys(
        rates,
        None,
        inputs="v",
        outputs="z",
        states=1,
        params={"k": own["k"]},
        name="decay",
    )
    if connect:
        small = clpt.connect([lag, plant], "r", name="small")
        small.params = {**small.params, **inner}
        large = clpt.connect([small], "r", name="large")
        large.params = {**large.params, **outer}
        return large
    small = control.interconnect(
        [lag, plant], connections=[["decay.v", "lag.v"]], inplist=["lag.r"], inputs=["r"],
        outlist=["lag.v", "decay.z"], outputs=["v", "z"], name="small", params=inner,
    )  # fmt: skip
    return control.interconnect(
        [small], inputs=["r"], outputs=["v", "z"], name="large", params=outer
    )


def drawn(generator):
    """Return numbers for all names, then for some names, by the four givers."""
    sets = []
    for share in (1.0, 0.5, 0.5, 0.5):
        chosen = [name for name in NAMES if generator.random() < share]
        sets.append({name: float(generator.uniform(0.5, 2.0)) for name in chosen})
    return sets


def by_control(system, call, start=START):
    """Return v and z of python-control at TIMES, for r = 1."""
    run = control.input_output_response(
        system, TIMES, np.ones(len(TIMES)), start, params=call,
        solve_ivp_method="DOP853", solve_ivp_kwargs={"rtol": 1e-9, "atol": 1e-11},
    )  # fmt: skip
    return np.atleast_2d(run.outputs)[-2:].T


def expected(numbers, start=START, r=1.0):
    """Return v and z at TIMES by a matrix exponential."""
    T, g, k = numbers["lag.lag"], numbers["lag.gain"], numbers["k"]
    plant = control.ss([[-1 / T, 0], [1, -k]], [[g / T], [0]], np.eye(2), 0)
    return control.forced_response(
        plant, TIMES, r * np.ones(len(TIMES)), start
    ).outputs.T


def as_of_python_control(system, call, numbers, folder):
    return by_control(system, call)


def as_of_simulate(system, call, numbers, folder):
    run = clpt.simulate(system, TIMES, 1.0, START, call)
    return np.transpose([run.v, run.z])


def as_of_prepare(system, call, numbers, folder):
    """Return a prepared run, after one with other numbers."""
    prepared = clpt.prepare(system, TIMES, 1.0, START, call)
    changed = {name: 1.5 * value for name, value in call.items()}
    right = expected(numbers | changed)
    np.testing.assert_allclose(prepared(params=changed).states, right, atol=1e-6)
    return prepared().states


def as_of_members(system, call, numbers, folder):
    """Return a member; another has another input and another k."""
    vary = {"r": [1.0, 2.0], "k": [numbers["k"], 0.7]}
    members = clpt.run_ensemble(
        system, vary, timepts=TIMES, initial_state=START, params=call, trajectories=True
    )
    last = np.transpose([members.v.values[-1], members.z.values[-1]])
    right = expected(numbers | {"k": 0.7}, r=2.0)
    np.testing.assert_allclose(last, right, atol=1e-6)
    return np.transpose([members.v.values[0], members.z.values[0]])


def as_of_sensitivity(system, call, numbers, folder):
    """Return states as the sum of their derivatives times the start, and of a run from rest."""
    run = clpt.sensitivity(
        system, TIMES, inputs=1.0, initial_state=START, params=call, to="x0"
    )
    homogeneous = run.states.values @ START  # of a linear system
    particular = clpt.simulate(system, TIMES, 1.0, [0.0, 0.0], call).states.values
    return homogeneous + particular


def as_of_fit(system, call, numbers, folder):
    """Return the run with the k that was found, of data with 1.3 times k."""
    data = expected(numbers | {"k": 1.3 * numbers["k"]})
    begin = {"k": numbers["k"]}
    fit = clpt.fit_parameters(
        system,
        {"v": data[:, 0], "z": data[:, 1]},
        begin,
        TIMES,
        1.0,
        START,
        params=call,
    )
    return expected(numbers | {"k": fit.values["k"] / 1.3})


def as_of_enclosure(system, call, numbers, folder):
    tube = clpt.enclose(system, TIMES, 1.0, START, call)
    np.testing.assert_allclose(tube.upper, tube.lower, atol=1e-9)
    return tube.lower.values[:, :2]


def as_of_linearization(system, call, numbers, folder):
    linear = clpt.linearize(system, [0.0, 0.0], [0.0], params=call)
    u = np.ones(len(TIMES))
    return control.forced_response(linear, TIMES, u, START).states.T


def as_of_equations(system, call, numbers, folder):
    """Return the run of the printed rates, for the diagram with the numbers of the call."""
    system.params = {**system.params, **call}
    rates = clpt.equations(system, numbers=True).rates

    def rates_at(v, x, r):
        values = {"v": v, "x": x, "r(t)": r}
        found = []
        for (rate,) in (rates["v"], rates["x"]):
            atoms = rate.free_symbols | rate.atoms(AppliedUndef)
            atoms = {atom: values[str(atom)] for atom in atoms if str(atom) in values}
            found.append(float(rate.xreplace(atoms)))
        return found

    matrix = np.transpose([rates_at(*row) for row in np.eye(3).tolist()])
    plant = control.ss(matrix[:, :2], matrix[:, 2:], np.eye(2), 0)
    return control.forced_response(plant, TIMES, np.ones(len(TIMES)), START).states.T


def as_of_compiled_c(system, call, numbers, folder):
    made = InC(system, folder, initial_state=START, params=call)
    h = TIMES[1] / 50
    steps = h * np.arange(50 * (len(TIMES) - 1) + 1)
    return made.run(np.array(START), np.ones(1), h, steps)[::50]


def as_of_fmu(system, call, numbers, folder):
    """Return the run until the end, whose last row an importer computes."""
    clpt.export(system, folder / "made.fmu", START, params=call)
    found = Importer(folder / "made.fmu", folder)
    following = found.initialize(r=1.0)
    end = found.run(TIMES[-1], following, 5e-3)
    return np.vstack([expected(numbers)[:-1], end])


VERBS = [
    pytest.param(function, marks=[needs_cc] * (name in COMPILED), id=name)
    for name, function in list(globals().items())
    if name.startswith("as_of_")
]


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("case", CASES)
def test_every_verb_has_the_numbers_of_python_control(case, verb, tmp_path):
    own, inner, outer, call = drawn(np.random.default_rng(case))
    system = nested(own, inner, outer, connect=case % 2)
    numbers = own | inner | outer | call
    found = verb(system, call, numbers, tmp_path)
    np.testing.assert_allclose(found, expected(numbers), atol=1e-6)


@pytest.mark.parametrize("connect", [False, True])
def test_equations_points_and_fits_have_these_numbers(connect):
    own = {"lag.gain": 3.0, "lag.lag": 1.0, "k": 1.0}
    system = nested(own, {"lag.gain": 4.0, "k": 2.0}, {"lag.gain": 5.0}, connect)
    numbers = own | {"lag.gain": 5.0, "k": 2.0}
    rates_of = clpt.equations(system, numbers=True).rates
    assert str(rates_of["v"][0]) == "-v + 5*r(t)"
    assert str(rates_of["x"][0]) == "v - 2*x"
    point = control.find_operating_point(system, [0, 0], [1.0])
    linear = clpt.linearize(system, point.states, [1.0])
    np.testing.assert_allclose(np.ravel(control.dcgain(linear)), point.outputs[-2:])
    z = expected(numbers | {"lag.lag": 1.7})[:, 1]
    fit = clpt.fit_parameters(system, {"z": z}, {"lag.lag": 1.0}, TIMES, 1.0, START)
    assert fit.values["lag.lag"] == pytest.approx(1.7, abs=1e-6)


@pytest.mark.parametrize("connect", [False, True])
@pytest.mark.parametrize("where", ["inner", "outer"])
def test_an_unknown_name_in_a_diagram_is_refused_with_the_nearest(connect, where):
    own = {"lag.gain": 3.0, "lag.lag": 1.0, "k": 1.0}
    wrong = {"inner": {}, "outer": {}} | {where: {"lag.gian": 5.0}}
    system = nested(own, **wrong, connect=connect)
    with pytest.raises(
        clpt.ClptError, match=r"params: unknown parameter 'lag\.gian'.*lag\.gain"
    ):
        clpt.simulate(system, TIMES, 1.0)


def test_rules_are_of_the_complete_numbers():
    """high of a diagram, 3, and low of a call, 1.5: below high of the diagram, not of the block."""
    limit = parts.saturation(-1.0, 1.0, name="limit")
    system = control.interconnect(
        [limit], inplist=["limit.u"], inputs=["u"], outlist=["limit.y"], outputs=["y"],
        params={"limit.high": 3.0}, name="clipped",
    )  # fmt: skip
    u = np.linspace(0.0, 4.0, 9)
    run = clpt.simulate(system, TIMES, u, params={"limit.low": 1.5})
    np.testing.assert_allclose(run.y, np.clip(u, 1.5, 3.0))
    with pytest.raises(clpt.ClptError, match=r"low = 3\.5"):
        clpt.simulate(system, TIMES, u, params={"limit.low": 3.5})


def test_members_with_one_mode_share_a_block_made_anew():
    def falls(t, x, u, p):
        return [x[1], -9.81 if p.mode == 1 else -5.0 + p.drift]

    ball = clpt.Block(
        "ball", update=falls, states={"h": 1, "v": 1}, parameters={"mode": 1.0, "drift": 0.0},
        jump=lambda t, x, u, p: [0.0, -0.8 * x[1]],
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )  # fmt: skip
    vary = {"ball.mode": [1.0, 2.0], "ball.drift": [0.0, 0.5, 1.0]}
    members = clpt.run_ensemble(
        ball, vary, timepts=TIMES[:5], initial_state=[1.0, 0.0], trajectories=True
    )
    for mode in vary["ball.mode"]:
        for drift in vary["ball.drift"]:
            params = {"ball.mode": mode, "ball.drift": drift}
            run = clpt.simulate(
                ball, TIMES[:5], initial_state=[1.0, 0.0], params=params
            )
            row = members.where(
                (members["ball.mode"] == mode) & (members["ball.drift"] == drift),
                drop=True,
            )
            np.testing.assert_allclose(row.h.values.ravel(), run.h.values, atol=1e-7)


def test_rules_of_a_block_that_does_not_vary_hold_in_every_verb():
    limit = parts.saturation(-1.0, 1.0, name="limit", u="r", y="v")
    system = clpt.connect([limit, parts.lag(1.0, u="v", y="z")], "r")
    wrong = {"limit.low": 5.0}
    for call in (
        lambda: clpt.run_ensemble(
            system, {"lag.gain": [1.0, 2.0]}, timepts=TIMES, params=wrong
        ),
        lambda: clpt.sensitivity(system, TIMES, to="lag.gain", params=wrong),
        lambda: clpt.fit_parameters(
            system, {"z": TIMES}, {"lag.gain": 1.0}, TIMES, 1.0, params=wrong
        ),
    ):
        with pytest.raises(clpt.ClptError, match=r"low = 5\.0: must be below high"):
            call()


AT, VALUES = [-1.0, 0.0, 0.5, 1.0, 2.0], [0.0, 1.0, 0.5, 2.0, -1.0]


def pieces(at, x0=-0.5):
    """Return x at TIMES for x' = 0.3 - x + table(x), by SciPy from kink to kink."""
    rate = lambda t, x: 0.3 - x + np.interp(x, at, VALUES)  # noqa: E731
    kinks = [lambda t, x, k=k: x[0] - k for k in at]
    for kink in kinks:
        kink.terminal = True
    found, t, x = [x0], 0.0, np.array([x0])
    for until in TIMES[1:]:
        while t < until:
            run = solve_ivp(rate, (t, until), x, rtol=1e-11, atol=1e-12, events=kinks)
            t, x = run.t[-1], run.y[:, -1]
            if t < until:  # over the kink
                x = x + 1e-12 * rate(t, x)
        found.append(x[0])
    return np.array(found)


def table_in_a_loop(kind):
    if kind == "nlsys":
        return control.nlsys(
            lambda t, x, u, p: [u[0] - x[0] + np.interp(x[0], p["at"], p["v"])],
            None,
            inputs="r",
            states=["x"],
            outputs=["x"],
            params={"at": np.array(AT), "v": np.array(VALUES)},
        ), "at"
    table = parts.lookup_table(AT, VALUES, name="table", u="x", y="w")
    sum_of = clpt.Block(
        "sum", output=lambda t, x, u, p: u.r + u.w, inputs={"r": 1, "w": 1}, outputs={"e": 1}
    )  # fmt: skip
    return clpt.connect([table, sum_of, parts.lag(1.0, u="e", y="x")], "r"), "table.at"


@pytest.mark.parametrize("kind", ["part", "nlsys"])
def test_points_of_a_table_vary_as_other_numbers(kind):
    system, at = table_in_a_loop(kind)
    levels = [-0.4, 0.1, 0.3]
    right = [pieces([-1.0, level, *AT[2:]]) for level in levels]
    members = clpt.run_ensemble(
        system, {f"{at}[1]": levels}, timepts=TIMES, inputs=0.3, initial_state=[-0.5],
        trajectories=True,
    )  # fmt: skip
    np.testing.assert_allclose(members.x.values, right, atol=1e-6)
    whole = np.array([-1.0, 0.1, *AT[2:]])
    prepared = clpt.prepare(system, TIMES, 0.3, [-0.5], {at: np.array(AT)})
    found = prepared(params={at: whole}).states[:, 0]
    np.testing.assert_allclose(found, right[1], atol=1e-6)
    fit = clpt.fit_parameters(
        system, {"x": right[1]}, {f"{at}[1]": 0.05}, TIMES, 0.3, [-0.5]
    )
    assert fit.values[f"{at}[1]"] == pytest.approx(0.1, abs=1e-6)
    h = 1e-4
    slope = clpt.sensitivity(
        system,
        TIMES,
        to=f"{at}[1]",
        inputs=0.3,
        initial_state=[-0.5],
        params={at: whole},
    ).x.values[:, 0]
    below, above = (pieces([-1.0, 0.1 + change, *AT[2:]]) for change in (-h, h))
    np.testing.assert_allclose(slope, (above - below) / (2 * h), atol=2e-3)


def test_points_that_do_not_increase_are_refused_in_a_sweep():
    system, at = table_in_a_loop("part")
    with pytest.raises(clpt.ClptError, match=r"member 1.*increasing numbers"):
        clpt.run_ensemble(system, {f"{at}[1]": [0.0, 0.7]}, timepts=TIMES)


PLANT = control.nlsys(
    lambda t, x, u, p: [u[0] - p["k"] * x[0]],
    None,
    inputs=["u"],
    states=["y"],
    outputs=["y"],
    params={"k": 1.0},
    name="plant",
)


def of_the_plant(k):
    """Return the plant with a k of its own, in a diagram, and in one whose params have it."""
    own = control.nlsys(
        PLANT.updfcn, None, inputs=["u"], states=["y"], outputs=["y"], params={"k": k}
    )
    around = control.interconnect(
        [PLANT], inplist=["plant.u"], inputs=["u"], outlist=["plant.y"], outputs=["y"],
        params={"k": k},
    )  # fmt: skip
    return own, around


@pytest.mark.parametrize("k", [1 + 2j, 1 + 0j, np.complex64(1j), np.array([1j]), [1j]])
def test_complex_params_are_refused_in_every_verb(k):
    u, x = 1.0, [1.0]
    verbs = {
        "simulate": lambda s, p: clpt.simulate(s, TIMES, u, x, p),
        "prepare": lambda s, p: clpt.prepare(s, TIMES, u, x, p),
        "linearize": lambda s, p: clpt.linearize(s, x, [u], params=p),
        "sensitivity": lambda s, p: clpt.sensitivity(
            s, TIMES, inputs=u, initial_state=x, params=p
        ),
        "enclose": lambda s, p: clpt.enclose(s, TIMES, u, x, p),
        "ensemble": lambda s, p: clpt.run_ensemble(
            s, {"y": [1.0, 2.0]}, timepts=TIMES, params=p
        ),
    }
    for verb in verbs.values():
        for system, params in [
            (PLANT, {"k": k}),
            *((s, None) for s in of_the_plant(k)),
        ]:
            with pytest.raises(clpt.ClptError, match=r"k = .*must be a number"):
                verb(system, params)
    with pytest.raises(clpt.ClptError, match="vary: k = "):
        clpt.run_ensemble(PLANT, {"k": [1.0, np.ravel(k)[0]]}, timepts=TIMES)
    prepared = clpt.prepare(PLANT, TIMES, u, x, {"k": 1.0})
    with pytest.raises(clpt.ClptError, match=r"params\['k'\]"):
        prepared(params={"k": k})


def lag_of_gain(name, source, target, k):
    return control.nlsys(
        lambda t, x, u, p: -x[0] + p["k"] * u[0],
        inputs=source,
        outputs=target,
        states=1,
        params={"k": k},
        name=name,
    )


def test_a_name_of_numbers_that_differ_has_no_one_derivative():
    """y = a.k b.k e(t) of two lags in a row, e = 1 - (1 + t) exp(-t)."""
    two = [lag_of_gain("a", "u", "w", 1.0), lag_of_gain("b", "w", "y", 1.0)]
    loop = control.interconnect(two, inputs="u", outputs="y", name="loop")
    t, e = [0.0, 2.0], 1 - 3 * np.exp(-2)
    slopes = clpt.sensitivity(loop, t, of="y", to=["k", "a.k"], inputs=1.0)
    np.testing.assert_allclose(slopes.y.values[-1].ravel(), [2 * e, e], rtol=1e-6)
    with pytest.raises(clpt.SimulationError, match="k has several values in the run"):
        clpt.sensitivity(loop, t, of="y", to="k", inputs=1.0, params={"a.k": 3.0})
    slopes = clpt.sensitivity(
        loop, t, of="y", to="b.k", inputs=1.0, params={"a.k": 3.0}
    )
    np.testing.assert_allclose(slopes.y.values[-1].ravel(), [3 * e], rtol=1e-6)


def test_the_learner_has_the_numbers_of_its_loop():
    scenario = clpt.paper_scenario()
    loop = clpt.closed_loop(scenario)
    loop.params["adaptation.gain"] = 2.0
    changed = scenario.with_values({"learning.gain": 2.0})
    right = clpt.export(changed, part="learner")
    assert clpt.export(loop, part="learner") == right
    loop.params["true_flow.theta"] = np.ones((2, 3))  # the learner has no such block
    assert clpt.export(loop, part="learner") == right
