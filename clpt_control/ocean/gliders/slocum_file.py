"""One file of a Slocum's flight computer: .dbd, or .mbd or .sbd, which hold a part of it.

.dcd, .mcd and .scd are these compressed: blocks of LZ4, each behind its size in two bytes,
the larger first.  A text that dbd2asc wrote has the same header, then lines with the names
of the sensors, their units and bytes, then a line of numbers for each cycle.

The bytes are a header of ASCII lines; the list of all sensors, or where that is `factored`
the check sum that names the `.cac` file with it; known bytes; then cycles of b"d", two
bits for each sensor (0 no value, 1 as before, 2 a new one) and the new values; b"X" ends it.
The first cycle has each sensor's last value, which for the GPS is an older fix: that is left
out.  Whole cycles of a file that is cut short are read; newer gliders write no b"X".  A list
of sensors, .cac or compressed .ccc, is looked for beside the file, in `cac` and `cache` there
and up to four folders up, and in the folder that the environment variable `CLPT_CAC` names.
"""

import os
import re
from contextlib import suppress
from functools import lru_cache
from io import BytesIO
from math import nan
from pathlib import Path
from struct import unpack_from
from typing import NamedTuple

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.files.reading import read_bytes
from ...base.units import number

MAGIC = b"dbd_"  # first bytes of `dbd_label:`
TEXT = "DBD_ASC"  # first letters of its value in a text
BLOCK = 2**16  # bytes of a block at most
MOST_PACKED = 2 * 10**7  # bytes of a compressed file
FOLDERS = ("cac", "cache")
KNOWN = 16  # bytes: b"sa", 4660 in 2, 123.456 in 4, 123456789.12345 in 8
# as `KNOWN` has it: how bytes are ordered
ORDERS = {b"sa\x34\x12": "<", b"sa\x12\x34": ">"}
KINDS = {1: "b", 2: "h", 4: "f", 8: "d"}  # of a value, by its bytes
TIME = "m_present_time"
FIX = ("m_gps_lat", "m_gps_lon", "m_gps_status")
PLACE, LOCAL = ("m_lat", "m_lon"), ("m_x_lmc", "m_y_lmc")  # by dead reckoning
WATER = ("m_water_vx", "m_water_vy")
PLAN = ("c_wpt_lat", "c_wpt_lon", "c_heading")
STATE = ("m_depth", "m_heading", "m_gps_mag_var", "u_use_current_correction")
NAMES = (*FIX, *PLACE, *LOCAL, *WATER, *PLAN, *STATE)
YEARS = (0.0, 7.3e9)  # s since 1970: to 2200
MOST = 10**6  # cycles: 46 days of 4 s each
WHOLE = ("total_num_sensors", "state_bytes_per_cycle", "sensor_list_factored")
OF_TEXT = ("sensors_per_cycle", "num_label_lines")


class Segment(NamedTuple):
    """Content of a file: its number, its log by time (s since 1970 UTC), and notes on faults."""

    number: int
    of: pandas.DataFrame
    notes: tuple[str, ...]


def read_segment(path: Path) -> Segment:
    """Read the sensors of `NAMES`, NaN where a file has them not."""
    raw = read_bytes(path)
    is_complete = True
    if not raw.startswith(MAGIC):
        raw, is_complete = uncompressed(raw)
    tags, offset = _header(raw, path)
    if tags["dbd_label"].startswith(TEXT):
        columns, offset = _table(raw, offset, int(tags["num_label_lines"]))
    else:
        sensors, offset = _sensors(raw, offset, tags, path)
        states = int(tags["state_bytes_per_cycle"])
        columns, offset = _cycles(raw, offset, sensors, states, path)
    if TIME not in columns:
        raise DataError(
            f"{path}: the Slocum file has no {TIME}, the times of its cycles"
        )
    notes: tuple[str, ...] = ()
    if not is_complete or raw[offset : offset + 1] not in (b"X", b""):
        where = f"at byte {offset} of {len(raw)}"
        notes = (f"{path.name} is cut short or damaged {where}: read up to there",)
    number = _number(tags.get("the8x3_filename", ""), path)
    log = columns.set_index(TIME).reindex(columns=NAMES)
    log.iloc[:1, : len(FIX)] = nan
    return Segment(number, log[(log.index > YEARS[0]) & (log.index < YEARS[1])], notes)


