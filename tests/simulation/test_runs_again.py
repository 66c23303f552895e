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


def by_params(t, x, u, params):
    return [-params["k"] * x[0]]


def held(rate, t, x, u, params, *, less):
    return [(less[0] - rate[0]) * x[0]]


def system(function, **params):
    sizes = {"states": 1, "inputs": 1, "outputs": 1, "name": "decay"}
    return control.nlsys(function, None, params=params, **sizes)


def end(diagram, **given):
    with np.errstate(all="raise"):
        return float(clpt.simulate(diagram, TIMES, initial_state=[1.0], **given).states[-1, 0])


def closed(value):
    def by_closure(t, x, u, params):
        return [-value[0] * x[0]]

    return by_closure


def by_another(plant):
    """A function that asks another system for its rate."""
    return lambda t, x, u, params: [-plant.params["k"] * x[0]]


def by_table(table):
    """A function that asks a table of SciPy."""
    return lambda t, x, u, params: [-float(table(x[0])) * x[0]]


def changes(patch):
    """Return diagrams of x' = -x, and what makes each x' = -2 x."""

    def of_global():
        patch.setitem(globals(), "RATE", 2.0)

    def in_module(rate):
        patch.setitem(sys.modules, "numbers_of_mine", types.SimpleNamespace(rate=rate))

    in_module(1.0)
    TABLE[0] = ROW[0] = 1.0
    value, rate, less = [1.0], [1.0], np.zeros(1)
    table, plant = interp1d([0.0, 1.0, 2.0], [1.0, 1.0, 1.0]), system(by_params, k=1.0)
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], [[0.0]], name="lag")
    wired = control.ss([[0.0]], [[1.0]], [[1.0]], [[0.0]], name="a", inputs="u", outputs="y")
    loop = control.interconnect([wired], [["a.u", "-a.y"]], ["a.u"], ["a.y"], name="loop")
    return {
        "a global": (system(by_global), of_global),
        "a global of a helper": (system(by_helper), of_global),
        "a global behind math": (system(by_math), of_global),
        "a global behind functools": (system(by_reduce), of_global),
        "a list": (system(by_list), lambda: TABLE.__setitem__(0, 2.0)),
        "an array": (system(by_array), lambda: ROW.__setitem__(0, 2.0)),
        "a default": (
            system(by_default),
            lambda: patch.setattr(by_default, "__defaults__", (2.0,)),
        ),
        "an import": (system(by_import), lambda: in_module(2.0)),
        "a closure": (system(closed(value)), lambda: value.append(value.pop() + 1.0)),
        "a partial": (
            system(functools.partial(held, rate, less=less)),
            lambda: less.__setitem__(0, -1.0),
        ),
        "params": (plant, lambda: plant.params.update(k=2.0)),
        "params of another": (system(by_another(plant)), lambda: plant.params.update(k=2.0)),
        "a table of SciPy": (system(by_table(table)), lambda: table.y.__setitem__(slice(None), 2)),
        "a matrix": (lag, lambda: lag.A.__setitem__((0, 0), -2.0)),
        "a wire": (loop, lambda: loop.connect_map.__setitem__((0, 0), -2.0)),
    }


with pytest.MonkeyPatch.context() as none:
    NAMES = [*changes(none)]


@pytest.mark.parametrize("name", NAMES)
def test_what_changed_counts_at_the_next_run(name, monkeypatch):
    diagram, change = changes(monkeypatch)[name]
    alike = system(closed([1.0]))
    for _ in range(2):
        assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    change()
    for _ in range(2):
        assert end(diagram) == pytest.approx(np.exp(-2.0), rel=1e-7)
    assert end(alike) == pytest.approx(np.exp(-1.0), rel=1e-7)
    assert (diagram_key(diagram, None) is None) == (name == "an import")


def test_params_at_call_time_and_names_count_as_they_are():
    diagram, params = system(by_params, k=1.0), {"k": np.array([3.0])}
    assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    assert end(diagram, params=params) == pytest.approx(np.exp(-3.0), rel=1e-7)
    params["k"][0] = 2.0
    assert end(diagram, params=params) == pytest.approx(np.exp(-2.0), rel=1e-7)
    diagram.set_outputs(["speed"])
    assert "speed" in clpt.simulate(diagram, TIMES)


def test_what_could_change_unseen_has_no_key():
    class Plant(list):
        rate = 1.0

        def rates(self, t, x, u, params):
            return [-self.rate * x[0]]

    assert diagram_key(system(Plant().rates), None) is None


def test_scenarios_run_again_alike():
    scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    first, again = clpt.simulate(scenario), clpt.simulate(scenario)
    assert first.identical(again)
    assert clpt.simulate(scenario, [0.0, 5.0], rtol=1e-6).sizes["time"] == 2
    assert clpt.simulate(scenario).identical(first)


def test_runs_of_one_diagram_share_no_attributes_and_no_numbers():
    """They share what is made once: names, units, the index of times."""
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], 0, inputs="u", outputs="y", name="lag")
    one = clpt.simulate(lag, TIMES, 1.0)
    wanted = one.copy(deep=True)
    two = clpt.simulate(lag, TIMES, 1.0)
    two.time.attrs["units"] = two.states.attrs["long_name"] = two.attrs["title"] = "changed"
    two.y.values[:] = two.states.values[:] = 0.0
    three = clpt.simulate(lag, TIMES, 1.0)
    for run in (one, three):
        assert run.identical(wanted)
    assert clpt.simulate(lag, TIMES + 1.0, 1.0).time[0] == 1.0


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


@pytest.mark.parametrize("sample", [None, 0.5])
def test_a_global_of_a_law_counts_at_the_next_run(law, monkeypatch, sample):
    loop = clpt.closed_loop(SHORT, law=clpt.equations.Sampled(law, sample) if sample else law)
    for gain in (0.8, 1.6):
        monkeypatch.setitem(globals(), "GAIN", gain)
        scenario = SHORT.with_values({"learning.gain": gain, "learning.sample": sample})
        expected, found = clpt.simulate(scenario), clpt.simulate(loop)
        np.testing.assert_allclose(found.alpha, expected.alpha, rtol=1e-6, atol=1e-8)


def test_a_global_of_a_law_counts_in_an_ensemble_and_a_proof(law, monkeypatch):
    before = clpt.run_ensemble(clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2)
    assert clpt.theory.prove(law, points=200).status == "proved"
    monkeypatch.setitem(globals(), "GAIN", -0.8)
    after = clpt.run_ensemble(clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2)
    assert not np.allclose(before.flow_parameter_error, after.flow_parameter_error)
    assert clpt.theory.prove(law, points=200).status != "proved"
