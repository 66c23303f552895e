"""Every code block of README, CONTRIBUTING and docs runs as it stands, page by page.

A page begins in an empty folder, and its blocks run in their order: `python` in one space, `sh`
in a shell that finds `clpt` first.  A block whose first line is `# NAME.py` or `# NAME.toml` is
that file.  `c` is compiled and run, where there is a compiler.  `text` right after `python` or `c`
is what it prints; a `console` shows commands after `$`
and what they print, `...` standing for lines left out.  What cannot run says why, visibly, in
its first line: `# not run by the tests: REASON`.  Notebooks are run by `make docs`.
"""

import contextlib
import importlib.util
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import pytest
from command_line import command
from subprocesses import GUARD, ran

ROOT = Path(__file__).parent.parent
# `clpt tune` and `clpt tune --waypoints` look for minutes; cluster, watch, film and reports take
# a quarter of one; test_release runs the ten lines of README. `make proofs` checks the files of Coq
SLOW = {"laws.md", "theory.md", "ensembles.md", "gliders.md", "measured_current.md"}
SLOW |= {"start.md", "report.md", "team.md", "README.md"}
SLOW |= {"machine_checked.md"}
LONG = {"on_board.md"}
FILM = "docs/index.md"
FENCE = re.compile(r"^(`{3,})([^\n`]*)\n(.*?)^\1[ ]*$", re.M | re.S)
FILE = re.compile(r"# ([\w.-]+\.(?:py|toml|csv))\n")
LEFT_OUT = re.compile(r"# not run by the tests: \S.*\n")
NUMBER = re.compile(r"-?\d+\.\d+(?=[\],])")
LANGUAGES = {
    *("python", "sh", "console", "toml", "text", "csv", "mermaid", "c", "matlab"),
    "bibtex",
}


class Block(NamedTuple):
    language: str
    text: str
    line: int
    after: str  # what stands between it and the block before


def pages():
    """README, CONTRIBUTING and every page of docs that is no notebook."""
    for path in [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        *sorted(ROOT.glob("docs/**/*.md")),
    ]:
        if any(blocks(path)):
            name = str(path.relative_to(ROOT))
            marks = [pytest.mark.slow] if path.name in SLOW or name == FILM else []
            marks += [pytest.mark.long] if path.name in LONG else []
            yield pytest.param(path, id=name, marks=marks)


def blocks(path):
    text, end = path.read_text("utf-8"), 0
    if text.startswith("---") and "kernelspec" in text.split("---")[1]:
        return
    for found in FENCE.finditer(text):
        start, before, (_, language, inside) = found.start(), end, found.groups()
        end = found.end()
        if not language.startswith("{"):
            yield Block(
                language, inside, text[:start].count("\n") + 2, text[before:start]
            )


def test_a_console_that_says_something_else_is_found():
    check_console(
        "$ echo one \\\n  two; echo three; echo four\none two\n...\nfour\n", "here"
    )
    for wrong in (
        "one three",
        "one two\nfour",
        "one two\n...\nfive",
        "four\n...\nthree",
    ):
        with pytest.raises(AssertionError, match="here: echo"):
            check_console(f"$ echo one two; echo three; echo four\n{wrong}\n", "here")


@pytest.mark.parametrize(
    "path", [page.values[0] for page in pages()], ids=lambda path: path.name
)
def test_commands_have_the_words_that_they_need(path):
    """Those of blocks that are not run, too."""
    clpt = command()
    shells = "\n".join(
        one.text for one in blocks(path) if one.language in ("sh", "console")
    )
    for line in re.findall(r"^(?:\$ )?clpt (.*)", shells.replace("\\\n", ""), re.M):
        name, *words = shlex.split(line.split(" |")[0], comments=True)
        clpt.commands[name].make_context(name, words)


