"""Facts about an integration method, which the solver and its callers ask."""

from collections.abc import Callable
from dataclasses import dataclass

from .formulas import Formula


@dataclass(frozen=True)
class Method:
    """Facts about an integration method.

    name : its name in datasets; in lower case the argument `method` of a run.
    stages : evaluations of a step, the rate at its end among them.
    order : of its global error.
    formulas : returns its formulas by name, in the order in which the solver numbers them.
    implicit : whether stages are solved with a matrix of df/dx.
    discrete : whether a step leads from one sample of discrete time to the next.
    dense_stages : further evaluations for its interpolant; after them its formulas give the new
        state again, in whose place the arguments were.
    """

    name: str
    stages: int
    order: int
    formulas: Callable[[], dict[str, Formula]]
    implicit: bool = False
    discrete: bool = False
    dense_stages: int = 0

    @property
    def ends_at_samples(self) -> bool:
        """True if each sample ends a step, so that steps depend on the samples."""
        return self.implicit or self.discrete

    @property
    def text(self) -> str:
        """Kind and order, for lists of methods."""
        kind = "implicit, for stiff equations" if self.implicit else "explicit"
        return f"{kind}, order {self.order}"
