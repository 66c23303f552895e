"""The name of a vehicle, as its files or their names have it.

A name begins with a letter, a digit or an underscore, so that no file can pass an option, a path or
a redirection to the command of `clpt replay --alert`.
"""

import re
from typing import Any

from .dives import SEAEXPLORER, SLOCUM

LONGEST = 40  # letters; a longer one is no name
DATED = re.compile(r"(.+?)_\d{8}")  # SG015_20040929T140907_delayed


def name_in(data: Any) -> str | None:
    """Return the vehicle's name in an open xarray.Dataset, of its identifiers.

    >>> import xarray
    >>> name_in(xarray.Dataset(attrs={"id": "SG015_20040929T140907_delayed"}))
    'SG015'
    >>> name_in(xarray.Dataset(attrs={"id": "x", "platform_id": " SG171 "}))
    'SG171'
    """
    dated = DATED.match(str(data.attrs.get("id", "")))
    return name_of(data.attrs.get("platform_id"), dated and dated[1])


def name_of_file(file: str) -> str | None:
    """Return the vehicle's name in that of a file of a Slocum or a SeaExplorer.

    >>> name_of_file("rosie_713-2019-166-0-156.sbd"), name_of_file("sea035.10.gli.sub.12.gz")
    ('rosie_713', 'sea035')
    >>> name_of_file("dives.csv") is None
    True
    """
    matched = SLOCUM.fullmatch(file) or SEAEXPLORER.fullmatch(file)
    return name_of(matched and matched["who"].partition(".")[0])


def name_of(*values: Any) -> str | None:
    """Return the first value that is a name, None where none is.

    >>> name_of("-oProxyCommand=x", "SG171")
    'SG171'
    """
    for value in values:
        name = value.strip() if isinstance(value, str) else ""
        begins_well = name[:1].isalnum() or name[:1] == "_"
        if begins_well and len(name) <= LONGEST and name.isprintable():
            return name
    return None
