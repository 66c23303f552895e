"""Tracing has no side effects: nothing outside of a function changes, in any call that traces it.

Each function here changes something in a branch that no run enters (x stays below 1).  Python runs
such a function, so x(1) = exp(-1), and one sentence names the call.
"""

# ruff: noqa: PTH102, PTH104, PTH106, PTH107, PTH108, PTH118, PTH123

import asyncio
import ctypes
import logging
import mmap
import multiprocessing
import os
import random
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import warnings
from pathlib import Path

import control
import numpy as np
import pytest
from error_sentences import says

import clpt_control as clpt

FILE = Path("log.txt")  # in the folder of each test
FOLDER = Path("folder")
MEMORY, NUMBER = mmap.mmap(-1, 8), ctypes.c_double(0.0)
FLAG, STREAM = threading.Event(), []


def appends_to_a_file():
    with open(FILE, "a") as file:
        file.write("full")


def fills_a_table():
    with sqlite3.connect("runs.db") as base:
        base.execute("create table runs (t)")


EFFECTS = {  # what the sentence names -> what happens
    "os.remove": lambda: os.remove(FILE),
    "os.unlink": lambda: os.unlink(FILE),
    "os.rename": lambda: os.rename(FILE, "other.txt"),
    "os.mkdir": lambda: os.mkdir("made"),
    "os.rmdir": lambda: os.rmdir(FOLDER),
    "os.chdir": lambda: os.chdir(FOLDER),
    "os.system": lambda: os.system("echo full > other.txt"),
    "os.putenv": lambda: os.putenv("CLPT_FULL", "1"),
    "os.environ": lambda: os.environ.update(CLPT_FULL="1"),
    "shutil.rmtree": lambda: shutil.rmtree(FOLDER),
    "shutil.copy": lambda: shutil.copy(FILE, "other.txt"),
    "write_text": lambda: FILE.write_text("full"),
    "unlink": lambda: FILE.unlink(),
    "open": appends_to_a_file,
    "subprocess.run": lambda: subprocess.run(["touch", "other.txt"], check=True),
    "socket.socket": lambda: socket.socket().bind(("localhost", 0)),
    "sqlite3.connect": fills_a_table,
    "np.save": lambda: np.save("other.npy", np.zeros(2)),
    "np.seterr": lambda: np.seterr(under="warn"),
    "random": lambda: random.seed(7),
    "draws random": lambda: np.random.seed(7),  # noqa: NPY002
    "MEMORY": lambda: MEMORY.write(b"full"),
    "NUMBER": lambda: setattr(NUMBER, "value", 1.0),
    "FLAG": lambda: FLAG.set(),
    "threading.Thread": lambda: threading.Thread(target=FLAG.set).start(),
    "tempfile.mkdtemp": lambda: tempfile.mkdtemp(dir="."),
    "multiprocessing.Process": lambda: multiprocessing.Process(target=FLAG.set).start(),
    "signal.signal": lambda: signal.signal(signal.SIGTERM, signal.SIG_IGN),
    "sys.setrecursionlimit": lambda: sys.setrecursionlimit(5000),
    "asyncio.run": lambda: asyncio.run(asyncio.sleep(0)),
    "logging.disable": lambda: logging.disable(),
}


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def outside():
    """Return all that one of the functions could change."""
    files = {
        str(path): path.is_file() and path.read_bytes() for path in Path().rglob("*")
    }
    process = Path.cwd(), dict(os.environ), sys.getrecursionlimit()
    chance = random.getstate(), np.random.get_state()[1].tolist()  # noqa: NPY002
    held = bytes(MEMORY[:]), NUMBER.value, FLAG.is_set(), np.geterr()
    logs = logging.root.level, [*logging.root.handlers], logging.root.manager.disable
    return files, process, chance, held, logs, signal.getsignal(signal.SIGTERM)


def with_effect(effect):
    """Return a block and a system whose function has an effect beyond x = 10."""

    def rate(t, x, u, p):
        if x[0] > 10.0:
            effect()
        return [-x[0]]

    return control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="tank")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    FILE.write_text("a log")
    FOLDER.mkdir()
    return tmp_path


