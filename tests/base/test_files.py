"""Files and folders are written beside their place: whole, or not at all."""

import errno
import os
import re
import struct
import sys
from contextlib import suppress
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray
import zarr
from command_outputs import write
from error_sentences import says
from matplotlib.figure import Figure
from subprocesses import ran

import clpt_control
from clpt_control import DataError
from clpt_control.base.files import atomic_path, make_folder, write_together
from clpt_control.base.files.reading import open_netcdf, zarr_store
from clpt_control.base.progress import interrupt
from clpt_control.ocean.gliders.dive_files import read_dive_file


def inner(path):
    return path / "inner" if path.is_dir() else path


def names(folder):
    return {path.name for path in folder.iterdir()}


@pytest.mark.parametrize("folder", [False, True])
@pytest.mark.parametrize("fails", [False, True])
def test_what_is_made_beside_is_seen_at_the_end_if_at_all(tmp_path, folder, fails):
    place = tmp_path / "made"
    with suppress(ZeroDivisionError), atomic_path(place, folder) as made:
        assert (made.parent, made.is_dir()) == (tmp_path, folder)
        inner(made).write_text("whole")
        assert not place.exists()
        if fails:
            raise ZeroDivisionError
    assert list(tmp_path.iterdir()) == ([] if fails else [place])
    assert fails or inner(place).read_text() == "whole"
    assert interrupt.unfinished == set()


def test_a_folder_takes_the_place_of_no_other(tmp_path):
    (taken := tmp_path / "taken").mkdir()
    inner(taken).write_text("before")
    said = "taken: cannot be written: another command made"
    with pytest.raises(DataError, match=said), atomic_path(taken, folder=True) as made:
        inner(made).write_text("after")
    assert (inner(taken).read_text(), names(tmp_path)) == ("before", {"taken"})


def test_files_that_belong_together_are_all_written_or_none(tmp_path):
    data = xarray.Dataset({"u": ("time", [1.0, float("nan")])})
    results = {"a.txt": "text", "b.nc": data, "c.png": Figure()}
    results = {tmp_path / name: one for name, one in results.items()}
    more = {**results, tmp_path / "none" / "d.txt": "text"}
    says(DataError, r"none/d\.txt: cannot be written: the folder", write_together, more)
    assert names(tmp_path) == set()
    write_together(results)
    assert (tmp_path / "a.txt").read_text() == "text"
    with xarray.open_dataset(tmp_path / "b.nc") as read:
        assert read.identical(data)
    assert (tmp_path / "c.png").read_bytes().startswith(b"\x89PNG")
    assert len(names(tmp_path)) == 3


POSIX = pytest.mark.skipif(os.name != "posix", reason="no such modes and processes")


