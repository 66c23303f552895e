"""Quality flags of a variable: values that its file flags as bad become gaps.

Flags of a variable NAME are the variables that its `ancillary_variables` list, the one with the
standard name `STANDARD_NAME status_flag`, and those named NAME_QC, NAME_qc, NAME_quality_control,
NAME_flag, QC_NAME and the like (CF conventions 3.4 and 3.5; OceanSITES, IMOS, QARTOD).

The words of `flag_meanings` decide which `flag_values` or `flag_masks` are bad.  Flags without
such words follow the scale 0 to 9 of OceanSITES: 3, 4 and 9 are bad.  A fix is also bad if it is
interpolated, 8, because an interpolated position is not an observation.
"""

import re
from collections.abc import Callable, Iterable
from functools import reduce
from operator import or_

import numpy as np
import xarray

from ...base.units import number

NAMED = r"{0}_?(qc|quality_?control|quality|flags?|qartod)\w*|(qc|flag)_{0}"
IS_FLAG = re.compile(r"qc|flag|qartod|quality")
WRONG = (
    "bad|poor|missing|fail|suspect|invalid|unusable|wrong|erron|error|spike|outlier|out_of|"
    "outside|question|doubt|reject|implausib|impossib|unreliabl"
)
RIGHT = "good|pass|ok|valid|usable"
DENIED = "(?:not?|never|non)_"
GOOD = re.compile(rf"(?<!not_)(?<!no_)(?<![a-z])(?:{RIGHT})|{DENIED}(?:{WRONG})")
BAD = re.compile(rf"{WRONG}|no_data|{DENIED}(?:{RIGHT})")
GUESSED = re.compile(r"interpolat|estimat|extrapolat")
BAD_CODES, BAD_FIX_CODES = (3.0, 4.0, 9.0), (3.0, 4.0, 8.0, 9.0)
SCALE = 9.0  # largest flag of the scale


def said(variable: xarray.DataArray | xarray.Variable, attribute: str = "units") -> str:
    """Return an attribute as text, '' where there is none."""
    return str(variable.attrs.get(attribute, "")).strip()


def flag_names(data: xarray.Dataset, name: str) -> list[str]:
    """Return the names of the variables that hold the flags of a variable.

    >>> axes = {f"{name}_QC": ("n", [1]) for name in ("u", "v")}
    >>> flag_names(xarray.Dataset({"u": ("n", [0.1]), "u_error": ("n", [0.0])} | axes), "u")
    ['u_QC']
    """
    variable = data.variables[name]
    listed = said(variable, "ancillary_variables").split()
    standard = f"{said(variable, 'standard_name')} status_flag"
    named = re.compile(NAMED.format(re.escape(name)), re.IGNORECASE)
    return [
        flag
        for flag, flags in ((str(key), data.variables[key]) for key in data.variables)
        if named.fullmatch(flag)
        or said(flags, "standard_name") == standard
        or (
            flag in listed
            and ("flag_meanings" in flags.attrs or IS_FLAG.search(flag.lower()))
        )
    ]


def without_flagged(
    data: xarray.Dataset,
    names: Iterable[str],
    select: Callable[[xarray.DataArray], xarray.DataArray] = lambda variable: variable,
    is_fix: bool = False,
) -> tuple[xarray.DataArray, list[str]]:
    """Return a variable, NaN where it or a coordinate of it is flagged bad, and a note on these.

    The variable is the first of the names, and its coordinates are the others.  `select` selects
    the values that are read, of the variable and of flags.
    """
    name, *coordinates = names
    values = select(data[name])
    flags = [flag for key in (name, *coordinates) for flag in flag_names(data, key)]
    codes = [
        select(data[f]) for f in flags if set(data[f].dims) <= set(data[name].dims)
    ]
    if not codes:
        return values, []
    bad = reduce(or_, (flag.copy(data=is_bad(flag, is_fix)) for flag in codes))
    count = int((values.notnull() & bad).sum()) if bad.any() else 0
    if not count:
        return values, []
    note = f"{count} of {values.size} values of {name} are flagged bad: left out"
    gaps = values.where(~bad)
    gaps.encoding = values.encoding
    return gaps, [note]


def is_bad(flag: xarray.DataArray, is_fix: bool) -> np.ndarray:
    """Return where a variable of flags says bad, by its words or by the scale."""
    codes = _codes(flag.values)
    words = said(flag, "flag_meanings").lower().replace(",", " ").split()
    values, masks = (_attribute(flag, key) for key in ("flag_values", "flag_masks"))
    decided = any(BAD.search(word) or GOOD.search(word) for word in words)
    if not (decided and len(words) == max(values.size, masks.size)):
        on_scale = not masks.size and not np.any(codes > SCALE)
        return np.isin(codes, BAD_FIX_CODES if is_fix else BAD_CODES) & on_scale
    values = values if values.size else masks
    masks = masks if masks.size else np.full(values.size, -1.0)
    integers = np.where(np.isfinite(codes), codes, 0.0).astype(np.int64)
    bad = np.zeros(codes.shape, bool)
    for word, value, mask in zip(words, values, masks, strict=True):
        is_bad_word = BAD.search(word) and not GOOD.search(word)
        if is_bad_word or (is_fix and GUESSED.search(word)):
            bad |= (integers & int(mask)) == int(value)
    return bad & np.isfinite(codes)


def _attribute(flag: xarray.DataArray, key: str) -> np.ndarray:
    """Return the numbers of an attribute, which may be a text such as '0b, 1b' or 'A B'."""
    value = flag.attrs.get(key, [])
    if isinstance(value, str):
        value = re.findall(r"-?\d+", value) or value.split()
    return _codes(np.atleast_1d(value))


def _codes(cells: np.ndarray) -> np.ndarray:
    """Return flags as numbers; a letter is its code, and an empty flag is NaN."""
    if cells.dtype.kind in "iufb":
        return cells.astype(float)
    texts, index = np.unique(cells.astype(str), return_inverse=True)
    codes = [
        float(ord(text)) if text.isalpha() and len(text) == 1 else number(text)
        for text in texts
    ]
    return np.array(codes)[index].reshape(cells.shape)
