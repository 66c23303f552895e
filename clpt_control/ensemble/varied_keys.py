"""What varies in an ensemble, as a user writes it.

    learning.gain=0.2:2.0         uniform between two numbers
    flow.parameters~normal:0.1    normal about the value that is there, with an
                                  absolute standard deviation
    learning.gain~gamma(2, 0, 1)  a distribution of scipy.stats
    learning.gain=[0.5, 1, 2]     one of these values

In Python a dict says the same, ``{"learning.gain": stats.gamma(2, 0, 1)}``.  Shapes never change;
an array varies element by element, a list gives whole values.
"""

import ast
import difflib
import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple, Protocol

import numpy as np

from ..arguments import public, shown
from ..errors import ScenarioError
from ..scenario.experiment import Scenario
from ..scenario.mistakes import Table
from ..scenario.quantities import key_of

FORMS = "KEY=LOW:HIGH, KEY~normal:DEVIATION or KEY=[VALUE, ...]"
IN_A_DICT = "a list of values, a range '0.2:2.0', or a distribution, such as scipy.stats.norm(1, 2)"


class Varied(Protocol):
    """What is run many times, as far as it says what may vary in it."""

    values: dict[str, np.ndarray]  # what may vary, as it is

    def why_not(self, key: str) -> str:
        """Return why a key cannot vary."""

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that is not allowed."""


@public
class Vary(NamedTuple):
    """One name of a scenario or a diagram, and how it varies.

    Attributes
    ----------
    key : str
        Dotted key, ``"learning.gain"``.
    kind : str
        ``"uniform"``, ``"normal"``, ``"drawn"`` or ``"levels"``.
    numbers : tuple
        Low and high; the standard deviation; a distribution, ``"gamma(2, 0, 1)"``; or the levels.

    Examples
    --------
    >>> Vary("learning.gain", "uniform", (0.2, 2.0)).text
    'learning.gain=0.2:2.0'
    """

    key: str
    kind: str
    numbers: tuple[Any, ...]

    @property
    def text(self) -> str:
        """The same as `read_vary` reads it."""
        if self.kind == "uniform":
            return f"{self.key}={self.numbers[0]!r}:{self.numbers[1]!r}"
        if self.kind == "normal":
            return f"{self.key}~normal:{self.numbers[0]!r}"
        if self.kind == "drawn":
            return f"{self.key}~{self.numbers[0]}"
        return f"{self.key}={json.dumps(list(self.numbers))}"


def read_vary(text: str) -> Vary:
    """Read how a key varies, in one of the forms above."""
    match = re.fullmatch(r"\s*([\w.]+(?:\[[\d, ]+\])?)\s*([=~])\s*(.+?)\s*", text, re.DOTALL)
    if match is None:
        raise ScenarioError(f"vary = '{text}': must be {FORMS}, such as learning.gain=0.2:2.0")
    key, sign, rest = match.groups()
    if sign == "~":
        kind, _, deviation = rest.partition(":")
        if rest.endswith(")"):
            distribution(rest)
            return Vary(key, "drawn", (rest,))
        if kind.strip() != "normal":
            raise ScenarioError(f"vary = '{text}': after ~ must stand normal:DEVIATION")
        size = _number(deviation, text)
        if not size > 0:
            raise ScenarioError(f"vary = '{text}': the standard deviation must be positive")
        return Vary(key, "normal", (size,))
    if rest.startswith("["):
        try:
            levels = json.loads(rest)
        except (ValueError, RecursionError):  # no list, or too many brackets or digits
            raise ScenarioError(
                f"vary = '{text}': the list cannot be read; write it as [0.5, 1, 2]"
            ) from None
        if not levels:
            raise ScenarioError(f"vary = '{text}': the list must have at least one value")
        return Vary(key, "levels", tuple(levels))
    low, colon, high = rest.partition(":")
    if not colon:
        raise ScenarioError(f"vary = '{text}': must be {FORMS}, such as {key}=0.2:2.0")
    ends = _number(low, text), _number(high, text)
    if not ends[0] < ends[1]:
        raise ScenarioError(f"vary = '{text}': the first number must be below the second")
    return Vary(key, "uniform", ends)


def _number(word: str, text: str) -> float:
    try:
        value = float(word) if word.isascii() else math.nan
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ScenarioError(f"vary = '{text}': '{word.strip()}' must be a finite number")
    return value


@lru_cache(maxsize=64)
def distribution(text: str) -> Any:
    """Return the distribution of scipy.stats that a text says, ``"gamma(2, scale=0.5)"``."""
    from scipy import stats

    try:
        call: Any = ast.parse(text.strip(), mode="eval").body
        given = [float(ast.literal_eval(one)) for one in call.args]
        named = {str(one.arg): float(ast.literal_eval(one.value)) for one in call.keywords}
        found = getattr(stats, call.func.id)(*given, **named)
        if not np.isfinite(found.ppf(0.5)):
            raise ValueError
    except Exception:  # whatever a text may be
        raise ScenarioError(
            f"vary: {text:.60} is no distribution of scipy.stats with numbers, such as "
            "uniform(0.5, 1) or gamma(2, scale=0.5)"
        ) from None
    return found


def _of_item(key: str, given: Any) -> Vary:
    """Return how a key of a dict varies."""
    if isinstance(given, str):
        return read_vary(key + (given if given.lstrip()[:1] in ("~", "=") else f"={given}"))
    try:
        if hasattr(given, "ppf"):
            named = [f"{name}={float(value)!r}" for name, value in given.kwds.items()]
            numbers = ", ".join([*(repr(float(one)) for one in given.args), *named])
            text = f"{given.dist.name}({numbers})"
            if distribution(text).ppf(0.3) == given.ppf(0.3):
                return Vary(key, "drawn", (text,))
        elif np.ndim(given) and len(given):
            return Vary(key, "levels", tuple(np.asarray(given, dtype=float).tolist()))
    except (TypeError, ValueError, AttributeError):
        pass
    raise ScenarioError(f"vary: {key} = {shown(given)}: must be {IN_A_DICT}")


def parsed(
    vary: str | Vary | Iterable[str | Vary] | Mapping[str, Any],
) -> tuple[Vary, ...]:
    """Read what varies, in any of its forms."""
    if isinstance(vary, Mapping):
        given: Iterable[str | Vary] = [_of_item(key, value) for key, value in vary.items()]
    else:
        given = [vary] if isinstance(vary, str | Vary) else vary
    varies = tuple(read_vary(one) if isinstance(one, str) else one for one in given)
    if not varies:
        raise ScenarioError("vary: name at least one key, such as learning.gain=0.2:2.0")
    return varies


def check_varies(varied: Varied, varies: Sequence[Vary]) -> None:
    """Refuse what cannot vary in a scenario or a diagram."""
    values, keys = varied.values, [one.key for one in varies]
    for one in varies:
        if one.key not in values:
            raise ScenarioError(varied.why_not(one.key))
        if keys.count(one.key) > 1:
            raise ScenarioError(f"vary: {one.key} is named {keys.count(one.key)} times, not once")
        if one.kind == "levels":
            _check_levels(one, values[one.key].shape)
        elif one.key.endswith(".seed"):
            raise ScenarioError(f"vary = '{one.text}': a seed is a whole number; list the values")


def _check_levels(one: Vary, shape: tuple[int, ...]) -> None:
    allowed = "a number" if shape == () else f"an array of shape {shape}"
    for level in one.numbers:
        try:
            fits = np.shape(np.asarray(level, dtype=float)) == shape and level is not None
        except (TypeError, ValueError, OverflowError):
            fits = False
        if fits and one.key.endswith(".seed") and not float(level).is_integer():
            fits, allowed = False, "a whole number"
        if not fits or isinstance(level, bool):
            shown = json.dumps(level)
            shown = shown if len(shown) <= 40 else shown[:37] + "..."
            raise ScenarioError(f"vary: {one.key} = {shown}: each value must be {allowed}")


class VariedScenario:
    """What may vary in a scenario."""

    def __init__(self, scenario: Scenario):
        self.scenario, self.values = scenario, variable_values(scenario)

    def why_not(self, key: str) -> str:
        """Return why a key cannot vary."""
        return _why_not(self.scenario, key, list(self.values))

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that the scenario does not allow."""
        self.scenario.with_values({key: value})