def uncompressed(raw: bytes) -> tuple[bytes, bool]:
    r"""Return the bytes of compressed ones, as far as these are sound, and whether all are.

    >>> uncompressed(b"\x00\x08" b"\x12a\x01\x00" b"\x30bcd")
    (b'aaaaaaabcd', True)
    """
    out = bytearray()
    offset = 0
    while offset < min(len(raw), MOST_PACKED):
        size = int.from_bytes(raw[offset : offset + 2])
        try:
            out += _block(raw[offset + 2 : offset + 2 + size])
        except IndexError:
            return bytes(out), False
        offset += 2 + size
    return bytes(out), offset == len(raw)


def _block(packed: bytes) -> bytes:
    """Return the bytes of an LZ4 block: runs of new bytes, each and a copy of what came before."""
    out = bytearray()
    offset = 0
    while True:
        token = packed[offset]
        new_bytes, offset = _length(packed, offset + 1, token >> 4)
        out += packed[offset : offset + new_bytes]
        offset += new_bytes
        if offset == len(packed):
            return bytes(out)
        back = packed[offset] | packed[offset + 1] << 8
        count, offset = _length(packed, offset + 2, token & 15)
        count += 4
        start = len(out) - back
        if start < 0 or back == 0 or len(out) + count > BLOCK:
            raise IndexError(back)
        out += (out[start : start + count] * (count // back + 1))[:count]


def _length(packed: bytes, offset: int, length: int) -> tuple[int, int]:
    """Return a length whose first four bits are known, and where it ends."""
    extra = 255 if length == 15 else 0
    while extra == 255:
        extra = packed[offset]
        length, offset = length + extra, offset + 1
    return length, offset


def _header(raw: bytes, path: Path) -> tuple[dict[str, str], int]:
    """Return the tags of the header and where it ends."""
    tags = {}
    offset = 0
    for line in BytesIO(raw):
        name, colon, value = line.decode("ascii", "replace").partition(":")
        if not colon:
            break
        tags[name.strip()] = value.strip()
        offset += len(line)
        if tags.get("num_ascii_tags") == str(len(tags)):
            break
    is_text = tags.get("dbd_label", "").startswith(TEXT)
    counts = OF_TEXT if is_text else WHOLE
    lacking = [
        name for name in counts if not re.fullmatch("[0-9]{1,5}", tags.get(name, ""))
    ]
    if (
        lacking
        or tags.get("num_ascii_tags") != str(len(tags))
        or not raw[:offset].isascii()
    ):
        raise DataError(
            f"{path}: the header of the Slocum file is damaged or cut short: "
            f"{', '.join(lacking) or 'too few lines'}"
        )
    if tags.get("encoding_ver") != ("2" if is_text else "5"):
        raise DataError(
            f"{path}: is a Slocum file of encoding {tags.get('encoding_ver')!r}; must be 5, "
            "of a text 2"
        )
    return tags, offset


def _sensors(
    raw: bytes, offset: int, tags: dict[str, str], path: Path
) -> tuple[list[tuple[str, int]], int]:
    """Return name and bytes of each sensor in a cycle, and where the list ends."""
    total = int(tags["total_num_sensors"])
    if tags["sensor_list_factored"] != "0":
        check_sum = tags.get("sensor_list_crc", "").lower()
        if not re.fullmatch("[0-9a-f]{1,8}", check_sum):
            raise DataError(
                f"{path}: the Slocum file names no list of sensors: sensor_list_crc"
            )
        list_file, listed = _list_of(path, check_sum)
        return _listed(listed, total, list_file), offset
    end = offset
    for _ in range(total):
        end = raw.find(b"\n", end) + 1 or len(raw)
    return _listed(raw[offset:end], total, path), end


def _list_of(path: Path, check_sum: str) -> tuple[Path, bytes]:
    """Return the .cac file of a check sum and its bytes."""
    name = f"{check_sum}.cac"
    packed = f"{check_sum}.ccc"
    folder_of_file = Path(os.path.realpath(path)).parent
    above = folder_of_file, *folder_of_file.parents[:4]
    folders = [folder_of_file, *(parent / sub for parent in above for sub in FOLDERS)]
    if cac_folder := os.environ.get("CLPT_CAC"):
        folders.insert(0, Path(cac_folder))
    for folder in folders:
        try:
            inside = {file.name.lower(): file for file in folder.iterdir()}
        except OSError:
            continue
        if list_file := inside.get(name) or inside.get(packed):
            listed = read_bytes(list_file)
            if list_file is inside.get(packed):
                listed = uncompressed(listed)[0]
            return list_file, listed
    raise DataError(
        f"{path}: its list of sensors {name} was not found next to it or in a folder 'cac' there. "
        "Get it from the glider's or dockserver's 'cache' and put it there, or name its folder in "
        "CLPT_CAC"
    )


@lru_cache(maxsize=64)
def _listed(listed: bytes, total: int, path: Path) -> list[tuple[str, int]]:
    """Return name and bytes of each sensor of a cycle, in their order."""
    rows = [line.split() for line in listed.splitlines() if line.strip()][:total]
    with suppress(IndexError, KeyError, ValueError):
        entries = [
            (words[0], int(words[3]), int(words[4]), words[5], words[6])
            for words in rows
        ]
        sensors = {
            index: (name.decode("ascii", "replace"), size)
            for mark, index, size, name, _ in entries
            if mark == b"s:" and index >= 0 and KINDS[size]
        }
        in_order = [sensors[index] for index in range(len(sensors))]
        if len(rows) == total and all(mark == b"s:" for mark, *_ in entries):
            return in_order
    raise DataError(
        f"{path}: is not a list of {total} sensors of a Slocum. Get it again from the "
        "glider or its "
        "dockserver"
    )


def _cycles(
    raw: bytes, offset: int, sensors: list[tuple[str, int]], states: int, path: Path
) -> tuple[pandas.DataFrame, int]:
    """Return the values of sensors in whole cycles, and where these end."""
    order = ORDERS.get(raw[offset : offset + 4])
    if len(raw) < offset + KNOWN or order is None:
        raise DataError(
            f"{path}: the Slocum file has no cycles after its header, or is damaged"
        )
    if states != (len(sensors) + 3) // 4:
        raise DataError(
            f"{path}: has {states} state bytes in a cycle, its list of sensors {len(sensors)} "
            "sensors: the list belongs to another file. Get the right list from the glider"
        )
    indices = {name: k for k, (name, _) in enumerate(sensors) if name in (TIME, *NAMES)}
    sizes = np.array([size for _, size in sensors])
    codes = (np.arange(256)[:, None] >> np.array([6, 4, 2, 0])) & 3
    last = dict.fromkeys(indices, nan)
    rows = list[list[float]]()
    offset += KNOWN
    while (
        raw[offset : offset + 1] == b"d"
        and offset + 1 + states <= len(raw)
        and len(rows) < MOST
    ):
        code = codes[np.frombuffer(raw, np.uint8, states, offset + 1)].ravel()[
            : len(sizes)
        ]
        ends = offset + 1 + states + np.cumsum(np.where(code == 2, sizes, 0))
        if np.any(code == 3) or ends[-1] > len(raw):
            break
        for name, k in indices.items():
            if code[k] == 2:
                (last[name],) = unpack_from(
                    f"{order}{KINDS[sizes[k]]}", raw, ends[k] - sizes[k]
                )
        rows.append([last[name] if code[k] else nan for name, k in indices.items()])
        offset = int(ends[-1])
    return pandas.DataFrame(rows, columns=[*indices], dtype=float), offset


def _table(raw: bytes, offset: int, labels: int) -> tuple[pandas.DataFrame, int]:
    """Return the values of sensors in the whole lines of a text, and where these end."""
    end = raw.rfind(b"\n") + 1
    lines = raw[offset:end].decode("ascii", "replace").splitlines()
    sensors = lines[0].split() if lines else []
    names = [name for name in (TIME, *NAMES) if name in sensors]
    indices = [sensors.index(name) for name in names]
    cells = [line.split() for line in lines[labels:]]
    rows = [
        [number(row[k]) for k in indices] for row in cells if len(row) == len(sensors)
    ]
    return pandas.DataFrame(rows, columns=names, dtype=float), end


def _number(short: str, path: Path) -> int:
    """Return the number of a segment: mission and segment, as in 00970156 or -166-0-156."""
    if short.isdecimal() and len(short) == 8:
        return int(short)
    matched = re.search(r"(\d+)-(\d+)-(\d+)-(\d+)$", path.stem)
    return int(matched[4]) if matched else int(re.sub(r"\D", "", path.stem)[-8:] or 0)
