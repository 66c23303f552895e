"""What an engine gives: states at times, and how they were reached."""

from dataclasses import dataclass, field

import numpy as np

FINISHED = "finished: the end of the span was reached"


@dataclass
class Solution:
    """States at the requested times, and how they were reached.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Requested times that were reached.
    x : ndarray, shape (n, nstates)
        States at these times.
    status : str
        ``"finished"`` or ``"stopped"`` (a guard ended the run).
    message : str
        One sentence on how the run ended.
    statistics : dict
        Numbers of steps, evaluations and restarts.
    """

    t: np.ndarray
    x: np.ndarray
    status: str = "finished"
    message: str = FINISHED
    statistics: dict[str, int] = field(default_factory=dict)
