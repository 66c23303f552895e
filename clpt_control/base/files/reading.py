"""Readers of text, NetCDF and Zarr files.

A file is opened once, without waiting, and checked through its descriptor: it is a regular file of
bounded size, and all else, a pipe too, is refused in a sentence.  A library that opens by name
(NetCDF) gets a name of the descriptor, where the system has one; Zarr, which lists a folder itself,
gets paths that are opened in this way.

Text is UTF-8, with or without a byte order mark; a few stray bytes are let
through, for they stand in comments and notes.
"""

import os
import re
import stat
import struct
import warnings
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from importlib.util import find_spec
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Literal

from ..errors import DataError, needed

if TYPE_CHECKING:
    import xarray

AnyPath = str | Path
STRAY = 0.05  # largest share of characters that are no UTF-8 text
LARGEST = 2 * 10**8  # bytes of a file that is read whole
# the folder in which a system names the descriptors of a process
OPENED = "/proc/self/fd"
NETCDF = (b"CDF\x01", b"CDF\x02", b"CDF\x05", b"\x89HDF")  # first bytes
DECODED_BY = {"scale_factor", "add_offset", "_Encoding"}  # attributes of a variable
# in a file, for a / of a name, which NetCDF and Zarr take for a folder
SLASH = "\N{DIVISION SLASH}"


@contextmanager
def opened(
    path: AnyPath, most: float = LARGEST, hint: str = "give the name of a file"
) -> Iterator[BinaryIO]:
    """Open a file of at most so many bytes; `hint` ends the sentence where there is none."""
    try:
        with open(path, "rb", opener=at_once) as file:
            _check(file, path, most)
            yield file
    except FileNotFoundError:
        raise DataError(f"{path}: no such file; {hint}") from None
    except IsADirectoryError:
        raise DataError(f"{path}: is a folder; give a file") from None
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror or error}") from None


def _check(file: BinaryIO, path: AnyPath, most: float) -> None:
    """Refuse what was opened where it is no regular file, or is too large."""
    state = os.fstat(file.fileno())
    if not stat.S_ISREG(state.st_mode):
        raise DataError(f"{path}: is no regular file; give one")
    if state.st_size > most:
        raise DataError(_too_large(path, most))


def shown_name(path: Path) -> str:
    r"""Return the name of a file as a line of text, which any file can hold.

    >>> shown_name(Path("a\n\udcff.nc"))
    'a\\n\\udcff.nc'
    """
    return "".join(one if one.isprintable() else ascii(one)[1:-1] for one in path.name)


def at_once(name: str, flags: int, more: int = 0) -> int:
    """Open as the opener of `open`, but do not wait for a writer of a pipe."""
    return os.open(name, flags | more | getattr(os, "O_NONBLOCK", 0))


def opened_name(number: int, path: AnyPath) -> str:
    """Return a name of a descriptor, whatever its path means by now; the path elsewhere."""
    return f"{OPENED}/{number}" if os.path.isdir(OPENED) else str(path)  # noqa: PTH112


def _too_large(path: AnyPath, most: float) -> str:
    return (
        f"{path}: is larger than {most / 1e6:.0f} MB, the most that is read; split it"
    )


def read_bytes(
    path: AnyPath,
    other: tuple[bytes, ...] = (),
    hint: str = "give the name of a file",
    most: int | None = None,
) -> bytes:
    """Read a file; `most` is `LARGEST` by default.

    Of a file that begins with one of `other`, 4 bytes each, only these are read.
    """
    most = most or LARGEST
    with opened(path, inf if other else most, hint) as file:
        raw = file.read(4)
        if raw not in other:
            raw += file.read(most)
    if len(raw) > most:
        raise DataError(_too_large(path, most))
    return raw


class _Inner(type(Path())):  # type: ignore[misc]
    """A path within a folder, whose file is no link and is checked when it is opened to read."""

    def open(self, mode: str = "r", *how: Any, **more: Any) -> Any:
        """Open the file; check it where it is to be read."""
        if mode != "rb":
            return super().open(mode, *how, **more)
        with ExitStack() as refused:
            opener = partial(at_once, more=getattr(os, "O_NOFOLLOW", 0))
            file = refused.enter_context(open(self, "rb", opener=opener))
            _check(file, self, inf)
            refused.pop_all()
        return file


def zarr_store(folder: Path, read_only: bool = True) -> Any:
    """Return a folder as Zarr reads it, and writes it unless it is `read_only`.

    Anything in it, at any depth, that is neither a file nor a folder is refused: Zarr would follow
    it elsewhere.
    """
    needed("zarr")
    from zarr.storage import LocalStore

    for place, folders, files in os.walk(folder):
        for name in (*folders, *files):
            mode = os.lstat(path := Path(place, name)).st_mode
            if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
                raise DataError(
                    f"{path}: is no regular file; {folder} must hold files alone"
                )
    return LocalStore(_Inner(folder), read_only=read_only)