@pytest.mark.parametrize("path", list(pages()))
def test_every_block_runs(path, tmp_path, monkeypatch):
    if not shutil.which("sh"):
        pytest.skip("no shell: sh is not on PATH")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    page, printed = ModuleType("page"), ""
    # its functions are found there, as in a script
    monkeypatch.setitem(sys.modules, "page", page)
    for block in blocks(path):
        where = f"{path.name}:{block.line}"
        assert block.language in LANGUAGES, (
            f"{where}: '{block.language}' is not a known language"
        )
        if block.language == "text" and printed and not block.after.strip():
            assert_same(printed, block.text, where)
        printed = "" if LEFT_OUT.match(block.text) else run(block, vars(page), where)


def run(block, space, where):
    """Run a block; return what Python printed."""
    name = FILE.match(block.text)
    match block.language:
        case "python" | "toml" | "csv" if name:
            Path(name[1]).write_text(block.text, "utf-8")
        case "python":
            code = compile("\n" * (block.line - 1) + block.text, where, "exec")
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                exec(code, space)
            return printed.getvalue()
        case "toml":
            tomllib.loads(block.text)
        case "sh" if not block.text.startswith("coqc") or shutil.which("coqc"):
            shell(block.text, where)
        case "console":
            check_console(block.text, where)
        case "c" if shutil.which("cc"):
            Path("main.c").write_text(block.text, "utf-8")
            words = "cc -std=c99 -Wall -Wextra -pedantic main.c -o main -lm; ./main"
            return shell(words, where)
    return ""


def shell(commands, where=None):
    """Run commands, the first that fails ends them; return all that is said."""
    both = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    done = subprocess.run(["sh", "-e", "-c", commands], timeout=GUARD, **both)
    assert done.returncode == 0 or not where, (
        f"{where}: status {done.returncode}: {done.stdout}"
    )
    return done.stdout


def check_console(text, where):
    """Run what stands after `$`; what is shown below must be what is said, but for `...`."""
    for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
        command, shown = re.match(
            r"((?:[^\n]*\\\n)*[^\n]*\n?)(.*)", part, re.S
        ).groups()
        out = shell(command)
        said = words(out)
        for piece in re.split(r"^\s*\.\.\.\s*$", shown, flags=re.M):
            wanted = words(piece)
            assert wanted in said, f"{where}: {command}said\n{out}\nnot\n{piece}"
            said = said.split(wanted, 1)[1] if wanted else said


def words(text):
    """Words with one blank between them; of a table's frame only the bars."""
    lines = [line for line in text.splitlines() if not line.startswith(("┏", "┡", "└"))]
    return " ".join(" ".join(lines).replace("┃", "|").replace("│", "|").split())


def assert_same(printed, shown, where):
    """Compare line by line, without LLVM's own numbering, rounded numbers nearly."""
    (text, numbers), (page, said) = parts(printed), parts(shown)
    assert text == page, where
    assert numbers == pytest.approx(said, abs=2e-6), where


def parts(text):
    """Lines without LLVM's own numbering and rounded numbers; the numbers apart."""
    lines = [
        re.sub(r'%"\.\d+"', "%", line).rstrip() for line in text.strip().splitlines()
    ]
    whole = "\n".join(lines)
    return NUMBER.sub("#", whole), [float(n) for n in NUMBER.findall(whole)]


# --- notebooks -----------------------------------------------------------------------------------

CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(?::[^\n]*\n)*(.*?)^```$", re.M | re.S)
PAGES = [
    path
    for folder in ("tutorials", "gallery")
    for path in sorted((ROOT / "docs" / folder).glob("*.md"))
    if CELL.search(path.read_text("utf-8"))
]


def test_there_are_pages():
    assert len(PAGES) > 10


@pytest.mark.slow
@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_the_cells_run(path, tmp_path):
    code = "\n".join(CELL.findall(path.read_text("utf-8")))
    if "IPython" in code and importlib.util.find_spec("IPython") is None:
        pytest.skip("IPython is not installed; `make docs` installs it")
    (tmp_path / "page.py").write_text(
        f"import matplotlib\n\nmatplotlib.use('agg')\n{code}", "utf-8"
    )
    ran(sys.executable, "page.py", cwd=tmp_path)
