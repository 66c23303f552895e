"""Interrupts: none is lost, whenever it comes, and each is answered in one line."""

import signal
import sys

import pytest
from processes import CLPT, GUARD, await_line, interrupt, started, without_progress
from synthetic_vehicle import one_file_each
from tidal_records import times, waves, write_table

import clpt_control
from clpt_control.gliders.dive_table import sample_dives

LINE = "clpt: interrupted; nothing half-written was left\n"
IN_IMPORT = """
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)

class Interrupted:
    def find_spec(self, name, path=None, target=None):
        if name == chosen and not done:
            done.append(name)
            os.kill(os.getpid(), signal.SIGINT)

done, chosen = [], sys.argv[1]
sys.meta_path.insert(0, Interrupted())
sys.argv[:2] = ["clpt"]
from clpt_control.cli import main
main()
"""


@pytest.fixture
def files(tmp_path):
    """A scenario, a record and dives."""
    clpt_control.save_scenario(clpt_control.paper_scenario(), tmp_path / "s.toml")
    write_table(tmp_path / "r.csv", times(2), waves(times(2)))
    (tmp_path / "in").mkdir()
    one_file_each(tmp_path / "in", sample_dives()[:2])
    return tmp_path


def names(folder):
    return sorted(path.name for path in folder.rglob("*") if path.is_file())


RUN = ("run", "s.toml", "--out", "run.nc")
TIDES = ("tides", "r.csv", "--constituents", "M2", "--out", "out")
ENSEMBLE = ("ensemble", "s.toml", "--vary", "learning.gain=1:2", "--out", "e.zarr", "--members")
FOLLOW = ("replay", "--follow", "in", "--out", "out", "--patience", "0", "--json")


@pytest.mark.parametrize(
    ("module", "words"),
    [
        ("typer", RUN),
        ("clpt_control.estimation.kalman", FOLLOW),
        *(
            pytest.param(*case, marks=pytest.mark.processes)
            for case in (
                ("numpy", RUN),
                ("pydantic", RUN),
                ("llvmlite", RUN),
                ("llvmlite.binding", RUN),
                ("netCDF4", RUN),
                ("clpt_control.native.solver", RUN),
                ("utide", TIDES),
                ("utide.harmonics", TIDES),
                ("matplotlib.figure", TIDES),
                ("numpy", FOLLOW),
                ("matplotlib", FOLLOW),
                ("netCDF4", FOLLOW),
                ("zarr", (*ENSEMBLE, "8")),
                ("control", ("excitation", "s.toml")),
                ("clpt_control.diagrams.drawing", ("diagram", "s.toml", "-o", "d.svg")),
            )
        ),
    ],
)
def test_an_interrupt_in_an_import_is_an_interrupt(files, module, words):
    before = names(files)
    with started([sys.executable, "-c", IN_IMPORT, module, *words], cwd=files) as process:
        out, err = process.communicate(timeout=GUARD)
    assert (process.returncode, out, without_progress(err)) == (130, "", LINE)
    assert not [name for name in names(files) if name.endswith((".part", ".partial"))]
    assert set(before) <= set(names(files))


MODULE = """
import hashlib, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
from clpt_control import cli
from clpt_control.progress import interrupt
interrupt.PATIENCE = 0.1

def work():
{work}

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


def ended(work):
    with started([sys.executable, "-c", MODULE.format(work=work)]) as process:
        out, err = process.communicate(timeout=GUARD)
    return process.returncode, out, err


THEN = {
    "the next look": "interrupt.PATIENCE = 1e6; interrupt.check(); print('never')",
    "a wait": "interrupt.PATIENCE = 1e6; interrupt.wait(1e9)",
    "a loop that never looks": "while True: pass",
    "the command's end": "return 0",
    "another error": "raise ImportError('initialization failed')",
}


@pytest.mark.parametrize("then", THEN)
def test_an_interrupt_that_a_callback_drops_ends_the_command_by(then):
    assert ended(DROPPED.format(then=THEN[then])) == (130, "dropped\n", LINE)


def test_one_long_call_is_ended_with_its_half_written_files(tmp_path):
    work = f"""
    from pathlib import Path
    from clpt_control.files import beside
    with beside(Path({str(tmp_path)!r}) / "file"):
        print("up", flush=True)
        hashlib.pbkdf2_hmac("sha256", b"", b"", 2_000_000_000)  # in C, for most of an hour
"""
    with started([sys.executable, "-c", MODULE.format(work=work)]) as process:
        await_line(process, process.stdout, "up")
        assert interrupt(process) == ("", LINE)
    assert process.returncode == 130
    assert names(tmp_path) == []


def test_an_interrupt_of_code_that_python_ran_from_text():
    work = """
    from contextlib import suppress
    with suppress(KeyboardInterrupt):
        exec("signal.raise_signal(signal.SIGINT)")
    return 0
"""
    assert ended(work) == (130, "", LINE)


@pytest.mark.processes
@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="no POSIX signals")
def test_a_cluster_ends_with_the_command(files):
    pytest.importorskip("distributed")
    words = (*ENSEMBLE, "3000", "--chunk", "20", "--dask", "local", "--threads", "1")
    hear = "import clpt_control.progress as c; c.PATIENCE = c.LOG_EVERY = 0.0\n"
    code = CLPT[2].replace("from clpt", f"{hear}from clpt", 1)
    with started([sys.executable, "-c", code, *words], cwd=files) as process:
        await_line(process, process.stderr, "20 of 3000 members")
        assert interrupt(process) == ("", LINE)
    assert process.returncode == 130
