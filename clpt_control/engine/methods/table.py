"""Table of the integration methods."""

from .dop853 import DOP853
from .discrete_time import DISCRETE
from .method import Method
from .rodas5p import RODAS5P

EXPLICIT, IMPLICIT = DOP853, RODAS5P  # of a run that chooses its method
ROWS = (DOP853, RODAS5P, DISCRETE)
ADAPTIVE: dict[str, Method] = {row.name.lower(): row for row in ROWS if row.adaptive}
TAYLOR = "taylor"  # series of smooth rates; where they end, the explicit method goes on
METHODS: dict[str, Method] = {"auto": EXPLICIT, **ADAPTIVE, TAYLOR: EXPLICIT}