@POSIX
def test_what_a_killed_process_left_goes_when_its_place_is_written_again(tmp_path):
    with atomic_path(tmp_path / "replay.nc") as made:
        here = made.name
    ended = ran(sys.executable, "-c", "import os; print(os.getpid())").stdout.strip()
    dead = re.sub(r"-\d+-", f"-{ended}-", here)
    elsewhere = re.sub(r"\.[0-9a-f]{8}-", ".00000000-", dead)
    other = dead.replace("replay", "other")
    kept = {here, elsewhere, other, ".replay.nc.part", ".replay.nc.mine", f"{dead}2"}
    for name in {dead, *kept}:
        (tmp_path / name).write_text("half")
    (tmp_path / dead.replace(".nc", ".zarr")).mkdir()
    with atomic_path(tmp_path / "replay.zarr", folder=True):
        pass
    write_together({tmp_path / "replay.nc": "whole"})
    assert names(tmp_path) == {*kept, "replay.nc", "replay.zarr"}


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_folders_that_stay_empty_go_with_the_command(clpt, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write({"run.duration": 20})
    words = "run", "s.toml", "--figures", "used/inner", "--out"

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", full)
        assert clpt(*words, "r.nc").status == 2
    assert names(Path()) == {"s.toml"}
    make_folder("empty/inner")
    assert clpt(*words, "r.nc").status == 0
    assert names(Path()) == {"s.toml", "r.nc", "used"}
    assert (Path("used/inner/figure1.png")).exists()


@POSIX
@pytest.mark.parametrize(
    ("umask", "file", "folder"), [(0o77, 0o600, 0o700), (2, 0o664, 0o775)]
)
def test_modes_are_those_of_the_umask_or_of_what_is_replaced(
    tmp_path, umask, file, folder
):
    closed = tmp_path / "closed"
    closed.touch(0o600)
    before = os.umask(umask)
    try:
        write_together({tmp_path / "new": "text", closed: "after"})
        with atomic_path(tmp_path / "made", folder=True):
            pass
    finally:
        os.umask(before)
    modes = [
        (tmp_path / name).stat().st_mode & 0o777 for name in ("new", "closed", "made")
    ]
    assert (modes, closed.read_text()) == ([file, 0o600, folder], "after")


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="written by name there")
@pytest.mark.parametrize("name", ["\udcff", "a\\b", "a\nb", "%s #?"])
def test_netcdf_is_written_into_folders_of_any_name(tmp_path, monkeypatch, name):
    (tmp_path / name).mkdir()
    monkeypatch.chdir(tmp_path / name)
    write_together({Path("run.nc"): xarray.Dataset({"a": 1.0})})
    assert names(Path()) == {"run.nc"}
    with open_netcdf("run.nc") as data:
        assert data.a == 1.0


def test_a_text_in_netcdf_that_is_no_text_is_named(tmp_path):
    data = {tmp_path / "run.nc": xarray.Dataset({"a": 1.0}, attrs={"b": "\udcff"})}
    says(
        DataError,
        "run.nc: cannot be written: .* a text in it, holds bytes",
        write_together,
        data,
    )
    assert names(tmp_path) == set()


def test_a_link_is_followed_and_stays(tmp_path):
    (tmp_path / "far").mkdir()
    place, link = tmp_path / "far" / "run.txt", tmp_path / "run.txt"
    for before in ("old", None):  # and one that leads to no file yet
        place.write_text(before) if before else place.unlink()
        link.unlink(missing_ok=True)
        link.symlink_to(place)
        write_together({link: "new"})
        assert (link.is_symlink(), place.read_text()) == (True, "new")
        assert names(tmp_path / "far") == {"run.txt"}


