"""Which statements of section III hold on the equations that run?

Every theorem is judged as printed, step by step, with the misprints; the
figure shows the counterexample to Eq. (33) on the paper's own system.

    python -m analysis.theorems [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated

import typer

from clpt_control.files import make_folder, write_figure, write_text
from clpt_control.progress import progress_bar
from clpt_control.theory.counterexamples.paper_system import disturbance_counterexample
from clpt_control.theory.counterexamples.plot import counterexample_plot
from clpt_control.theory.proving.audit_page import audit_latex, audit_markdown
from clpt_control.theory.proving.misprints import misprints
from clpt_control.theory.proving.theorems import audit


def main(out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/theorems")) -> None:
    """Leave theorems.md, theorems.tex and theorems.png."""
    folder = make_folder(out)
    with progress_bar("proving", 4.0) as report:
        proofs = audit(progress=report)
    listed = misprints()
    write_text(folder / "theorems.md", audit_markdown(proofs, listed))
    write_text(folder / "theorems.tex", audit_latex(proofs, listed))
    with progress_bar("the counterexample to Eq. (33)", 800.0) as report:
        found = disturbance_counterexample(progress=report)
    write_figure(counterexample_plot(found), folder / "theorems.png")
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
