"""What does each part of the shelf do, and how far is it from its closed form?

    python -m analysis.shelf [--out FOLDER]

Runs every part of `clpt.parts` once.  FOLDER (default: shelf) gets parts.png, a panel for each, and
parts.md, the largest difference from a closed form of what is drawn, where there is one.
"""

import argparse
from pathlib import Path
from typing import Any

import control
import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt
from clpt_control import parts

T = np.linspace(0.0, 10.0, 1001)  # s
WAVE = 1.5 * np.sin(T)
RAMP = np.linspace(-2.0, 2.0, 401)
TIGHT: dict[str, Any] = {"rtol": 1e-10, "atol": 1e-12}


def ran(block, u, start=None, name="y"):
    """Return an output along T, of inputs that are given."""
    given: dict[str, Any] = {} if block.dt else TIGHT
    times = np.arange(0.0, 10.0, block.dt) if block.dt else T
    at = [np.interp(times, T, one) if np.ndim(one) else one for one in u]
    run = clpt.simulate(
        block, times, np.array(np.broadcast_arrays(*at, times)[:-1]), start, **given
    )
    return times, run[name].values.squeeze()


def static(block, exact):
    """Return the panel of a part without memory, y over u."""
    y = np.array([block.output(0, [], [u])[0] for u in RAMP])
    return [(RAMP, RAMP, "k:"), (RAMP, y, "C0")], np.abs(y - exact).max()


def saturation():
    """A limit."""
    return static(parts.saturation(-1, 1), np.clip(RAMP, -1, 1))


def dead_zone():
    """A gap."""
    return static(
        parts.dead_zone(-1, 1), np.sign(RAMP) * np.maximum(np.abs(RAMP) - 1, 0)
    )


def lookup_table():
    """A table."""
    at, values = [-2, -0.5, 0.5, 2], [0, -1, 1, 1.5]
    lines, off = static(parts.lookup_table(at, values), np.interp(RAMP, at, values))
    return [(at, values, "ko"), *lines[1:]], off


def rate_limit():
    """A limited rate, after a step."""
    _, y = ran(parts.rate_limit(0.4, lag=0.2), [1.5])
    end = 1.5 / 0.4 - 0.2
    exact = np.where(end > T, 0.4 * T, 1.5 - 0.08 * np.exp(-(T - end) / 0.2))
    return [(T, 0 * T + 1.5, "k:"), (T, y, "C0")], np.abs(y - exact).max()


def backlash():
    """Teeth with a gap, sampled and continuous."""
    _, y = ran(parts.backlash(1.0, lag=0.05), [WAVE])
    times, play = ran(parts.backlash(1.0, dt=0.25), [WAVE])
    return [(T, WAVE, "k:"), (T, y, "C0"), (times, play, "C1.")], None


def relay():
    """A switch with hysteresis."""
    _, y = ran(parts.relay(0.7, -0.7, lag=1e-3), [WAVE])
    on = np.arcsin(0.7 / 1.5)
    exact = np.where((np.mod(T - on, 2 * np.pi) < np.pi) & (on < T), 1.0, -1.0)
    away = np.abs(np.mod(T - on + 1, np.pi) - 1) > 0.02
    return [(T, WAVE, "k:"), (T, y, "C0")], np.abs(y - exact)[away].max()


def lag():
    """A lag of first order."""
    _, y = ran(parts.lag(2.0), [1.5])
    return [(T, 0 * T + 1.5, "k:"), (T, y, "C0")], np.abs(
        y - 1.5 * (1 - np.exp(-T / 2))
    ).max()


def delay():
    """A delay: Pade of order 6, and sampled."""
    _, y = ran(parts.delay(2.0, 6), [WAVE])
    times, exact = ran(parts.delay(2.0, dt=0.25), [WAVE])
    late = np.interp(times - 2.0, T, WAVE, left=0.0)
    return [(T, WAVE, "k:"), (T, y, "C0"), (times, exact, "C1.")], np.abs(
        exact - late
    ).max()


def hold():
    """A sample, held."""
    y = ran(
        clpt.connect([parts.hold(0.8), parts.lag(1.0, u="y", y="v")], external="u"),
        [WAVE],
    )[1]
    k = np.floor(T / 0.8 + 1e-9)
    return [(T, WAVE, "k:"), (T, y, "C0")], np.abs(
        y - np.interp(0.8 * k, T, WAVE)
    ).max()


def pid():
    """A PID with limits and an integrator: with anti-windup, and without."""
    lines: list[Any] = [(T, 0 * T + 3, "k:")]
    for tracking, style in ((1.0, "C0"), (np.inf, "C1--")):
        tank = control.ss(0, 1, 1, 0, inputs="u", outputs="y", name="tank")
        controller = parts.pid(2.0, 1.0, low=-1, high=1, tracking=tracking)
        run = clpt.simulate(clpt.connect([controller, tank], external="r"), T, 3.0)
        lines.append((T, run.y.values, style))
    return lines, None


PLANT = control.ss(
    [[0, 1], [-1, -0.2]], [[0], [1]], [[1, 0]], 0, inputs="u", outputs="y", name="p"
)


