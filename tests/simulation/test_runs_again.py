"""A second run of a diagram is ready at once; whatever changed in between counts."""

import functools
import random
import subprocess
import sys
import threading
import types
from concurrent.futures import ThreadPoolExecutor

import control
import law_blocks
import numpy as np
import pytest
from engine_runs import NativeDiagram
from random_diagrams import random_diagram
from scipy.interpolate import interp1d

import clpt_control as clpt

TIMES = np.linspace(0.0, 1.0, 11)
RATE, TABLE = 1.0, [1.0]
SEEDS = [  # the first by `make test`, all by `make test-slow`
    pytest.param(seed, marks=[pytest.mark.slow] * (seed >= 4)) for seed in range(60)
]


def table_of(rate):
    return interp1d([0.0, 1.0, 2.0], [rate] * 3)


def of_rate(rate):
    """A function whose rate is what another says."""
    return lambda t, x, u, params: [-rate(x[0]) * x[0]]


def by_params(t, x, u, params):
    return [-params["k"] * x[0]]


def changes(patch):
    """Return diagrams of x' = -x, and what makes each x' = -2 x."""

    def of_global():
        patch.setitem(globals(), "RATE", 2.0)

    def in_module(rate):
        patch.setitem(sys.modules, "numbers_of_mine", types.SimpleNamespace(rate=rate))

    in_module(1.0)
    TABLE[0] = 1.0
    value, less, ends = [1.0], np.zeros(1), ([[1.0]], [[1.0]], [[0.0]])
    table, plant = table_of(1.0), system(by_params, k=1.0)
    wired = control.ss([[0.0]], *ends, name="a", inputs="u", outputs="y")
    lag = control.ss([[-1.0]], *ends, name="lag")
    loop = control.interconnect(
        [wired], [["a.u", "-a.y"]], ["a.u"], ["a.y"], name="loop"
    )
    product = lambda t, x, u, p: [functools.reduce(lambda a, b: a * b, [-RATE, x[0]])]  # noqa: E731
    partial = functools.partial(held, [1.0], less=less)
    of_mine = types.ModuleType("of_mine")
    of_mine.rate = 1.0
    patch.setitem(globals(), "of_mine", of_mine)
    rated, keyed, helped, bare = fresh_functions()
    variable, rebind = rebound()
    return {
        "a variable of a closure": (system(variable), rebind),
        "code": (
            system(bare),
            lambda: setattr(
                bare, "__code__", (lambda t, x, u, p: [-2 * x[0]]).__code__
            ),
        ),
        "code of a helper": (
            system(of_rate(helped)),
            lambda: setattr(helped, "__code__", (lambda x: 2.0).__code__),
        ),
        "defaults": (system(rated), lambda: setattr(rated, "__defaults__", (2.0,))),
        "defaults by name": (
            system(keyed),
            lambda: keyed.__kwdefaults__.update(rate=2.0),
        ),
        "a name of a module": (
            system(lambda t, x, u, params: [-of_mine.rate * x[0]]),
            lambda: setattr(of_mine, "rate", 2.0),
        ),
        "a global over a builtin": (
            system(lambda t, x, u, params: [-abs(x[0])]),
            lambda: patch.setitem(globals(), "abs", lambda x: 2.0 * x),
        ),
        "a global": (system(lambda t, x, u, params: [-RATE * x[0]]), of_global),
        "a global behind math": (system(by_math), of_global),
        "a global behind functools": (system(product), of_global),
        "a list": (
            system(of_rate(lambda x: TABLE[0])),
            lambda: TABLE.__setitem__(0, 2.0),
        ),
        "an import": (system(by_import), lambda: in_module(2.0)),
        "a closure": (
            system(of_rate(lambda x: value[0])),
            lambda: value.append(value.pop() + 1.0),
        ),
        "a partial": (system(partial), lambda: less.__setitem__(0, -1.0)),
        "params": (plant, lambda: plant.params.update(k=2.0)),
        "params of another": (
            system(of_rate(lambda x: plant.params["k"])),
            lambda: plant.params.update(k=2.0),
        ),
        "a table of SciPy": (
            system(of_rate(lambda x: float(table(x)))),
            lambda: table.y.__setitem__(slice(None), 2),
        ),
        "a matrix": (lag, lambda: lag.A.__setitem__((0, 0), -2.0)),
        "a wire": (loop, lambda: loop.connect_map.__setitem__((0, 0), -2.0)),
    }


def by_math(t, x, u, params):
    from math import fabs

    return [-fabs(RATE) * x[0]]


