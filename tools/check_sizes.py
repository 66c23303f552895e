"""Sizes: tokens of each folder, lines of each file, files at the top, words and lines of documents.

`make lint` runs this script. It prints a line for each folder or file that outgrew its size
and ends with status 1. `python tools/check_sizes.py --write` sets the table `folder_sizes.txt`.
Comments, docstrings and line ends are not counted; an f-string is one token on every Python.
"""

import ast
import io
import sys
import tokenize
from collections import Counter
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "clpt_control"
TABLE = Path(__file__).parent / "folder_sizes.txt"
LONGEST_FILE = 450  # lines of code
FILES_AT_THE_TOP = 7
WORDS_OF_DOCS = 30_000
LINES = {"README.md": 130, "CONTRIBUTING.md": 150}
HELP = "CONTRIBUTING.md, Size"
LAID_OUT = {
    *(tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT),
    *(tokenize.DEDENT, tokenize.ENCODING, tokenize.ENDMARKER),
}
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


def lines_of_docstrings(tree: ast.AST) -> set[int]:
    """Return the numbers of lines that docstrings take."""
    lines: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, DOCUMENTED) and ast.get_docstring(node, clean=False):
            lines |= {*range(node.body[0].lineno, node.body[0].end_lineno + 1)}
    return lines


def size(source: str) -> tuple[int, int]:
    """Return the tokens and the lines of code of a file."""
    docstrings = lines_of_docstrings(ast.parse(source))
    count, depth, lines = 0, 0, set()
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type in LAID_OUT or token.start[0] in docstrings:
            continue
        name = tokenize.tok_name[token.type]
        # Python 3.12 and newer divide an f-string into tokens: only its start is counted
        count += depth == 0
        depth += (name == "FSTRING_START") - (name == "FSTRING_END")
        lines |= {*range(token.start[0], token.end[0] + 1)}
    return count, len(lines)


def folder_of(path: Path) -> str:
    """Return the folder of a file in the table: the first two names of its path."""
    return ".".join(path.relative_to(PACKAGE).parts[:-1][:2])


def outgrown() -> list[str]:
    """Return a sentence for each folder and file that outgrew its size."""
    tokens, sentences = Counter(), []
    for path in sorted(PACKAGE.rglob("*.py")):
        count, lines = size(path.read_text("utf-8"))
        tokens[folder_of(path) or "top"] += count
        if lines > LONGEST_FILE:
            name = path.relative_to(PACKAGE.parent)
            sentences.append(f"{name} has {lines} lines of code, of {LONGEST_FILE}")
    if "--write" in sys.argv:
        rows = [
            f"{folder} {count}\n" for folder, count in sorted(tokens.items()) if count
        ]
        TABLE.write_text("".join(rows), "utf-8")
    allowed = dict(row.split() for row in TABLE.read_text("utf-8").splitlines())
    for folder, count in sorted(tokens.items()):
        grown = count - int(allowed.get(folder, 0))
        if grown > 0:
            sentences.append(f"folder {folder} grew by {grown} tokens, to {count}")
    if (files := len([*PACKAGE.glob("*.py")])) > FILES_AT_THE_TOP:
        sentences.append(f"{PACKAGE.name} has {files} files, of {FILES_AT_THE_TOP}")
    root = PACKAGE.parent
    pages = [path.read_text("utf-8") for path in root.glob("docs/**/*.md")]
    if (words := sum(len(page.split()) for page in pages)) > WORDS_OF_DOCS:
        sentences.append(f"docs has {words} words, of {WORDS_OF_DOCS}")
    for name, most in LINES.items():
        if (lines := len((root / name).read_text("utf-8").splitlines())) > most:
            sentences.append(f"{name} has {lines} lines, of {most}")
    return sentences


if __name__ == "__main__":
    found = outgrown()
    for sentence in found:
        print(f"{sentence}; {HELP}", file=sys.stderr)
    sys.exit(bool(found))