def variable_values(scenario: Scenario) -> dict[str, np.ndarray]:
    """Return every key that may vary, with the scenario's value or the default."""
    defaults = {"basis.phases": scenario.phases, "model.parameters": scenario.model_parameters}
    if not scenario.learning.row.keeps_alpha:
        defaults["learning.parameters"] = scenario.learning_parameters
    found: dict[str, np.ndarray] = {}

    def walk(part: Table, prefix: str) -> None:
        for name in type(part).model_fields:
            value, key = getattr(part, name), f"{prefix}{name}"
            if isinstance(value, Table):
                if key != "run":
                    walk(value, f"{key}.")
                continue
            value = float(value or 0) if name == "seed" else defaults.get(key, value)
            if isinstance(value, float) or _is_array(value):
                found[key] = np.array(value, dtype=float)

    walk(scenario, "")
    learning = scenario.learning
    own = {f"{learning.row.table}.{key}": value for key, value in learning.settings.items()}
    if learning.gain is None and learning.gains is None:
        own["gain"] = learning.row.gain
    for name, value in own.items():  # the law's defaults may vary too
        if isinstance(value, float) or _is_array(value):
            found.setdefault(f"learning.{name}", np.array(value, dtype=float))
    kind = None if scenario.flow.disturbance is None else scenario.flow.disturbance.kind
    if kind == "constant":
        found.pop("flow.disturbance.period", None)
    found.pop("learning.sample", None)
    if kind != "noise":
        found.pop("flow.disturbance.seed", None)
    return found


def _is_array(value: Any) -> bool:
    while isinstance(value, Sequence) and not isinstance(value, str) and value:
        value = value[0]
    return isinstance(value, float)


def _why_not(scenario: Scenario, key: str, allowed: list[str]) -> str:
    """Return why a key cannot vary."""
    if key not in allowed and (other := key_of(key)):
        return f"vary: {other}"
    place: Any = scenario
    for name in key.split("."):
        known = isinstance(place, Table) and name in type(place).model_fields
        place = getattr(place, name) if known else None
        if not known or place is None:
            break
    if key.split(".")[0] == "run":
        return f"vary: {key} cannot vary: members share duration, samples and tolerances"
    if key == "learning.sample":
        return f"vary: {key} cannot vary: members share the times at which their law runs"
    if isinstance(place, int):
        return f"vary: {key} = {place} cannot vary: counts are whole numbers"
    if isinstance(place, Table):
        return f"vary: {key} is a table; name one of its keys, such as {key}.{_first(place)}"
    if place is not None and known:
        return f"vary: {key} = {place!r} cannot vary: it is not a number"
    if known:
        return f"vary: {key} is not set in the scenario; may vary: {', '.join(allowed)}"
    close = difflib.get_close_matches(key, allowed, n=1)
    hint = f"; did you mean {close[0]}?" if close else ";"
    return f"vary: unknown key {key}{hint} May vary: {', '.join(allowed)}".replace("; May", "; may")


def _first(part: Table) -> str:
    names = list(type(part).model_fields)
    return next(
        (name for name in names if isinstance(getattr(part, name), float | tuple)), names[0]
    )
