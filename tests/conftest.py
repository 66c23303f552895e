"""Shared fixtures: the command line in-process, the reference numbers, measured data."""

import gc
import json
import os
import sys
from collections import Counter
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple

import pytest

HERE = Path(__file__).parent
for name in ("COLUMNS", "FORCE_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE"):
    # what is printed is as wide and plain as in a pipe, everywhere
    os.environ.pop(name, None)
# as `clpt prove` has it, before its import
os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")
gc.disable()  # a seventh of the time is taken by looking for garbage, of which imports make none


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Run one of nine cases of a test with three or more in `make test`; the others are `long`.

    So it is with any number of cases of a test that is marked `sampled`, one of three in Coq, which
    leaves none unmarked.  Of damaged files it is one of three, the others are `slow`.
    """
    cases = Counter(item.nodeid.partition("[")[0] for item in items)
    for item in items:
        case = getattr(item, "callspec", None)
        place = sum(case.indices.values()) if case else 0
        is_damaged = item.path.name.startswith("test_damaged_")
        in_coq = item.get_closest_marker("coq")
        is_family = item.get_closest_marker("sampled") or (
            cases[item.nodeid.partition("[")[0]] > 2 and not in_coq
        )
        every = 3 if is_damaged or in_coq else 9
        if place % every and (is_family or is_damaged):
            item.add_marker(pytest.mark.slow if is_damaged else pytest.mark.long)


class Outcome(NamedTuple):
    """What a command printed and how it ended."""

    status: int
    out: str
    err: str


@pytest.fixture
def clpt(monkeypatch, capsys):
    """Run `clpt ARGUMENTS` and give its outcome."""
    from clpt_control.app.cli import main
    from clpt_control.base.progress import interrupt

    # no lines that only a slow machine shows
    stopped = SimpleNamespace(monotonic=lambda: 0.0)
    monkeypatch.setattr("clpt_control.base.progress.time", stopped)

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["clpt", *map(str, arguments)])
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            main(before=None)  # the handler of interrupts stays pytest's
        text = capsys.readouterr()
        return Outcome(ended.value.code or 0, text.out, text.err)

    yield run
    interrupt.listen(None)  # a command that ended ignores interrupts


@pytest.fixture
def printed(clpt):
    """Run `clpt ARGUMENTS --json`, and give what it prints."""

    def run(*arguments):
        outcome = clpt(*arguments, "--json")
        assert outcome.status == 0, outcome.err
        return json.loads(outcome.out)

    return run


@pytest.fixture
def reported(printed, tmp_path):
    """Run a scenario or a team by `clpt run`; return what the command prints, and the run."""
    from team_scenarios import write_team

    import clpt_control

    def run(system):
        file, out = tmp_path / "reported.toml", tmp_path / "reported.nc"
        if isinstance(system, clpt_control.Team):
            write_team(file, system)
        else:
            clpt_control.save_scenario(system, file)
        return printed("run", file, "--out", out), clpt_control.load_run(out)

    return run


@pytest.fixture
def refused(clpt):
    """Run `clpt ARGUMENTS`, a user's mistake, and give the one line that it says."""

    def run(*arguments):
        outcome = clpt(*arguments)
        assert (outcome.status, outcome.out, outcome.err.count("\n")) == (2, "", 1), (
            outcome
        )
        assert outcome.err.startswith("clpt: ")
        return outcome.err

    return run


@pytest.fixture
def refused_for(refused):
    """Run a command, a user's mistake, whose line holds words, and which writes nothing."""

    def run(words, *arguments):
        before = sorted(Path().rglob("*"))
        said = refused(*arguments)
        assert all(word in said for word in words), said
        assert sorted(Path().rglob("*")) == before
        return said

    return run


@pytest.fixture(autouse=True)
def here(request):
    """Each test of a command begins in an empty folder."""
    if request.path.parent.name == "cli":
        request.getfixturevalue("monkeypatch").chdir(
            request.getfixturevalue("tmp_path")
        )


@pytest.fixture(autouse=True)
def _closed():
    """Figures that a test leaves to pyplot end with it."""
    yield
    if plt := sys.modules.get("matplotlib.pyplot"):
        plt.close("all")


@pytest.fixture
def undrawn(monkeypatch):
    """Figures are made and not drawn, which takes most of the time."""
    from matplotlib.figure import Figure

    def savefig(self, file, **_):
        if hasattr(file, "write"):
            file.write(b'<svg viewBox="0 0 9 9"></svg>')
        else:
            Path(file).write_bytes(b"drawn")

    monkeypatch.setattr(Figure, "savefig", savefig)


@pytest.fixture(scope="session")
def reference():
    """Independent numbers: scenario name -> states and figures."""
    return json.loads((HERE / "reference" / "paper.json").read_text())


@pytest.fixture(scope="session")
def facts():
    """The folder of facts drawn from measured files, at the paths of `../shared/data`."""
    return HERE / "data"


@pytest.fixture(scope="session")
def shared():
    """The folder of the measured files themselves, for what a drawn part cannot show."""
    folder = HERE.parent.parent / "shared" / "data"
    if not folder.is_dir():
        pytest.skip(
            "needs the whole measured files, which are too large for the repository"
        )
    return folder


def pytest_collection_finish():
    """What was imported is no garbage; what tests leave is looked for now and then."""
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)
    gc.enable()


def pytest_sessionstart(session):
    """Make the solver's machine code first, so that no test depends on the cache."""
    from clpt_control.engine.codegen.machine import compiled_solver

    if not getattr(session.config.option, "collectonly", False):
        compiled_solver()
