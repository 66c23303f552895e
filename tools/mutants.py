"""Share of wrong programs that the tests reject: mutants of one token.

    python tools/mutants.py [--count N] [--seed N] [SUBPACKAGE ...]

An operator, a comparison or a number of `clpt_control` is changed in a copy in a temporary folder;
the tests of its subpackage alone run on the copy.  A mutant that every test passes has survived.
One seed draws the same mutants as long as the sources are the same.  Each takes up to minutes.
"""

import argparse
import itertools
import os
import random
import shutil
import subprocess
import sys
import tempfile
import tokenize
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "clpt_control"
LONGEST = 900  # seconds of a subpackage's tests; a mutant that takes longer is rejected
PAIRS = [
    "+ -",
    "* /",
    "< <=",
    "> >=",
    "== !=",
    "and or",
    "+= -=",
    "*= /=",
    "True False",
]
SWAPPED = {a: b for pair in PAIRS for a, b in (pair.split(), pair.split()[::-1])}
SIGNS = {"+", "-", "*", "/"}  # operators only between two operands
OPERANDS = {tokenize.NUMBER, tokenize.NAME}
KEYWORDS = {"return", "yield", "in", "not", "and", "or", "if", "else", "lambda"}


class Mutant(NamedTuple):
    """A token of a file and the token that replaces it."""

    file: Path
    line: int
    column: int
    old: str
    new: str


def mutants_of(file: Path) -> Iterator[Mutant]:
    """Yield each mutant of a file."""
    with file.open("rb") as stream:
        tokens = list(tokenize.tokenize(stream.readline))
    for before, token in itertools.pairwise(tokens):
        new = replacement(before, token)
        if new:
            yield Mutant(file, *token.start, token.string, new)


def replacement(before: tokenize.TokenInfo, token: tokenize.TokenInfo) -> str | None:
    """Return the token that replaces a token, if it is one to change."""
    if token.type == tokenize.NUMBER:
        integer = token.string.isdigit()
        return str(int(token.string) + 1) if integer else f"(2 * {token.string})"
    operand = before.type in OPERANDS and before.string not in KEYWORDS
    if token.string in SIGNS and not operand and before.string not in (")", "]"):
        return None
    return SWAPPED.get(token.string)


def tests_of(file: Path) -> str:
    """Return the folder of the tests of a file's subpackage."""
    parts = file.relative_to(PACKAGE).parts
    if parts[:2] == ("paper", "currents"):
        return "tests/ocean/currents"
    return f"tests/{parts[0]}"


def failure_of(copy: Path, folder: str) -> str:
    """Run the tests of a folder on a copy of the repository; return why they fail, or ""."""
    command = [sys.executable, "-m", "pytest", "-x", "-p", "no:cacheprovider", folder]
    environment = {**os.environ, "PYTHONPATH": str(copy), "OPENBLAS_NUM_THREADS": "1"}
    options: dict[str, Any] = {"capture_output": True, "text": True, "timeout": LONGEST}
    try:
        done = subprocess.run(command, cwd=copy, env=environment, **options)
    except subprocess.TimeoutExpired:
        return f"not done in {LONGEST} s"
    return done.stdout[-2000:] if done.returncode else ""


def survives(copy: Path, mutant: Mutant) -> bool:
    """Write a mutant into the copy, run the tests, and restore the file."""
    file = copy / mutant.file.relative_to(ROOT)
    text = file.read_text("utf-8")
    lines = text.splitlines(keepends=True)
    line = lines[mutant.line - 1]
    end = mutant.column + len(mutant.old)
    lines[mutant.line - 1] = line[: mutant.column] + mutant.new + line[end:]
    file.write_text("".join(lines), "utf-8")
    try:
        return not failure_of(copy, tests_of(mutant.file))
    finally:
        file.write_text(text, "utf-8")


def main() -> None:
    """Print each mutant and the share that was rejected."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("subpackages", nargs="*", help="default: every subpackage")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chosen = options.subpackages or [path.name for path in PACKAGE.iterdir()]
    files = (one for name in chosen for one in (PACKAGE / name).rglob("*.py"))
    every = [mutant for file in sorted(files) for mutant in mutants_of(file)]
    drawn = random.Random(options.seed).sample(every, options.count)
    rejected = 0
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "copy"
        skipped = shutil.ignore_patterns(".git", ".venv", "build", "__pycache__")
        shutil.copytree(ROOT, copy, ignore=skipped)
        for tests in sorted({tests_of(mutant.file) for mutant in drawn}):
            if why := failure_of(copy, tests):
                sys.exit(f"{why}\n{tests}: fails without a mutant. Repair it first.")
        for mutant in drawn:
            alive = survives(copy, mutant)
            rejected += not alive
            where = f"{mutant.file.relative_to(ROOT)}:{mutant.line}:{mutant.column}"
            word = "survived" if alive else "rejected"
            print(f"{word}  {where}  {mutant.old} -> {mutant.new}", flush=True)
    print(f"{rejected} of {len(drawn)} mutants rejected")


if __name__ == "__main__":
    main()
