"""Table of conclusions in docs/theory.md, from the rows that the verdicts are made of.

`tests/test_documentation.py` checks that the table is current; print it anew by

    python tools/print_conclusions.py
"""

from pathlib import Path

from clpt_control.theory.proofs.conclusions import CONCLUSIONS, CONDITIONS, REQUIREMENTS

PAGE = Path(__file__).parents[1] / "docs" / "theory.md"
BEGIN, END = "<!-- conclusions -->\n", "<!-- end of conclusions -->\n"
USUAL = frozenset(
    ("definite", "jumps", "exists")
)  # of most rows: said once, above them
ALWAYS = CONCLUSIONS["V' is at most the claim"].requires - {"claimed"}


def table() -> str:
    """Return the table of conclusions and the list of conditions."""
    rows = [("conclusion", "requires", "what to do"), ("---", "---", "---")]
    for name, row in CONCLUSIONS.items():
        own = row.requires - ALWAYS
        is_usual = own >= USUAL
        own = own - USUAL if is_usual else own
        needed = ["\\*"] * is_usual
        needed += [REQUIREMENTS[k] for k in REQUIREMENTS if k in own]
        rows.append((name, "; ".join(needed), row.to_do))
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    always = " and ".join(REQUIREMENTS[k] for k in REQUIREMENTS if k in ALWAYS)
    usual = "; ".join(REQUIREMENTS[k] for k in REQUIREMENTS if k in USUAL)
    named = "; ".join(f"`{name}`" for name in CONDITIONS)
    return "\n".join(
        [
            *lines,
            "",
            f"\\*: {usual}. Each requires too: {always}.",
            "",
            f"Conditions: {named}.",
            "",
        ]
    )


def page() -> str:
    """Return the page with its table made anew."""
    before, _, rest = PAGE.read_text("utf-8").partition(BEGIN)
    return before + BEGIN + "\n" + table() + "\n" + END + rest.partition(END)[2]


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
