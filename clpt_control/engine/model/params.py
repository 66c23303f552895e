"""The params of python-control, which record the names that a function reads."""

from collections.abc import Callable, Mapping
from typing import Any

EVERY = object()  # stands for all names
FOR_ONE = ("__getitem__", "__contains__", "get", "pop", "setdefault")
FOR_ALL = (
    "__iter__",
    "__reversed__",
    "__eq__",
    "__or__",
    "__ror__",
    "keys",
    "values",
    "items",
    "copy",
    "popitem",
)


def _noted(method: str) -> Callable:
    """Return a method of dict that adds the name it reads, or EVERY, to the names."""
    real = getattr(dict, method)

    def noting(self: "Params", *arguments: Any) -> Any:
        self.names.add(arguments[0] if method in FOR_ONE else EVERY)
        return real(self, *arguments)

    return noting


class Params(dict):
    """The params of python-control; they record the names that a function reads."""

    def __init__(self, params: Mapping[str, Any], names: set[Any]) -> None:
        super().__init__(params)
        self.names = names

    vars().update({method: _noted(method) for method in (*FOR_ONE, *FOR_ALL)})
