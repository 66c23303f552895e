"""A second run of a diagram is ready at once; whatever changed in between counts."""

import functools
import sys
import types

import control
import numpy as np
import pytest
from scipy.interpolate import interp1d

import clpt_control as clpt
from clpt_control.diagrams.plain_data import diagram_key

TIMES = np.linspace(0.0, 1.0, 11)
RATE, TABLE, ROW = 1.0, [1.0], np.array([1.0])


def helper(x):
    return RATE * x


def by_global(t, x, u, params):
    return [-RATE * x[0]]


def by_helper(t, x, u, params):
    return [-helper(x[0])]


def by_list(t, x, u, params):
    return [-TABLE[0] * x[0]]


def by_array(t, x, u, params):
    return [-ROW[0] * x[0]]


def by_default(t, x, u, params, rate=1.0):
    return [-rate * x[0]]


def by_math(t, x, u, params):
    from math import fabs

    return [-fabs(RATE) * x[0]]


def by_reduce(t, x, u, params):
    return [functools.reduce(lambda a, b: a * b, [-RATE, x[0]])]


def by_import(t, x, u, params):
    from numbers_of_mine import rate

    return [-rate * x[0]]


def system(function):
    return control.nlsys(function, None, states=1, inputs=1, outputs=1, name="decay")


def end(diagram, **given):
    with np.errstate(all="raise"):
        return float(clpt.simulate(diagram, TIMES, initial_state=[1.0], **given).states[-1, 0])


def closed(value):
    def by_closure(t, x, u, params):
        return [-value[0] * x[0]]

    return by_closure


def in_module(monkeypatch, rate):
    monkeypatch.setitem(sys.modules, "numbers_of_mine", types.SimpleNamespace(rate=rate))


CHANGES = {
    by_global: lambda patch: patch.setitem(globals(), "RATE", 2.0),
    by_helper: lambda patch: patch.setitem(globals(), "RATE", 2.0),
    by_math: lambda patch: patch.setitem(globals(), "RATE", 2.0),
    by_reduce: lambda patch: patch.setitem(globals(), "RATE", 2.0),
    by_list: lambda patch: TABLE.__setitem__(0, 2.0),
    by_array: lambda patch: ROW.__setitem__(0, 2.0),
    by_default: lambda patch: patch.setattr(by_default, "__defaults__", (2.0,)),
    by_import: lambda patch: in_module(patch, 2.0),
}


@pytest.mark.parametrize("function", CHANGES, ids=lambda one: one.__name__)
def test_what_a_function_reaches_counts_as_it_is(function, monkeypatch):
    in_module(monkeypatch, 1.0)
    diagram = system(function)
    for _ in range(2):
        assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    CHANGES[function](monkeypatch)
    for _ in range(2):
        assert end(diagram) == pytest.approx(np.exp(-2.0), rel=1e-7)
    monkeypatch.undo()
    TABLE[0] = ROW[0] = 1.0
    in_module(monkeypatch, 1.0)
    assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)


def test_a_closure_that_is_alike_does_not_stand_for_another():
    first, second = [1.0], [1.0]
    one, other = system(closed(first)), system(closed(second))
    assert end(one) == end(other)
    first[0] = 2.0
    assert end(other) == pytest.approx(np.exp(-1.0), rel=1e-7)
    assert end(one) == pytest.approx(np.exp(-2.0), rel=1e-7)
    first[0] = 1.0
    assert end(one) == end(other)


def test_a_partial_counts_as_what_it_holds():
    def held(rate, t, x, u, params, *, less):
        return [(less[0] - rate[0]) * x[0]]

    rate, less = [1.0], np.zeros(1)
    diagram = system(functools.partial(held, rate, less=less))
    assert diagram_key(diagram, None) is not None
    assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    rate[0] = 3.0
    assert end(diagram) == pytest.approx(np.exp(-3.0), rel=1e-7)
    less[0] = 1.0
    assert end(diagram) == pytest.approx(np.exp(-2.0), rel=1e-7)


def test_params_matrices_and_names_count_as_they_are():
    def rates(t, x, u, params):
        return -params["k"] * x

    diagram = control.nlsys(rates, None, states=1, inputs=1, outputs=1, params={"k": 1.0})
    params = {"k": np.array([3.0])}
    assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    assert end(diagram, params=params) == pytest.approx(np.exp(-3.0), rel=1e-7)
    params["k"][0] = 2.0
    assert end(diagram, params=params) == pytest.approx(np.exp(-2.0), rel=1e-7)
    diagram.params["k"] = 4.0
    assert end(diagram) == pytest.approx(np.exp(-4.0), rel=1e-7)
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], [[0.0]], name="lag")
    assert end(lag) == pytest.approx(np.exp(-1.0), rel=1e-7)
    lag.A[0, 0] = -2.0
    assert end(lag) == pytest.approx(np.exp(-2.0), rel=1e-7)
    lag.set_outputs(["speed"])
    assert "speed" in clpt.simulate(lag, TIMES)


