"""Table of the integration methods."""

from .discrete_time import DISCRETE
from .dop853 import DOP853
from .method import Method
from .rodas5p import RODAS5P

EXPLICIT, IMPLICIT = DOP853, RODAS5P  # of a run that chooses its method
ROWS = (DOP853, RODAS5P, DISCRETE)
BY_NAME: dict[str, Method] = {row.name.lower(): row for row in ROWS if not row.discrete}
TAYLOR = "taylor"  # series of smooth rates; where they end, the explicit method goes on
METHODS: dict[str, Method] = {"auto": EXPLICIT, **BY_NAME, TAYLOR: EXPLICIT}
