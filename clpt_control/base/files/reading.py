"""Readers of text, NetCDF and Zarr files.

A file is opened once, without waiting, and checked through its descriptor: it must be a regular
file of bounded size; pipes and devices are refused.  A library that opens files by name (NetCDF)
gets the name of the descriptor, if the system has one.  Zarr, which lists folders itself, gets
paths whose files are opened in this way.

Text is UTF-8, with or without a byte order mark, or UTF-16 with one.  Degree signs of Latin-1 are
read; a few other invalid bytes are allowed, because comments and notes have them.
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

from ..errors import DataError, import_optional

if TYPE_CHECKING:
    import xarray

AnyPath = str | Path
UTF_16 = (b"\xff\xfe", b"\xfe\xff")  # first bytes
# of Latin-1: in UTF-8 another byte above 127 is before these
DEGREE = re.compile(rb"(?<![\x80-\xff])[\xb0\xba]")
STRAY = 0.05  # largest share of characters that are no UTF-8 text
LARGEST = 2 * 10**8  # bytes of a file that is read into memory
# folder of the names of a process's descriptors
OPENED = "/proc/self/fd"
NETCDF = (b"CDF\x01", b"CDF\x02", b"CDF\x05", b"\x89HDF")  # first bytes
DECODED_BY = {"scale_factor", "add_offset", "_Encoding"}  # attributes of a variable
# replaces the / of a name in a file, which NetCDF and Zarr would read as a folder
SLASH = "\N{DIVISION SLASH}"


@contextmanager
def opened(
    path: AnyPath, most: float = LARGEST, hint: str = "give the name of a file"
) -> Iterator[BinaryIO]:
    """Open a file of at most so many bytes; `hint` ends the message for a missing file."""
    try:
        with open(path, "rb", opener=at_once) as file:
            _check(file, path, most)
            yield file
    except FileNotFoundError:
        raise DataError(f"{path}: no such file; {hint}") from None
    except IsADirectoryError:
        raise DataError(f"{path}: is a folder. Give a file") from None
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror or error}") from None


def _check(file: BinaryIO, path: AnyPath, most: float) -> None:
    """Refuse an opened file that is not a regular file, or is too large."""
    state = os.fstat(file.fileno())
    if not stat.S_ISREG(state.st_mode):
        raise DataError(f"{path}: is not a regular file. Give a file")
    if state.st_size > most:
        raise DataError(_too_large(path, most))


def shown_name(path: Path) -> str:
    r"""Return the name of a file as one line of printable text.

    >>> shown_name(Path("a\n\udcff.nc"))
    'a\\n\\udcff.nc'
    """
    return "".join(
        character if character.isprintable() else ascii(character)[1:-1]
        for character in path.name
    )


def at_once(name: str, flags: int, extra_flags: int = 0) -> int:
    """Open a file (an opener of `open`) without waiting for the writer of a pipe."""
    return os.open(name, flags | extra_flags | getattr(os, "O_NONBLOCK", 0))


def opened_name(number: int, path: AnyPath) -> str:
    """Return the name of a descriptor, valid if its path changes; the path on other systems."""
    return f"{OPENED}/{number}" if os.path.isdir(OPENED) else str(path)  # noqa: PTH112


def _too_large(path: AnyPath, most: float) -> str:
    return f"{path}: is larger than the limit of {most / 1e6:.0f} MB. Split it"


def read_bytes(
    path: AnyPath,
    signatures: tuple[bytes, ...] = (),
    hint: str = "give the name of a file",
    most: int | None = None,
) -> bytes:
    """Read a file; `most` is `LARGEST` by default.

    If a file begins with one of `signatures`, 4 bytes each, only those bytes are read.
    """
    most = most or LARGEST
    with opened(path, inf if signatures else most, hint) as file:
        raw = file.read(4)
        if raw not in signatures:
            raw += file.read(most)
    if len(raw) > most:
        raise DataError(_too_large(path, most))
    return raw


class _CheckedPath(type(Path())):  # type: ignore[misc]
    """A path within a folder; a file that is opened to read is checked and must not be a link."""

    def open(self, mode: str = "r", *arguments: Any, **options: Any) -> Any:
        """Open the file; check it if it is opened to read."""
        if mode != "rb":
            return super().open(mode, *arguments, **options)
        with ExitStack() as stack:
            opener = partial(at_once, extra_flags=getattr(os, "O_NOFOLLOW", 0))
            file = stack.enter_context(open(self, "rb", opener=opener))
            _check(file, self, inf)
            stack.pop_all()
        return file


def zarr_store(folder: Path, read_only: bool = True) -> Any:
    """Return a folder as a store of Zarr.

    Links, pipes and devices in the folder, at any depth, are refused: Zarr would follow them.
    """
    import_optional("zarr")
    from zarr.storage import LocalStore

    for parent, folders, files in os.walk(folder):
        for name in (*folders, *files):
            mode = os.lstat(path := Path(parent, name)).st_mode
            if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
                raise DataError(
                    f"{path}: is not a regular file; {folder} must contain files only"
                )
    return LocalStore(_CheckedPath(folder), read_only=read_only)


def read_text(path: AnyPath, no_text: str, most: int | None = None) -> str:
    """Read a text file; the message for other files is the name and `no_text`."""
    return text_of(read_bytes(path, most=most), path, no_text)


def text_of(raw: bytes, path: AnyPath, no_text: str) -> str:
    r"""Return the bytes of a file as text, with U+FFFD for bytes that are not of its encoding.

    >>> text_of(b"36\xb042", "a", ""), text_of("36\xb0".encode(), "a", "")
    ('36°42', '36°')
    """
    if raw.startswith(UTF_16):
        raw = raw.decode("utf-16", "replace").encode()
    text = DEGREE.sub("°".encode(), raw).decode("utf-8-sig", "replace")
    if "\0" in text or text.count("\ufffd") > STRAY * len(text):
        raise DataError(f"{path}: {no_text}")
    return text


# --- NetCDF --------------------------------------------------------------------------------------


@contextmanager
def open_netcdf(path: AnyPath, most: float = inf) -> "Iterator[xarray.Dataset]":
    """Open a NetCDF file with xarray, or raise a `DataError` with the reason.

    Times stay numbers.  Values are read when they are used; a damaged variable then raises a
    `DataError` too.  The variables together must have at most `most` bytes: a small file may
    declare large arrays.
    """
    import xarray

    with opened(path, inf, "must be a NetCDF file") as file:
        if Path(path).suffix == ".toml":
            raise DataError(
                f"{path}: is a scenario. Make a run of it: clpt run {path} --out run.nc"
            )
        _check_header(file, path)
        name, engine = opened_name(file.fileno(), path), netcdf_engine()
        try:
            data = xarray.open_dataset(name, decode_times=False, engine=engine)
            for variable in data.variables.values():
                if DECODED_BY & variable.encoding.keys():  # they may have any value
                    variable[dict.fromkeys(variable.dims, slice(1))].load()
        except Exception as error:  # a damaged file can raise anything
            raise DataError(
                f"{path}: cannot be read as NetCDF: {_reason(error)}"
            ) from None
        with data:
            if data.nbytes > most:
                size = f"{data.nbytes / 1e9:.3g} GB of numbers"
                raise DataError(
                    f"{path}: has {size}; the limit is {most / 1e9:g} are read at once"
                )
            try:
                yield renamed(data, SLASH, "/")
            except (OSError, RuntimeError) as error:
                reason = _reason(error)
                raise DataError(
                    f"{path}: damaged: a variable cannot be read: {reason}"
                ) from None


def renamed(data: "xarray.Dataset", old: str, new: str) -> "xarray.Dataset":
    """Return a dataset with a letter replaced in the names of variables and dimensions."""
    names = {str(name) for name in (*data.variables, *data.dims) if old in str(name)}
    return (
        data.rename({name: name.replace(old, new) for name in names}) if names else data
    )


def netcdf_engine() -> Literal["netcdf4", "scipy"]:
    """Return the library for NetCDF: netCDF4, or SciPy, which reads only classic files."""
    return "netcdf4" if find_spec("netCDF4") else "scipy"


def _reason(error: Exception) -> str:
    words = str(getattr(error, "strerror", None) or error) or type(error).__name__
    return words.splitlines()[0][:120]


def _check_header(file: BinaryIO, path: AnyPath) -> None:
    """Refuse a damaged file that a library reads without an error, or reads for ever.

    SciPy pads a truncated classic file with zeros.  HDF5 walks a global heap object by object, for
    ever if a free object (number 0) has no size; files above `LARGEST` are not searched.
    """
    start = file.read(4)
    if start == b"CDF\x05":
        raise DataError(
            f"{path}: is in the 64-bit data format. Convert it with: nccopy -k nc4"
        )
    if start[:3] != b"CDF":
        import_optional("netCDF4")
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
            pass  # raise outside: the error of SciPy would keep the file open
    raise DataError(f"{path}: damaged or cut short: less than its header says")


def _check_heap(raw: bytes, offset: int, path: AnyPath) -> None:
    """Refuse a global heap whose objects do not reach its end; `offset` is that of its size."""
    end = offset - 8 + int.from_bytes(raw[offset : offset + 8], "little")
    offset += 8
    while offset + 16 <= min(end, len(raw)):
        number, size = struct.unpack_from("<H6xQ", raw, offset)
        if not (number or size):
            raise DataError(
                f"{path}: damaged: its HDF5 heap has no end. Download it again"
            )
        offset += 16 + -(-size // 8) * 8 if number else size
