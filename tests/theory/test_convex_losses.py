"""Gradient flows of strictly convex losses, whose least point is none in closed form; and traps.

A strictly convex loss that grows without end has one least point: where its slopes are zero.  By
hand: slopes of one state that rise from below 0 to above 0; or a positive definite quadratic form
beside convex terms.  A trap has no least point, or others where nothing moves.  On an open set,
x > 0, V that grows without end at 0 keeps runs away from it, or a rate that is positive near 0.
"""

import numpy as np
import pytest

import clpt_control as clpt


def loop(rates, states="x"):
    return clpt.Block(
        "loop", update=lambda t, x, u, p: rates(x), states=dict.fromkeys(states, 1)
    )


def tilted(x):
    return np.tanh(x) - 0.5


def of_tilted(x):
    return np.log(np.cosh(x)) - x / 2


def logistic(s):
    return 1 / (1 + np.exp(s))


RIGHT = {  # rates, V, states
    "tilted log cosh": (lambda x: {"x": -tilted(x.x)}, lambda s: of_tilted(s.x), "x"),
    "a ridge": (
        lambda x: {"x": logistic(x.x) - x.x / 10},
        lambda s: np.log(1 + np.exp(-s.x)) + s.x**2 / 20,
        "x",
    ),
    "exp(x) + exp(-2 x)": (
        lambda x: {"x": 2 * np.exp(-2 * x.x) - np.exp(x.x)},
        lambda s: np.exp(s.x) + np.exp(-2 * s.x),
        "x",
    ),
    "two states apart": (
        lambda x: {"x": -tilted(x.x), "y": -3 * tilted(x.y)},
        lambda s: of_tilted(s.x) + of_tilted(s.y),
        "xy",
    ),
    "a quadratic form beside a convex term": (
        lambda x: {
            "x": -2 * x.x + x.y - np.tanh(x.x - x.y) - 1,
            "y": -2 * x.y + x.x + np.tanh(x.x - x.y),
        },
        lambda s: s.x**2 - s.x * s.y + s.y**2 + np.log(np.cosh(s.x - s.y)) + s.x,
        "xy",
    ),
    "a heavy ball": (
        lambda x: {"x": x.y, "y": -x.y - tilted(x.x)},
        lambda s: s.y**2 / 2 + of_tilted(s.x),
        "xy",
    ),
}
TRAPS = {
    "no least point": (
        lambda x: {"x": -logistic(-x.x)},
        lambda s: np.log(1 + np.exp(s.x)),
        "x",
    ),
    "a flat tail": (
        lambda x: {"x": 1 - np.tanh(x.x)},
        lambda s: np.log(np.cosh(s.x)) - s.x,
        "x",
    ),
    "falls without end": (
        lambda x: {"x": 2 - np.tanh(x.x)},
        lambda s: np.log(np.cosh(s.x)) - 2 * s.x,
        "x",
    ),
    "falls along a line": (
        lambda x: {"x": -2 * (x.x - x.y) - np.exp(x.x), "y": 2 * (x.x - x.y)},
        lambda s: (s.x - s.y) ** 2 + np.exp(s.x),
        "xy",
    ),
    "a line of rests": (
        lambda x: {"x": -tilted(x.x + x.y), "y": -tilted(x.x + x.y)},
        lambda s: of_tilted(s.x + s.y),
        "xy",
    ),
    "two wells": (
        lambda x: {"x": -4 * x.x**3 + 4 * x.x - 0.1},
        lambda s: s.x**4 - 2 * s.x**2 + s.x / 10,
        "x",
    ),
    "convex but flat below": (
        lambda x: {"x": -2 * (x.x - np.clip(x.x, -1, 1))},
        lambda s: (s.x - np.clip(s.x, -1, 1)) ** 2,
        "x",
    ),
    "another rest on the way": (
        lambda x: {"x": -tilted(x.x) * x.x**2},
        lambda s: of_tilted(s.x),
        "x",
    ),
    "a state outside V": (
        lambda x: {"x": -tilted(x.x), "y": x.y},
        lambda s: of_tilted(s.x),
        "xy",
    ),
    "a state that turns": (
        lambda x: {"x": x.y, "y": -tilted(x.x)},
        lambda s: s.y**2 / 2 + of_tilted(s.x),
        "xy",
    ),
    "a loss that time lifts": (
        lambda x: {"x": -tilted(x.x) * np.exp(-x.y), "y": 1 + 0 * x.y},
        lambda s: of_tilted(s.x),
        "xy",
    ),
}


