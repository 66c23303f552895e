"""Whether a classic NetCDF file is whole.

The NetCDF library reads a classic file that was cut short as if it were whole
and fills with zeros.  Its header says where each variable begins and how long
it is ("NetCDF classic format specification", Unidata NUG, appendix B), so the
length that the file must have is known.
"""

import struct
from pathlib import Path

from ...errors import DataError

HEADER = 2**22  # bytes that hold nearly every header
SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8, 7: 1, 8: 2, 9: 4, 10: 8, 11: 8}  # bytes of a type


class _Header:
    """Reads big-endian numbers and padded names one after the other."""

    def __init__(self, raw: bytes):
        self.raw, self.at = raw, 4
        version = raw[3]
        self.count = ">q" if version == 5 else ">i"  # counts and dimension numbers
        self.offset = ">i" if version == 1 else ">q"  # where a variable begins

    def number(self, form: str) -> int:
        (value,) = struct.unpack_from(form, self.raw, self.at)
        self.at += struct.calcsize(form)
        return value

    def skip(self, length: int) -> None:
        self.at += -(-length // 4) * 4

    def entries(self) -> range:
        self.number(">i")  # the tag of the list
        return range(self.number(self.count))

    def attributes(self) -> None:
        for _ in self.entries():
            self.skip(self.number(self.count))
            size = SIZES[self.number(">i")]
            self.skip(size * self.number(self.count))


def least_size(raw: bytes) -> int:
    """Give the bytes that a classic NetCDF file must at least have.

    Parameters
    ----------
    raw : bytes
        The file, or its beginning with the whole header.

    Returns
    -------
    int
        Where the last value of the last variable ends.

    Raises
    ------
    struct.error, KeyError
        If the header itself is cut short or damaged.
    """
    header = _Header(raw)
    records = max(header.number(header.count), 0)
    lengths = []
    for _ in header.entries():
        header.skip(header.number(header.count))
        lengths.append(header.number(header.count))
    header.attributes()
    least = header.at
    for _ in header.entries():
        header.skip(header.number(header.count))
        shape = [lengths[header.number(header.count)] for _ in range(header.number(header.count))]
        header.attributes()
        size = SIZES[header.number(">i")]
        header.number(header.count)
        begin = header.number(header.offset)
        if shape and shape[0] == 0 and records == 0:
            continue
        for length in shape:
            size *= length or 1  # a record's own part; the others lie before the last
        least = max(least, begin + size)
    return least


def check_whole(path: Path) -> None:
    """Refuse a classic NetCDF file that was cut short.

    Parameters
    ----------
    path : Path
        Any file; one that is no classic NetCDF file passes.

    Raises
    ------
    DataError
        If the file is shorter than its header says.
    """
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            raw = file.read(HEADER)
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror}") from None
    if raw[:3] != b"CDF" or raw[3:4] not in (b"\x01", b"\x02", b"\x05"):
        return
    try:
        least = least_size(raw)
    except (struct.error, KeyError, IndexError, OverflowError):
        if len(raw) < size:
            return  # a header of more than 4 MB: left to the NetCDF library
        raise DataError(f"{path}: damaged: its NetCDF header cannot be read to its end") from None
    if size < least:
        raise DataError(f"{path}: cut short: has {size} of {least} bytes; fetch it again")
