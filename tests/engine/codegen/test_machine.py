"""The cache of compiled code: whose it is, how much it holds, what goes on without it; threads."""

import hashlib
import os
import re
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import control
import llvmlite.binding as llvm
import numpy as np
import pytest
from engine_runs import (
    Machine,
    NativeDiagram,
    Program,
    cache_code,
    cached_code,
    code_name,
    machine,
    print_program,
    run_many,
)
from paths import ROOT

from clpt_control import Block
from clpt_control.base.files import CACHE, cache_folder, trusted, write_cached

EMPTY = hashlib.sha256(b"").digest()  # a file with no code


@pytest.fixture
def folder(monkeypatch, tmp_path):
    place = tmp_path / "cache"
    monkeypatch.setenv(CACHE, str(place))
    return place


posix = pytest.mark.skipif(
    os.name != "posix", reason="no owners and modes on this system"
)


@posix
def test_a_folder_of_others_is_not_used(folder, monkeypatch):
    assert cache_folder() == folder  # made for the user alone
    assert folder.stat().st_mode & 0o777 == 0o700
    for mode in (0o770, 0o702, 0o777):
        folder.chmod(mode)
        assert (trusted(folder.stat()), cache_folder()) == (False, None)
    folder.chmod(0o755)
    assert cache_folder() == folder
    owner = folder.stat().st_uid
    if owner != 0:  # what the administrator put there is trusted
        monkeypatch.setattr(os, "getuid", lambda: owner + 1)
    else:
        os.chown(folder, 12345, -1)
    assert cache_folder() is None


