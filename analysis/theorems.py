"""Which statements of section III hold on the equations that run?

Every theorem is judged as printed, step by step, with the misprints; the figure shows the
counterexample to Eq. (33) on the paper's own system.

    python -m analysis.theorems [--out FOLDER]
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

import clpt_control as clpt
from clpt_control.theory.theorems.counterexamples import disturbance_counterexample

from .study import BLUE, RED, leave, new_figure, progress_bar


def page(proofs: Mapping[str, Any], listed: Sequence[Any]) -> str:
    """Return a section for each theorem and the table of misprints, as Markdown."""
    lines = ["# Section III of the paper, checked on the equations that run", ""]
    for number, proof in proofs.items():
        every = ", for every N" if proof.for_every_N else ""
        lines += [
            f"## Theorem {number}: {proof.status}{every}",
            "",
            f"*Printed:* {proof.printed}.",
            "",
            f"*Assumed:* {'; '.join(proof.assumptions)}.",
            "",
            "| holds | how | claim |",
            "|---|---|---|",
        ]
        for step in proof.steps:
            claim = step.claim + (f" ({step.detail})" if step.detail else "")
            lines.append(row("yes" if step.holds else "**no**", step.how, claim))
        lines += ["", proof.claim, ""]
        for title, said in (
            ("What holds", proof.corrected),
            ("Cited", proof.cited),
            ("Not shown", "; ".join(proof.not_proved)),
        ):
            lines += [f"*{title}:* {said}.", ""] if said else []
    lines += [
        "## Misprints",
        "",
        "| equation | printed | should be | told apart by | confirmed |",
        "|---|---|---|---|---|",
    ]
    lines += [
        row(
            m.equation,
            m.printed,
            m.corrected,
            m.check,
            "yes" if m.confirmed else "**no**",
        )
        for m in listed
    ]
    return "\n".join(lines) + "\n"


def row(*cells: str) -> str:
    """Return a row of a Markdown table."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def figure(found: Any) -> Any:
    """Draw |e| and the printed bound; below, around the peak."""
    picture, (top, bottom) = new_figure(6.4, 5.2, nrows=2)
    times, size = found.times, found.size
    peak, span = times[np.argmax(size)], (times[-1] - times[0]) / 30
    near = (times >= peak - span / 2) & (times <= peak + span / 2)
    for ax, shown, width in ((top, slice(None), 0.4), (bottom, near, 1.2)):
        ax.plot(times[shown], size[shown], color=BLUE, linewidth=width, label="|e|")
        ax.axhline(
            found.claimed,
            color=RED,
            linestyle="--",
            linewidth=1.4,
            label=f"Eq. {found.equation} allows, at most",
        )
        ax.set_ylabel("|e| (m)")
        ax.set_ylim(0, 1.15 * found.peak)
    label = f"peak, {found.ratio:.3g} of the bound"
    bottom.plot(peak, found.peak, "o", color="black", markersize=4, label=label)
    top.set_xlim(times[0], times[-1])
    bottom.set(xlabel="time (s)", xlim=(times[near][0], times[near][-1]))
    verdict = (
        rf"is no ultimate bound: |e| exceeds it for every $\beta$ from {found.k / found.ratio:.2g} "
        f"to {found.k:g} per s"
        if found.ratio > 1
        else "is not violated here"
    )
    top.set_title(f"Eq. {found.equation} {verdict}", loc="left", fontsize=10)
    handles = bottom.get_legend_handles_labels()
    picture.legend(
        *handles, fontsize=8, frameon=False, loc="outside lower center", ncols=4
    )
    return picture


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/theorems"),
) -> None:
    """Leave theorems.md and theorems.png."""
    with progress_bar("proving", 4.0) as report:
        proofs = clpt.theory.audit(progress=report)
    listed = clpt.theory.misprints()
    with progress_bar("the counterexample to Eq. (33)", 800.0) as report:
        found = disturbance_counterexample(progress=report)
    leave(out, "theorems", page(proofs, listed), figure(found))
    typer.echo("| theorem | as printed | for every N | steps |\n|---|---|---|---|")
    for number, proof in proofs.items():
        every = "yes" if proof.for_every_N else "no"
        typer.echo(f"| {number} | {proof.status} | {every} | {len(proof.steps)} |")
    typer.echo(
        f"\nEq. (33), paper's system: max|e| = {found.ratio:.3f} Delta_max/KD, "
        f"rms(e) = {found.rms:.3f} of the mean-square bound; "
        f"{sum(m.confirmed for m in listed)} of {len(listed)} misprints confirmed"
    )


if __name__ == "__main__":
    typer.run(main)
