"""A pendulum with a proof and a guaranteed run: what both say, beside runs.

    python examples/proved_swing.py [FIGURE]

Left: `clpt.lyapunov` finds V and proves that each run that begins where V is below a level comes
to rest; runs from beside its border.  Right: `clpt.enclose` bounds every run from angles of 1.9 to
2.1 rad with a damping of 0.45 to 0.55 1/s; runs from its corners.  FIGURE: default swing.png.
"""

import sys
from itertools import product
from pathlib import Path

import control
import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt

TIMES = np.linspace(0, 4, 161)  # s
BOX = {"angle": (-3.0, 3.0), "rate": (-6.0, 6.0)}
ANGLES, DAMPINGS = (1.9, 2.1), (0.45, 0.55)


def swing(t, x, u, params):
    """angle'' = -g sin(angle) - d angle' + torque."""
    return [x[1], -params["g"] * np.sin(x[0]) - params["d"] * x[1] + u[0]]


def pendulum():
    """Make the pendulum of the README."""
    return control.nlsys(
        swing,
        states=["angle", "rate"],
        inputs=["torque"],
        outputs=["angle", "rate"],
        params={"g": 9.81, "d": 0.5},
        name="pendulum",
    )


def draw_region(ax):
    """Draw the region that is proved, and runs from beside its border."""
    verdict = clpt.lyapunov(pendulum(), within=BOX)
    print(verdict)
    angle, rate = np.meshgrid(np.linspace(-3.2, 3.2, 321), np.linspace(-6.5, 6.5, 261))
    V = rate**2 / 2 + 9.81 * (1 - np.cos(angle))
    ax.contourf(angle, rate, V, [0.0, verdict.level], colors=["#0072B2"], alpha=0.2)
    for turn in np.linspace(0, 2 * np.pi, 8, endpoint=False):
        size = 0.98 * verdict.level
        start = [
            np.arccos(1 - size * np.cos(turn) ** 2 / 9.81) * np.sign(np.cos(turn)),
            np.sqrt(2 * size) * np.sin(turn),
        ]
        run = clpt.simulate(pendulum(), TIMES, initial_state=start)
        ax.plot(*run.states.values.T, color="black", lw=0.7)
        ax.plot(*start, "o", color="#D55E00", ms=4)
    ax.set(xlabel="angle (rad)", ylabel="rate (rad/s)")
    ax.set_title(f"Proved: V < {verdict.level:.4g} comes to rest", loc="left", size=10)


def draw_tube(ax):
    """Draw the boxes of all runs, and those from the corners."""
    tube = clpt.enclose(
        pendulum(),
        TIMES,
        initial_state={"angle": ANGLES},
        params={"d": DAMPINGS},
        pieces=4,
    )
    print(tube.attrs["message"])
    box = tube.sel(name="angle[0]")
    between = {"step": "pre", "color": "#0072B2", "alpha": 0.25, "lw": 0}
    ax.fill_between(TIMES, box.over_lower, box.over_upper, **between, label="every run")
    for angle, damping in product(ANGLES, DAMPINGS):
        run = clpt.simulate(
            pendulum(), TIMES, initial_state=[angle, 0.0], params={"d": damping}
        )
        ax.plot(TIMES, run.angle, color="black", lw=0.7)
    ax.set(xlabel="time (s)", ylabel="angle (rad)")
    ax.set_title("Guaranteed: 1.9 to 2.1 rad, d within 10 %", loc="left", size=10)


@plt.style.context("clpt_control.data.house")
def main(path="swing.png"):
    """Prove, enclose, draw."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    draw_region(left)
    draw_tube(right)
    figure.savefig(Path(path), dpi=110)
    plt.close(figure)
    print(f"Wrote {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
