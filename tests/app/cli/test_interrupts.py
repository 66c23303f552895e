"""Commands as processes: interrupts, the same bytes, damaged inputs."""

import fnmatch
import json
import os
import random
import re
import shutil
import signal
import sys
import time
from contextlib import suppress

import pytest
from command_outputs import COMMANDS, ENSEMBLE, FOLLOW, RUN, seldom, write_each
from paths import ROOT, TESTS
from subprocesses import (
    CLPT,
    CODE,
    GUARD,
    await_line,
    interrupt,
    ran,
    started,
    without_progress,
)

LINE = "clpt: interrupted; nothing half-written was left\n"
HELD = r"clpt: interrupted; e\.zarr holds \d+ of \d+ members; the same command goes on from there\n"
HEARS = """
import hashlib, os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
"""
IN_IMPORT = f"""{HEARS}
class Interrupted:
    def find_spec(self, name, path=None, target=None):
        if name == chosen and not done:
            done.append(name)
            os.kill(os.getpid(), signal.SIGINT)

done, chosen = [], sys.argv[1]
sys.meta_path.insert(0, Interrupted())
sys.argv[:2] = ["clpt"]
from clpt_control.app.cli import main
main()
"""


@pytest.fixture
def files(tmp_path):
    """What each command is given; they begin with nothing else."""
    write_each(tmp_path, 40)
    return tmp_path


def names(folder):
    return sorted(path.name for path in folder.rglob("*") if path.is_file())


IMPORTS = {  # what is imported when the interrupt comes -> the command
    "typer": RUN,
    "clpt_control.ocean.estimation.process_mixture": FOLLOW,
    "numpy": FOLLOW,
    "llvmlite.binding": RUN,
    "netCDF4": RUN,
    "zarr": (*ENSEMBLE, "8"),
    "clpt_control.plots.drawing": ("export", "s.toml", "--drawing", "-o", "d.svg"),
}


@pytest.mark.long
@pytest.mark.parametrize("module", seldom(IMPORTS, 2))
def test_an_interrupt_in_an_import_is_an_interrupt(files, module):
    before, words = names(files), IMPORTS[module]
    done = ran(sys.executable, "-c", IN_IMPORT, module, *words, cwd=files, status=130)
    assert (done.stdout, without_progress(done.stderr)) == ("", LINE)
    assert not [name for name in names(files) if name.endswith((".part", ".partial"))]
    assert set(before) <= set(names(files))


MODULE = f"""{HEARS}
from clpt_control.app import cli
from clpt_control.base.progress import interrupt
interrupt.PATIENCE = 0.1

def work():
WORK

cli._run = work
cli.main()
"""
DROPPED = """
    class Callback:
        def __del__(self):  # Python drops what is raised here
            signal.raise_signal(signal.SIGINT)
    callback = Callback()
    del callback
    print("dropped", flush=True)
    {then}
"""


THEN = {
    "the next look": "interrupt.PATIENCE = 1e6; interrupt.check(); print('never')",
    "a wait": "interrupt.PATIENCE = 1e6; interrupt.wait(1e9)",
    "a loop that never looks": "while True: pass",
    "the command's end": "return 0",
    "another error": "raise ImportError('initialization failed')",
}


@pytest.mark.parametrize("then", THEN)
def test_an_interrupt_that_a_callback_drops_ends_the_command_by(then):
    work = DROPPED.format(then=THEN[then])
    done = ran(sys.executable, "-c", MODULE.replace("WORK", work), status=130)
    assert (done.stdout, done.stderr) == ("dropped\n", LINE)


def test_one_long_call_is_ended_with_its_half_written_files(tmp_path):
    work = f"""
    from pathlib import Path
    from clpt_control.base.files import atomic_path
    with atomic_path(Path({str(tmp_path)!r}) / "file"):
        print("up", flush=True)
        hashlib.pbkdf2_hmac("sha256", b"", b"", 2_000_000_000)  # in C, for most of an hour
"""
    with started([sys.executable, "-c", MODULE.replace("WORK", work)]) as process:
        await_line(process, process.stdout, "up")
        assert interrupt(process) == ("", LINE)
    assert (process.returncode, names(tmp_path)) == (130, [])


@pytest.mark.processes
@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="no POSIX signals")
def test_a_cluster_ends_with_the_command(files):
    pytest.importorskip("distributed")
    words = (*ENSEMBLE, "3000", "--chunk", "20", "--dask", "local", "--threads", "1")
    hear = "import clpt_control.base.progress as c; c.PATIENCE = c.LOG_EVERY = 0.0\n"
    with started([sys.executable, "-c", hear + CODE, *words], cwd=files) as process:
        await_line(process, process.stderr, "20 of 3000 members")
        out, err = interrupt(process)
    assert (out, process.returncode, bool(re.fullmatch(HELD, err))) == (
        "",
        130,
        True,
    ), err


