"""Every block of the package conforms, and broken ones are told so in a sentence."""

import itertools
import math
import re

import control
import numpy as np
import pytest
from engine_runs import (
    BACKEND,
    check_block,
    compare_backends,
    differ,
    linear,
    python_values,
    random_samples,
    readings,
    roles,
    vectors,
)
from error_sentences import says
from package_blocks import EACH
from recorded_blocks import static

import clpt_control as clpt
from clpt_control import ArgumentError, Block, BlockError, ClptError, check


@pytest.mark.parametrize("block", EACH)
def test_package_block_conforms(block):
    assert not check(block, samples=8).notes
    compare_backends(block, samples=8)


def test_a_report_counts_its_checks_and_repeats():
    blocks = clpt.paper_blocks(clpt.paper_scenario())
    (clpe,) = (block for block in blocks if block.name == "clpe")
    report = check_block(clpe)
    assert (report.ok, report.failures, len(report.checks)) == (True, (), 6)
    assert str(report) == "clpe: conforms (6 checks)"
    assert check_block(static(root, 1), seed=3) == check_block(static(root, 1), seed=3)
    says(ArgumentError, "block = 3: must be a Block", check, 3)


def adapting(t, x, u, params):
    """theta' = gain e phi."""
    return params["gain"] * u[0] * u[1:]


def counted(t, x, u, params, calls=[0.0]):  # noqa: B006 - memory of the function
    """x' = calls x."""
    calls[0] += 1.0
    return calls[0] * x


def test_systems_of_python_control_are_checked():
    names = {"inputs": ["e", "phi[0]", "phi[1]"], "states": ["theta[0]", "theta[1]"]}
    law = control.nlsys(adapting, **names, params={"gain": 2.0}, name="law")
    assert str(check(law)) == "law: conforms (6 checks)"
    assert check(control.ss(0.5, 1, 1, 0, 0.1, name="sampled")).ok
    memory = control.nlsys(counted, inputs=0, states=1, outputs=1, name="memory")
    with pytest.raises(BlockError, match=r"memory\.update gives another value"):
        check(memory)
    with pytest.raises(BlockError, match=r"units: are checked of a clpt\.Block alone"):
        check(law, units={"e": "m"})
    loop = control.interconnect([law], inputs=names["inputs"], outputs=names["states"])
    says(BlockError, "is a diagram. Check each of its blocks", check, loop)


# --- blocks of a user, each with one mistake ---------------------------------------------------


def root(t, x, u, p):
    """y = sqrt(u), section 2: u = u[1], y = y[1]."""
    return math.sqrt(u[0])


def remembers(t, x, u, p):
    """y = u + calls, Eq. (1): u = u[1], y = y[1]."""
    return u[0] + count_calls(0.0)


def count_calls(a):
    return a


def test_memory_is_told(monkeypatch):
    block, calls = static(remembers, 1), itertools.count()
    monkeypatch.setitem(
        remembers.__globals__, "count_calls", lambda a: float(next(calls))
    )
    assert "must keep no memory" in failures(block)


def ticking(breakpoints):
    """y = interval, section 2: y[1]."""
    ports = {
        "outputs": {"y": 1},
        "parameters": {"step": 0.7, "interval": -1.0},
        "opaque": True,
    }
    return Block(
        "mine", output=lambda t, x, u, p: p.interval, breakpoints=breakpoints, **ports
    )


def failures(block):
    report = check_block(block)
    told = "\n".join(report.failures)
    assert (report.ok, all(one.startswith("mine") for one in report.failures)) == (
        False,
        True,
    )
    with pytest.raises(BlockError) as caught:
        check(block)
    assert all(sentence in str(caught.value) for sentence in report.failures)
    return told


@pytest.mark.parametrize(
    "make",
    [
        lambda: Block(
            "mine", update=lambda t, x, u, p: x.__setitem__(0, 1.0), states={"x": 1}
        ),
        lambda: static(lambda t, x, u, p: u.__setitem__(0, 1.0), 1),
        lambda: static(
            lambda t, x, u, p: p.k.__setitem__(0, 1.0), 1, parameters={"k": [1.0]}
        ),
    ],
)
def test_writing_into_what_is_given_makes_no_block(make):
    says(BlockError, r"line .*read-only", make)


