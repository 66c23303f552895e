"""Model-reference adaptive control of a plant that is not known, proved and run.

    python examples/mrac.py [FIGURE]

The textbook's loop: y' = -a y + b v with a and b unknown shall follow ym' = -2 ym + 2 r.  The
table says how the adaptation gain trades the first error against the last; FIGURE (default:
mrac.png) shows the responses, and the error over adaptation gain and b.
Source: Astrom and Wittenmark 1995, Adaptive Control, chapter 5.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt

GAINS = (0.2, 1.0, 5.0)
TIMES = np.linspace(0, 100, 2001)  # s


def plant(t, x, u, p):
    """y' = -a y + b v."""
    return -p.a * x.y + p.b * u.v


def model(t, x, u, p):
    """ym' = -2 ym + 2 r."""
    return -2 * x.ym + 2 * u.r


def controller(t, x, u, p):
    """v = k_r r - k_y y, e = y - ym, and what is learned."""
    return {"v": x.k_r * u.r - x.k_y * u.y, "e": u.y - u.ym, "k_r": x.k_r, "k_y": x.k_y}


def learning(t, x, u, p):
    """k_r' = -gamma r e, k_y' = gamma y e."""
    e = u.y - u.ym
    return {"k_r": -p.gain * u.r * e, "k_y": p.gain * u.y * e}


def loop(gain=1.0):
    """Wire plant, model and adaptive controller; r comes from outside."""
    numbers = {"a": 1.0, "b": 0.5}
    return clpt.connect(
        [
            clpt.Block(
                "plant",
                update=plant,
                inputs={"v": 1},
                states={"y": 1},
                parameters=numbers,
            ),
            clpt.Block("model", update=model, inputs={"r": 1}, states={"ym": 1}),
            clpt.Block(
                "adaptation",
                update=learning,
                output=controller,
                inputs={"r": 1, "y": 1, "ym": 1},
                states={"k_r": 1, "k_y": 1},
                outputs={"v": 1, "e": 1, "k_r": 1, "k_y": 1},
                parameters={"gain": gain},
            ),
        ],
        external="r",
        name="mrac",
    )


def V(s):
    """V = e^2/2 + b/(2 gamma) ((k_r - 2/b)^2 + (k_y - (2 - a)/b)^2)."""
    off = (s.adaptation_k_r - 2 / s.b) ** 2 + (s.adaptation_k_y - (2 - s.a) / s.b) ** 2
    return s.e**2 / 2 + s.b / (2 * s.gain) * off


@plt.style.context("clpt_control.data.house")
def main(path="mrac.png"):
    """Prove, run for each gain, print, draw."""
    judged = clpt.lyapunov(loop(), V)
    print(f"V' = {judged.rate}: {judged.status}")
    r = np.sign(np.sin(2 * np.pi * TIMES / 40) + 1e-9)
    runs = {gain: clpt.simulate(loop(gain), TIMES, [r]) for gain in GAINS}
    print("| gain | rms error, first 20 s | rms error, last 20 s | k_r (4) | k_y (2) |")
    print("|---|---|---|---|---|")
    for gain, run in runs.items():
        first, last = (
            float(np.sqrt((run.e.sel(time=slice(*span)) ** 2).mean()))
            for span in ((0, 20), (80, 100))
        )
        k_r, k_y = float(run.k_r[-1]), float(run.k_y[-1])
        print(f"| {gain:g} | {first:.3f} | {last:.4f} | {k_r:.2f} | {k_y:.2f} |")
    over = {
        "adaptation.gain": np.geomspace(0.2, 5, 9),
        "plant.b": np.linspace(0.25, 1, 7),
    }
    swept = clpt.run_ensemble(loop(), over, timepts=TIMES, inputs=r).unstack()
    figure, axes = plt.subplot_mosaic(
        [["y", "sweep"], ["k", "sweep"]], figsize=(8.4, 4.6)
    )
    top, bottom = axes["y"], axes["k"]
    swept.e_rms.plot.contourf(
        x="adaptation.gain", ax=axes["sweep"], xscale="log", cmap="viridis"
    )
    top.plot(TIMES, next(iter(runs.values())).ym, "k--", lw=1, label="model")
    for gain, run in runs.items():
        top.plot(TIMES, run.y, lw=1, label=f"gain {gain:g}")
        bottom.plot(TIMES, run.k_r, lw=1, label=f"gain {gain:g}")
    bottom.axhline(4, color="k", ls=":", lw=1)
    top.set(ylabel="y")
    top.sharex(bottom)
    axes["sweep"].set(xlabel="adaptation gain", ylabel="b of the plant")
    axes["sweep"].set_xticks(GAINS, [f"{gain:g}" for gain in GAINS])
    axes["sweep"].minorticks_off()
    bottom.set(ylabel="k_r (right: 4)", xlabel="time (s)")
    top.legend(
        frameon=False,
        ncols=4,
        fontsize=7,
        loc="lower center",
        bbox_to_anchor=(0.5, 1.0),
    )
    figure.savefig(Path(path))
    plt.close(figure)
    print(f"Wrote {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
