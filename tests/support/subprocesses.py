"""Processes that tests start: killed at the end whatever happens, and heard without noise."""

import re
import signal
import subprocess
import sys
from contextlib import contextmanager, suppress
from pathlib import Path

GUARD = 600  # seconds after which a test that hangs is given up, on any machine
CODE = (
    "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # as in a terminal
    "from clpt_control.app.cli import main; main()"
)
CLPT = [sys.executable, "-c", CODE]
# lines that only a slow machine shows
PROGRESS = re.compile(
    r".*: \d+ %.*|.*: \d+ of \d+ (members|frames).*|clpt: making the solver.*"
)


@contextmanager
def started(words, **options):
    """Start a process; its pipes are closed and it is gone at the end."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(list(map(str, words)), **pipes | options) as process:
        try:
            yield process
        finally:
            process.kill()


def ran(*words, status=0, **options):
    """Run a process to its end, which has this status, and give what it says."""
    own = {"capture_output": True, "text": True, "timeout": GUARD, **options}
    done = subprocess.run(list(map(str, words)), **own)
    assert done.returncode == status, done.stderr[-3000:]
    return done


def await_line(process, stream, part):
    """Read lines until one has a part; the process must not end before."""
    while part not in (line := stream.readline()):
        assert line, f"it ended, with status {process.wait()}, before it said '{part}'"
    return line


def interrupt(process):
    """Interrupt a process and give what it says to its end, without progress."""
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=GUARD)
    return out, without_progress(err)


def kill_while_it_writes(process, folder, part):
    """Kill a process once a file of this name lies in a folder or below it."""
    while not list(folder.rglob(part)):
        assert process.poll() is None
    process.kill()
    process.wait(GUARD)


def without_progress(text):
    """Leave out the lines that tell how far a command has come."""
    return "".join(
        line for line in text.splitlines(True) if not PROGRESS.fullmatch(line.strip())
    )


def listening(pids):
    """Give the local addresses, as Linux writes them, at which processes take connections."""
    held = set()
    for number in (one for pid in pids for one in Path(f"/proc/{pid}/fd").iterdir()):
        with suppress(OSError):
            held.add(str(number.readlink()))
    tables = (Path(f"/proc/self/net/{kind}") for kind in ("tcp", "tcp6", "udp", "udp6"))
    rows = [row.split() for one in tables for row in one.read_text().splitlines()[1:]]
    states = ("0A", "07")  # of TCP: listens; of UDP: has no peer
    return [row[1] for row in rows if row[3] in states and f"socket:[{row[9]}]" in held]
