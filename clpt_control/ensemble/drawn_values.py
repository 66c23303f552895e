"""Sampled parameters of an ensemble, and the values of each member.

    learning.gain=0.2:2.0         uniform between two numbers
    flow.parameters~normal:0.1    normal about the value that is there, with an
                                  absolute standard deviation
    learning.gain=[0.5, 1, 2]     one of these values

In Python a dict says the same, and may hold a distribution of scipy.stats,
``{"learning.gain": stats.gamma(2, 0, 1)}``.  Shapes never change; an array varies element by
element, a list gives whole values.

    lhs       Latin hypercube: each number's range is cut into as many equal
              parts as there are members, and each part is drawn from once
    random    independent draws
    grid      every combination

Every number has its own stream of random numbers, made of the seed and its
own name, so that a member's values depend on the seed, the design, how many
members there are and its number: never on chunks, threads, order, or on what
else varies.
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
from .members import Values, Varied

FORMS = (
    "KEY=LOW:HIGH, two finite numbers of which the first is the smaller; KEY~normal:DEVIATION, a "
    "positive number; or KEY=[VALUE, ...]"
)
IN_A_DICT = "a list of values, a range '0.2:2.0', or a distribution, such as scipy.stats.norm(1, 2)"
DESIGNS = ("lhs", "grid", "random")
MOST_NUMBERS = 2 * 10**8  # 1.6 GB
EDGE = 2.0**-53  # shares stay away from 0 and 1, where the normal quantile is infinite


class Vary(NamedTuple):
    """One name of a scenario or a diagram, and how it varies."""

    key: str  # dotted, ``"learning.gain"``
    kind: str  # uniform, normal, drawn or levels
    numbers: tuple[Any, ...]  # low and high; the deviation; a distribution; the levels
    text: str  # key and values as they are written


def read_vary(text: str) -> Vary:
    """Read how a key varies, in one of the forms above."""
    match = re.fullmatch(
        r"\s*([\w.]+(?:\[[\d, ]+\])?)\s*([=~])\s*(.+?)\s*", text, re.DOTALL
    )
    key, sign, rest = match.groups() if match else ("", "", "")
    written = key + sign + rest
    with suppress(ValueError, RecursionError):
        # no number or list, or too many brackets or digits
        if rest.startswith("["):
            if levels := json.loads(rest):
                return Vary(key, "levels", tuple(levels), written)
        elif sign == "=":
            low, high = map(float, rest.split(":"))
            if -math.inf < low < high < math.inf:
                return Vary(key, "uniform", (low, high), written)
        elif rest.startswith("normal:"):
            size = float(rest.removeprefix("normal:"))
            if 0 < size < math.inf:
                return Vary(key, "normal", (size,), written)
    raise ScenarioError(f"vary = '{shortened(text, 60)}': must be {FORMS}")


def _of_item(key: str, given: Any) -> Vary:
    """Return how a key of a dict varies."""
    if isinstance(given, str):
        return read_vary(
            key + (given if given.lstrip()[:1] in ("~", "=") else f"={given}")
        )
    try:
        if hasattr(given, "ppf"):
            named = [f"{name}={float(value)!r}" for name, value in given.kwds.items()]
            numbers = ", ".join([*(repr(float(one)) for one in given.args), *named])
            if np.isfinite(given.ppf(0.5)):
                return Vary(
                    key, "drawn", (given,), f"{key}~{given.dist.name}({numbers})"
                )
        elif np.ndim(given) and len(given):
            levels = np.asarray(given, dtype=float).tolist()
            return Vary(key, "levels", tuple(levels), f"{key}={json.dumps(levels)}")
    except (TypeError, ValueError, AttributeError):
        pass
    raise ScenarioError(f"vary: {key} = {brief(given)}: must be {IN_A_DICT}")


def read_varies(vary: str | Iterable[str] | Mapping[str, Any]) -> tuple[Vary, ...]:
    """Read what varies, in any of its forms."""
    if isinstance(vary, Mapping):
        varies = [_of_item(key, value) for key, value in vary.items()]
    else:
        varies = [read_vary(one) for one in ([vary] if isinstance(vary, str) else vary)]
    if not varies:
        raise ScenarioError(
            "vary: name at least one key, such as learning.gain=0.2:2.0"
        )
    return tuple(varies)


def check_varies(varied: Varied, varies: Sequence[Vary]) -> None:
    """Refuse what cannot vary in a system."""
    values, keys = varied.values, [one.key for one in varies]
    for one in varies:
        if one.key not in values:
            raise ScenarioError(varied.why_not(one.key))
        if keys.count(one.key) > 1:
            raise ScenarioError(
                f"vary: {one.key} is named {keys.count(one.key)} times, not once"
            )
        if one.kind == "levels":
            _check_levels(one, values[one.key].shape)
        elif one.key.endswith(".seed"):
            raise ScenarioError(
                f"vary = '{one.text}': a seed is a whole number; list the values"
            )


def what_may_vary(name: str, known: Iterable[str]) -> str:
    """Return the sentence on a name that does not vary: what may be meant, and what may vary."""
    close = nearest(name, known)
    hint = f"did you mean {close}? May vary" if close and close != name else "may vary"
    return f"vary: {name} cannot vary; {hint}: {', '.join(known)}"


def _check_levels(one: Vary, shape: tuple[int, ...]) -> None:
    try:
        levels = np.array(one.numbers, dtype=float)
    except (TypeError, ValueError, OverflowError):
        levels = np.array(math.nan)
    whole = not one.key.endswith(".seed") or np.all(levels % 1 == 0)
    finite = np.all(np.isfinite(levels)) and bool not in map(type, one.numbers)
    if levels.shape[1:] != shape or not finite or not whole:
        allowed = "a number" if shape == () else f"an array of shape {shape}"
        allowed = allowed if whole else "a whole number"
        text = shortened(json.dumps(one.numbers), 60)
        raise ScenarioError(f"vary: {one.key} = {text}: each value must be {allowed}")


# --- the values of each member -------------------------------------------------------------------


def grid_count(varies: Sequence[Vary]) -> int:
    """Return the number of combinations of lists."""
    if not all(one.kind == "levels" for one in varies):
        raise ScenarioError(
            "members: is required where values are drawn; lists alone make a grid"
        )
    return prod(len(one.numbers) for one in varies)


def draw_members(
    varied: Varied, varies: Sequence[Vary], members: int, design: str, seed: int
) -> Values:
    """Draw the members' values: key -> array, shape (members,) + the key's shape."""
    if design not in DESIGNS:
        raise ScenarioError(f"design = '{design}': must be one of {', '.join(DESIGNS)}")
    if members < 1:
        raise ScenarioError(f"members = {members}: must be a whole number, at least 1")
    base = varied.values
    sizes = [1 if one.kind == "levels" else base[one.key].size for one in varies]
    count = members * sum(sizes)
    if count > MOST_NUMBERS:
        raise ScenarioError(
            f"members = {members}: would draw {Decimal(count).normalize():.3g} numbers; at most "
            f"{MOST_NUMBERS:.0e} are allowed"
        )
    if design == "grid":
        shares = iter(_grid_shares(varies, sizes, members))
    else:
        drawn = zip(varies, sizes, strict=True)
        shares = (_shares(one.key, size, members, design, seed) for one, size in drawn)
    values = {one.key: _values(one, base[one.key], next(shares)) for one in varies}
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
    fixed = [len(one.numbers) if one.kind == "levels" else 0 for one in varies]
    free = sum(c for c, count in zip(columns, fixed, strict=True) if not count)
    lists = prod(filter(None, fixed))
    n = max(1, round((members / lists) ** (1 / free))) if free else 1
    if lists * n**free != members:
        more = f" n^{free} members, such as {lists * n**free}" if free else " members"
        raise ScenarioError(f"members = {members}: this grid must have {lists}{more}")
    sizes = np.repeat([count or n for count in fixed], columns)
    index = iter(np.unravel_index(np.arange(members), sizes))
    shares = []
    for one, c, count in zip(varies, columns, fixed, strict=True):
        numbers = np.stack([next(index) for _ in range(c)], axis=1)
        if one.kind == "uniform" and n > 1:
            shares.append(numbers / (n - 1))
        else:
            shares.append((numbers + 0.5) / (count or n))
    return shares


def _values(one: Vary, base: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Turn shares into values, in place where they are numbers."""
    if one.kind == "levels":
        levels = np.array(one.numbers, dtype=float)
        return levels[
            np.minimum((shares[:, 0] * len(levels)).astype(int), len(levels) - 1)
        ]
    if one.kind == "uniform":
        low, high = one.numbers
        shares *= high - low
        shares += low
    elif one.kind == "drawn":
        shares = np.asarray(one.numbers[0].ppf(shares), dtype=float)
    else:
        from scipy.special import ndtri

        ndtri(shares, out=shares)
        shares *= one.numbers[0]
        shares += base.ravel()
    return shares.reshape(len(shares), *base.shape)


def check_members(varied: Varied, varies: Sequence[Vary], values: Values) -> None:
    """Refuse members with values that are not allowed.

    What is allowed are intervals: where the members with the least and the largest number are
    allowed, so are the others.
    """
    for one in varies:
        numbers = values[one.key].reshape(len(values[one.key]), -1)
        for m in (numbers.min(axis=1).argmin(), numbers.max(axis=1).argmax()):
            try:
                varied.check(one.key, values[one.key][m])
            except ScenarioError as error:
                sentence = str(error).removeprefix("scenario: ")
                raise ScenarioError(
                    f"member {m}: {sentence}; narrow {one.text}"
                ) from None