def read_text(path: AnyPath, no_text: str, most: int | None = None) -> str:
    """Read a file that must be text; where it is none, the error is its name and `no_text`."""
    return text_of(read_bytes(path, most=most), path, no_text)


def text_of(raw: bytes, path: AnyPath, no_text: str) -> str:
    """Return a whole file's bytes as text, those that are no UTF-8 as U+FFFD."""
    text = raw.decode("utf-8-sig", "replace")
    if "\0" in text or text.count("\ufffd") > STRAY * len(text):
        raise DataError(f"{path}: {no_text}")
    return text


# --- NetCDF --------------------------------------------------------------------------------------


@contextmanager
def open_netcdf(path: AnyPath, most: float = inf) -> "Iterator[xarray.Dataset]":
    """Open a NetCDF file with xarray, or raise one sentence that says why not.

    Times stay numbers, and values are read when they are used: a damaged variable is a
    `DataError` there too.  A small file may claim to hold much: all variables together are at most
    so many bytes.
    """
    import xarray

    with opened(path, inf, "must be a NetCDF file") as file:
        _check_header(file, path)
        name, engine = opened_name(file.fileno(), path), netcdf_engine()
        try:
            data = xarray.open_dataset(name, decode_times=False, engine=engine)
            for one in data.variables.values():
                if DECODED_BY & one.encoding.keys():  # which may say anything
                    one[dict.fromkeys(one.dims, slice(1))].load()
        except Exception as error:  # a damaged file can raise anything
            raise DataError(
                f"{path}: cannot be read as NetCDF: {_reason(error)}"
            ) from None
        with data:
            if data.nbytes > most:
                size = f"{data.nbytes / 1e9:.3g} GB of numbers"
                raise DataError(
                    f"{path}: holds {size}; at most {most / 1e9:g} are read at once"
                )
            try:
                yield renamed(data, SLASH, "/")
            except (OSError, RuntimeError) as error:
                reason = _reason(error)
                raise DataError(
                    f"{path}: damaged: a variable cannot be read: {reason}"
                ) from None


def renamed(data: "xarray.Dataset", old: str, new: str) -> "xarray.Dataset":
    """Return a dataset with one letter for another in the names of variables and dimensions."""
    names = {str(name) for name in (*data.variables, *data.dims) if old in str(name)}
    return (
        data.rename({name: name.replace(old, new) for name in names}) if names else data
    )


def netcdf_engine() -> Literal["netcdf4", "scipy"]:
    """Return the library for NetCDF: netCDF4, or without it SciPy, for classic files alone."""
    return "netcdf4" if find_spec("netCDF4") else "scipy"


def _reason(error: Exception) -> str:
    words = str(getattr(error, "strerror", None) or error) or type(error).__name__
    return words.splitlines()[0][:120]


def _check_header(file: BinaryIO, path: AnyPath) -> None:
    """Refuse a damaged file that a library takes for whole, or never finishes to read.

    SciPy fills a classic file that was cut with zeros.  HDF5 walks a global heap object by object,
    for ever where a free one (number 0) has no size; files above `LARGEST` are not searched.
    """
    start = file.read(4)
    if start == b"CDF\x05":
        raise DataError(f"{path}: is of 64-bit data; `nccopy -k nc4` makes it NetCDF-4")
    if start[:3] != b"CDF":
        needed("netCDF4")
        raw = file.read() if os.fstat(file.fileno()).st_size <= LARGEST else b""
        for heap in re.finditer(rb"GCOL\x01\0{3}", raw):
            _check_heap(raw, heap.end(), path)
        return
    from scipy.io import netcdf_file

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of memory that is still mapped
        try:
            return netcdf_file(opened_name(file.fileno(), path), mmap=True).close()
        except Exception:  # a damaged header can raise anything
            pass  # what was opened ends here, not with an error that keeps it open
    raise DataError(f"{path}: damaged or cut short: less than its header says")


def _check_heap(raw: bytes, at: int, path: AnyPath) -> None:
    """Refuse a global heap, from its size on, whose objects do not lead to its end."""
    end, at = at - 8 + int.from_bytes(raw[at : at + 8], "little"), at + 8
    while at + 16 <= min(end, len(raw)):
        number, size = struct.unpack_from("<H6xQ", raw, at)
        if not (number or size):
            raise DataError(
                f"{path}: damaged: a heap of its HDF5 does not end; fetch it again"
            )
        at += 16 + -(-size // 8) * 8 if number else size
