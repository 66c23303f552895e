"""Columns of the regression between fixes: what one unit of a parameter does.

    steady current      T                             two parameters, m/s
    tide, speed w       T s(w) cos(w tm), T s(w) sin(w tm)    four, m/s
    inertial current    T s(c)                        two, m/s, at mid-dive
    flow model          its displacement (east, north)    one, a factor
    speed               (d_east, d_north)             f - 1
    compass             (d_north, -d_east)            psi, rad, clockwise

with T the duration, tm mid-dive, d the dead reckoning and s(w) = sin(w T/2)/(w T/2),
the mean of a tide over a dive.  Between dives the inertial current turns by
-c dt, c = 2 Omega sin(latitude) (A. E. Gill, "Atmosphere-Ocean Dynamics", 1982,
section 8.3).
"""

import math

import numpy as np

from .dive import Dive

ROTATION = 7.292115e-5  # rad/s, of the Earth


def mid_time(dive: Dive) -> float:
    """Return the middle of a dive, s since 1970 UTC."""
    return 0.5 * (dive.t_gps2 + dive.t_gpse)


def miss(dive: Dive) -> np.ndarray:
    """Return y, fix less dead reckoning at a dive's end, (2,), m."""
    return np.array([dive.miss_east, dive.miss_north])


def reckoned(dive: Dive) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return dead reckoning: time since the fix before the dive (s), east and north (m).

    A straight line at constant speed where the dive has no track; its end fix is not read.
    """
    if dive.track is not None:
        return dive.track
    ends = np.array([[0.0, dive.duration], [0.0, dive.dr_east], [0.0, dive.dr_north]])
    return ends[0], ends[1], ends[2]


def inertial_frequency(latitude: float) -> float:
    """Return the Coriolis frequency at a latitude (degrees), rad/s: positive turns clockwise."""
    return 2 * ROTATION * math.sin(math.radians(latitude))


def steady(dive: Dive) -> np.ndarray:
    """Return the columns of a steady current, (2, 2), s."""
    return dive.duration * np.eye(2)


def swing(dive: Dive, w: float) -> float:
    """Return T s(w), s: how far an oscillation of unit size at mid-dive carries; w in rad/s."""
    T = dive.duration
    return T * float(np.sinc(w * T / (2 * math.pi)))


def tide(dive: Dive, w: float) -> np.ndarray:
    """Return the columns of a tide, (2, 4), s: east and north of the cosine, then of the sine."""
    turn, mean = w * mid_time(dive), swing(dive, w)
    return mean * np.hstack([math.cos(turn) * np.eye(2), math.sin(turn) * np.eye(2)])


def inertial(dive: Dive) -> np.ndarray:
    """Return the columns of the inertial current, (2, 2), s."""
    return swing(dive, inertial_frequency(dive.lat_gps2)) * np.eye(2)


def flow_model(dive: Dive) -> np.ndarray:
    """Return the column of a flow model, (2, 1), m; zero where it does not cover the dive."""
    return np.array([[dive.model_east or 0.0], [dive.model_north or 0.0]])


def water(dive: Dive) -> np.ndarray:
    """Return the columns of speed and compass, (2, 2), m."""
    return np.array([[dive.dr_east, dive.dr_north], [dive.dr_north, -dive.dr_east]])
