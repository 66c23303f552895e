"""The page docs/paper_map.md against the files that it links."""

import re
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[1] / "docs" / "paper_map.md"
ROWS = [
    line.split("|")[1:-1]
    for line in PAGE.read_text("utf-8").splitlines()
    if line.startswith("| ") and not line.startswith("| number")
]
LINKED = [row for row in ROWS if "](" in row[2]]


def numbers(row):
    """Equations, definitions, assumptions, remarks and theorems of a row."""
    return [part.strip() for part in row[0].split(",")]


def holds(text, number):
    """Whether a file names an equation, alone or in a range."""
    if not number.startswith("("):
        return number in text
    wanted = int(number.strip("()"))
    ranges = re.findall(r"\((\d+)\)(?:\s*(?:-|to|and)\s*\((\d+)\))?", text)
    return any(int(low) <= wanted <= int(high or low) for low, high in ranges)


def test_each_equation_and_statement_has_a_row():
    named = {number for row in ROWS for number in numbers(row)}
    assert {f"({n})" for n in range(1, 36)} <= named
    assert {f"Theorem 3.{n}" for n in range(1, 5)} <= named
    assert {f"Assumption 3.{n}" for n in range(1, 4)} <= named
    assert {"Definition 3.1", "Remark 3.1", "Remark 3.2", "Remark 3.3"} <= named
    assert {"figure 1", "figure 2", "figures 3 and 4"} <= named


@pytest.mark.parametrize("row", LINKED, ids=lambda row: row[0].strip())
def test_the_linked_file_names_the_number(row):
    (target,) = re.findall(r"\]\((.*?)\)", row[2])
    text = (PAGE.parent / target).read_text("utf-8")
    assert [number for number in numbers(row) if not holds(text, number)] == []
