"""The cache of compiled code: whose it is, how much it holds, and what goes on without it."""

import inspect
import os
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from clpt_control.files.user_cache import FOLDER, cache_folder, trusted
from clpt_control.native import solver, solver_cache
from clpt_control.native.solver_cache import KEPT

TEXT = Path(solver.__file__)


@pytest.fixture
def folder(monkeypatch, tmp_path):
    place = tmp_path / "cache"
    monkeypatch.setenv(FOLDER, str(place))
    return place


def test_the_folder_is_made_for_the_user_alone(folder):
    assert cache_folder() == folder
    assert folder.is_dir()
    if hasattr(os, "getuid"):
        assert folder.stat().st_mode & 0o777 == 0o700
    assert cache_folder() == folder  # and found again


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="no owners and modes on this system")
def test_a_folder_of_others_is_not_used(folder, monkeypatch):
    folder.mkdir(mode=0o700)
    for mode in (0o770, 0o702, 0o777):
        folder.chmod(mode)
        assert not trusted(folder)
        assert cache_folder() is None
    folder.chmod(0o755)
    assert cache_folder() == folder
    owner = folder.stat().st_uid
    if owner != 0:  # what the administrator put there is trusted
        monkeypatch.setattr(os, "getuid", lambda: owner + 1)
        assert cache_folder() is None
    else:
        os.chown(folder, 12345, -1)
        assert cache_folder() is None


def test_without_a_home_or_with_a_read_only_one_there_is_no_folder(folder, monkeypatch):
    cache_folder()
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    assert cache_folder() is None
    monkeypatch.undo()
    monkeypatch.setenv(FOLDER, os.devnull + "/none/at/all")
    assert cache_folder() is None


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="the folder is found elsewhere")
def test_the_users_own_folder_comes_from_home(monkeypatch, tmp_path):
    for name in (FOLDER, "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_folder() == tmp_path / ".cache" / "clpt-control"
    monkeypatch.setenv("HOME", os.devnull + "/none")
    assert cache_folder() is None


def test_the_text_lies_beside_its_code_and_is_checked(folder):
    place = solver_cache._place(cache_folder(), TEXT)
    assert place.read_bytes() == TEXT.read_bytes()
    assert place.parent.stat().st_mode & 0o022 == 0
    assert solver_cache._place(folder, TEXT) == place
    if hasattr(os, "getuid"):
        place.parent.chmod(0o777)
        assert solver_cache._place(folder, TEXT) is None
        place.parent.chmod(0o700)
    place.write_text("print('not ours')\n")
    assert solver_cache._place(folder, TEXT) is None


def test_files_cut_short_are_made_again(folder):
    place = solver_cache._place(cache_folder(), TEXT)
    kept = place.parent / "__pycache__"
    kept.mkdir()
    index, code = kept / "solver.advance-1.nbi", kept / "solver.advance-1.1.nbc"
    index.write_bytes(pickle.dumps("0.60") + pickle.dumps(("stamp", {})))
    code.write_bytes(pickle.dumps(("code", b"0123456789")))
    assert solver_cache._place(folder, TEXT) == place
    assert code.exists()
    for file, whole in ((index, index.read_bytes()), (code, code.read_bytes())):
        file.write_bytes(whole[:-4])
        assert solver_cache._place(folder, TEXT) == place
        assert not kept.exists()
        kept.mkdir()


def test_few_of_other_versions_stay(folder):
    cache_folder()
    for k in range(KEPT + 3):
        (folder / f"solver-{k}").mkdir()
        os.utime(folder / f"solver-{k}", (1000 + k, 1000 + k))
    place = solver_cache._place(folder, TEXT)
    left = {one.name for one in folder.iterdir()}
    assert left == {place.parent.name, *(f"solver-{k}" for k in range(3, KEPT + 3))}


def test_nothing_can_be_kept_and_the_work_goes_on(monkeypatch):
    monkeypatch.setattr(solver_cache, "cache_folder", lambda: None)
    kept = []
    monkeypatch.setattr(solver_cache, "_compile", lambda module, keep: kept.append(keep))
    monkeypatch.setitem(sys.modules, "clpt_control_solver", None)
    module = inspect.unwrap(solver_cache._compiled)()
    assert kept == [False]
    assert Path(module.__file__) == TEXT


def test_the_key_changes_with_what_is_compiled(monkeypatch):
    first = solver_cache._key()
    assert solver_cache._key() == first
    monkeypatch.setattr(solver_cache, "processor", lambda: ("another", "+fma"))
    assert solver_cache._key() != first


RUN = """
import clpt_control as clpt
scenario = clpt.paper_scenario().with_values({"run.duration": 20})
print(clpt.simulate(scenario, engine="native").attrs["status"])
"""


def test_two_processes_fill_it_at_once(folder):
    def start():
        return subprocess.Popen([sys.executable, "-c", RUN], stdout=-1, stderr=-1, text=True)

    with start() as one, start() as other:
        try:
            for work in (one, other):
                out, error = work.communicate(timeout=300)
                assert (work.returncode, out) == (0, "finished\n"), error
        finally:
            one.kill()
            other.kill()
    (own,) = folder.iterdir()
    kept = {path: path.stat().st_mtime_ns for path in own.rglob("*.nbc")}
    assert kept
    again = subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True)
    assert (again.returncode, again.stdout) == (0, "finished\n"), again.stderr
    assert {path: path.stat().st_mtime_ns for path in own.rglob("*.nbc")} == kept