def observer():
    """What an observer thinks of a speed."""
    L = control.place(PLANT.A.T, PLANT.C.T, [-1, -1.5]).T
    loop = clpt.connect([PLANT, parts.observer(PLANT, L)], external="u")
    run = clpt.simulate(loop, T, [0 * T], [1.0, 1.0, 0, 0], **TIGHT)
    error = run.states.values[:, 1] - run.x_hat.values[:, 1]
    M = PLANT.A - L @ PLANT.C
    exact = control.initial_response(
        control.ss(M, PLANT.B, [[0, 1]], 0), T, [1.0, 1.0]
    ).y
    lines = [(T, run.states.values[:, 1], "k:"), (T, run.x_hat.values[:, 1], "C0")]
    return lines, np.abs(error - exact.squeeze()).max()


def kalman_filter():
    """A value seen with noise, and how sure the filter is of it."""
    n = clpt.simulate(
        parts.noise(0.5, 0.1, seed=1), np.arange(100) * 0.1 + 0.05
    ).n.values
    seen = np.interp(T, np.arange(100) * 0.1, 1.0 + n)
    filter = parts.kalman_filter(
        control.ss(1, 1, 1, 0, 0.1), [[4e-3]], [[0.25]], [[1.0]]
    )
    times, x = ran(filter, [0.0, seen], name="x_hat")
    _, P = ran(filter, [0.0, seen], name="P")
    _, settled, _ = control.dlqe([[1.0]], [[1.0]], [[1.0]], [[4e-3]], [[0.25]])
    posterior = settled[0, 0] * 0.25 / (settled[0, 0] + 0.25)
    lines = [(times, 1.0 + n, "k."), (times, x, "C0")]
    lines += [(times, x + sign * 2 * np.sqrt(P), "C0:") for sign in (1, -1)]
    return lines, abs(P[-1] - posterior)


def noise():
    """Numbers drawn anew each 0.2 s."""
    y = clpt.simulate(parts.noise(0.7, 0.2, seed=2), T).n.values
    return [(T, y, "C0")], None


def point_vehicle():
    """A force against drag."""
    _, v = ran(parts.point_vehicle(1.0, 0.0, 0.5, axes=1), [0.5, 0.0], name="v")
    return [(T, 0 * T + 1, "k:"), (T, v, "C0")], np.abs(v - np.tanh(0.5 * T)).max()


def planar_vehicle():
    """A turn in a current, seen from above."""
    auv = parts.planar_vehicle(np.diag([60, 90, 20]), np.diag([30, 60, 20]))
    lines: list[Any] = []
    for current, style in ((0.0, "k:"), (0.1, "C0")):
        run = clpt.simulate(auv, 6 * T, [15, 0, 2, current, 0])
        lines.append((*run.eta[:, :2].values.T, style))
    return lines, None


def thrusters():
    """Two thrusters: their force, and their moment."""
    pair = parts.thrusters([(-0.8, -0.2), (-0.8, 0.2)], [0, 0], -10, 20, lag=1.0)
    tau = clpt.simulate(pair, T, [20, 5], **TIGHT).tau.values
    exact = np.outer(1 - np.exp(-T), [25, 0, 3])
    return [(T, tau[:, 0], "C0"), (T, tau[:, 2], "C1--")], np.abs(tau - exact).max()


PANELS: tuple[Any, ...] = (
    *(
        saturation,
        dead_zone,
        lookup_table,
        rate_limit,
        backlash,
        relay,
        lag,
        delay,
        hold,
        pid,
    ),
    *(observer, kalman_filter, noise, point_vehicle, planar_vehicle, thrusters),
)


@plt.style.context("clpt_control.data.house")
def main(out="shelf"):
    """Draw a panel for each part, and write the differences."""
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    count = -(-len(PANELS) // 2)  # two beside each other: for a telephone
    figure, axes = plt.subplots(count, 2, figsize=(4.8, 1.45 * count))
    for ax in axes.flat[len(PANELS) :]:
        ax.remove()
    rows = [
        "| part | drawn | largest difference from its closed form |",
        "|---|---|---|",
    ]
    for panel, ax in zip(PANELS, axes.flat, strict=False):
        lines, off = panel()
        for x, y, style in lines:
            ax.plot(x, y, style, lw=1.2, ms=3)
        ax.set_title(panel.__name__, fontsize=9)
        ax.set_xlabel("u" if panel in PANELS[:3] else "time (s)", fontsize=8)
        if panel is planar_vehicle:
            ax.set(xlabel="x (m)", aspect="equal", adjustable="datalim")
            ax.set_ylabel("y (m)", fontsize=8)
        ax.tick_params(labelsize=8)
        told = "" if off is None else f"{off:.1e}"
        rows.append(f"| `{panel.__name__}` | {panel.__doc__} | {told} |")
    (folder / "parts.md").write_text("\n".join(rows) + "\n", "utf-8")
    figure.savefig(folder / "parts.png", dpi=150)
    plt.close(figure)
    print(f"{folder}: parts.md and parts.png written")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--out", default="shelf", help="folder for the table and the figure"
    )
    main(parser.parse_args().out)
