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
TYPES = re.compile(r"<|\b(TEXT|FLOAT|INTEGER|PATH|None|inf|float|str|int|list|bool)\b|\.\.\.$")


@pytest.mark.parametrize("words", [(), ("--help",), ("-h",)])
def test_the_page_lists_every_command_in_one_line(clpt, words):
    status, out, err = clpt(*words)
    assert (status, err) == (0, "")
    for name in COMMANDS:
        (line,) = re.findall(rf"^  {name} +[A-Z].*", out, re.M)
        assert line.endswith("."), line  # not cut, not broken
    assert "  clpt init mine.toml" in out


@pytest.mark.parametrize("name", ["", *COMMANDS])
def test_help_is_of_shell_words_80_columns_and_an_example(clpt, name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    text = clpt(*([name] if name else []), "--help").out
    assert max(map(len, text.splitlines())) <= 80
    entries = re.findall(r"^  (?:-|[A-Z])(?:\S| (?! ))*", text, re.M)
    assert entries
    assert [entry for entry in entries if TYPES.search(entry)] == []
    assert not re.search(r"\x1b|\[default: inf\]", text)
    if not name:
        return
    example = text.split("\n  Example:\n")[1].split("\n\n")[0].replace("\\\n", " ").split()
    assert example[:2] == ["clpt", name]
    options = re.findall(r"^  (-\S+?)[ ,]", text, re.M) + re.findall(r" (--[\w-]+)", text)
    assert {word for word in example if re.match("--?[a-z]", word)} - set(options) == set()


def test_the_version_is_that_of_the_package(clpt):
    status, out, _ = clpt("--version")
    first, python, *others = out.splitlines()
    assert (status, first) == (0, f"clpt-control {clpt_control.__version__}")
    assert python.split()[:2] == ["Python", ".".join(map(str, sys.version_info[:3]))]
    assert {"control", "llvmlite"} <= {line.split()[0] for line in others}


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
    done = ran(sys.executable, "-m", "clpt_control", "run", "--help")
    assert done.stdout == clpt("run", "--help").out


# --- completion ----------------------------------------------------------------------------------


IN_BASH = r"""
eval "$(_CLPT_COMPLETE=source_bash clpt)"
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_clpt_completion clpt; printf "%s\n" "${COMPREPLY[@]}"
"""


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
    """By bash's own completion function, of the last word."""
    command = tmp_path / "clpt"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m clpt_control "$@"\n')
    command.chmod(0o755)
    env = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    env["PYTHONPATH"] = str(Path(clpt_control.__file__).parents[1])
    done = ran("bash", "--norc", "-c", IN_BASH, "bash", "clpt", *words, env=env)
    assert (done.stdout.split(), done.stderr) == (offered, "")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_each_shell_has_its_script(clpt, monkeypatch, shell):
    monkeypatch.setenv("_CLPT_COMPLETE", f"source_{shell}")
    status, out, err = clpt()
    assert (status, err, f"complete_{shell}" in out) == (0, "", True)


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