def large_constant(t, x, u, p):
    """y = 2^70 u, Eq. (1): u = u[1], y = y[1]."""
    power = 1
    for _i in range(70):
        power = 2 * power
    return power * u[0]


def asked_once(t, x, u, p):
    """y = 3 k u, Eq. (1): u = u[1], y = y[1]; code of others is kept."""
    return 3.0 * p.k * u[0]


def test_machine_code_that_differs_is_told(monkeypatch):
    wrong = {**vectors.PRIMITIVES, "mul": vectors.PRIMITIVES["add"]}
    monkeypatch.setattr(vectors, "PRIMITIVES", wrong)
    told = failures(static(asked_once, 1, parameters={"k": 2.0}))
    assert "mine: differs as machine code at t = " in told
    asked = readings(static(asked_once, 1, parameters={"k": 2.0}))
    values = {name: ask(0.0, [], [5.0])[1] for name, ask in asked.items()}
    assert {name for name, y in values.items() if y != 30.0} == {
        *("native", "scalar", "looped", "lanes")
    }


BROKEN = {  # -> what is told
    "not finite at zero": lambda: static(lambda t, x, u, p: 1.0 / u[0], 1),
    "mine.output is not finite at zero": lambda: static(
        lambda t, x, u, p: math.log(u[0] ** 2), 1
    ),
    "random inputs only": lambda: static(lambda t, x, u, p: np.sqrt(u[0] - 9.0), 1),
    "breakpoints are not increasing": lambda: ticking(
        lambda p, t0, t1: np.array([t0, t1 + 1.0])
    ),
    "differ from those over both": lambda: ticking(
        lambda p, a, b: np.arange(a + p.step, b, p.step)
    ),
}


@pytest.mark.parametrize("sentence", BROKEN)
def test_what_is_broken_is_told(sentence):
    assert sentence in failures(BROKEN[sentence]())


def test_a_lambda_conforms_and_is_noted():
    system = control.nlsys(
        lambda t, x, u, p: -x + u, states=1, inputs=1, outputs=1, name="mine"
    )
    for made in (static(lambda t, x, u, p: u[0], 1), system):
        report = check(made)
        verdict, note = str(report).splitlines()
        assert report.ok
        assert verdict == "mine: conforms (6 checks)"
        assert note.startswith("Note: mine: cannot be pickled (")


# --- units ----------------------------------------------------------------------------------------


def leaky(t, x, u, p):
    near = np.exp(-((u.e - p.centre) ** 2) / p.centre**2)
    return p.gain * u.e * near - p.leak * x.theta


def leaky_in_metres(t, x, u, p):
    return p.gain * u.e * np.exp(-(u.e**2)) - p.leak * x.theta


LEAKY = {"e": "m", "theta": "m/s", "gain": "1/s^2", "leak": "s-1", "centre": "m"}


def made_leaky(update=leaky):
    parameters = {"gain": 0.8, "leak": 0.1, "centre": [2.0, 3.0]}
    return Block(
        "mine",
        update=update,
        inputs={"e": 2},
        states={"theta": 2},
        parameters=parameters,
    )


def test_units_that_fit_pass():
    assert len(check_block(made_leaky(), units=LEAKY).checks) == 7
    check(made_leaky(), units=LEAKY)
    hours = {
        "t": "h",
        "e": "km",
        "theta": "km/h",
        "gain": "h-2",
        "leak": "1/h",
        "centre": "km",
    }
    check(made_leaky(), units=hours)


SMALLER = [
    (leaky_in_metres, {}, r"mine.update: theta is not of the unit 'm/s'.*smaller m "),
    (leaky, {"gain": "1/s"}, r"theta is not of the unit 'm/s'.*smaller s "),
    (leaky, {"leak": "1"}, r"smaller s "),
    (leaky, {"centre": "km"}, r"smaller km "),
    (leaky, {"t": "h"}, r"smaller h "),
    (leaky, {"velocity": "m/s"}, r"no port or parameter is called 'velocity'"),
    (leaky, {"gain": None}, r"units: 'gain' has none"),
    (leaky, {"e": "m per s!"}, r"'m per s!' is not a unit. Write such as"),
]


@pytest.mark.parametrize(("update", "changed", "said"), SMALLER)
def test_units_that_do_not_fit_are_told(update, changed, said):
    units = {
        name: unit for name, unit in {**LEAKY, **changed}.items() if unit is not None
    }
    report = check_block(made_leaky(update), units=units)
    assert not report.ok
    assert re.match(rf"\A.*{said}.*\Z", report.failures[0])


