"""The audit of the paper on a page: JSON, Markdown and LaTeX."""

from collections.abc import Mapping, Sequence
from typing import Any

from .misprints import Misprint
from .proof import Proof

_TEX = {
    "\\": r"\textbackslash{}",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "~": r"\textasciitilde{}",
    "|": r"\textbar{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
}


def audit_json(proofs: Mapping[str, Proof], listed: Sequence[Misprint]) -> dict[str, Any]:
    """Return the audit ready for JSON.

    Parameters
    ----------
    proofs : mapping
        Theorem -> Proof.
    listed : sequence of Misprint
        The misprints.

    Returns
    -------
    dict
        ``theorems`` with status, steps and the corrected statement, and
        ``misprints``.

    Examples
    --------
    >>> sorted(audit_json({}, []))
    ['misprints', 'theorems']
    """
    return {
        "theorems": {
            number: {
                "status": proof.status,
                "for_every_N": proof.for_every_N,
                "printed": proof.printed,
                "assumptions": list(proof.assumptions),
                "steps": [
                    {
                        "claim": s.claim,
                        "holds": s.holds,
                        "how": s.how,
                        "detail": s.detail,
                        "every_N": s.every_N,
                    }
                    for s in proof.steps
                ],
                "conclusion": proof.conclusion,
                "corrected": proof.corrected,
                "cited": proof.cited,
                "not_proved": list(proof.not_proved),
            }
            for number, proof in proofs.items()
        },
        "misprints": [
            {
                "equation": m.equation,
                "printed": m.printed,
                "corrected": m.corrected,
                "check": m.check,
                "confirmed": m.confirmed,
            }
            for m in listed
        ],
    }


def audit_markdown(proofs: Mapping[str, Proof], listed: Sequence[Misprint]) -> str:
    """Return the audit as a page of Markdown.

    Parameters
    ----------
    proofs : mapping
        Theorem -> Proof.
    listed : sequence of Misprint
        The misprints.

    Returns
    -------
    str
        One section a theorem, then the table of misprints.

    Examples
    --------
    >>> audit_markdown({}, []).splitlines()[0]
    '# Section III of the paper, checked on the equations that run'
    """
    lines = ["# Section III of the paper, checked on the equations that run", ""]
    for number, proof in proofs.items():
        every = ", for every N" if proof.for_every_N else ""
        lines += [
            f"## Theorem {number}: {proof.status}{every}",
            "",
            f"*Printed:* {proof.printed}.",
            "",
        ]
        lines += [f"*Assumed:* {'; '.join(proof.assumptions)}.", ""]
        lines += ["| holds | how | claim |", "|---|---|---|"]
        for s in proof.steps:
            detail = f" ({s.detail})" if s.detail else ""
            claim = f"{s.claim}{detail}".replace("|", "\\|")
            lines.append(f"| {'yes' if s.holds else '**no**'} | {s.how} | {claim} |")
        lines += ["", proof.conclusion, ""]
        if proof.corrected:
            lines += [f"*What holds:* {proof.corrected}.", ""]
        if proof.cited:
            lines += [f"*Cited:* {proof.cited}.", ""]
        if proof.not_proved:
            lines += [f"*Not shown:* {'; '.join(proof.not_proved)}.", ""]
    lines += [
        "## Misprints",
        "",
        "| equation | printed | should be | told apart by | confirmed |",
        "|---|---|---|---|---|",
    ]
    for m in listed:
        cells = (m.equation, m.printed, m.corrected, m.check, "yes" if m.confirmed else "**no**")
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def audit_latex(proofs: Mapping[str, Proof], listed: Sequence[Misprint]) -> str:
    """Return the audit as a LaTeX document.

    Parameters
    ----------
    proofs : mapping
        Theorem -> Proof.
    listed : sequence of Misprint
        The misprints.

    Returns
    -------
    str
        A whole document for `article` with `longtable`.

    Examples
    --------
    >>> "longtable" in audit_latex({}, [])
    True
    """
    lines = [
        r"\documentclass{article}",
        r"\usepackage[margin=2cm]{geometry}",
        r"\usepackage{longtable}",
        r"\usepackage[T1]{fontenc}",
        r"\begin{document}",
        r"\section*{Section III of the paper, checked on the equations that run}",
    ]
    for number, proof in proofs.items():
        every = ", for every $N$" if proof.for_every_N else ""
        lines += [
            rf"\subsection*{{Theorem {number}: {proof.status}{every}}}",
            rf"\emph{{Printed:}} {_tex(proof.printed)}.\par",
            rf"\emph{{Assumed:}} {_tex('; '.join(proof.assumptions))}.",
            r"\begin{longtable}{lp{2.2cm}p{12cm}}",
            r"holds & how & claim \\ \hline",
        ]
        for s in proof.steps:
            detail = f" ({s.detail})" if s.detail else ""
            lines.append(rf"{'yes' if s.holds else 'no'} & {s.how} & {_tex(s.claim + detail)} \\")
        lines += [r"\end{longtable}", _tex(proof.conclusion) + r"\par"]
        if proof.corrected:
            lines.append(rf"\emph{{What holds:}} {_tex(proof.corrected)}.\par")
        if proof.cited:
            lines.append(rf"\emph{{Cited:}} {_tex(proof.cited)}.\par")
        if proof.not_proved:
            lines.append(rf"\emph{{Not shown:}} {_tex('; '.join(proof.not_proved))}.")
    lines += [
        r"\subsection*{Misprints}",
        r"\begin{longtable}{p{2.2cm}p{4cm}p{4.5cm}p{4.5cm}}",
        r"equation & printed & should be & told apart by \\ \hline",
    ]
    lines += [
        " & ".join(_tex(cell) for cell in (m.equation, m.printed, m.corrected, m.check)) + r" \\"
        for m in listed
    ]
    return "\n".join([*lines, r"\end{longtable}", r"\end{document}"]) + "\n"


def _tex(text: str) -> str:
    return "".join(_TEX.get(letter, letter) for letter in text)
