"""What a replay says of one dive.

CLPE is |x - z|, Eq. (10), at the surfacing; z follows one of three flow models,
or one that was given.
"""

from dataclasses import dataclass

import numpy as np

from ..gliders.dives import Dive
from .anomaly import Anomaly

MODELS = ("no_flow", "previous_dive", "adaptive")
FLOW_MODEL = "flow_model"  # a forecast or a fit that was given


@dataclass(frozen=True)
class Step:
    """What a replay says of one dive.

    Attributes
    ----------
    dive : Dive
        The dive.
    clpe : dict of float or None
        |x - z| for "no_flow", "previous_dive", "adaptive" and "flow_model", m;
        the last is None where no such model covers the dive.
    forecast : ndarray, shape (2,)
        Fix less dead reckoning, east and north, as forecast, m.
    covariance : ndarray, shape (2, 2)
        Of the forecast, m^2.
    inside : bool
        Whether the vehicle surfaced in the forecast's 90 % ellipse.
    anomaly : Anomaly or None
        Where the speed left its credible range.
    current, current_error : ndarray, shape (2,)
        Learned flow over this dive and its standard error, m/s.
    learned, held : tuple of str
        Parameters that the dives so far do and do not excite.
    speed, speed_error : float
        Learned factor on speed through water; 1 +- 0 where not a parameter.
    compass, compass_error : float
        Learned compass error, degrees clockwise; 0 +- 0 where none.
    previous_share : float
        Share of the previous dive's current in the forecast.
    """

    dive: Dive
    clpe: dict[str, float | None]
    forecast: np.ndarray
    covariance: np.ndarray
    inside: bool
    anomaly: Anomaly | None
    current: np.ndarray
    current_error: np.ndarray
    learned: tuple[str, ...]
    held: tuple[str, ...]
    speed: float = 1.0
    speed_error: float = 0.0
    compass: float = 0.0
    compass_error: float = 0.0
    previous_share: float = 0.0
