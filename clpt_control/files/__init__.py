"""Files: opened with one clear sentence, written whole or not at all.

What is written goes beside its place first and is renamed there, so that an
interrupt leaves the old file or none.
"""

import glob
import os
import platform
import re
import secrets
import shutil
import stat
import struct
import sys
import warnings
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from importlib.util import find_spec
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Literal

from ..errors import ClptError, DataError, needed
from ..progress.interrupt import check, folders, remove, unfinished
from .reading import LARGEST, kind_of, opened, opened_name

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

LONGEST_NAME, LONGEST_PATH = 200, 3000  # bytes, with room for what is written beside
HERE = f"{zlib.crc32(platform.node().encode()):08x}"  # this machine
PART = re.compile(rf"\..+\.{HERE}-(\d{{1,7}})-[0-9a-f]{{8}}\.part")  # of a process here


@contextmanager
def open_netcdf(path: str | Path, most: float = inf) -> "Iterator[xarray.Dataset]":
    """Open a NetCDF file with xarray, or say in one sentence why not.

    Times are left as numbers, and values are read when used: a damaged variable is a
    `DataError` also there.  A small file may say that it holds much: of one that is read whole
    all variables together are at most so many bytes.
    """
    import xarray

    with opened(path, inf, "must be a NetCDF file") as file:
        if not file.seekable():
            raise DataError(f"{path}: is NetCDF through a pipe; save it as a file and give it")
        _check_header(file, path)
        name, engine = opened_name(file.fileno(), path), netcdf_engine()
        try:
            data = xarray.open_dataset(name, decode_times=False, engine=engine)
        except Exception as error:  # a damaged file can raise anything
            raise DataError(f"{path}: cannot be read as NetCDF: {_reason(error)}") from None
        with data:
            if data.nbytes > most:
                raise DataError(
                    f"{path}: holds {data.nbytes / 1e9:.3g} GB of numbers; at most "
                    f"{most / 1e9:g} are read at once"
                )
            try:
                yield data
            except (OSError, RuntimeError) as error:
                reason = _reason(error)
                raise DataError(f"{path}: damaged: a variable cannot be read: {reason}") from None


def netcdf_engine() -> Literal["netcdf4", "scipy"]:
    """Return what reads and writes NetCDF: netCDF4, or without it SciPy, in classic files alone."""
    return "netcdf4" if find_spec("netCDF4") else "scipy"


def _reason(error: Exception) -> str:
    words = str(getattr(error, "strerror", None) or error) or type(error).__name__
    return words.splitlines()[0][:120]


def _check_header(file: BinaryIO, path: str | Path) -> None:
    """Refuse what the libraries take for whole, or never end with.

    A classic file that was cut is filled with zeros.  A global heap of HDF5 is walked object by
    object, for ever where a free one (number 0) has no size; larger files are not looked through.
    """
    start = file.read(4)
    if start == b"CDF\x05":
        raise DataError(
            f"{path}: is classic NetCDF of 64-bit data, of which a part could be missing "
            "unseen; `nccopy -k nc4 FILE NEW` writes it as NetCDF-4"
        )
    if start[:3] != b"CDF":
        needed("netCDF4")
        raw = file.read() if os.fstat(file.fileno()).st_size <= LARGEST else b""
        for heap in re.finditer(rb"GCOL\x01\0{3}", raw):
            _check_heap(raw, heap.end(), path)
        return
    from scipy.io import netcdf_file

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of memory that is still mapped
            netcdf_file(opened_name(file.fileno(), path), mmap=True).close()
    except Exception:  # whatever a damaged header makes of itself
        raise DataError(
            f"{path}: damaged or cut short: it holds less than its NetCDF header says; "
            "fetch it again"
        ) from None


