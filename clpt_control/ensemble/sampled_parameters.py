"""Sampled parameters of an ensemble, and the values of each member.

    learning.gain=0.2:2.0         uniform between two numbers
    flow.parameters~normal:0.1    normal about the system's value, with an absolute standard
                                  deviation
    learning.gain=[0.5, 1, 2]     one of these values

In Python a dict may be used instead; its values may be distributions of scipy.stats,
``{"learning.gain": stats.gamma(2, 0, 1)}``.  Shapes never change: an array varies element by
element, and an item of a list is a complete value.

    lhs       Latin hypercube: the range of each number is divided into equal intervals, one for
              each member, and each interval is drawn from once
    random    independent draws
    grid      every combination

Each number has a separate stream of random numbers, seeded with the seed and the name of the
number.  The values of a member depend only on the seed, the design, the number of members and the
member's number: not on chunks, threads, order or other sampled parameters.
"""

import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from decimal import Decimal
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..base.arguments import brief, nearest
from ..base.errors import ScenarioError
from ..base.html import shortened
from ..base.labelled import TIME, axes_of, unit_of, unlabelled
from ..engine.diagram.wiring import check_unit
from .members import Values, Varied

FORMS = (
    "KEY=LOW:HIGH, two finite numbers of which the first is the smaller; KEY~normal:DEVIATION, a "
    "positive number; or KEY=[VALUE, ...]"
)
IN_A_DICT = (
    "a list of values without labels, a range '0.2:2.0', or a distribution, such as "
    "scipy.stats.norm(1, 2)"
)
DESIGNS = ("lhs", "grid", "random")
MOST_NUMBERS = 2 * 10**8  # 1.6 GB
EDGE = 2.0**-53  # shares stay away from 0 and 1, where the normal quantile is infinite


class Vary(NamedTuple):
    """A sampled parameter: its name in a scenario or a diagram, and its distribution."""

    key: str  # dotted, ``"learning.gain"``
    kind: str  # uniform, normal, drawn (from a distribution) or levels
    numbers: tuple[Any, ...]  # low and high; the deviation; a distribution; the levels
    text: str  # key and values as written
    units: str = ""  # of labelled levels


def read_vary(text: str) -> Vary:
    """Return the sampled parameter of a text in one of the forms above."""
    match = re.fullmatch(
        r"\s*([\w.]+(?:\[[\d, ]+\])?)\s*([=~])\s*(.+?)\s*", text, re.DOTALL
    )
    key, sign, values = match.groups() if match else ("", "", "")
    written = key + sign + values
    with suppress(ValueError, RecursionError):
        # no number or list, or too many brackets or digits
        if values.startswith("["):
            if levels := json.loads(values):
                return Vary(key, "levels", tuple(levels), written)
        elif sign == "=":
            low, high = map(float, values.split(":"))
            if -math.inf < low < high < math.inf:
                return Vary(key, "uniform", (low, high), written)
        elif values.startswith("normal:"):
            size = float(values.removeprefix("normal:"))
            if 0 < size < math.inf:
                return Vary(key, "normal", (size,), written)
    raise ScenarioError(f"vary = '{shortened(text, 60)}': must be {FORMS}")


def _of_item(key: str, values: Any) -> Vary:
    """Return the sampled parameter of an item of a dict."""
    if isinstance(values, str):
        has_sign = values.lstrip()[:1] in ("~", "=")
        return read_vary(key + values if has_sign else f"{key}={values}")
    is_series = any(dim in TIME for dim, *_ in axes_of(values) or ())
    try:
        if hasattr(values, "ppf"):
            words = [repr(float(argument)) for argument in values.args]
            words += [f"{name}={float(value)!r}" for name, value in values.kwds.items()]
            if values.dist.name == "uniform":  # its arguments are no bounds
                low, high = map(float, values.support())
                return read_vary(f"{key}={low!r}:{high!r}")
            if np.isfinite(values.ppf(0.5)):
                text = f"{key}~{values.dist.name}({', '.join(words)})"
                return Vary(key, "drawn", (values,), text)
        elif np.ndim(values) and len(values) and not is_series:
            levels = (
                np.asarray(values) if np.ndim(values) == 1 else unlabelled(key, values)
            )
            if levels.dtype.kind in "bc" or bool in map(type, values):
                raise TypeError
            levels = levels.astype(str if levels.dtype.kind == "U" else float).tolist()
            text = f"{key}={json.dumps(levels)}"
            return Vary(key, "levels", tuple(levels), text, unit_of(values))
    except (TypeError, ValueError, AttributeError):
        pass
    raise ScenarioError(f"vary: {key} = {brief(values)}: must be {IN_A_DICT}")