@POSIX
def test_what_is_no_file_is_not_replaced_and_nothing_is_written(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    (tmp_path / "device").symlink_to(os.devnull)
    kinds = {
        "pipe": "not a regular file",
        "folder": "a folder",
        "device": "not a regular file",
    }
    for name, why in kinds.items():
        both = {tmp_path / "first.txt": "text", tmp_path / name: "text"}
        says(DataError, f"{name}: is {why}", write_together, both)
    assert names(tmp_path) == set(kinds)


def test_a_small_file_that_says_it_holds_much_is_refused(tmp_path):
    with netCDF4.Dataset(tmp_path / "r.nc", "w") as data:
        for name in ("time", "axis"):
            data.createDimension(name, 10**6)
        for name in ("clpe", "log_gps_time"):
            shape = {"chunksizes": (10**3, 10**3), "zlib": True}
            data.createVariable(name, float, ("time", "axis"), **shape)
    assert (tmp_path / "r.nc").stat().st_size < 10**5
    for read in (clpt_control.load_run, read_dive_file):
        says(
            DataError, r"has 1.6e\+04 GB of numbers; the limit", read, tmp_path / "r.nc"
        )


@pytest.mark.parametrize("how", ["i2 scale_factor", "f8 add_offset", "S1 _Encoding"])
def test_what_tells_how_numbers_are_decoded_may_be_anything(tmp_path, how):
    kind, key = how.split()
    with netCDF4.Dataset(tmp_path / "d.nc", "w") as data:
        data.createDimension("dive", 3)
        data.createVariable("u", kind, ("dive",))[:] = np.ones(3, kind)
        data["u"].setncattr(key, "x")
    says(
        DataError,
        "d.nc: cannot be read as NetCDF: ",
        clpt_control.load_run,
        tmp_path / "d.nc",
    )


def test_a_number_that_was_overwritten_is_found(tmp_path):
    numbers = np.linspace(1.0, 2.0, 1000)
    write_together({tmp_path / "whole.nc": xarray.Dataset({"u": ("x", numbers)})})
    data = bytearray((tmp_path / "whole.nc").read_bytes())
    at = data.find(numbers[500].tobytes())
    data[at : at + 8] = np.float64(999.0).tobytes()
    (tmp_path / "damaged.nc").write_bytes(data)
    with open_netcdf(tmp_path / "whole.nc", 10**6) as whole:
        np.testing.assert_array_equal(whole.u, numbers)

    def load():
        with open_netcdf(tmp_path / "damaged.nc", 10**6) as damaged:
            damaged.load()

    says(DataError, "damaged.nc: damaged", load)


def test_a_global_heap_that_does_not_end_is_refused(tmp_path):
    """HDF5 walks its objects for ever where one without a number has no size."""
    path = tmp_path / "a.nc"
    xarray.Dataset({"a": ("x", [1.0, 2.0]), "x": [0, 1]}).to_netcdf(path)
    raw = bytearray(path.read_bytes())
    first = raw.index(b"GCOL") + 16  # object: its number, and its size 8 bytes on
    assert struct.unpack_from("<H", raw, first)[0] == 1
    for longer in (2048, 2048 + 64):  # to where there are zeros
        struct.pack_into("<Q", raw, first + 8, longer)
        path.write_bytes(raw)
        said = "damaged: its HDF5 heap has no end."
        says(DataError, said, clpt_control.load_run, path)


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="opened by name there")
def test_what_was_asked_is_what_the_library_opens(tmp_path, monkeypatch):
    path, library = tmp_path / "a.nc", xarray.open_dataset
    for engine in ("netcdf4", "scipy"):
        xarray.Dataset({"a": ("x", [1.0, 2.0])}).to_netcdf(path, engine=engine)

        def replaced(name, **how):
            path.rename(tmp_path / "moved.nc")
            os.mkfifo(path)
            return library(name, **how)

        monkeypatch.setattr(xarray, "open_dataset", replaced)
        with open_netcdf(path) as data:
            assert data.a.values.tolist() == [1.0, 2.0]
        path.unlink()


@pytest.mark.skipif(
    not Path("/proc/self/fd").is_dir(), reason="descriptors are counted there"
)
def test_an_error_of_a_damaged_file_keeps_nothing_open(tmp_path):
    xarray.Dataset({"a": ("x", np.zeros(500))}).to_netcdf(
        path := tmp_path / "a.nc", engine="scipy"
    )
    os.truncate(path, 2000)
    opened = len(names(Path("/proc/self/fd")))
    with pytest.raises(DataError, match="damaged or cut short: less than") as kept:
        clpt_control.load_run(path)
    assert len(names(Path("/proc/self/fd"))) == opened, kept


BECOMES = {
    "a pipe with a name": os.mkfifo,
    "a link": lambda path: path.symlink_to("moved"),
}


@POSIX
@pytest.mark.parametrize("kind", BECOMES)
def test_a_file_of_a_zarr_folder_that_becomes_a_pipe_is_not_waited_for(tmp_path, kind):
    zarr.create_group(tmp_path / "z").create_array("a", data=np.arange(3.0))
    store = zarr_store(tmp_path / "z")

    def read():
        return zarr.open_group(store, mode="r")["a"][:].tolist()

    assert read() == [0.0, 1.0, 2.0]
    chunk = tmp_path / "z" / "a" / "c" / "0"
    chunk.rename(chunk.with_name("moved"))
    BECOMES[kind](chunk)
    says((DataError, OSError), r"is not a regular file|symbolic links", read)
