"""An AUV turns in a current; its thrusters follow late.

    python examples/auv.py [FIGURE]

Surge, sway and yaw, two thrusters at the stern, an autopilot for speed and heading, a current along
x.  The table says what the lag of the thrusters costs; FIGURE (default: auv.png) shows
tracks and headings.
Source: Fossen 2011, Handbook of Marine Craft Hydrodynamics and Motion Control, sections 7.1, 12.2.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt
from clpt_control import parts

LAGS = (0.1, 0.5, 1.0, 2.0)  # s
TIMES = np.linspace(0, 60, 601)  # s
ARM = 0.2  # m, of each thruster
TURN = np.radians(90)
# kg, kg m, kg m^2, with added mass
MASS = np.array([[50.0, 0, 0], [0, 90, 2], [0, 2, 12]])
LINEAR, SQUARE = np.diag([10.0, 60, 8]), np.diag([20.0, 100, 20])
CURRENT = (0.2, 0.0)  # m/s, along x and y


def autopilot(t, x, u, p):
    """Forces for a speed and a heading, split over port and starboard."""
    off = p.heading - u.eta[2]
    surge = p.k_speed * (p.speed - u.nu[0]) + 10 * p.speed + 20 * p.speed**2
    yaw = p.k_heading * np.arctan2(np.sin(off), np.cos(off)) - p.k_rate * u.nu[2]
    return [(surge + yaw / ARM) / 2, (surge - yaw / ARM) / 2]


def loop(lag):
    """Wire autopilot, thrusters and vehicle; the current comes from outside."""
    pilot = clpt.Block(
        "autopilot",
        output=autopilot,
        inputs={"eta": 3, "nu": 3},
        outputs={"thrust": 2},
        parameters={"heading": TURN, "speed": 0.8, "k_speed": 60.0, "k_heading": 12.0}
        | {"k_rate": 16.0},
    )
    return clpt.connect(
        [
            pilot,
            parts.thrusters(
                [(-0.7, -ARM), (-0.7, ARM)], [0, 0], low=-25, high=40, lag=lag
            ),
            parts.planar_vehicle(MASS, LINEAR, SQUARE),
        ],
        external="flow",
        name="auv",
    )


@plt.style.context("clpt_control.data.house")
def main(path="auv.png"):
    """Run for each lag, print, draw."""
    figure, (track, heading) = plt.subplots(1, 2, figsize=(7.2, 3.6))
    print(
        "| lag (s) | overshoot (degrees) | within 2 degrees after (s) | surge at the end (m/s) |"
    )
    print("|---|---|---|---|")
    for lag in LAGS:
        run = clpt.simulate(loop(lag), TIMES, list(CURRENT))
        psi = np.degrees(run.eta[:, 2].values)
        outside = np.flatnonzero(np.abs(psi - 90) > 2)
        settled = TIMES[outside[-1]]
        print(
            f"| {lag:g} | {max(psi.max() - 90, 0):.1f} | "
            f"{f'{settled:.0f}' if settled < TIMES[-2] else 'never'} | {float(run.nu[-1, 0]):.3f} |"
        )
        early = run.eta.sel(time=slice(0, 25))
        track.plot(early[:, 0], early[:, 1], lw=1.2)
        heading.plot(TIMES, psi, lw=1.2, label=f"{lag:g} s")
    heading.axhline(90, color="k", ls=":", lw=1)
    track.set(xlabel="x (m)", ylabel="y (m)", aspect="equal", title="first 25 s")
    heading.set(xlabel="time (s)", ylabel="heading (degrees)")
    heading.legend(
        frameon=False, fontsize=8, title="lag of thrust", ncols=2, loc="lower right"
    )
    figure.savefig(Path(path))
    plt.close(figure)
    print(f"Wrote {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
