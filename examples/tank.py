"""A sampled PID holds the level of a tank, through a pipe and a valve with limits.

    python examples/tank.py [FIGURE]

A tank drains by its own weight; the controller samples each 2 s, the valve opens from 0 to 1, and
water comes 6 s late.  The table compares what winds up with what does not, and a controller that
takes no heed of the pipe; FIGURE (default: tank.png) shows levels and valves.
Source: Astrom and Murray 2008, Feedback Systems, sections 10.3 to 10.5.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt
from clpt_control import parts

DT, LATE = 2.0, 6.0  # s
TIMES = np.arange(0, 601, 1.0)  # s
WANTED = np.where(TIMES < 300, 1.0, 0.6)  # m
AREA, HOLE, MOST = 0.5, 0.005, 0.025  # m^2, m^2, m^3/s


def level(t, x, u, p):
    """A h' = q_max u - a (2 g h)^0.5."""
    out = p.hole * np.sqrt(2 * 9.81 * np.maximum(x.h, 0.0))
    return (p.most * u.inflow - out) / p.area


def loop(kp, ki, kd, tracking=None, late=LATE):
    """Wire controller, pipe and tank; the wanted level comes from outside."""
    numbers = {"area": AREA, "hole": HOLE, "most": MOST}
    own = {"low": 0.0, "high": 1.0, "tracking": tracking, "filter": 4.0}
    return clpt.connect(
        [
            parts.pid(kp, ki, kd, **own, dt=DT, r="wanted", y="h", u="valve"),
            parts.delay(late, dt=DT, u="valve", y="inflow"),
            clpt.Block(
                "tank",
                update=level,
                inputs={"inflow": 1},
                states={"h": 1},
                parameters=numbers,
            ),
        ],
        external="wanted",
        name="level",
    )


CASES = {
    "with anti-windup": {"kp": 1.8, "ki": 0.05, "kd": 4.0},
    "without": {"kp": 1.8, "ki": 0.05, "kd": 4.0, "tracking": np.inf},
    "gains of a shorter pipe": {"kp": 5.0, "ki": 0.12, "kd": 12.0},
}


@plt.style.context("clpt_control.data.house")
def main(path="tank.png"):
    """Run each controller, print, draw."""
    figure, (levels, valves) = plt.subplots(2, sharex=True, figsize=(6.4, 5))
    levels.plot(TIMES, WANTED, "k--", lw=1, label="wanted")
    print("| controller | overshoot (m) | within 0.02 m after (s) | mean error (m) |")
    print("|---|---|---|---|")
    for name, gains in CASES.items():
        run = clpt.simulate(loop(**gains), TIMES, [WANTED])
        h = run.h.values.ravel()
        off = np.abs(h - WANTED)
        outside = np.flatnonzero(off[:300] > 0.02)
        print(
            f"| {name} | {max(h.max() - 1, 0):.3f} | "
            f"{f'{outside[-1] + 1}' if outside[-1] < 299 else 'never'} | {off.mean():.3f} |"
        )
        levels.plot(TIMES, h, lw=1.2, label=name)
        valves.step(TIMES, run.valve, lw=1, where="post", label=name)
    levels.set(ylabel="level (m)")
    valves.set(ylabel="valve", xlabel="time (s)")
    levels.legend(frameon=False, fontsize=8)
    figure.savefig(Path(path))
    plt.close(figure)
    print(f"Wrote {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