def read_varies(vary: str | Iterable[str] | Mapping[str, Any]) -> tuple[Vary, ...]:
    """Return the sampled parameters of `vary` in any of its forms."""
    if axes_of(vary) is not None:
        raise ScenarioError(
            "vary: a table of members is no grid. Give a dict, {'k': values}, for a grid, or call "
            "clpt.prepare for each row"
        )
    if isinstance(vary, Mapping):
        varies = [_of_item(key, value) for key, value in vary.items()]
    else:
        texts = [vary] if isinstance(vary, str) else vary
        varies = [read_vary(text) for text in texts]
    if not varies:
        raise ScenarioError(
            "vary: name at least one key, such as learning.gain=0.2:2.0"
        )
    return tuple(varies)


def check_varies(varied: Varied, varies: Sequence[Vary]) -> None:
    """Refuse parameters that cannot vary in a system, and keys named twice."""
    values, keys = varied.values, [item.key for item in varies]
    for item in varies:
        if item.key not in values:
            raise ScenarioError(varied.why_not(item.key))
        if keys.count(item.key) > 1:
            raise ScenarioError(
                f"vary: {item.key} is named {keys.count(item.key)} times, not once"
            )
        unit = varied.key_layout(item.key, 0)[1].get("units", "")
        check_unit(f"vary['{item.key}']", item.units, [unit])
        if item.kind == "levels":
            _check_levels(item, values[item.key])
        elif item.key.endswith(".seed") or values[item.key].dtype.kind == "U":
            raise ScenarioError(
                f"vary = '{item.text}': {item.key} has no range. List the values"
            )


def cannot_vary(name: str, names: Iterable[str]) -> str:
    """Return the message for a name that cannot vary: a similar name, and all that may vary."""
    close = nearest(name, names)
    hint = f"did you mean {close}? May vary" if close and close != name else "may vary"
    return f"vary: {name} cannot vary; {hint}: {', '.join(names)}"


def _check_levels(item: Vary, base: np.ndarray) -> None:
    shape, is_text = base.shape, base.dtype.kind == "U"
    try:
        levels = np.array(item.numbers, dtype=base.dtype.type)
    except (TypeError, ValueError, OverflowError):
        levels = np.array(math.nan)
    has_integers = not item.key.endswith(".seed") or np.all(levels % 1 == 0)
    others = {bool, *([] if is_text else [str])} & {*map(type, item.numbers)}
    has_gaps = bool(others) or not (is_text or np.all(levels == levels))
    if levels.shape[1:] != shape or has_gaps or not has_integers:
        allowed = "a number" if shape == () else f"an array of shape {shape}"
        allowed = allowed if has_integers else "a whole number"
        allowed = "a text" if is_text else allowed
        text = shortened(json.dumps(item.numbers), 60)
        raise ScenarioError(f"vary: {item.key} = {text}: each value must be {allowed}")


# --- values of the members -----------------------------------------------------------------------


def grid_count(varies: Sequence[Vary]) -> int:
    """Return the number of combinations of lists."""
    if not all(item.kind == "levels" for item in varies):
        raise ScenarioError(
            "members: is required for ranges and distributions. Only lists define a grid"
        )
    return prod(len(item.numbers) for item in varies)


