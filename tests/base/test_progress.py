"""How far work has come: a rate and the time left, on standard error."""

import io
import os
import re
import sys
import time
from itertools import count

import pytest
from subprocesses import ran

from clpt_control.base import progress


@pytest.fixture
def ticking(monkeypatch):
    """A clock that moves by twenty seconds whenever it is read."""
    monkeypatch.setattr(time, "monotonic", count(step=20.0).__next__)


THERE = (
    "clpt: running: 90 of 100 members were there already",
    "running: 90 of 100 members",
)
SAID = [
    ("members", (0, 50), ["running: 50 of 100 members, 1.25 a second, 0:00:40 left"]),
    ("", (0, 50), ["running: 50 %, 0:00:40 left"]),
    ("", (0, 1e-200), ["running: 0 %, 11574 days, 1:46:40 left"]),
    # what was done before is no rate
    (
        "members",
        (90, 92),
        [*THERE, "running: 92 of 100 members, 0.05 a second, 0:02:40 left"],
    ),
]


@pytest.mark.parametrize(("counted", "done", "said"), SAID)
def test_lines_say_rate_and_time_left(ticking, capsys, counted, done, said):
    with progress.progress_bar("running", 100, counted) as report:
        for count in done:
            report(count)
    assert capsys.readouterr().err.splitlines()[-len(said) :] == said


@pytest.mark.parametrize(
    ("terminal", "shown"), [(False, [3, 15, 25]), (True, [3, 4, 12, 15, 25])]
)
def test_work_of_two_seconds_is_shown_now_and_then(monkeypatch, terminal, shown):
    """A log has a line every ten seconds; a line of a terminal changes ten times a second."""
    monkeypatch.setattr("sys.stderr", screen := io.StringIO())
    screen.isatty = lambda: terminal
    clock = [0.0, 1.0, 1.9, 3.0, 3.05, 4.0, 12.9, 15.0, 25.0]
    later = (50.0 + seconds for seconds in clock)
    monkeypatch.setattr(time, "monotonic", later.__next__)
    with progress.progress_bar("running", 100.0) as report:
        for seconds in clock[1:]:
            report(int(seconds))
    found = re.findall(r"running: (\d+) %", screen.getvalue())
    assert [*map(int, found)] == shown


def test_a_bar_shows_any_name_as_it_is(ticking, monkeypatch):
    monkeypatch.setattr("sys.stderr", screen := io.StringIO())
    screen.isatty = lambda: True
    with progress.progress_bar("running [red]{x}.toml", 4.0) as report:
        report(0)
        report(1)
    assert "running [red]{x}.toml" in screen.getvalue()


UNGUARDED = """
import os
from clpt_control.base.progress.processes import processes

print("once", flush=True)
with processes(1) as pool:
    print(pool.submit(abs, -1).result(), flush=True)
    {then}
"""
SEMAPHORES = pytest.mark.skipif(
    os.name != "posix", reason="tidied by another process there"
)
ENDS = [("pass", 0), pytest.param("os._exit(130)", 130, marks=SEMAPHORES)]


@pytest.mark.parametrize(("then", "status"), ENDS)
def test_a_script_needs_no_guard_and_one_that_ends_at_work_says_nothing(
    tmp_path, then, status
):
    """Nothing of semaphores."""
    (tmp_path / "unguarded.py").write_text(UNGUARDED.format(then=then))
    done = ran(sys.executable, "unguarded.py", status=status, cwd=tmp_path)
    assert (done.stdout, done.stderr) == ("once\n1\n", "")
