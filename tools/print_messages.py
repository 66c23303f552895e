"""List of all error messages of the package: tests/messages.md, to be read on one page.

A message is the text of one of the package's errors where it is made, with its values as {NAMES}.
`tests/test_messages.py` checks that the page is current; print it anew by

    python tools/print_messages.py
"""

import ast
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "tests" / "messages.md"
ERRORS = {
    "ArgumentError",
    "BlockError",
    "ClptError",
    "DataError",
    "DiagramError",
    "ScenarioError",
    "SimulationError",
    "Uncovered",
}
INTRODUCTION = """# Error messages

Made by `python tools/print_messages.py`. Form:

    WHERE: what is wrong. What is allowed or what to do.
"""


def text_of(node: ast.AST) -> str:
    """Return the text of an expression of strings, with its values in braces."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(map(text_of, node.values))
    if isinstance(node, ast.FormattedValue):
        return "{" + ast.unparse(node.value) + "}"
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return text_of(node.left) + text_of(node.right)
    return "{" + ast.unparse(node) + "}"


def messages_in(path: Path) -> Iterator[str]:
    """Return the messages of a file, in their order."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name)):
            continue
        if node.func.id in ERRORS and node.args:
            yield " ".join(text_of(node.args[0]).split())


def page() -> str:
    """Return the page: the messages of each file."""
    parts = [INTRODUCTION]
    for path in sorted((ROOT / "clpt_control").rglob("*.py")):
        messages = list(messages_in(path))
        if messages:
            name = path.relative_to(ROOT / "clpt_control")
            parts.append(f"## {name}\n" + "".join(f"- {text}\n" for text in messages))
    return "\n".join(parts)


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