@pytest.mark.parametrize("name", RIGHT)
def test_a_convex_loss_brings_the_flow_to_its_least_point(name):
    rates, V, states = RIGHT[name]
    verdict = clpt.lyapunov(loop(rates, states), V)
    assert (verdict.status, verdict.conclusion) == ("proved", "asymptotically stable")


@pytest.mark.parametrize("name", TRAPS)
def test_a_loss_without_one_least_point_shows_no_more_than_is_true(name):
    rates, V, states = TRAPS[name]
    verdict = clpt.lyapunov(loop(rates, states), V)
    assert verdict.conclusion != "asymptotically stable"
    if name not in ("convex but flat below", "two wells", "another rest on the way"):
        assert "rest" not in verdict.conclusion


def test_what_a_loss_below_zero_loses_is_not_bounded_by_its_start():
    # V(0) = 0 and V falls to log(cosh(atanh(1/2))) - atanh(1/2)/2 = -0.131
    block = clpt.Block(
        "loop",
        update=lambda t, x, u, p: {"x": -tilted(x.x) * (2 + np.sin(t**2))},
        states={"x": 1},
    )
    verdict = clpt.lyapunov(block, lambda s: of_tilted(s.x))
    assert "V(0)" not in verdict.sentence


def entropy(x):
    return x * np.log(x) - x + 1


def spring_and_barrier(x):
    return x**2 / 2 - np.log(x) - 0.5


def damped(x):
    return {"x": 1 / x.x - x.x - x.y, "y": x.x - 1 / x.x - x.y}


ABOVE = {"x": (0, None)}
OPEN_SETS = {  # rates, V, sets, the rest; then the conclusion
    "V keeps x away from 0": (
        lambda x: {"x": 1 / x.x - x.x},
        lambda s: spring_and_barrier(s.x),
        ABOVE,
        {"x": 1.0},
        "asymptotically stable",
    ),
    "with a state beside it": (
        damped,
        lambda s: spring_and_barrier(s.x) + s.y**2 / 2,
        ABOVE,
        {"x": 1.0},
        "asymptotically stable",
    ),
    "a turning one": (
        lambda x: {"x": -x.y, "y": x.x - 1 / x.x},
        lambda s: spring_and_barrier(s.x) + s.y**2 / 2,
        ABOVE,
        {"x": 1.0},
        "stable",
    ),
    "the rate keeps x away from 0": (
        lambda x: {"x": -np.log(x.x)},
        lambda s: entropy(s.x),
        ABOVE,
        {"x": 1.0},
        "asymptotically stable",
    ),
    "least where it is not said": (
        lambda x: {"x": -np.log(x.x), "y": -np.log(x.y)},
        lambda s: entropy(s.x) + entropy(s.y),
        ABOVE | {"y": (0, None)},
        None,
        "asymptotically stable",
    ),
    "Volterra, least where it is not said": (
        lambda x: {"x": x.x * (1 - x.y), "y": x.y * (x.x - 1)},
        lambda s: s.x - np.log(s.x) + s.y - np.log(s.y),
        ABOVE | {"y": (0, None)},
        None,
        "stable",
    ),
    # traps: y falls to 0 in the time 1/2, which V does not see
    "another state leaves": (
        lambda x: {"x": 1 / x.x - x.x, "y": -1 / x.y},
        lambda s: spring_and_barrier(s.x),
        ABOVE | {"y": (0, None)},
        {"x": 1.0},
        "",
    ),
    # x passes 1.2 from (1, -1), which V does not see
    "an upper end": (
        damped,
        lambda s: spring_and_barrier(s.x) + s.y**2 / 2,
        {"x": (0, 1.2)},
        {"x": 1.0},
        "",
    ),
    # x' = -1 - 1/x reaches 0, where V is 1
    "V has an end at 0": (
        lambda x: {"x": -1 - 1 / x.x},
        lambda s: (s.x + 1) ** 2 + 0 * np.log(s.x),
        ABOVE,
        None,
        "",
    ),
    # V is least at 0, which is no state
    "least at the end": (
        lambda x: {"x": -x.x * (1 + np.log(1 + x.x))},
        lambda s: s.x + s.x * np.log(1 + s.x),
        ABOVE,
        None,
        None,
    ),
}


@pytest.mark.parametrize("name", OPEN_SETS)
def test_V_or_a_rate_keeps_an_open_set(name):
    rates, V, sets, rest, conclusion = OPEN_SETS[name]
    states = "xy" if "y" in (*V.__code__.co_names, *sets) else "x"
    verdict = clpt.lyapunov(loop(rates, states), V, where=sets, at=rest)
    if conclusion is None:
        assert verdict.conclusion not in ("asymptotically stable", "stable")
    else:
        assert verdict.conclusion == conclusion
