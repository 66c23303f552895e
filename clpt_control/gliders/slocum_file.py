"""One file of a Slocum's flight computer: .dbd, or .mbd or .sbd, which hold a part of it.

Its bytes are a header of ASCII lines; the list of all sensors, or where that is `factored`
the check sum that names the `.cac` file with it; known bytes; then cycles of b"d", two
bits for each sensor (0 no value, 1 as before, 2 a new one) and the new values; b"X" ends it.

`dbdreader` reads them, but does not return from a file that is cut short (0.6.3), so the
cycles are counted here first: whole ones are given to it, in a folder of its own, as it
looks for a `.cac` in lower case and may write one.  A list is looked for beside the
file, in `cac` and `cache` there and one folder up, and in the folder that the environment
variable `CLPT_CAC` names.
"""

import os
import re
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np

from ..errors import DataError
from .dives import NotYet

SUFFIXES = (".sbd", ".mbd", ".dbd")
MAGIC = b"dbd_"  # first bytes of `dbd_label:`
FOLDERS = ("cac", "cache")
KNOWN = 16  # bytes: b"sa", 4660 in 2, 123.456 in 4, 123456789.12345 in 8
HOMES = ("HOME", "USERPROFILE")
LARGEST = 2 * 10**8  # bytes
WHOLE = ("num_ascii_tags", "total_num_sensors", "state_bytes_per_cycle", "sensor_list_factored")
Series = tuple[np.ndarray, np.ndarray]  # s since 1970 UTC, values


class Segment(NamedTuple):
    """What a file holds: its name and number, sensors, and what is wrong with it."""

    name: str
    number: int
    of: dict[str, Series]
    notes: tuple[str, ...]


def read_segment(path: Path, names: tuple[str, ...]) -> Segment:
    """Read the sensors among `names` that a file has."""
    try:
        with path.open("rb") as file:
            raw = file.read(LARGEST + 1)
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror}") from None
    if len(raw) > LARGEST:
        raise DataError(f"{path}: is larger than {LARGEST // 10**6} MB; give its .sbd")
    tags, at = _header(raw, path)
    words, at, listed = _sensors(raw, at, tags, path)
    number = _number(tags.get("the8x3_filename", ""), path)
    end, why = _whole(raw, at, words, int(tags["state_bytes_per_cycle"]), path)
    of = _read(raw[:end] + b"X", tags, listed, names, path)
    return Segment(tags.get("full_filename", path.stem), number, of, (why,) if why else ())


def _header(raw: bytes, path: Path) -> tuple[dict[str, str], int]:
    """Return the tags of the header and where it ends."""
    damaged = f"{path}: the header of the Slocum file is damaged or cut short"
    tags: dict[str, str] = {}
    at = 0
    for _ in range(100):
        end = raw.find(b"\n", at)
        if end < 0:
            break
        name, _, value = raw[at:end].decode("ascii", "replace").partition(":")
        tags[name.strip()] = value.strip()
        at = end + 1
        if tags.get("num_ascii_tags") == str(len(tags)):
            break
    if not raw.startswith(MAGIC) or not raw[:at].isascii():
        raise DataError(damaged)
    numbers = [tags.get(name, "") for name in WHOLE]
    if not all(number.isdecimal() for number in numbers) or int(numbers[0]) != len(tags):
        lacking = [name for name, text in zip(WHOLE, numbers, strict=True) if not text.isdecimal()]
        raise DataError(f"{damaged}: {', '.join(lacking) or 'too few lines'}")
    if not (0 < int(numbers[1]) < 10**5 and 0 < int(numbers[2]) < 10**5):
        raise DataError(f"{damaged}: it counts {numbers[1]} sensors, {numbers[2]} state bytes")
    if tags.get("encoding_ver") != "5":
        raise DataError(
            f"{path}: is a Slocum file of encoding {tags.get('encoding_ver')!r}; must be 5"
        )
    return tags, at


def _sensors(
    raw: bytes, at: int, tags: dict[str, str], path: Path
) -> tuple[list[int], int, bytes | None]:
    """Return the bytes of each sensor in a cycle, where the list ends, and the .cac that has it."""
    total = int(tags["total_num_sensors"])
    if tags["sensor_list_factored"] != "0":
        check_sum = tags.get("sensor_list_crc", "").lower()
        if not re.fullmatch("[0-9a-f]{1,8}", check_sum):
            raise DataError(f"{path}: the Slocum file names no list of sensors: sensor_list_crc")
        place, listed = _list_of(path, check_sum)
        return _sizes(listed, total, place), at, listed
    end = at
    for _ in range(total):
        end = raw.find(b"\n", end) + 1
        if end == 0:
            raise DataError(f"{path}: the list of sensors in the Slocum file is cut short")
    return _sizes(raw[at:end], total, path), end, None


