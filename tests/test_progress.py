"""How far work has come: a rate and the time left, on standard error."""

import io
import os
import sys
from itertools import count
from types import SimpleNamespace

import pytest
from processes import ran

from clpt_control import progress


@pytest.fixture
def ticking(monkeypatch):
    """A clock that moves by a second whenever it is asked, and no patience."""
    ticks = count(0.0, 1.0)
    monkeypatch.setattr(progress, "time", SimpleNamespace(monotonic=lambda: next(ticks)))
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    monkeypatch.setattr(progress, "LOG_EVERY", 0.0)


@pytest.mark.parametrize(
    ("counted", "said"),
    [("members", "50 of 100 members, 25 a second, 0:02 left"), ("", "50 %, 0:02 left")],
)
def test_lines_say_rate_and_time_left(ticking, capsys, counted, said):
    with progress.progress_bar("running", 100, counted) as report:
        report(0)
        report(50)
    assert capsys.readouterr().err.splitlines()[-1] == f"running: {said}"
    assert progress.clock(7265) == "2:01:05"


def test_what_was_done_before_is_no_rate(ticking, capsys):
    with progress.progress_bar("running", 100, "members") as report:
        report(90)
        report(92)
    there, first, last = capsys.readouterr().err.splitlines()
    assert there == "clpt: running: 90 of 100 members were there already"
    assert first == "running: 90 of 100 members"
    assert last == "running: 92 of 100 members, 1 a second, 0:08 left"


def test_a_bar_shows_any_name_as_it_is(ticking, monkeypatch):
    screen = io.StringIO()
    screen.isatty = lambda: True
    monkeypatch.setattr("sys.stderr", screen)
    with progress.progress_bar("running [red]{x}.toml", 4.0) as report:
        report(0)
        report(1)
    assert "running [red]{x}.toml" in screen.getvalue()


ENDED = """
import os
from clpt_control.progress.processes import processes

if __name__ == "__main__":
    with processes(1) as pool:
        print(pool.submit(abs, -1).result(), flush=True)
        os._exit(130)
"""


@pytest.mark.skipif(os.name != "posix", reason="semaphores are tidied by another process there")
def test_a_command_that_ends_with_its_processes_at_work_says_nothing_of_semaphores(tmp_path):
    (tmp_path / "ended.py").write_text(ENDED)
    done = ran(sys.executable, "ended.py", status=130, cwd=tmp_path)
    assert (done.stdout, done.stderr) == ("1\n", "")


UNGUARDED = """
from clpt_control.progress.processes import processes

print("once", flush=True)
with processes(1) as pool:
    print(pool.submit(abs, -1).result())
"""


def test_a_script_needs_no_guard_for_its_processes(tmp_path):
    (tmp_path / "unguarded.py").write_text(UNGUARDED)
    done = ran(sys.executable, "unguarded.py", cwd=tmp_path)
    assert (done.stdout, done.stderr) == ("once\n1\n", "")