def _check_heap(raw: bytes, at: int, path: str | Path) -> None:
    """Refuse a global heap, from its size on, whose objects do not lead to its end."""
    end, at = at - 8 + int.from_bytes(raw[at : at + 8], "little"), at + 8
    while at + 16 <= min(end, len(raw)):
        number, size = struct.unpack_from("<H6xQ", raw, at)
        if not (number or size):
            raise DataError(f"{path}: damaged: a heap of its HDF5 does not end; fetch it again")
        at += 16 + -(-size // 8) * 8 if number else size


@contextmanager
def beside(path: str | Path, folder: bool = False) -> Iterator[Path]:
    """Make a hidden empty file, or folder, beside a place, and rename it there at the end.

    It is ``.NAME.MACHINE-PROCESS-CHANCE.part``; it is gone where the work fails, and what a killed
    process of this machine left goes with the next one.  It has the mode of the file that it
    replaces, or a new file's by the umask; a link is followed.
    """
    place, mode = _place(path)
    made = place.parent / f".{place.name}.{HERE}-{os.getpid()}-{secrets.token_hex(4)}.part"
    try:
        for left in place.parent.glob(f".{glob.escape(place.name)}.{HERE}-*.part"):
            found = PART.fullmatch(left.name)
            if found and _is_dead(int(found[1])):
                remove(left)
        unfinished.add(made)
        if folder:
            made.mkdir()
        else:
            new = 0o666 if mode is None else 0o600  # less what the umask takes
            os.close(os.open(made, os.O_CREAT | os.O_EXCL | os.O_WRONLY, new))
        yield made
        check()  # an interrupt that was dropped may have changed what was written
        if mode is not None and not folder:
            made.chmod(mode)
        made.replace(place)
    except OSError as error:
        raise DataError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        remove(made)
        unfinished.discard(made)


def _place(path: str | Path) -> tuple[Path, int | None]:
    """Return where a file is to be written, and the mode of the one that stands there.

    A device, a pipe or a socket is refused: it would be replaced by a file.
    """
    path = Path(path)
    check_name(path)
    place = Path(os.path.realpath(path)) if path.is_symlink() else path
    if not place.parent.is_dir():
        raise DataError(f"{path}: cannot be written: the folder {place.parent} does not exist")
    try:
        mode = place.stat().st_mode
    except FileNotFoundError:
        return place, None
    except OSError as error:
        raise DataError(f"{path}: cannot be written: {error.strerror or error}") from None
    if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
        raise DataError(f"{path}: is {kind_of(mode)}; give the name of a file")
    return place, stat.S_IMODE(mode)


def _is_dead(process: int) -> bool:
    """Whether a process of this machine has ended; on Windows it may not be asked."""
    if os.name != "posix":
        return False
    try:
        os.kill(process, 0)
    except OSError as error:
        return isinstance(error, ProcessLookupError)
    return False


def write_together(results: "Mapping[Path, str | bytes | xarray.Dataset | Figure]") -> None:
    """Write files beside their places, then rename them; none where one cannot be written.

    Each is a text, bytes, a dataset, whose variables with NaN get them as _FillValue, or a
    figure.  The first is renamed last: where it is new, all are.
    """
    with ExitStack() as renamed:
        for path in results:
            check_writable(path)
        for path, result in results.items():
            _put(result, renamed.enter_context(beside(path)), Path(path))


def _put(result: Any, made: Path, path: Path) -> None:
    if isinstance(result, str | bytes):
        made.write_bytes(result.encode() if isinstance(result, str) else result)
        return
    if hasattr(result, "savefig"):
        from ..figures import save_figure

        save_figure(result, made, path.suffix[1:].lower())
        return
    engine, written = netcdf_engine(), {}
    for name, values in result.variables.items():
        written[name] = {"_FillValue": float("nan") if _has_nan(values) else None}
        if engine == "netcdf4" and values.ndim and values.dtype.kind in "fiu":
            written[name]["fletcher32"] = True  # a checksum, which reading asks
    try:
        with _no_cluster():
            result.to_netcdf(made, engine=engine, encoding=written)
    except (RuntimeError, PermissionError, UnicodeError) as error:  # of a full disk, too
        full = shutil.disk_usage(made.parent).free < 2**20
        reason = getattr(error, "strerror", None) or str(error)
        reason = "no space left" if full else f"{reason}; is there a limit on the size of files?"
        raise DataError(f"{path}: cannot be written: {reason}") from None


@contextmanager
def _no_cluster() -> Iterator[None]:
    """Keep xarray from importing dask's cluster to see whether one writes too.

    Where nobody has imported it, none does.
    """
    if "distributed" in sys.modules:
        yield
        return
    sys.modules["distributed"] = None  # type: ignore[assignment]
    try:
        yield
    finally:
        del sys.modules["distributed"]


def _has_nan(values: "xarray.Variable") -> bool:
    return values.dtype.kind == "f" and bool(values.isnull().any())


def write_netcdf(data: "xarray.Dataset", path: str | Path) -> None:
    """Write a dataset, whole or not at all."""
    write_together({Path(path): data})


def write_figure(figure: "Figure", path: str | Path) -> None:
    """Write a figure, such as ``map.png``, whole or not at all."""
    write_together({Path(path): figure})


def write_text(path: str | Path, text: str) -> None:
    """Write a text file, whole or not at all."""
    write_together({Path(path): text})


def check_name(path: str | Path) -> None:
    """Refuse a name that is too long or no text: nothing can be written under it."""
    try:
        longest = max((len(part.encode()) for part in Path(path).parts), default=0)
    except UnicodeEncodeError:
        raise DataError(
            f"{path}: its name holds bytes that are no text; give another name"
        ) from None
    if longest > LONGEST_NAME or len(str(path)) > LONGEST_PATH:
        raise DataError(
            f"{str(path)[:40]}...: the name is too long; at most {LONGEST_NAME} letters are "
            f"allowed, and {LONGEST_PATH} with all folders"
        )


def make_folder(path: str | Path) -> Path:
    """Make a folder for results, which a command removes if it stays empty; or say why not."""
    path = Path(path)
    check_name(path)
    new = [folder for folder in (path, *path.parents) if not os.path.lexists(folder)]
    folders.extend(reversed(new))
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise ClptError(f"{path}: is a file; give a folder") from None
    except OSError as error:
        raise ClptError(f"{path}: cannot be made: {error.strerror}") from None
    return path


def check_writable(path: str | Path, what: str = "", endings: Sequence[str] = ()) -> None:
    """Refuse, before work begins, a file that could not be written: no folder, or read-only.

    One of some `endings` says what it is to be, such as "a figure".
    """
    place, _ = _place(path)
    if place.is_dir():
        raise DataError(f"{path}: is a folder; give a file name such as {Path(path) / 'run.nc'}")
    if not os.access(place.parent, os.W_OK):
        raise DataError(f"{path}: cannot be written: the folder {place.parent} is read-only")
    if endings and Path(path).suffix.lower() not in endings:
        allowed = " or ".join(", ".join(endings).rsplit(", ", 1))
        raise DataError(f"{path}: {what}'s name must end in {allowed}")
