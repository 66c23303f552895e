"""Flows that are known in closed form, on every engine and by both methods."""

import numpy as np
import pytest
from engine_runs import ENGINES, LANES, Each, Status, side_by_side
from user_laws import formula

from clpt_control import Block

N = 6  # copies of a flow, each with its rate
RATES, TIMES = np.linspace(0.5, 2.0, N), np.array([0.0, 0.3, 1.0, 1.7, 2.0])


def jumped(t, q, r, a, dwell=0.7):
    """Interval k from k dwell on: q is straight there and r a parabola."""
    k = 0
    while t > 0:
        h = min(t, dwell)
        q, r, t, k = q + a * k * h, r + k * (q * h + a * k * h**2 / 2), t - h, k + 1
    return q, r


def solved(q, r):
    """Where a flow is at t."""
    return eval(f"lambda t, q, r, a: ({q}, {r})", vars(np))


FLOWS = {  # rates of q and r, and where they are at t
    "rotation": (
        "-a*r",
        "a*q",
        solved("q*cos(a*t) - r*sin(a*t)", "q*sin(a*t) + r*cos(a*t)"),
    ),
    "saddle": ("a*q", "-a*r", solved("q*exp(a*t)", "r*exp(-a*t)")),
    "growth": ("a*q*(1 - q)", "a*r", solved("q/(q + (1 - q)*exp(-a*t))", "r*exp(a*t)")),
    "oscillator": (  # q'' = -a^2 q + cos t: the forced part and what starts freely
        "r",
        "-(a**2)*q + cos(t)",
        solved(
            "(q - 1/(a**2 - 1))*cos(a*t) + r/a*sin(a*t) + cos(t)/(a**2 - 1)",
            "-a*(q - 1/(a**2 - 1))*sin(a*t) + r*cos(a*t) - sin(t)/(a**2 - 1)",
        ),
    ),
    "jump": ("a*interval", "interval*q", jumped),
}


def states(engine, block, x0):
    lanes, count = (LANES, LANES + 3) if engine == "lanes" else (1, 1)
    runner = ENGINES.get(engine, ENGINES["unrolled"])(block)
    if engine == "python":
        return runner.run(x0, TIMES, rtol=1e-11, atol=1e-13).x
    runs = side_by_side(runner, lanes, np.tile(x0, (count, 1)), TIMES, rtol=1e-11)
    assert set(runs.status) == {Status.FINISHED}
    np.testing.assert_array_equal(runs.out, runs.out[:1].repeat(count, 0))
    return runs.out[0]


@pytest.mark.parametrize("engine", [*ENGINES, "lanes"])
@pytest.mark.parametrize("flow", FLOWS)
def test_flow(flow, engine):
    *rates, exact = FLOWS[flow]
    known, jumps = (
        {"a": RATES},
        {"breakpoints": Each("dwell")} if flow == "jump" else {},
    )
    known |= {"dwell": 0.7, "interval": -1.0} if jumps else {}
    q, r = (formula(text, "qr", known) for text in rates)
    update = lambda *at: {"q": q(*at), "r": r(*at)}  # noqa: E731
    own = {
        "states": {"q": "N", "r": "N"},
        "parameters": known,
        "shapes": {"a": "N"},
        **jumps,
    }
    x, y = np.linspace(0.2, 1.5, N), np.linspace(-1.0, 1.0, N)
    found = states(engine, Block(flow, update=update, **own), np.concatenate([x, y]))
    wanted = [np.concatenate(exact(t, x, y, RATES)) for t in TIMES]
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9)
