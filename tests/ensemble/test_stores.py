"""The folder of an ensemble: what is damaged is named and left, or run again."""

import errno
import hashlib
import json
import os
import re
import shutil
import tracemalloc

import pytest
import zarr
from error_sentences import says
from sampled_runs import VARY, files

import clpt_control as clpt
from clpt_control import DataError, run_ensemble


@pytest.fixture(scope="module")
def whole(quick, tmp_path_factory):
    """A whole store of two chunks, with what makes it."""
    given = {
        "system": quick,
        "vary": VARY[0],
        "members": 6,
        "chunk": 3,
        "trajectories": True,
    }
    out = tmp_path_factory.mktemp("stored") / "e.zarr"
    run_ensemble(out=out, **given)
    return out, given


@pytest.fixture
def out(whole, tmp_path):
    """A copy of it."""
    return shutil.copytree(whole[0], tmp_path / "e.zarr")


def edited(key, value):
    def edit(path):
        path.write_text(json.dumps(json.loads(path.read_text()) | {key: value}))

    return edit


def flipped(path):
    raw = bytearray(path.read_bytes())
    raw[len(raw) // 2] ^= 0xFF
    path.write_bytes(raw)


def shortened(path):
    path.write_bytes(path.read_bytes()[:-6])


def another_chunk(path):
    """Put the first chunk in the place of the second one; its own checksum is right."""
    shutil.copy(str(path).replace("/c/1", "/c/0"), path)


def put(make):
    """Put something else in the place of a file."""

    def replace(path):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
        make(path)

    return replace


LOST = "(is not an ensemble|damaged, .*its {array} is)"
DAMAGES = [  # a file, what happens to it, what is said: its array is not as it was made
    ("gain_error/zarr.json", os.unlink, LOST),
    ("learning.gain/zarr.json", edited("shape", [7]), LOST),
    (
        "learning.gain/zarr.json",
        edited("shape", [3 * 10**7]),
        LOST,
    ),  # which is not read
    ("end/zarr.json", edited("data_type", "float32"), LOST),
    ("mark/zarr.json", edited("dimension_names", ["time"]), LOST),
    ("alpha/zarr.json", edited("attributes", {}), LOST),
    ("done/zarr.json", edited("shape", [9]), LOST),
    ("clpe_rms/zarr.json", edited("fill_value", 0.0), LOST),
    ("zarr.json", flipped, LOST),
    ("zarr.json", put(lambda at: at.write_text("{}")), LOST),
    ("time/c/0", flipped, LOST),
    ("learning.gain/c/1", flipped, LOST),
    ("learning.gain/c/1", another_chunk, LOST),
    ("member/c/0", os.unlink, LOST),
    ("status", shutil.rmtree, LOST),
    (
        "mine",
        lambda at: shutil.copytree(at.parent / "end", at),
        "mine, which is not part of",
    ),
    ("status/c/0", put(os.mkfifo), "c/0: is not a regular file"),
    (
        "status/c/0",
        put(lambda at: at.symlink_to(at.parent / "1")),
        "c/0: is not a regular file",
    ),
    ("", put(lambda at: at.write_text("text")), "(is a file|cannot be read as NetCDF)"),
    ("zarr.json", os.unlink, "is a folder without an ensemble"),
]


@pytest.mark.parametrize(("name", "damage", "said"), DAMAGES)
def test_a_damaged_ensemble_is_a_sentence(whole, out, name, damage, said):
    """It is named before it is gone on with, or shown; nothing is written."""
    damage(out / name)
    before = files(out)
    words = rf"e\.zarr.*{said.format(array=re.escape(name.partition('/')[0]))}"
    tracemalloc.start()
    for go_on in (
        lambda: run_ensemble(out=out, **whole[1]),
        lambda: clpt.report(out, "e.html"),
    ):
        says(DataError, words, go_on)
    assert tracemalloc.get_traced_memory()[1] < 5 * 10**7
    tracemalloc.stop()
    assert files(out) == before
    assert not os.path.lexists("e.html")


CHUNKS = [
    ("gain_error/c/0/0", flipped),
    ("alpha/c/1/0/0/0", flipped),
    ("gain_error/c/1/0", shortened),
    ("gain_error/c/1/0", another_chunk),
    ("done/c/0", shortened),  # a checksum
    ("clpe_rms_whole/c/1", os.unlink),
    ("alpha/c/1/0/0/0", os.unlink),
]


@pytest.mark.parametrize(("name", "damage"), CHUNKS)
def test_a_damaged_chunk_is_run_again(whole, out, name, damage):
    damage(out / name)
    if not name.startswith(("alpha", "done")):  # which a page does not read
        with pytest.raises(
            DataError, match=r"is damaged: (chunk \d is not as written|a part of)"
        ):
            clpt.report(out, "e.html")
    run_ensemble(out=out, **whole[1])
    assert files(out) == files(whole[0])


def test_a_whole_ensemble_is_not_run_again(whole, out):
    counts, written = [], {path: path.stat().st_mtime_ns for path in out.rglob("c/*")}
    run_ensemble(out=out, progress=counts.append, **whole[1])
    assert counts[:1] == [6]  # members that are there before any is run
    assert written == {path: path.stat().st_mtime_ns for path in out.rglob("c/*")}


@pytest.mark.parametrize("name", ["members", "chunk", "keys", "scenario"])
def test_arguments_that_do_not_fit_are_told(out, tmp_path, name):
    group = zarr.open_group(out)
    text = group.attrs["ensemble"]
    for value in (None, 10**12, [], "x", -1, 0):
        group.attrs["ensemble"] = json.dumps({**json.loads(text), name: value})
        says(DataError, r"is damaged", clpt.report, out, tmp_path / "e.html")


def test_what_lacks_is_neither_mixed_nor_written_over(whole, out):
    """A chunk is not made by other versions, nor put where something else lies."""
    group, one = zarr.open_group(out), out / "clpe_rms_whole" / "c" / "1"
    kept = dict(group.attrs)
    group.attrs["code"] = "another"
    others = sorted((k, v) for k, v in group.attrs.items() if k != "digests")
    digest = hashlib.sha256(repr(others).encode()).hexdigest()[:16]
    digests = json.loads(kept["digests"]) | {"zarr.json": digest}
    group.attrs["digests"] = json.dumps(digests)
    run_ensemble(out=out, **whole[1])
    group["done"][1] = 0
    says(DataError, "by other versions", run_ensemble, out=out, **whole[1])
    group.attrs.update(kept)
    put(lambda at: (at / "mine").mkdir(parents=True))(one)
    says(
        DataError,
        r"clpe_rms_whole.c.1: cannot be written",
        run_ensemble,
        out=out,
        **whole[1],
    )


OTHERS = {"seed": 1, "members": 7, "design": "random", "vary": "learning.gain=1:2"}
OTHERS |= {"trajectories": False, "chunk": 2, "scenario": 0.9}


@pytest.mark.parametrize(("what", "value"), OTHERS.items())
def test_another_ensemble_is_refused(whole, out, what, value):
    before, given = files(out), {**whole[1], what: value}
    if gain := given.pop("scenario", None):
        given["system"] = given["system"].with_values({"learning.gain": gain})
    says(
        DataError,
        f"contains an ensemble of another {what}",
        run_ensemble,
        out=out,
        **given,
    )
    assert files(out) == before


def test_where_there_is_none_it_begins(whole, tmp_path):
    (tmp_path / "new").mkdir()
    assert run_ensemble(out=tmp_path / "new", **whole[1]).sizes["member"] == 6
    says(
        DataError,
        "does not exist",
        run_ensemble,
        out=tmp_path / "no" / "e.zarr",
        **whole[1],
    )

    def too_much(done):
        raise MemoryError

    with pytest.raises(MemoryError):
        run_ensemble(out=tmp_path / "e.zarr", progress=too_much, **whole[1])
    assert [path.name for path in tmp_path.iterdir()] == ["new"]


def test_what_ends_an_ensemble_says_what_is_kept(clpt, quick, tmp_path, monkeypatch):
    from clpt_control import save_scenario

    save_scenario(quick, tmp_path / "s.toml")
    out, write = tmp_path / "e.zarr", zarr.storage.LocalStore.set
    words = (
        "ensemble",
        tmp_path / "s.toml",
        "--vary",
        "learning.gain=1:2",
        "--threads",
        "1",
    )

    def asked(after, members="4", chunk="2"):
        """Run the command, which finds no space after some chunks."""

        async def full(store, key, value):
            name, is_chunk, number = key.partition("/c/")
            if name == "clpe_rms_whole" and is_chunk and int(number) >= after:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            await write(store, key, value)

        monkeypatch.setattr(zarr.storage.LocalStore, "set", full)
        return clpt(*words, "--out", out, "--members", members, "--chunk", chunk)

    said = f"clpt: {out}: cannot be written: No space left on device"
    for ended in (asked(0), asked(0, "24", "24")):
        # of the last, members are done, none stored
        assert (ended.status, ended.err.splitlines()[-1], out.exists()) == (
            2,
            said,
            False,
        )
    kept = f"{out} holds 2 of 4 members; the same command goes on from there"
    assert asked(1) == (2, "", f"{said}; {kept}\n")
    outcome = asked(2)
    there = "clpt: running s.toml: 2 of 4 members were there already\n"
    assert (outcome.status, outcome.err) == (0, there)
