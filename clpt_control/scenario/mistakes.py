"""A table of a scenario, whose mistakes are one sentence: key, value, what is allowed.

Pydantic finds them; every way to make a table, by call or from nested dicts, ends here.
"""

import difflib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Self, get_args

from pydantic import BaseModel, ConfigDict, ValidationError, model_validator

from ..errors import ScenarioError
from .quantities import key_of

if TYPE_CHECKING:
    from pydantic._internal._model_construction import ModelMetaclass
else:
    ModelMetaclass = type(BaseModel)


@contextmanager
def _said(table: Any, name: str) -> Iterator[None]:
    """Raise a ScenarioError that begins with `name` in place of pydantic's error."""
    try:
        yield
    except ValidationError as error:
        problems = error.errors()
        first = min(problems, key=lambda problem: problem["type"] != "extra_forbidden")
        more = f" (and {len(problems) - 1} more)" if len(problems) > 1 else ""
        raise ScenarioError(f"{name}: {sentence(first, table)}{more}") from None


class _Checked(ModelMetaclass):
    def __call__(cls, *args: Any, **values: Any) -> Any:
        with _said(cls, cls.__name__.lower()):
            return super().__call__(*args, **values)


class Table(BaseModel, metaclass=_Checked):
    """A table of the scenario; unknown keys are errors."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    def _mistakes(self) -> Iterator[str]:
        """Yield a sentence for each way in which keys do not fit together."""
        yield from ()

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        for mistake in self._mistakes():
            raise ValueError(mistake)
        return self

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Make a table of nested dicts; ``context["name"]`` is its name in errors."""
        with _said(cls, (options.get("context") or {}).get("name", cls.__name__.lower())):
            return super().model_validate(obj, **options)


def sentence(problem: Any, table: type[Table]) -> str:
    """Return what is wrong with one key, of an entry of pydantic's errors."""
    where = [part for part in problem["loc"] if not _is_tag(part, problem["loc"])]
    key = ""
    for part in where:
        key += f"[{part}]" if isinstance(part, int) else f".{part}" if key else str(part)
    message = problem["msg"].replace("Input should be", "must be").replace("Value error, ", "")
    kind = problem["type"]
    if kind == "missing":
        return f"missing key {key}"
    if kind == "extra_forbidden":
        return _unknown(key, problem, list(_inner(table, problem["loc"][:-1]).model_fields))
    if kind == "union_tag_not_found":
        return f'{key}.kind: is required; must be "circle" or "waypoints"'
    if kind == "union_tag_invalid":
        return f'{key}.kind = {problem["ctx"]["tag"]!r}: must be "circle" or "waypoints"'
    if kind == "value_error" and len(where) <= 1:
        return message
    if kind in ("too_long", "too_short", "tuple_type", "missing_argument"):
        message = message.replace("Tuple should", "must").replace(" after validation", "")
    if kind in ("model_type", "model_attributes_type"):
        message = "must be a table of keys"
    shown = " ".join(repr(problem["input"]).split())
    shown = shown if len(shown) <= 60 else shown[:57] + "..."
    return f"{key} = {shown}: {message}" if key else f"{shown}: {message}"


def _unknown(key: str, problem: Any, allowed: list[str]) -> str:
    value = problem["input"]
    for name in (f"{key}.{inner}" for inner in value) if isinstance(value, dict) else ():
        if other := key_of(name):
            return other
    close = difflib.get_close_matches(str(problem["loc"][-1]), allowed, n=1)
    hint = f"; did you mean {close[0]}? Allowed" if close else "; allowed"
    return f"unknown key {key}{hint} here: {', '.join(allowed)}"


def _inner(table: type[Table], location: tuple[Any, ...]) -> type[Table]:
    """Return the table at a place in another one."""
    for part in location:
        if not _is_tag(part, location):
            found = _tables(table.model_fields[part].annotation)
            named = [one for one in found if one.__name__.lower() in location]
            table = (named or found)[0]
    return table


def _tables(annotation: Any) -> list[type[Table]]:
    if isinstance(annotation, type) and issubclass(annotation, Table):
        return [annotation]
    return [found for inner in get_args(annotation) for found in _tables(inner)]


def _is_tag(part: Any, location: tuple[Any, ...]) -> bool:
    return location[:1] == ("reference",) and part in ("circle", "waypoints")
