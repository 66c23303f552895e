"""How large does the error get under a disturbance: claimed, corrected, simulated?

The paper's system, started at the true parameters, under the square wave Delta =
(amplitude sign(sin(frequency t)), 0).  One sweep goes over the amplitude at 3.5
rad/s, near the resonance of adaptation and error; one over the frequency at
0.05 m/s.  From 400 s on, with k = lambda_min(KD):

    claimed        max|e| <= Dmax/k                          Eq. (33), beta -> k
    mean square    rms(e) <= rms(Delta)/k                    always
    corrected      max|e| <= T Dmax (1 + 1/(1 - sqrt(1 - rho)))
    worst          the largest |e| that any Delta of that size on this axis makes, for
                   the regressor of the undisturbed run

rho is the drop of V over a window of T = 200 s, the smaller of the windows 400-600
and 600-800 s of that very run (w holds z, which the disturbance moves).

    python -m analysis.disturbance_bounds [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated, Any, NamedTuple

import numpy as np
import typer

import clpt_control as clpt
from clpt_control.theory.theorems.counterexamples import printed_bound

from .mean_square import mean_square_bound
from .study import BLUE, COLOURS, GREEN, ORANGE, RED, leave, new_figure, progress_bar
from .worst_disturbance import worst_disturbance

# rad/s: near sqrt(gamma |w|^2) of the paper's x1 axis at its far waypoints
RESONANT = 3.5
AMPLITUDES = (0.01, 0.02, 0.05, 0.1, 0.15, 0.2)  # m/s
FREQUENCIES = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, RESONANT, 4.0, 4.5, 5.0, 6.0, 8.0)  # rad/s
AMPLITUDE = 0.05  # m/s, of the sweep over the frequency
START, WINDOW, END = 400.0, 200.0, 800.0  # s


class Row(NamedTuple):
    """One disturbance: its bounds and what was measured, in m."""

    amplitude: float
    frequency: float
    claimed: float
    peak: float
    rms: float
    tightness: float  # left over right side of the mean-square bound, at most
    worst: float
    exact: float


def row(amplitude: float, frequency: float, gain: float) -> Row:
    """Run one disturbance and measure it; gain is the worst |e|/Dmax."""
    wave = {
        "kind": "square",
        "amplitude": [amplitude, 0.0],
        "period": 2 * np.pi / frequency,
    }
    step = min(np.pi / frequency / 50, 0.02)
    scenario = (
        clpt.paper_scenario()
        .started_true()
        .with_values(
            {"flow.disturbance": wave, "run.duration": END, "run.output_step": step}
        )
    )
    run = clpt.simulate(scenario)
    found = printed_bound(scenario, run, START)
    windows = [
        clpt.gramian(run, WINDOW, start).certificate()
        for start in (START, END - WINDOW)
    ]
    exact = max(window.ultimate_bound(amplitude) for window in windows)
    return Row(
        amplitude,
        frequency,
        found.claimed,
        found.peak,
        found.rms * found.claimed,
        mean_square_bound(run, scenario).tightness,
        gain * amplitude,
        exact,
    )


def table(rows: list[Row]) -> str:
    """Write the rows as a Markdown table."""
    lines = [
        "| Dmax (m/s) | frequency (rad/s) | claimed, Eq. (33) (m) | simulated max abs(e) (m) | "
        "max/claimed | simulated rms(e) (m) | rms/(rms(Delta)/k) | mean-square sides, at most | "
        "worst of any Delta (m) | corrected, exact drop (m) | "
        "Eq. (33) |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    lines += [
        f"| {r.amplitude:g} | {r.frequency:g} | {r.claimed:.3f} | {r.peak:.4f} | "
        f"{r.peak / r.claimed:.3f} | {r.rms:.4f} | {r.rms / r.claimed:.3f} | {r.tightness:.3f} | "
        f"{r.worst:.4f} | {r.exact:.3g} | "
        f"{'violated' if r.peak > r.claimed else 'not violated'} |"
        for r in rows
    ]
    return "\n".join(lines) + "\n"


def figure(by_amplitude: list[Row], by_frequency: list[Row]) -> Any:
    """Draw both sweeps: above in units of the claim, below in metres."""
    picture, axes = new_figure(7.2, 6.0, nrows=2, ncols=2, sharex="col", sharey="row")
    sweeps = (
        (
            by_amplitude,
            [r.amplitude for r in by_amplitude],
            r"$\Delta_{\max}$ (m/s)",
            f"square wave at {RESONANT:g} rad/s",
        ),
        (
            by_frequency,
            [r.frequency for r in by_frequency],
            "frequency (rad/s)",
            rf"$\Delta_{{\max}}$ = {AMPLITUDE:g} m/s",
        ),
    )
    for (rows, x, label, title), (above, below) in zip(sweeps, axes.T, strict=True):
        above.plot(
            x, [r.peak / r.claimed for r in rows], "o-", color=BLUE, markersize=4
        )
        above.plot(
            x, [r.rms / r.claimed for r in rows], "^:", color=GREEN, markersize=4
        )
        above.plot(
            x,
            [r.worst / r.claimed for r in rows],
            "D--",
            color=COLOURS[4],
            markersize=3,
        )
        above.axhline(1.0, color=RED, linestyle="--", linewidth=1.4)
        for values, style, colour, name in (
            (
                [r.exact for r in rows],
                "s-.",
                ORANGE,
                "corrected bound on max|e|, exact drop",
            ),
            (
                [r.worst for r in rows],
                "D--",
                COLOURS[4],
                r"worst max|e| of any $\Delta$ that large",
            ),
            (
                [r.claimed for r in rows],
                "--",
                RED,
                r"$\Delta_{\max}/k$: claimed for max|e|, holds for rms(e)",
            ),
            ([r.peak for r in rows], "o-", BLUE, "simulated max|e|, 400-800 s"),
            ([r.rms for r in rows], "^:", GREEN, "simulated rms(e), 400-800 s"),
        ):
            below.semilogy(x, values, style, color=colour, markersize=4, label=name)
        above.set_title(title, loc="left", fontsize=10)
        below.set_xlabel(label)
    axes[0, 0].set(ylabel=r"|e| in units of $\Delta_{\max}/k$", ylim=(0, None))
    axes[1, 0].set_ylabel("|e| (m)")
    axes[0, 1].annotate(
        "Eq. (33) claims",
        (FREQUENCIES[-1], 1.0),
        xytext=(0, 3),
        ha="right",
        textcoords="offset points",
        fontsize=8,
        color=RED,
    )
    picture.legend(
        *axes[1, 0].get_legend_handles_labels(),
        fontsize=8,
        frameon=False,
        loc="outside lower center",
        ncols=2,
    )
    return picture


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/disturbance_bounds"),
) -> None:
    """Run both sweeps; leave disturbance_bounds.md and disturbance_bounds.png."""
    cases = list(
        dict.fromkeys(
            [(a, RESONANT) for a in AMPLITUDES] + [(AMPLITUDE, f) for f in FREQUENCIES]
        )
    )
    rows: list[Row] = []
    with progress_bar("bounds under a disturbance", len(cases)) as report:
        gain = worst_disturbance(clpt.paper_scenario(), START, END).peaks[0]
        for case in cases:
            rows.append(row(*case, gain))
            report(len(rows))
    drawn = figure(
        [r for r in rows if r.frequency == RESONANT],
        sorted(
            (r for r in rows if r.amplitude == AMPLITUDE), key=lambda r: r.frequency
        ),
    )
    leave(out, "disturbance_bounds", table(rows), drawn)
    typer.echo(table(rows))
    violated = sum(r.peak > r.claimed for r in rows)
    typer.echo(
        f"Eq. (33) is violated in {violated} of {len(rows)} runs, at worst by the factor "
        f"{max(r.peak / r.claimed for r in rows):.3f}; the mean-square bound in "
        f"{sum(r.tightness > 1 for r in rows)}, the corrected bound in "
        f"{sum(r.peak > r.exact for r in rows)}. "
        f"The worst disturbance on axis 1 makes |e| = {gain:.2f} Dmax."
    )


if __name__ == "__main__":
    typer.run(main)
