"""The command line's manners: its page, help in shell words, near names, completion."""

import os
import re
import shutil
import sys
from pathlib import Path

import pytest
from processes import ran

import clpt_control
from clpt_control.cli import application

COMMANDS = [one.callback.__name__ for one in application().registered_commands]
TYPES = re.compile(
    r"<|\b(TEXT|FLOAT|INTEGER|PATH|None|inf)\b|\b(float|str|int|list|bool)\b|\.\.\.$"
)
WIDTH = 80


@pytest.mark.parametrize("words", [(), ("--help",), ("-h",)])
def test_the_page_lists_every_command_in_one_line(clpt, words):
    outcome = clpt(*words)
    assert (outcome.status, outcome.err) == (0, "")
    lines = outcome.out.splitlines()
    for name in COMMANDS:
        (line,) = [line for line in lines if re.match(rf"  {name} +[A-Z]", line)]
        assert line.endswith("."), line  # not cut, not broken
    assert [line for line in lines if "  clpt init mine.toml" in line]


@pytest.mark.parametrize("name", ["", *COMMANDS])
def test_help_is_of_shell_words_80_columns_and_an_example(clpt, name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    text = clpt(*([name] if name else []), "--help").out
    assert max(map(len, text.splitlines())) <= WIDTH
    assert not text.count("\x1b")
    entries = [line for line in text.splitlines() if re.match(r"  (-|[A-Z])", line)]
    assert entries
    for line in entries:
        assert not TYPES.search(re.split(r"\s{2,}", line.strip())[0]), line
    assert "[default: inf]" not in text
    if not name:
        return
    example = text.split("\n  Example:\n")[1].split("\n\n")[0].replace("\\\n", " ").split()
    assert example[:2] == ["clpt", name]
    options = re.findall(r"^  (-\S+?)[ ,]", text, re.M) + re.findall(r" (--[\w-]+)", text)
    assert {word for word in example if re.match("--?[a-z]", word)} - set(options) == set()


def test_the_version_is_that_of_the_package(clpt):
    outcome = clpt("--version")
    first, *others = outcome.out.splitlines()
    assert (outcome.status, first) == (0, f"clpt-control {clpt_control.__version__}")
    python = ".".join(map(str, sys.version_info[:3]))
    assert {"Python", "control", "llvmlite"} <= {line.split()[0] for line in others}
    assert others[0].split()[1].startswith(python)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["rnu"], "; did you mean .*run.*\\?"),
        (["run", "x.toml", "--figure", "f"], "; did you mean .*--figures.*\\?"),
        (["--versoin"], "; did you mean .*--version.*\\?"),
        (["run"], "(?i)scenario.*; `clpt run --help` shows what it takes"),
        (["run", "x.toml", "--out"], "--out.*; `clpt run --help` shows what it takes"),
        (["nothing-like-it"], "nothing-like-it.*; `clpt --help` shows what it takes"),
        (["tides", "a.csv", "--at", "3"], "--at.*; `clpt tides --help` shows what it takes"),
    ],
)
def test_what_is_misspelt_or_lacks_is_said(refused, words, said):
    assert re.search(rf"{said}\n$", refused(*words))


def test_the_module_is_the_command(clpt):
    words = [sys.executable, "-m", "clpt_control", "run", "--help"]
    assert ran(*words).stdout == clpt("run", "--help").out


# --- completion ----------------------------------------------------------------------------------


def completed(tmp_path, *words):
    """What bash's own completion function offers for the last word."""
    command = tmp_path / "clpt"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m clpt_control "$@"\n')
    command.chmod(0o755)
    script = (
        'eval "$(_CLPT_COMPLETE=source_bash clpt)"\n'
        'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))\n'
        '_clpt_completion clpt; printf "%s\\n" "${COMPREPLY[@]}"\n'
    )
    env = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    env["PYTHONPATH"] = str(Path(clpt_control.__file__).parents[1])
    done = ran("bash", "--norc", "-c", script, "bash", "clpt", *words, env=env)
    assert done.stderr == ""
    return done.stdout.split()


@pytest.mark.skipif(not shutil.which("bash"), reason="no bash")
@pytest.mark.parametrize(
    ("words", "offered"),
    [
        (["re"], ["refute", "replay", "report"]),
        (["run", "--fi"], ["--figures"]),
        (["run", "mine"], []),  # files, by bash itself
    ],
)
def test_bash_completes(tmp_path, words, offered):
    assert completed(tmp_path, *words) == offered


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_each_shell_has_its_script(clpt, monkeypatch, shell):
    monkeypatch.setenv("_CLPT_COMPLETE", f"source_{shell}")
    outcome = clpt()
    assert (outcome.status, outcome.err) == (0, "")
    assert f"complete_{shell}" in outcome.out


@pytest.mark.parametrize(("words", "status"), [("clpt r", 0), ("clpt run mine", 1)])
def test_fish_is_told_whether_there_are_words_or_files(clpt, monkeypatch, words, status):
    monkeypatch.setenv("_CLPT_COMPLETE", "complete_fish")
    monkeypatch.setenv("_TYPER_COMPLETE_FISH_ACTION", "is-args")
    monkeypatch.setenv("_TYPER_COMPLETE_ARGS", words)
    assert clpt().status == status


COMPLETING = {"_CLPT_COMPLETE": "complete_bash", "COMP_CWORD": "1", "COMP_WORDS": "clpt ref"}
COMMAND = "sys.argv = {}; os.environ.update({}); from clpt_control.cli import main; main()"
LIGHT = {  # code, and what it says
    "the package": ("import clpt_control", ""),
    "help": (COMMAND.format(["clpt", "--help"], {}), "clpt init mine.toml"),
    "completion": (COMMAND.format(["clpt"], COMPLETING), "refute\n"),
}


@pytest.mark.parametrize("name", LIGHT)
def test_nothing_heavy_is_imported_for(name):
    code, said = LIGHT[name]
    heavy = {"control", "numpy", "sympy", "matplotlib", "xarray", "pandas", "scipy"}
    heavy |= {"pydantic"} if name != "completion" else set()  # Typer brings it
    code = f"import os, sys\ntry: {code}\nexcept SystemExit: pass\n"
    code += f"print(sorted({heavy} & set(sys.modules)), file=sys.stderr)"
    done = ran(sys.executable, "-c", code)
    assert (said in done.stdout, done.stderr.strip()) == (True, "[]")