@pytest.mark.parametrize("named", EFFECTS)
def test_nothing_happens_in_any_call_that_traces(named, folder):
    tank, before = with_effect(EFFECTS[named]), outside()
    with pytest.warns(UserWarning, match=r"tank runs in Python") as caught:
        run = clpt.simulate(tank, [0.0, 1.0], initial_state=[1.0])
    assert outside() == before
    assert run.attrs["engine"] == "python"
    assert run.states[-1].item() == pytest.approx(np.exp(-1.0), rel=1e-6)
    assert named in str(caught[0].message)
    assert ", line " in str(caught[0].message)
    says(clpt.DiagramError, "tank.update: ", clpt.linearize, tank)
    says(clpt.DiagramError, "tank", clpt.export, tank, "tank.c")
    says(clpt.ClptError, "tank", clpt.equations, tank)
    says(clpt.ClptError, "tank", clpt.lyapunov, tank, "x[0]**2")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ensemble = clpt.run_ensemble(tank, "x[0]=0.5:1", 2, timepts=[0.0, 1.0])
    assert ensemble.sizes["member"] == 2
    assert outside() == before


# --- what does not keep a function from being traced ----------------------------------------------


LOGGER = logging.getLogger("tank")


def shouts(t, x, u, p):
    if x[0] > 10.0:
        print("full")
        print("full", file=sys.stderr)
        sys.stdout.write("full")
        warnings.warn("full", stacklevel=2)
        logging.warning("full")
        logging.getLogger().setLevel(1)
        LOGGER.warning("full of %s", "water")
        os.path.join("a", "b")
        sys.exit(1)
    return [-x[0]]


def test_what_is_printed_and_logged_is_neither_when_traced(capfd, caplog, recwarn):
    tank, before = (
        control.nlsys(shouts, None, inputs=0, states=1, name="tank"),
        outside(),
    )
    run = clpt.simulate(tank, [0.0, 1.0], initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    assert run.states[-1].item() == pytest.approx(np.exp(-1.0), rel=1e-6)
    assert clpt.linearize(tank).A.item() == pytest.approx(-1.0)
    assert capfd.readouterr() == ("", "")
    assert not caplog.records
    assert not recwarn.list
    assert outside() == before


def test_a_path_that_exits_is_nan_and_control_c_ends_the_program():
    def rate(t, x, u, p):
        if x[0] > 0.5:
            raise (SystemExit if p["exits"] else KeyboardInterrupt)
        return [-x[0]]

    tank = control.nlsys(
        rate, None, inputs=0, outputs=1, states=1, params={"exits": 1.0}
    )
    run = clpt.simulate(tank, [0.0, 1.0], initial_state=[0.4])
    assert run.states[-1].item() == pytest.approx(0.4 * np.exp(-1.0), rel=1e-6)
    with pytest.raises(clpt.SimulationError):
        clpt.simulate(tank, [0.0, 1.0], initial_state=[1.0])
    with pytest.raises(KeyboardInterrupt):
        clpt.simulate(tank, [0.0, 1.0], initial_state=[0.4], params={"exits": 0.0})


MODULE = """from pathlib import Path
Path("imported").touch()
gain = 2.0
"""


@pytest.mark.filterwarnings("ignore:.*runs in Python")
def test_a_module_that_a_branch_imports_is_not_run(folder, monkeypatch):
    monkeypatch.syspath_prepend(folder)
    Path("module_with_effect.py").write_text(MODULE)

    def rate(t, x, u, p):
        if x[0] > 10.0:
            import module_with_effect

            return [module_with_effect.gain]
        return [-x[0]]

    tank = control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="tank")
    assert (
        clpt.simulate(tank, [0.0, 1.0], initial_state=[1.0]).attrs["engine"] == "python"
    )
    assert not Path("imported").exists()
    assert "module_with_effect" not in sys.modules
    assert not list(folder.rglob("*.pyc"))


def test_a_pure_module_that_a_branch_imports_is_traced(folder, monkeypatch):
    monkeypatch.syspath_prepend(folder)
    Path("pure_module.py").write_text(
        "import math\n\n\ndef gain(x):\n    return math.cos(x)\n"
    )

    def rate(t, x, u, p):
        from pure_module import gain

        return [-gain(0.0) * x[0] if x[0] > 0 else gain(x[0])]

    tank = control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="tank")
    assert (
        clpt.simulate(tank, [0.0, 1.0], initial_state=[1.0]).attrs["engine"] == "native"
    )
