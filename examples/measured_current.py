"""Learn a measured current: fit it, run it, and ask what was learned.

    python examples/measured_current.py CURRENTS.nc [FOLDER]

CURRENTS.nc is a gridded current such as the HF-radar file of 1 January 2019
(MARACOOS, 6 km, hourly).  The box is on Nantucket Shoals, where a rotary M2
tide of 0.6 m/s runs.  The field itself is the true flow; the learner has 27
basis functions and starts without theta.  It is run with the paper's law, with the gain 0, that
is without learning, and with the law that `clpt fit` writes; FOLDER (default: out) gets the
scenario, its field and one picture.
"""

import sys
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt
from clpt_control.currents import explained_variance, fit_current, flow_velocity

BOX = (40.9, 41.55, -69.9, -69.0)
LATE = (18.0, 23.0)  # h
# Okabe and Ito, safe for the colour-blind
BLUE, ORANGE, GREY = ("#0072B2", "#D55E00", "#555555")


def late_rms(run):
    """Root mean square of the CLPE over the last hours, km."""
    late = run.clpe.sel(time=slice(*LATE))
    return float(np.sqrt((late**2).sum("axis").mean()))


def learned_flow(scenario, run):
    """Flow the learner assigns to the vehicle's place at each time, km/h."""
    estimate = run.flow_parameters_estimate.values
    return flow_velocity(scenario, run.position.values, run.time.values, estimate)


def draw(scenario, runs, path):
    """Draw the track with both currents along it, and the prediction errors."""
    learning, without = runs
    fig, (plane, error) = plt.subplots(
        1, 2, figsize=(10, 5.4), width_ratios=(1.25, 1), layout="constrained"
    )
    track, every = learning.position.values, slice(0, None, 5)
    plane.plot(*track.T, color="0.6", lw=1.2, label="track", zorder=1)
    plane.plot(*scenario.waypoints.T, "k+", ms=9, label="waypoints", zorder=2)
    plane.plot(*track[0], "ko", ms=5, label="start", zorder=3)
    for flow, colour, label, width in (
        (learning.true_flow.values, BLUE, "true current", 0.0055),
        (learned_flow(scenario, learning), ORANGE, "learned current", 0.003),
    ):
        arrows = plane.quiver(
            *track[every].T,
            *flow[every].T,
            color=colour,
            width=width,
            angles="xy",
            scale_units="xy",
            scale=1.0,
            label=label,
            zorder=4,
        )
    plane.quiverkey(arrows, 0.82, 0.05, 2.0, "2 km/h", labelpos="W", color=GREY)
    plane.set(
        xlabel="x1, east of the origin (km)", ylabel="x2, north of the origin (km)"
    )
    plane.set_title("Current along the track, each half hour", fontsize=10)
    plane.set_aspect("equal")
    tips = np.vstack([track, track + learning.true_flow.values, scenario.waypoints])
    low, high = tips.min(axis=0) - 1.5, tips.max(axis=0) + 1.5
    plane.set(xlim=(low[0], high[0]), ylim=(low[1] - 2.0, high[1]))
    plane.legend(loc="center", fontsize=8, frameon=False)

    for run, colour, style, label in (
        (without, GREY, "--", "without learning (gain 0)"),
        (learning, ORANGE, "-", f"learning (gain {scenario.learning.gain:g})"),
    ):
        size = np.hypot(*run.clpe.values.T)
        error.semilogy(run.time[1:], size[1:], style, color=colour, lw=1.5, label=label)
    error.axvspan(*LATE, color="0.9", zorder=0)
    error.text(
        np.mean(LATE),
        0.97,
        "rms window",
        ha="center",
        va="top",
        fontsize=8,
        transform=error.get_xaxis_transform(),
    )
    error.set(
        xlabel="time since the first measurement (h)",
        ylabel="CLPE |x - z| (km)",
        xlim=(0, scenario.run.duration),
    )
    error.set_title("Controlled Lagrangian prediction error", fontsize=10)
    error.grid(alpha=0.3)
    error.legend(loc="lower right", fontsize=8)
    fig.savefig(path, dpi=150)
    plt.close(fig)


def main(currents, folder="out"):
    """Fit, run, print and draw."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    fit = fit_current(
        currents, BOX, rows=3, columns=3, width_km=15.0, constituents=("steady", "M2")
    )
    fitted = fit.save(folder / "measured_current.toml")
    scenario = fitted.with_values({"learning.law": "learned-flow"})  # the paper's
    report = fit.report
    print(
        f"{report['functions']} functions fitted to {report['samples']} samples explain "
        f"{report['explained_variance']:.1%} of the variance; residual rms "
        f"{report['residual_rms']:.2f}, at most {report['residual_max']:.2f} km/h"
    )
    print(
        f"{report['missing_fraction']:.1%} of the samples were missing and are filled"
    )
    runs = [
        clpt.simulate(
            scenario.with_values({"learning.gain": gain, "run.output_step": 0.1})
        )
        for gain in (scenario.learning.gain, 0.0)
    ]
    rms = [late_rms(run) for run in runs]
    print(
        f"CLPE rms over {LATE[0]:g} to {LATE[1]:g} h: learning {rms[0]:.4f} km, without "
        f"{rms[1]:.3f} km, ratio {rms[0] / rms[1]:.4f}"
    )
    shares = explained_variance(scenario, runs[0])
    day = explained_variance(scenario, runs[0], (0.0, scenario.run.duration))
    print(
        f"the learned flow explains {shares['track']:.1%} of the current's variance along the "
        f"track from {shares['window'][0]:g} h on ({day['track']:.1%} over the whole run) and "
        f"{shares['box']:.1%} over the box"
    )
    gains = ", ".join(
        f"{name} {runs[0][key].values[-1].round(2)}"
        for name, key in (("K", "feedback_gain"), ("Gamma", "feedforward_gain"))
    )
    print(
        f"a small prediction error is not a right flow: the gains drifted from 1 to {gains}"
    )
    started = {"learning.parameters": [[-a for a in row] for row in report["theta"]]}
    told = scenario.with_values(started)
    run = clpt.simulate(told)
    shares = explained_variance(told, run)
    print(
        f"a learner that starts at the fitted theta: CLPE rms {late_rms(run):.4f} km, and its flow "
        f"explains {shares['track']:.1%} along the track and {shares['box']:.1%} over the box"
    )
    run = clpt.simulate(fitted)
    shares = explained_variance(fitted, run)
    print(
        f"{fitted.learning.law}: CLPE rms {late_rms(run):.4f} km, and its flow "
        f"explains {shares['track']:.1%} along the track and {shares['box']:.1%} over the box"
    )
    draw(scenario, runs, folder / "measured_current.png")
    print(f"Wrote {folder / 'measured_current.png'}")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    mpl.use("Agg")
    try:
        main(*sys.argv[1:])
    except clpt.ClptError as problem:
        sys.exit(str(problem))