START = f"""{HEARS}
sys.path.insert(0, sys.argv[1])
from clpt_control import __main__ as command
sys.argv[:2] = ["clpt"]
sys.stdout.write(".")
sys.stdout.flush()
command.main()
"""


def interrupted_after(seconds, words, folder):
    """Interrupt a command and its own processes, as a terminal does; what it says, its status."""
    start, own = (
        [sys.executable, "-c", START, ROOT, *words],
        {"start_new_session": True},
    )
    with started(start, cwd=folder, **own) as process:
        assert process.stdout.read(1) == "."
        time.sleep(seconds)
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGINT)
        _, err = process.communicate(timeout=GUARD)
    return process.returncode, without_progress(err)


@pytest.mark.long
@pytest.mark.skipif(not hasattr(os, "killpg"), reason="no groups of processes")
@pytest.mark.parametrize("part", seldom(range(60)))
def test_interrupts_at_random_from_the_first_import_on(files, part):
    chance = random.Random(part)
    before = {
        path: path.stat().st_mtime_ns for path in files.rglob("*") if path.is_file()
    }
    for k in range(5 * part, 5 * (part + 1)):  # all sixty tests are 300
        words = [*COMMANDS][k % len(COMMANDS)]
        seconds = chance.uniform(0.0, 1.0 if k % 2 == 0 or part == 0 else 6.0)
        status, err = interrupted_after(seconds, words, files)
        told, made = (seconds, words, status, err), COMMANDS[words] or ()
        # before the interrupt
        finished = status == 0 and not re.search("Traceback|fault", err)
        assert finished or (status == 130 and re.fullmatch(f"{LINE}|{HELD}", err)), told
        paths = [
            path for path in files.rglob("*") if path not in before and path.is_file()
        ]
        new = [path.name for path in paths]
        assert not [one for one in new if one.endswith((".part", ".partial"))], told
        assert not new or all(fnmatch.filter(new, one) for one in made), told
        for name in ("out", "e.zarr"):
            shutil.rmtree(files / name, ignore_errors=True)
        for path in paths:
            path.unlink(missing_ok=True)
    assert {path: path.stat().st_mtime_ns for path in before} == before


# --- the same bytes: cold and warm cache, 1 and 4 threads, any hashes ----------------------------

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
# `watch` tells when it was
SAME = [words for words in COMMANDS if words[0] != "watch"]
SAME.sort(key=lambda words: "--drawing" not in words)


def held(folder):
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


@pytest.fixture(scope="module")
def given(tmp_path_factory):
    write_each(folder := tmp_path_factory.mktemp("given"), 420)
    return folder


@pytest.mark.long
@pytest.mark.parametrize("words", seldom(SAME))
def test_the_same_command_gives_the_same_bytes(given, tmp_path, words):
    found = []
    for seed, threads in (("1", "1"), ("2", "1" if "--waypoints" in words else "4")):
        work = tmp_path / "work"  # the same name: it is part of what is printed
        shutil.copytree(given, work)
        env = {**os.environ, **dict.fromkeys(THREADS, threads), "PYTHONHASHSEED": seed}
        env["CLPT_CONTROL_CACHE"] = str(tmp_path / "cache")  # cold, then warm
        more = ("--threads", threads) if words[0] == "ensemble" else ()
        done = ran(*CLPT, *words, *more, cwd=work, env=env)
        assert without_progress(done.stderr) == ""
        found.append((done.stdout, held(work)))
        work.rename(tmp_path / f"work{seed}")
    (said, files), (again, others) = found
    assert (said, files.keys()) == (again, others.keys())
    assert [name for name in files if files[name] != others[name]] == []


# --- damaged inputs, which `damaged_inputs` makes; it says what an answer is ---------------------

FORKED = pytest.mark.skipif(not hasattr(os, "fork"), reason="cases are forked")
CASES = TESTS / "support" / "damaged_inputs.py"


THOUSANDS = [
    pytest.param((k, 1000), marks=pytest.mark.slow) for k in (1000, 2000, 3000)
]


@pytest.mark.long
@FORKED
@pytest.mark.parametrize("words", [(0, 40, 0), *THOUSANDS])
def test_damaged_inputs_are_answered(words):
    """A share of them; `make test-slow` asks 3,000."""
    ended = ran(
        sys.executable, CASES, *words, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    )
    answers = [json.loads(line) for line in ended.stdout.splitlines()]
    keys = ("case", "wrong", "words", "how", "err")
    assert [{key: one[key] for key in keys} for one in answers if one["wrong"]] == []
    assert len(answers) == words[1]
