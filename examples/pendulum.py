"""An inverted pendulum on a cart, held up by LQR of what an observer sees.

    python examples/pendulum.py [FIGURE]

The cart's place and the angle are measured, speeds are estimated.  Gains are of the linear model at
the top, `clpt.linearize`; the run has the whole pendulum, a limited force and noise.  The table
says from which angles it is caught; FIGURE (default: pendulum.png) shows the runs.
Source: Astrom and Murray 2008, Feedback Systems, example 2.1.
"""

import sys
from pathlib import Path

import control
import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt
from clpt_control import parts

CART, BOB, LENGTH, GRAVITY = 1.0, 0.2, 0.5, 9.81  # kg, kg, m, m/s^2
ANGLES = (10.0, 30.0, 45.0, 55.0)  # degrees
TIMES = np.linspace(0, 6, 601)  # s
HELD = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0]])  # what is measured: place and angle


def motion(t, x, u, p):
    """(M + m) x'' + m l (th'^2 sin th - th'' cos th) = F, l th'' = g sin th + x'' cos th."""
    _, angle, speed, turning = x.q
    s, c = np.sin(angle), np.cos(angle)
    force = u.force[0] - p.bob * p.length * turning**2 * s
    pushed = (force + p.bob * GRAVITY * s * c) / (p.cart + p.bob * s**2)
    return [speed, turning, pushed, (GRAVITY * s + pushed * c) / p.length]


def measured(t, x, u, p):
    """Place and angle, with noise."""
    return x.q[:2] + u.n


def feedback(t, x, u, p):
    """F = -K x_hat."""
    return -p.K @ u.x_hat


def pendulum():
    """Make the pendulum: force, n -> y; angle 0 is upright."""
    return clpt.Block(
        "pendulum",
        update=motion,
        output=measured,
        inputs={"force": 1, "n": 2},
        outputs={"y": 2},
        states={"q": 4},
        parameters={"cart": CART, "bob": BOB, "length": LENGTH},
    )


def loop(limit=20.0):
    """Wire pendulum, observer, LQR, limited force and noise."""
    top = clpt.linearize(pendulum(), np.zeros(4), np.zeros(3))
    A, B = top.A, top.B[:, :1]
    K, _, _ = control.lqr(A, B, np.diag([4.0, 20, 1, 1]), [[0.1]])
    L, _, _ = control.lqe(
        A, np.eye(4), HELD, np.diag([0.1, 0.1, 10, 10]), 0.001 * np.eye(2)
    )
    gain = clpt.Block(
        "lqr",
        output=feedback,
        inputs={"x_hat": 4},
        outputs={"wanted": 1},
        parameters={"K": K},
    )
    return clpt.connect(
        [
            pendulum(),
            parts.observer(control.ss(A, B, HELD, 0), L, u="force"),
            gain,
            parts.saturation(-limit, limit, u="wanted", y="force"),
            parts.noise([0.002, 0.005], period=0.02, signals=2, seed=1),
        ],
        name="upright",
    )


@plt.style.context("clpt_control.data.house")
def main(path="pendulum.png"):
    """Run from several angles, print, draw."""
    system = loop()
    poles = clpt.linearize(system, np.zeros(8), [], t=0.0).poles()
    print(f"slowest pole of the linear loop {max(poles.real):.2f}/s")
    print("| starts at (degrees) | caught | largest force (N) | cart goes (m) |")
    print("|---|---|---|---|")
    figure, (angles, places) = plt.subplots(2, sharex=True, figsize=(6.4, 5))
    for angle in ANGLES:
        start = [0, np.radians(angle), 0, 0, 0, np.radians(angle), 0, 0]
        run = clpt.simulate(system, TIMES, initial_state=start)
        held = bool(abs(run.y[-100:, 1]).max() < 0.1)
        away = float(abs(run.y[:, 0]).max())
        print(
            f"| {angle:g} | {'yes' if held else 'no'} | {float(abs(run.force).max()):.1f} | "
            f"{f'{away:.2f}' if held else '-'} |"
        )
        style = {"lw": 1.2, "ls": "-" if held else ":", "label": f"{angle:g} degrees"}
        angles.plot(TIMES, np.degrees(run.y[:, 1]), **style)
        places.plot(TIMES, run.y[:, 0], **style)
    angles.set(ylabel="angle (degrees)", ylim=(-45, 60))
    places.set(ylabel="cart (m)", xlabel="time (s)", ylim=(-2, 3))
    angles.legend(frameon=False, fontsize=8, title="starts at")
    figure.savefig(Path(path))
    plt.close(figure)
    print(f"Wrote {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