def test_wires_that_change_count():
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], [[0.0]], name="lag", inputs="u", outputs="y")
    wires = [["lag.u", "-lag.y"]]
    loop = control.interconnect([lag], wires, ["lag.u"], ["lag.y"], name="loop")
    assert end(loop) == pytest.approx(np.exp(-2.0), rel=1e-7)
    loop.connect_map[0, 0] = -3.0
    assert end(loop) == pytest.approx(np.exp(-4.0), rel=1e-7)


def test_what_could_change_unseen_has_no_key(monkeypatch):
    class Plant:
        rate = 1.0

        def rates(self, t, x, u, params):
            return [-self.rate * x[0]]

    class Noisy(Plant, list):
        pass

    plant = Plant()
    diagram = system(plant.rates)
    assert diagram_key(diagram, None) is not None
    assert diagram_key(system(Noisy().rates), None) is None
    assert diagram_key(system(by_import), None) is None
    assert diagram_key(system(by_math), None) is not None
    assert diagram_key(system(by_reduce), None) is not None
    assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    plant.rate = 2.0
    assert end(diagram) == pytest.approx(np.exp(-2.0), rel=1e-7)


def test_scenarios_run_again_alike():
    scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    first, again = clpt.simulate(scenario), clpt.simulate(scenario)
    assert first.identical(again)
    shorter = clpt.simulate(scenario, [0.0, 5.0], rtol=1e-6)
    assert shorter.sizes["time"] == 2
    assert clpt.simulate(scenario).identical(first)


def test_a_table_or_a_system_that_a_function_asks_counts_as_it_is():
    """What changes in SciPy's tables and python-control's systems counts at once."""
    table = interp1d([0.0, 1.0, 2.0], [1.0, 1.0, 1.0])
    inner = control.nlsys(
        lambda t, x, u, params: [-params["a"] * x[0]], None,
        inputs=0, outputs=1, states=1, params={"a": 1.0}, name="inner",
    )  # fmt: skip

    def rate(t, x, u, params):
        return [inner.params["a"] * float(table(x[0]))]

    plant = control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="plant")
    ends = [float(clpt.simulate(plant, [0.0, 1.0]).states[-1, 0])]
    inner.params["a"] = 2.0
    ends.append(float(clpt.simulate(plant, [0.0, 0.5]).states[-1, 0]))
    table.y[:] = 3.0
    ends.append(float(clpt.simulate(plant, [0.0, 0.1]).states[-1, 0]))
    np.testing.assert_allclose(ends, [1.0, 1.0, 0.6], rtol=1e-9)


def test_runs_of_one_diagram_share_no_attributes_and_no_numbers():
    """They share what is made once: names, units, the index of times."""
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], 0, inputs="u", outputs="y", name="lag")
    times = np.linspace(0.0, 1.0, 5)
    one = clpt.simulate(lag, times, 1.0)
    wanted = one.copy(deep=True)
    two = clpt.simulate(lag, times, 1.0)
    two.time.attrs["units"] = two.states.attrs["long_name"] = two.attrs["title"] = "changed"
    two.y.values[:] = two.states.values[:] = 0.0
    three = clpt.simulate(lag, times, 1.0)
    for run in (one, three):
        assert run.identical(wanted)
    assert clpt.simulate(lag, times + 1.0, 1.0).time[0] == 1.0


SHORT = clpt.paper_scenario().with_values({"run.duration": 5})
GAIN = 0.8


def adaptation(t, x, u, p):
    alpha = -GAIN * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -GAIN * u.z * u.e, "Gamma": GAIN * u.zc * u.e}


@pytest.fixture
def law():
    return clpt.Block(
        "adaptation",
        update=adaptation,
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2},
        states={"alpha": (2, "N"), "K": 2, "Gamma": 2},
        sizes={"N": 3},
    )


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("sample", [None, 0.5])
def test_a_global_that_changes_counts_at_the_next_run(law, monkeypatch, engine, sample):
    loop = clpt.closed_loop(SHORT, law=clpt.equations.Sampled(law, sample) if sample else law)
    for gain in (0.8, 1.6):
        monkeypatch.setitem(globals(), "GAIN", gain)
        scenario = SHORT.with_values({"learning.gain": gain, "learning.sample": sample})
        expected, found = clpt.simulate(scenario), clpt.simulate(loop, engine=engine)
        np.testing.assert_allclose(found.alpha, expected.alpha, rtol=1e-6, atol=1e-8)


def test_a_global_that_changes_counts_in_an_ensemble_and_a_proof(law, monkeypatch):
    before = clpt.run_ensemble(clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2)
    assert clpt.theory.prove(law, points=200).status == "proved"
    monkeypatch.setitem(globals(), "GAIN", -0.8)
    after = clpt.run_ensemble(clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2)
    assert not np.allclose(before.flow_parameter_error, after.flow_parameter_error)
    assert clpt.theory.prove(law, points=200).status != "proved"