def test_one_gain_for_all_is_of_no_unit():
    """Eqs. (21)-(23): phi has none, z has that of length, so one gamma for both cannot have one."""
    units = {"e": "m", "phi_x": "1", "z": "m", "zc": "m", "alpha": "m/s", "K": "1/s"}
    units |= {
        "Gamma": "1/s",
        "gain": "1/s^2",
        "gain_K": "m-2 s-2",
        "gain_Gamma": "m-2 s-2",
    }
    law = clpt.laws()["learned-flow"]
    check(law.of(3, gain=0.7, gain_K=0.4, gain_Gamma=1.3), units=units)
    del units["gain_K"], units["gain_Gamma"]
    one = check_block(law.of(3, gain=0.7), units=units)
    assert "adaptation.update: K is not of the unit '1/s'" in one.failures[0]


def bare(t, x, u, p):
    return p.k * u[0]


@pytest.mark.parametrize("output", [bare, root, large_constant])
def test_good_user_blocks_pass(output):
    """Without a docstring, finite for half of the random inputs, of 2^70 too."""
    compare_backends(static(output, 1, parameters={"k": 2.0}))


def test_a_block_too_large_for_sympy_is_told_so():
    block = linear(
        control.ss(-np.eye(150), np.ones((150, 1)), np.ones((1, 150)), 0, name="long")
    )
    with pytest.raises(
        BlockError, match=r"long\.update takes more than 20000 operations"
    ):
        readings(block)["symbolic"](0.0, np.ones(150), [1.0])


def test_an_untraced_function_is_refused_by_each_backend_of_records():
    block = static(lambda t, x, u, p: np.roots([1.0, u[0]]).real, 1)
    asked = readings(block)
    for name in asked.keys() - {"python", "control"}:
        with pytest.raises(ClptError, match=r"mine\.output: .*line \d+"):
            asked[name](0.0, [], [1.0])


# --- alone in a diagram of python-control, with call-time parameters ----------------------------


def alone(block):
    ports = {"inputs": block.input_labels, "outputs": block.output_labels}
    for end, labels in (("inplist", ports["inputs"]), ("outlist", ports["outputs"])):
        ports[end] = [f"{block.name}.{label}" for label in labels]
    return control.interconnect([block], connections=False, check_unused=False, **ports)


@pytest.mark.parametrize("block", EACH)
def test_alone_in_a_diagram_it_gives_the_same_and_parameters_reach_it(block):
    diagram = alone(block)
    for sample in random_samples(block, 0, 3):
        calls = {"update": diagram.dynamics, "output": diagram.output}
        for role in calls.keys() & roles(block):
            given = calls[role](sample.t, sample.x, sample.u)
            ours = python_values(block, role, sample)
            assert not differ(given, ours, BACKEND).any(), role
    arguments = (sample.t, sample.x, sample.u)
    for field, value in block.parameters._asdict().items():
        if isinstance(value, int):
            continue
        # zeros of a matrix may have to stay
        other = 1.25 * np.asarray(value) if np.any(value) else np.asarray(value) + 0.125
        is_whole = field in ("interval", "seed")
        changed = {f"{block.name}.{field}": 3.0 if is_whole else other[()]}
        arrived = block.with_params(changed)
        np.testing.assert_array_equal(
            getattr(arrived, field), changed[f"{block.name}.{field}"]
        )
        p = block.parameters_at(sample.t, arrived)
        try:
            calls = [
                system.output(*arguments, params=changed) for system in (block, diagram)
            ]
        except RuntimeError:
            # python-control takes NaN, as of a table too short, for a loop
            continue
        finally:
            block.output(*arguments)  # with its own parameters again
        ours = python_values(block, "output", sample._replace(p=p))
        assert not any(differ(given, ours, BACKEND).any() for given in calls), field
    for unknown in (
        f"{block.name}.no_such_field",
        "no_such_block.gain",
        "no_such_name",
    ):
        says(
            BlockError,
            "unknown parameter",
            block.output,
            *arguments,
            params={unknown: 1.0},
        )
    ours = block.output(*arguments)
    given = diagram.output(*arguments, params={"another_block.gain": 1.0})
    assert not differ(given, ours, BACKEND).any()
