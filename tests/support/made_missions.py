"""Made missions in a uniform current, by geodesics: fixes and course and speed of a vehicle."""

import itertools
from math import cos, radians, sin

import numpy as np
from geodesics import displacement, place_from

BEGIN = 1777593600.0  # 2026-05-01 00:00 UTC
LEG = 10800.0  # s
CURRENT = (0.15, -0.10)  # m/s
UNIFORM = """
[units]
length = "km"
time = "h"
[basis]
kernel = "gaussian"
centers = [[0, 0]]
widths = [1e5]
constituents = ["steady"]
[learning]
law = "fix-regression"
"""
HEAD = "time,latitude,longitude,course,speed"


def mission(
    legs=40,
    current=CURRENT,
    scatter=0.02,
    seed=0,
    begin=(BEGIN, 36.7, -122.1),
    fix=10.0,
):
    """Rows of time, latitude, longitude, course, speed: a turn of 75 degrees at each fix."""
    random, course = np.random.default_rng(seed), 17.0
    time, latitude, longitude = begin
    rows = []
    for number in range(legs + 1):
        read = place_from(latitude, longitude, *random.normal(0, fix, 2))
        rows.append((time + number * LEG, *read, course % 360, 1.0))
        way = np.array([sin(radians(course)), cos(radians(course))]) + current
        way = (way + random.normal(0, scatter, 2)) * LEG
        latitude, longitude = place_from(latitude, longitude, *way)
        course += 75.0
    return rows


def moved(row, east, north):
    """A row whose fix is off by a displacement, m."""
    return (row[0], *place_from(row[1], row[2], east, north), *row[3:])


def exact(rows, scatter=0.02, fix=10.0, prior=0.5):
    """Least squares with the noise that was made; neighbouring legs share a fix."""
    errors = []
    for before, after in itertools.pairwise(rows):
        ground = np.array(displacement(*before[1:3], *after[1:3]))
        angle = radians(before[3])
        errors.append(ground - before[4] * LEG * np.array([sin(angle), cos(angle)]))
    n = len(errors)
    C = np.diag(np.full(n, (scatter * LEG) ** 2 + 2 * fix**2))
    C -= fix**2 * (np.eye(n, k=1) + np.eye(n, k=-1))
    W = LEG * np.ones(n) @ np.linalg.inv(C)
    return W @ np.array(errors) / (W.sum() * LEG + prior**-2)


def table(path, rows, head=HEAD, mark=","):
    """Write a log."""
    cells = [[f"{row[0]:.3f}", *(f"{cell:.9g}" for cell in row[1:])] for row in rows]
    path.write_text("\n".join([head, *map(mark.join, cells)]) + "\n")
    return path