def _list_of(path: Path, check_sum: str) -> tuple[Path, bytes]:
    """Return the .cac file of a check sum and its bytes."""
    name = f"{check_sum}.cac"
    beside = Path(os.path.realpath(path)).parent
    folders = [beside, *(here / sub for here in (beside, beside.parent) for sub in FOLDERS)]
    if given := os.environ.get("CLPT_CAC"):
        folders.insert(0, Path(given))
    for folder in folders:
        try:
            inside = {file.name.lower(): file for file in folder.iterdir()}
            if name in inside:
                return inside[name], inside[name].read_bytes()
        except OSError:
            continue
    raise NotYet(
        f"{path}: its list of sensors {name} was not found beside it or in a folder 'cac' there; "
        "get it from the glider's or dockserver's 'cache' and put it there, or name its folder in "
        "CLPT_CAC"
    )


@lru_cache(maxsize=64)
def _sizes(listed: bytes, total: int, path: Path) -> list[int]:
    """Return how many bytes each sensor of a cycle takes, in their order."""
    sizes: dict[int, int] = {}
    lines = [line.split() for line in listed.splitlines() if line.strip()]
    for words in lines[:total]:
        try:
            place, size = int(words[3]), int(words[4])
        except (IndexError, ValueError):
            break
        if len(words) < 7 or words[0] != b"s:" or size not in (1, 2, 4, 8):
            break
        if place >= 0:
            sizes[place] = size
    else:
        if len(lines) >= total and sorted(sizes) == list(range(len(sizes))):
            return [sizes[place] for place in range(len(sizes))]
    raise NotYet(
        f"{path}: is no list of {total} sensors of a Slocum; get it again from the glider or its "
        "dockserver"
    )


def _whole(raw: bytes, at: int, sizes: list[int], states: int, path: Path) -> tuple[int, str]:
    """Return where the last whole cycle ends, and what is wrong behind it."""
    if len(raw) < at + KNOWN or raw[at : at + 4] not in (b"sa\x34\x12", b"sa\x12\x34"):
        raise DataError(f"{path}: the Slocum file has no cycles behind its header, or is damaged")
    if states != (len(sizes) + 3) // 4:
        raise DataError(
            f"{path}: has {states} state bytes in a cycle, its list of sensors {len(sizes)} "
            "sensors: the list is of another file; get the right one from the glider"
        )
    codes = (np.arange(256)[:, None] >> np.array([6, 4, 2, 0])) & 3
    cost = np.zeros((states, 256), np.int64)
    for k, size in enumerate(sizes):
        code = codes[:, k % 4]
        cost[k // 4] += np.where(code == 3, LARGEST, size * (code == 2))
    place = np.arange(states)
    at += KNOWN
    while raw[at : at + 1] == b"d" and at + 1 + states <= len(raw):
        state = np.frombuffer(raw, np.uint8, states, at + 1)
        step = 1 + states + int(cost[place, state].sum())
        if at + step > len(raw):
            break
        at += step
    if raw[at : at + 1] == b"X":
        return at, ""
    return at, f"{path.name} is cut short or damaged at byte {at} of {len(raw)}: read up to there"


def _read(
    raw: bytes, tags: dict[str, str], listed: bytes | None, names: tuple[str, ...], path: Path
) -> dict[str, Series]:
    """Read whole cycles by dbdreader."""
    try:
        dbdreader = _dbdreader()
    except ImportError:
        raise NotYet(
            f"{path}: is a Slocum file, which dbdreader reads; install it: "
            "pip install 'clpt-control[slocum]'"
        ) from None
    with TemporaryDirectory() as folder:
        copy = Path(folder) / f"segment{path.suffix.lower()}"
        copy.write_bytes(raw)
        if listed is not None:
            Path(folder, f"{tags['sensor_list_crc'].lower()}.cac").write_bytes(listed)
        try:
            file = dbdreader.DBD(str(copy), cacheDir=folder)
            try:
                known = [name for name in names if name in file.parameterNames]
                columns = [
                    file.get(name, decimalLatLon=False, discardBadLatLon=False) for name in known
                ]
            finally:
                file.close()
        except Exception as error:  # whatever damage makes of it
            raise DataError(
                f"{path}: dbdreader does not read the Slocum file ({type(error).__name__}): damaged"
            ) from None
    return {
        name: (np.asarray(time, float), np.asarray(value, float))
        for name, (time, value) in zip(known, columns, strict=True)
    }


def _dbdreader() -> Any:
    """Return dbdreader, which makes a folder in the home of who imports it first: elsewhere."""
    homes = {name: os.environ.get(name) for name in HOMES}
    with TemporaryDirectory() as folder:
        os.environ.update(dict.fromkeys(HOMES, folder))
        try:
            import dbdreader
        finally:
            for name, home in homes.items():
                if home is None:
                    del os.environ[name]
                else:
                    os.environ[name] = home
    if (dbdreader.DBDCache.CACHEDIR or "").startswith(folder):
        dbdreader.DBDCache.CACHEDIR = None  # it looks for one again when it needs one
    return dbdreader


def _number(short: str, path: Path) -> int:
    """Return the number of a segment: mission and segment, as in 00970156 or -166-0-156."""
    if short.isdecimal() and len(short) == 8:
        return int(short)
    found = re.search(r"(\d+)-(\d+)-(\d+)-(\d+)$", path.stem)
    return int(found[4]) if found else int(re.sub(r"\D", "", path.stem)[-8:] or 0)
