"""The page on the engine: its commands print what it says, its links lead to every file."""

import contextlib
import io
import re
from pathlib import Path

import pytest

import clpt_control

PACKAGE = Path(clpt_control.__file__).parent
PAGE = PACKAGE.parent / "docs" / "engine.md"
NUMBER = re.compile(r"-?\d+\.\d+(?=[\],])")


def parts(text):
    """Lines without LLVM's own numbering and rounded numbers; the numbers apart."""
    lines = [re.sub(r'%"\.\d+"', "%", line).rstrip() for line in text.strip().splitlines()]
    whole = "\n".join(lines)
    return NUMBER.sub("#", whole), [float(n) for n in NUMBER.findall(whole)]


def test_the_commands_print_what_the_page_says():
    found = re.findall(r"```python\n(.*?)```(?:\n```text\n(.*?)```)?", PAGE.read_text(), re.S)
    assert len(found) >= 5
    space: dict = {}
    for code, wanted in found:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, PAGE.name, "exec"), space)
        (text, numbers), (page, said) = parts(printed.getvalue()), parts(wanted)
        assert text == page
        assert numbers == pytest.approx(said, abs=2e-6)


def test_every_file_of_the_engine_is_on_the_page():
    links = {
        (PAGE.parent / name).resolve() for name in re.findall(r"\]\((\S+?)\)", PAGE.read_text())
    }
    assert all(link.exists() for link in links)
    files = {path for path in (PACKAGE / "native").glob("*.py") if path.stem != "__init__"}
    assert files <= links
