"""Which reading of Eq. (5) reproduces the claims of section IV?

The exponent of Eq. (5) is printed ambiguously, and section IV gives periods in
hours while time runs in seconds.  Each kernel is run with the periods in the
scenario's own time unit and in hours of 3600 s; every run is judged by the
same claims, and its Gramian over the second cycle, started at the true
parameters, says which parameters can be learned at all.

    python -m analysis.readings [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated, Any

import typer

import clpt_control as clpt
from clpt_control.simulation.summary import claims, run_and_report

from .study import BLUE, GREEN, RED, leave, new_figure, progress_bar

KERNELS = ("exponential", "gaussian", "gaussian-sigma")
UNITS = {"periods in s": 1.0, "periods in h": 3600.0}


def reading(kernel: str, seconds: float) -> dict[str, Any]:
    """Run one reading and judge it."""
    paper = clpt.paper_scenario()
    scenario = paper.with_values(
        {"basis.kernel": kernel, "basis.periods": seconds * paper.periods}
    )
    summary = run_and_report(scenario).summary
    true = scenario.started_true()
    eigenvalues = clpt.gramian(true, 200.0, 200.0).eigenvalues
    return {
        "kernel": kernel,
        "rms": summary["clpe_rms_per_cycle"],
        "parameters": summary["max_flow_parameter_error"],
        "gains": summary["max_gain_error"],
        "kappa_1": min(float(values[0]) for values in eigenvalues.values()),
        "verdicts": [claim["verdict"] for claim in claims(summary)],
    }


def table(rows: list[dict[str, Any]]) -> str:
    """Write the readings as a Markdown table."""
    lines = [
        "| kernel | periods | CLPE rms, cycles 1, 2, 10 | flow parameters off at 200, 2000 | "
        "gains off at 200, 2000 | smallest eigenvalue | CLPE | flow | gains |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        rms, theta, gains = row["rms"], row["parameters"], row["gains"]
        lines.append(
            f"| {row['kernel']} | {row['unit'][-1:]} "
            f"| {rms[0]:.3f}, {rms[1]:.4f}, {rms[-1]:.4f} | "
            f"{theta['200']:.3f}, {theta['2000']:.3f} | {gains['200']:.3f}, {gains['2000']:.3f} | "
            f"{_eigenvalue(row['kappa_1'])} | {' | '.join(row['verdicts'])} |"
        )
    return "\n".join(lines) + "\n"


def _eigenvalue(value: float) -> str:
    """Show an eigenvalue; below 1e-12 it is rounding."""
    return f"{value:.3g}" if value > 1e-12 else "below 1e-12"


def figure(rows: list[dict[str, Any]]) -> Any:
    """Draw the largest flow parameter error of each reading against time."""
    picture, ax = new_figure(6.4, 4.4)
    for row in rows:
        colour = (BLUE, RED, GREEN)[KERNELS.index(row["kernel"])]
        in_hours = row["unit"] == "periods in h"
        times = [float(time) for time in row["parameters"]]
        ax.loglog(
            times,
            list(row["parameters"].values()),
            color=colour,
            linestyle="--" if in_hours else "-",
            marker="s" if in_hours else "o",
            markersize=4,
            markerfacecolor="none" if in_hours else colour,
            label=f"{row['kernel']}, {row['unit']}: " + _eigenvalue(row["kappa_1"]),
        )
    ax.axhline(0.05, color="black", linewidth=0.8, linestyle=":")
    ax.annotate(
        "criterion 0.05",
        (10, 0.05),
        xytext=(0, 3),
        textcoords="offset points",
        fontsize=8,
    )
    ax.set(xlabel="time (s)", ylabel="largest flow parameter error (m/s)")
    ax.legend(
        title="reading: smallest Gramian eigenvalue (m$^2$ s)",
        fontsize=8,
        title_fontsize=8,
        frameon=False,
        loc="lower left",
    )
    ax.set_ylim(0.008, 1.2)
    return picture


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/readings"),
) -> None:
    """Run all readings; leave readings.md and readings.png."""
    rows = []
    with progress_bar("readings of Eq. (5)", len(KERNELS) * len(UNITS)) as report:
        for unit, seconds in UNITS.items():
            for kernel in KERNELS:
                rows.append({"unit": unit, **reading(kernel, seconds)})
                report(len(rows))
    leave(out, "readings", table(rows), figure(rows))
    typer.echo(table(rows))
    best = [
        row for row in rows if all(verdict != "fails" for verdict in row["verdicts"])
    ]
    learned = ", ".join(f"{row['kernel']} with {row['unit']}" for row in best) or "none"
    typer.echo(f"Readings in which every claim holds by the end: {learned}")


if __name__ == "__main__":
    typer.run(main)