@posix
def test_the_users_own_folder_comes_from_home(monkeypatch, tmp_path):
    for name in (CACHE, "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_folder() == tmp_path / ".cache" / "clpt-control"
    with monkeypatch.context() as patch:
        patch.setattr(os, "access", lambda path, mode: False)  # it is read-only
        assert cache_folder() is None
    monkeypatch.setenv("HOME", os.devnull + "/none")
    assert cache_folder() is None


def test_code_comes_back_whole_or_not_at_all(folder):
    cache_code("some", b"0123456789")
    assert cached_code("some") == b"0123456789"
    assert cached_code("other") is None
    path = folder / "some.o"
    whole = path.read_bytes()
    for damaged in (whole[:-4], b"", whole[:20], b"9" + whole[1:]):
        # as after a full disk
        path.write_bytes(damaged)
        assert cached_code("some") is None
    path.write_bytes(whole)
    assert cached_code("some") == b"0123456789"


@posix
def test_what_is_kept_is_the_users_own_whatever_the_umask(folder):
    before = os.umask(0o002)
    try:
        cache_code("some", b"0123456789")
    finally:
        os.umask(before)
    path = folder / "some.o"
    assert (path.stat().st_mode & 0o777, cached_code("some")) == (0o600, b"0123456789")
    for place in (folder, path):
        place.chmod(0o777)
        assert cached_code("some") is None
        place.chmod(0o700)
    cache_code("some", b"9876543210")  # and is trusted again
    assert cached_code("some") == b"9876543210"
    path.unlink()
    os.mkfifo(path)  # which a reader would wait for
    assert cached_code("some") is None


def test_few_files_stay(folder):
    cache_folder()
    for k in range(5):
        write_cached(folder / f"code-{k}.o", EMPTY, 3)
        os.utime(folder / f"code-{k}.o", (1000 + k, 1000 + k))
        write_cached(folder / f"{k}.o", EMPTY, 3)
        assert cached_code("code-0") == b""  # used, so it stays
    stay = {one.stem for one in folder.iterdir()}
    assert stay == {"code-0", "code-3", "code-4", "2", "3", "4"}  # of each family


def test_nothing_can_be_kept_and_the_work_goes_on(monkeypatch):
    monkeypatch.setenv(CACHE, os.devnull + "/none")
    program = Program((), {"nothing": ()}, {}, (), 0, 0, 0, ())
    for _ in range(2):
        machine_code = Machine(
            ["nothing"], "nothing", lambda: print_program(program, ("nothing",), 1)
        )
        assert machine_code.addresses["nothing"]


def test_the_name_changes_with_what_is_compiled(monkeypatch):
    names = {code_name("text"), code_name("another")}
    monkeypatch.setenv(machine.VARIABLE, "another")
    names.add(code_name("text"))
    monkeypatch.setattr(machine, "llvm_version", "9")
    names.add(code_name("text"))
    assert len(names) == 4


PAGES = ("solver_layout", "event_checks", "event_location", "implicit", "segments")


@pytest.mark.parametrize(
    ("text", "pages"),
    [(machine.TEXT, (*PAGES, "time_stepper")), (machine.BALLS, ("ball_series",))],
)
def test_a_text_of_machine_code_is_of_its_source(text, pages):
    """`make solver` prints both."""
    wanted = hashlib.sha256()
    for page in pages:
        wanted.update((text.parent / f"{page}.py").read_bytes())
    wanted.update((ROOT / "tools" / "print_solver.py").read_bytes())
    first, text = text.read_text("utf-8").split("\n", 1)
    of_text = hashlib.sha256(text.encode()).hexdigest()
    assert first.startswith(f"; sha256 {wanted.hexdigest()} {of_text}, Python 3")
    assert not re.search(r"target|\bx86|/home|/work|/root", text)


@pytest.mark.long
@pytest.mark.parametrize(
    "triple",
    ["x86_64-pc-windows-msvc", "arm64-apple-darwin", "aarch64-unknown-linux-gnu"],
)
def test_the_solver_is_made_for_other_processors(triple):
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple(triple).create_target_machine()
    parsed = llvm.parse_assembly(machine.TEXT.read_text("utf-8"))
    parsed.triple, parsed.data_layout = triple, str(target.target_data)
    assert len(target.emit_object(parsed)) > 10_000


def test_threads_that_compile_at_once_get_the_same_code():
    """A structure that nobody has asked for yet."""
    own = np.random.default_rng().normal(size=3).tolist()
    block = Block(
        "own", update=lambda t, x, u, p: own[0] * x - own[1] * x**3, states={"x": 3}
    )
    together, start = threading.Barrier(6), np.array([1.0, 0.4, -0.2])

    def run(k):
        together.wait()
        native = NativeDiagram(block)
        found = [
            run_many(native, np.tile(start, (m, 1)), [0.0, 4.0])[0] for m in (1, 8)
        ]
        return native.code, found

    with ThreadPoolExecutor(6) as pool:
        codes, found = zip(*pool.map(run, range(6)), strict=True)
    assert len(set(codes)) == 1
    np.testing.assert_allclose(
        found, np.tile(found[0][1], (6, 2, 1, 1)), rtol=1e-12, atol=1e-12
    )


def test_each_thread_runs_a_shared_block_with_its_own_params():
    own = {"states": {"x": 1}, "parameters": {"rate": 1.0}}
    block = Block("plant", update=lambda t, x, u, p: -p.rate * x, **own)
    rates, times = 1.0 + 0.3 * (np.arange(48) % 8), np.linspace(0.0, 1.0, 20)

    def run(rate):
        asked = {"params": {"plant.rate": rate}, "solve_ivp_kwargs": {"rtol": 1e-8}}
        return control.input_output_response(block, times, 0, [1.0], **asked).states[0]

    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(run, rates))
    np.testing.assert_allclose(found, np.exp(-np.outer(rates, times)), atol=1e-5)


@pytest.mark.long
@pytest.mark.skipif(
    not Path("/proc/self/fd").is_dir(), reason="folders are asked by name there"
)
def test_a_folder_renamed_by_others_meanwhile_is_not_read_or_written(folder):
    """A thread puts a folder that others may write to in the cache's place, again and again.

    It holds a file that is the user's own by a link, as whoever may rename in the parent folder
    can make it: the file alone does not tell.
    """
    own, theirs, link, foreign = map(
        folder.with_name, ("own", "theirs", "link", "foreign.o")
    )
    folder.symlink_to(own)
    own.mkdir(mode=0o700)
    cache_code("some", b"own")
    theirs.mkdir()
    (theirs / "some.o").symlink_to(foreign)
    foreign.write_bytes(hashlib.sha256(b"foreign").digest() + b"foreign")
    theirs.chmod(0o777)
    swaps, ended = [0], threading.Event()

    def swap():
        while not ended.is_set():
            for place in (theirs, own):
                link.symlink_to(place)
                link.replace(folder)
            swaps[0] += 1

    with ThreadPoolExecutor(1) as pool:
        other = pool.submit(swap)
        try:
            found = Counter(cached_code("some") for _ in range(20_000))
            for _ in range(2_000):
                cache_code("new", b"new")
        finally:
            ended.set()
        other.result()
    assert swaps[0] > 100
    assert set(found) <= {b"own", None}
    assert found[b"own"] > 100
    assert [one.name for one in theirs.iterdir()] == ["some.o"]