def by_import(t, x, u, params):
    from numbers_of_mine import rate

    return [-rate * x[0]]


def fresh_functions():
    """Return functions of rate 1 whose parts may be changed."""

    def rated(t, x, u, params, rate=1.0):
        return [-rate * x[0]]

    def keyed(t, x, u, params, *, rate=1.0):
        return [-rate * x[0]]

    return rated, keyed, lambda x: 1.0, lambda t, x, u, params: [-x[0]]


def rebound():
    """Return rates of a variable, and what gives it another value."""
    rate = 1.0

    def rates(t, x, u, params):
        return [-rate * x[0]]

    def rebind():
        nonlocal rate
        rate = 2.0

    return rates, rebind


def held(rate, t, x, u, params, *, less):
    return [(less[0] - rate[0]) * x[0]]


def system(function, **params):
    sizes = {"states": 1, "inputs": 1, "outputs": 1, "name": "decay"}
    return control.nlsys(function, None, params=params, **sizes)


def end(diagram, **given):
    with np.errstate(all="raise"):
        return float(
            clpt.simulate(diagram, TIMES, initial_state=[1.0], **given).states[-1, 0]
        )


with pytest.MonkeyPatch.context() as none:
    NAMES = [*changes(none)]


@pytest.mark.parametrize("name", NAMES)
def test_what_changed_counts_at_the_next_run(name, monkeypatch):
    diagram, change = changes(monkeypatch)[name]
    one = [1.0]
    alike = system(of_rate(lambda x: one[0]))
    assert [end(diagram), end(diagram)] == pytest.approx([np.exp(-1.0)] * 2, rel=1e-7)
    change()
    assert [end(diagram), end(diagram)] == pytest.approx([np.exp(-2.0)] * 2, rel=1e-7)
    assert end(alike) == pytest.approx(np.exp(-1.0), rel=1e-7)


def test_params_at_call_time_and_names_count_as_they_are():
    diagram, k = system(by_params, k=1.0), np.array([3.0])
    assert end(diagram) == pytest.approx(np.exp(-1.0), rel=1e-7)
    for k[0] in (3.0, 2.0):
        assert end(diagram, params={"k": k}) == pytest.approx(np.exp(-k[0]), rel=1e-7)
    diagram.set_outputs(["speed"])
    assert "speed" in clpt.simulate(diagram, TIMES)


def test_what_could_change_unseen_counts_at_the_next_run():
    class Plant:
        rate, lock = 1.0, threading.Lock()

        def rates(self, t, x, u, params):
            with self.lock:
                return [-self.rate * x[0]]

    plant = Plant()
    diagram = system(plant.rates)
    for plant.rate in (1.0, 2.0):
        found = end(diagram, engine="python")
        assert found == pytest.approx(np.exp(-plant.rate), rel=1e-7)


def test_scenarios_run_again_alike():
    scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    first = clpt.simulate(scenario)
    assert first.identical(clpt.simulate(scenario))
    assert clpt.simulate(scenario, [0.0, 5.0], rtol=1e-6).sizes["time"] == 2
    assert first.identical(clpt.simulate(scenario))


def test_runs_of_one_diagram_share_no_attributes_and_no_numbers():
    """They share what is made once: names, units, the index of times."""
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], 0, inputs="u", outputs="y", name="lag")
    one = clpt.simulate(lag, TIMES, 1.0)
    wanted = one.copy(deep=True)
    two = clpt.simulate(lag, TIMES, 1.0)
    two.time.attrs["units"] = two.states.attrs["long_name"] = two.attrs["title"] = (
        "changed"
    )
    two.y.values[:] = two.states.values[:] = 0.0
    three = clpt.simulate(lag, TIMES, 1.0)
    for run in (one, three):
        assert run.identical(wanted)
    assert clpt.simulate(lag, TIMES + 1.0, 1.0).time[0] == 1.0


