"""SECURITY.md: each of its lines names the tests that show it, and these are there."""

import re
from pathlib import Path

HOUSE = Path(__file__).parent.parent
ROWS = [
    line
    for line in (HOUSE / "SECURITY.md").read_text("utf-8").splitlines()
    if line.startswith("| ") and not line.endswith("| tests |")
]


def test_each_line_has_its_tests():
    texts = [path.read_text("utf-8") for path in (HOUSE / "tests").rglob("test_*.py")]
    there = {name for text in texts for name in re.findall(r"^def (test_\w+)\(", text, re.M)}
    assert len(ROWS) > 12
    for row in ROWS:
        named = re.findall(r"`(test_\w+)`", row.rsplit("|", 2)[1])
        assert named, row
        assert set(named) <= there, row
