"""Which values each member has.

    lhs       Latin hypercube: each number's range is cut into as many equal
              parts as there are members, and each part is drawn from once
    random    independent draws
    grid      every combination

Every number has its own stream of random numbers, made of the seed and its
own name, so that a member's values depend on the seed, the design, how many
members there are and its number: never on chunks, threads, order, or on what
else varies.
"""

from collections.abc import Sequence
from decimal import Decimal
from math import prod
from typing import Any

import numpy as np

from ..errors import ScenarioError
from .varied_keys import Varied, Vary, distribution

DESIGNS = ("lhs", "grid", "random")
MOST_NUMBERS = 2 * 10**8  # 1.6 GB
EDGE = 2.0**-53  # shares stay away from 0 and 1, where the normal quantile is infinite


def grid_count(varies: Sequence[Vary]) -> int:
    """Return how many combinations there are of what is listed."""
    if not all(one.kind == "levels" for one in varies):
        raise ScenarioError("members: is required where values are drawn; lists alone make a grid")
    return prod(len(one.numbers) for one in varies)


def draw_members(
    varied: Varied, varies: Sequence[Vary], members: int, design: str = "lhs", seed: int = 0
) -> dict[str, np.ndarray]:
    """Draw the members' values: key -> array, shape (members,) + the key's shape."""
    if design not in DESIGNS:
        raise ScenarioError(f"design = '{design}': must be one of {', '.join(DESIGNS)}")
    if members < 1:
        raise ScenarioError(f"members = {members}: must be a whole number, at least 1")
    base = varied.values
    count = members * sum(1 if one.kind == "levels" else base[one.key].size for one in varies)
    if count > MOST_NUMBERS:
        raise ScenarioError(
            f"members = {members}: would draw {Decimal(count).normalize():.3g} numbers; at most "
            f"{MOST_NUMBERS:.0e} are allowed"
        )
    if design == "grid":
        shares = iter(_grid_shares(varies, base, members))
    else:
        shares = (_shares(one, base[one.key].size, members, design, seed) for one in varies)
    values = {one.key: _values(one, base[one.key], next(shares)) for one in varies}
    check_members(varied, varies, values)
    return values


def _shares(one: Vary, size: int, members: int, design: str, seed: int) -> np.ndarray:
    """Return shares in (0, 1), a column for each number that varies."""
    columns = 1 if one.kind == "levels" else size
    shares = np.empty((members, columns))
    for k in range(columns):
        rng = np.random.default_rng([seed, int.from_bytes(one.key.encode(), "big"), k])
        shares[:, k] = rng.random(members)
        if design == "lhs":
            shares[:, k] += rng.permutation(members)
            shares[:, k] /= members
    return np.clip(shares, EDGE, 1 - EDGE, out=shares)


def _grid_shares(varies: Sequence[Vary], base: dict[str, Any], members: int) -> list[np.ndarray]:
    """Return shares on a grid; the last number varies fastest."""
    fixed = [len(one.numbers) if one.kind == "levels" else 0 for one in varies]
    columns = [1 if count else base[one.key].size for one, count in zip(varies, fixed, strict=True)]
    free = sum(c for c, count in zip(columns, fixed, strict=True) if not count)
    lists = int(np.prod([count for count in fixed if count], dtype=float))
    n = max(1, round((members / lists) ** (1 / free))) if free else 1
    if lists * n**free != members:
        allowed = sorted({lists * max(1, n + step) ** free for step in (-1, 0, 1)})
        shown = " or ".join(f"{count:,}".replace(",", " ") for count in allowed[:3])
        raise ScenarioError(
            f"members = {members}: this grid must have "
            + (f"{lists} n^{free} members, such as {shown}" if free else f"{lists} members")
        )
    sizes = [count or n for c, count in zip(columns, fixed, strict=True) for _ in range(c)]
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
        return levels[np.minimum((shares[:, 0] * len(levels)).astype(int), len(levels) - 1)]
    if one.kind == "uniform":
        low, high = one.numbers
        shares *= high - low
        shares += low
    elif one.kind == "drawn":
        shares = np.asarray(distribution(one.numbers[0]).ppf(shares), dtype=float)
    else:
        from scipy.special import ndtri

        ndtri(shares, out=shares)
        shares *= one.numbers[0]
        shares += base.ravel()
    return shares.reshape(len(shares), *base.shape)


def check_members(varied: Varied, varies: Sequence[Vary], values: dict[str, np.ndarray]) -> None:
    """Refuse members with values that are not allowed.

    What is allowed are intervals: where the least and the largest of all members
    are allowed, so is what lies between.
    """
    for one in varies:
        own = values[one.key]
        if _allowed(varied, one.key, own):
            continue
        first, last = 0, len(own) - 1  # the first member refused lies in [first, last]
        while first < last:
            middle = (first + last) // 2
            if _allowed(varied, one.key, own[: middle + 1]):
                first = middle + 1
            else:
                last = middle
        try:
            varied.check(one.key, own[first])
        except ScenarioError as error:
            sentence = str(error).removeprefix("scenario: ")
            raise ScenarioError(f"member {first}: {sentence}; narrow {one.text}") from None


def _allowed(varied: Varied, key: str, values: np.ndarray) -> bool:
    try:
        for extreme in (values.min(axis=0), values.max(axis=0)):
            varied.check(key, extreme)
    except ScenarioError:
        return False
    return True