@pytest.mark.parametrize("method", ["dop853", "rodas5p"])
def test_inputs_states_and_steps_count_in_the_arrays_of_the_run_before(method):
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], 0, inputs="u", outputs="y", name="lag")
    ramp = (2.0 * TIMES)[None]
    cases = [
        (1.0, 0.0, 1.0 - np.exp(-TIMES)),
        (-2.0, 3.0, 5.0 * np.exp(-TIMES) - 2.0),
        (ramp, 0.0, 2.0 * (TIMES - 1.0 + np.exp(-TIMES))),
        (0.5 * ramp, 1.0, TIMES - 1.0 + 2.0 * np.exp(-TIMES)),
    ]
    found = []
    for inputs, start, _ in cases * 2:
        found.append(clpt.simulate(lag, TIMES, inputs, start, method=method).states)
    for states, (_, _, expected) in zip(found, cases * 2, strict=True):
        np.testing.assert_allclose(states[:, 0], expected, rtol=2e-7, atol=2e-9)
    steps = [
        clpt.simulate(lag, TIMES, 1.0, method=method, max_step=step).solver_steps
        for step in (np.inf, 0.01, np.inf)
    ]
    assert steps[1] >= 100 > steps[0] == steps[2]


def numbers_of(diagram, draw, method):
    """Return states and outputs of a run from a drawn start, or the sentence of its error."""
    start, inputs = draw.normal(size=diagram.nstates), draw.normal(size=diagram.ninputs)
    try:
        run = clpt.simulate(diagram, TIMES, list(inputs), start, method=method)
    except clpt.SimulationError as error:
        return str(error)
    response = run.clpt.response()
    return response.states.tobytes(), response.outputs.tobytes()


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("method", ["auto", "rodas5p"])
@pytest.mark.parametrize("seed", SEEDS)
def test_random_diagrams_repeat_to_the_bit_after_another_run(seed, method):
    """The second run leaves its numbers in the arrays that the third one fills."""
    diagram = random_diagram(random.Random(seed), blocks=2)
    first, _, again = (
        numbers_of(diagram, np.random.default_rng(k), method) for k in (1, 2, 1)
    )
    assert again == first


def test_threads_that_run_one_diagram_do_not_share_arrays():
    native = NativeDiagram(system(by_params, k=1.0))
    starts = np.linspace(1.0, 2.0, 40)

    def runs_from(start):
        return [native.run([start], TIMES).x[:, 0] for _ in range(10)]

    with ThreadPoolExecutor(4) as pool:
        for start, runs in zip(starts, pool.map(runs_from, starts), strict=True):
            expected = np.tile(start * np.exp(-TIMES), (10, 1))
            np.testing.assert_allclose(runs, expected, rtol=1e-7)


DIAGRAM = """
import sys
import control, numpy as np, clpt_control as clpt
decay = control.nlsys(lambda t, x, u, p: -x, states=1, inputs=0, name="decay")
run = clpt.simulate(decay, [0.0, 1.0], initial_state=1.0)
assert abs(run.states[-1, 0] - np.exp(-1.0)) < 1e-7
print(*{"pydantic", "clpt_control.paper.scenario.experiment"} & sys.modules.keys())
assert run.clpt.kind == "diagram"
"""


@pytest.mark.long
def test_the_run_of_a_diagram_imports_no_scenario():
    done = subprocess.run([sys.executable, "-c", DIAGRAM], capture_output=True)
    assert (done.stdout.strip(), done.stderr) == (b"", b"")


SHORT = clpt.paper_scenario().with_values({"run.duration": 5})
GAIN = 0.8


def adaptation(t, x, u, p):
    alpha = -GAIN * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -GAIN * u.z * u.e, "Gamma": GAIN * u.zc * u.e}


@pytest.fixture
def law():
    own = law_blocks.papers_law()
    return clpt.Block(
        "adaptation", update=adaptation, inputs=own.input_ports, states=own.state_shapes
    )


@pytest.mark.parametrize("sample", [None, 0.5])
def test_a_global_of_a_law_counts_at_the_next_run(law, monkeypatch, sample):
    loop = clpt.closed_loop(SHORT, law=clpt.Sampled(law, sample) if sample else law)
    for gain in (0.8, 1.6):
        monkeypatch.setitem(globals(), "GAIN", gain)
        scenario = SHORT.with_values({"learning.gain": gain, "learning.sample": sample})
        expected, found = clpt.simulate(scenario), clpt.simulate(loop)
        np.testing.assert_allclose(found.alpha, expected.alpha, rtol=1e-6, atol=1e-8)


@pytest.mark.long
def test_a_global_of_a_law_counts_in_an_ensemble_and_a_proof(law, monkeypatch):
    def asked():
        data = clpt.run_ensemble(
            clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2
        )
        return data.flow_parameter_error, clpt.prove(law, points=200).status

    before, proved = asked()
    monkeypatch.setitem(globals(), "GAIN", -0.8)
    after, refuted = asked()
    assert not np.allclose(before, after)
    assert (proved, refuted == "proved") == ("proved", False)
