"""Folders that tests read: the clone, its test data and its reference numbers."""

from pathlib import Path

ROOT = Path(__file__).parents[2]
TESTS = ROOT / "tests"
DATA = TESTS / "data"
REFERENCE = TESTS / "reference"
