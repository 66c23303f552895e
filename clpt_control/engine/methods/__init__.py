"""Table of the integration methods: a row of facts for each, which the solver and its callers ask.

The formulas of a method are in a file of their own, which is loaded when they are first needed.
"""

from importlib import import_module
from typing import Any, NamedTuple

FORMULAS = (
    *("attempt", "control", "sizes", "trial", "first"),
    *("accept", "dense", "cubic", "within", "stiffness"),
)


class Method(NamedTuple):
    """Facts about an integration method.

    name : its name in datasets; in lower case the argument `method` of a run.
    stages : evaluations of a step, the rate at its end among them.
    order : of its global error.
    module : the file of its formulas, relative to this one.
    implicit : whether stages are solved with a matrix of df/dx.
    discrete : whether a step leads from one sample of discrete time to the next.
    dense_stages : further evaluations for its interpolant; after them its formulas give the new
        state again, in whose place the arguments were.
    """

    name: str
    stages: int
    order: int
    module: str
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

    @property
    def names(self) -> list[str]:
        """Names of its formulas, in the order in which the solver numbers them."""
        stages = self.stages - 1 + (self.dense_stages and self.dense_stages + 1)
        return [*FORMULAS, *(f"stage_{k}" for k in range(1, stages + 1))]

    def formulas(self) -> dict[str, Any]:
        """Return its formulas by name."""
        formulas = import_module(self.module, __package__).formulas()
        return dict(zip(self.names, formulas, strict=True))


DOP853 = Method("DOP853", 12, 8, ".dop853", dense_stages=3)
RODAS5P = Method("Rodas5P", 9, 5, ".rodas5p", implicit=True)
DISCRETE = Method("none", 1, 0, ".discrete_time", discrete=True)
EXPLICIT, IMPLICIT = DOP853, RODAS5P  # of a run that chooses its method
ROWS = (DOP853, RODAS5P, DISCRETE)
BY_NAME: dict[str, Method] = {row.name.lower(): row for row in ROWS if not row.discrete}
TAYLOR = "taylor"  # series of smooth rates; where they end, the explicit method goes on
METHODS: dict[str, Method] = {"auto": EXPLICIT, **BY_NAME, TAYLOR: EXPLICIT}