def draw_members(
    varied: Varied, varies: Sequence[Vary], members: int, design: str, seed: int
) -> Values:
    """Sample the members' values: key -> array, shape (members,) + the key's shape."""
    if design not in DESIGNS:
        raise ScenarioError(f"design = '{design}': must be one of {', '.join(DESIGNS)}")
    base = varied.values
    sizes = [1 if item.kind == "levels" else base[item.key].size for item in varies]
    count = members * sum(sizes)
    if count > MOST_NUMBERS:
        raise ScenarioError(
            f"members = {members}: would draw {Decimal(count).normalize():.3g} numbers; at most "
            f"{MOST_NUMBERS:.0e} are allowed"
        )
    if design == "grid":
        shares = iter(_grid_shares(varies, sizes, members))
    else:
        shares = (
            _shares(item.key, size, members, design, seed)
            for item, size in zip(varies, sizes, strict=True)
        )
    values = {item.key: _values(item, base[item.key], next(shares)) for item in varies}
    check_members(varied, varies, values)
    return values


def _shares(key: str, size: int, members: int, design: str, seed: int) -> np.ndarray:
    """Return shares in (0, 1), a column for each number that varies."""
    shares = np.empty((members, size))
    for k in range(size):
        rng = np.random.default_rng([seed, int.from_bytes(key.encode(), "big"), k])
        shares[:, k] = rng.random(members)
        if design == "lhs":
            shares[:, k] += rng.permutation(members)
            shares[:, k] /= members
    return np.clip(shares, EDGE, 1 - EDGE, out=shares)


def _grid_shares(
    varies: Sequence[Vary], columns: Sequence[int], members: int
) -> list[np.ndarray]:
    """Return shares on a grid; the last number varies fastest."""
    # 1. the number of levels of each item: its list's, or n, the same for all ranges
    fixed = [len(item.numbers) if item.kind == "levels" else 0 for item in varies]
    free = sum(c for c, count in zip(columns, fixed, strict=True) if not count)
    lists = prod(filter(None, fixed))
    n = max(1, round((members / lists) ** (1 / free))) if free else 1
    if lists * n**free != members:
        allowed = (
            f" n^{free} members, such as {lists * n**free:.9g}" if free else " members"
        )
        raise ScenarioError(
            f"members = {members}: this grid must have {lists:.9g}{allowed}, every value with all "
            "values of the other keys. A range is '0.4:0.6'; for pairs run clpt.prepare in a loop"
        )
    # 2. the level of each member, and its share
    sizes = np.repeat([count or n for count in fixed], columns)
    index = iter(np.unravel_index(np.arange(members), sizes))
    shares = []
    for item, c, count in zip(varies, columns, fixed, strict=True):
        numbers = np.stack([next(index) for _ in range(c)], axis=1)
        if item.kind == "uniform" and n > 1:
            shares.append(numbers / (n - 1))
        else:
            shares.append((numbers + 0.5) / (count or n))
    return shares


def _values(item: Vary, base: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Return the values at shares of the distribution; the array of shares is overwritten."""
    if item.kind == "levels":
        levels = np.array(item.numbers, dtype=base.dtype.type)
        index = (shares[:, 0] * len(levels)).astype(int)
        return levels[np.minimum(index, len(levels) - 1)]
    if item.kind == "uniform":
        low, high = item.numbers
        shares *= high - low
        shares += low
    elif item.kind == "drawn":
        shares = np.asarray(item.numbers[0].ppf(shares), dtype=float)
    else:
        from scipy.special import ndtri

        ndtri(shares, out=shares)
        shares *= item.numbers[0]
        shares += base.ravel()
    return shares.reshape(len(shares), *base.shape)


def check_members(varied: Varied, varies: Sequence[Vary], values: Values) -> None:
    """Refuse members with values that are not allowed.

    Allowed values are intervals, so only the members with the least and the largest number are
    checked, and one with each text.
    """
    for item in varies:
        numbers = values[item.key].reshape(len(values[item.key]), -1)
        if numbers.dtype.kind == "U":
            checked = np.unique(numbers, return_index=True)[1].tolist()
        else:
            checked = [numbers.min(axis=1).argmin(), numbers.max(axis=1).argmax()]
        for m in checked:
            try:
                varied.check(item.key, values[item.key][m])
            except ScenarioError as error:
                sentence = str(error).removeprefix("scenario: ")
                raise ScenarioError(
                    f"member {m}: {sentence}; narrow {item.text}"
                ) from None
    varied.check_blocks(values)
