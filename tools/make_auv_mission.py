"""Print the log of the made AUV mission that ships with the package.

    python tools/make_auv_mission.py > clpt_control/data/made_auv_mission.csv

No vehicle recorded it: an AUV of 1 m/s visits three waypoints for two days, dead reckoning between
fixes each 3 h of 10 m noise, in a steady current of three Gaussians, Eq. (3), with theta = `THETA`.
The log has a row at each fix and at each turn.
"""

from datetime import UTC, datetime, timedelta

import numpy as np
from pyproj import Proj

ORIGIN = 36.7, -122.1  # degrees
CENTERS = np.array([[0.0, 0.0], [12e3, 0.0], [6e3, 10e3]])  # m
WIDTH = 8e3  # m
THETA = np.array([[0.15, -0.20, 0.10], [-0.10, 0.15, 0.25]])  # m/s
WAYPOINTS = CENTERS[[1, 2, 0]]
SPEED, NEAR, NOISE = 1.0, 300.0, 10.0  # m/s, m, m
STEP, BETWEEN, DURATION = 10.0, 3 * 3600.0, 48 * 3600.0  # s
BEGIN = datetime(2026, 5, 1, tzinfo=UTC)
PLANE = Proj(proj="aeqd", ellps="WGS84", lat_0=ORIGIN[0], lon_0=ORIGIN[1])


def flow(x: np.ndarray) -> np.ndarray:
    """Return the current at a point, m/s."""
    square = np.sum((x - CENTERS) ** 2, axis=1)
    return THETA @ np.exp(-square / (2 * WIDTH**2))


def course_of(x: np.ndarray, velocity: np.ndarray) -> float:
    """Return the true course of a velocity in the plane at a point, degrees."""
    longitude, latitude = PLANE(*x, inverse=True)
    factors = PLANE.get_factors(longitude, latitude)
    # the plane's axes at the point: east, and north at a right angle to it
    east = np.arctan2(factors.dy_dlam, factors.dx_dlam)
    angle = np.arctan2(velocity[1], velocity[0]) - east
    return float(90.0 - np.degrees(angle)) % 360.0


def rows() -> list[str]:
    """Return the lines of the log below its header."""
    noise = np.random.default_rng(20)
    lines = []
    x, t, target, fixed = np.zeros(2), 0.0, 0, -np.inf
    while t <= DURATION:
        place, turned = "", False
        if t - fixed >= BETWEEN:
            estimate = x + noise.normal(0, NOISE, 2)
            longitude, latitude = PLANE(*estimate, inverse=True)
            place, fixed, turned = f"{latitude:.6f},{longitude:.6f}", t, True
        if np.hypot(*(WAYPOINTS[target] - estimate)) < NEAR:
            target, turned = (target + 1) % len(WAYPOINTS), True
        if turned:
            ahead = WAYPOINTS[target] - estimate
            velocity = SPEED * ahead / np.hypot(*ahead)
            time = (BEGIN + timedelta(seconds=t)).strftime("%Y-%m-%dT%H:%M:%SZ")
            course = course_of(x, velocity)
            lines.append(f"{time},{place or ','},{course:.2f},{SPEED:.1f}")
        middle = x + STEP / 2 * (flow(x) + velocity)
        x = x + STEP * (flow(middle) + velocity)
        estimate, t = estimate + STEP * velocity, t + STEP
    return lines


if __name__ == "__main__":
    print(
        "# Made by tools/make_auv_mission.py, not recorded: an AUV in a current of three Gaussians"
    )
    print("time,latitude,longitude,course,speed", *rows(), sep="\n")
