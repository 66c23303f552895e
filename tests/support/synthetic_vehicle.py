"""A made vehicle whose current, speed and fixes are known, and its dives as files."""

import math
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from geodesics import place_from
from scipy.integrate import trapezoid

import clpt_control as clpt
from clpt_control.app.cli.replay_report import Job
from clpt_control.gliders import Dive, make_dive, write_dive_table
from clpt_control.ocean.forecast.flow_models import FlowModel
from clpt_control.ocean.forecast.netcdf_export import dataset_of
from clpt_control.replay import replay_dives

STEADY = (0.1, -0.05)
M2 = 2 * math.pi / (12.4206012 * 3600)  # rad/s
EARTH = 7.292115e-5  # rad/s, of the rotation


class Made(FlowModel):
    """A flow given as a formula."""

    source, about = "made", "a formula"

    def __init__(self, flow):
        self.flow = flow

    def along(self, dive):
        return self.flow


def vehicle(
    seed,
    count=30,
    flow="steady",
    factor=1.0,
    fault=None,
    lost=0.15,
    walk=0.0,
    noise=0.0,
    hours=4.0,
    heading="any",
    fix=20.0,
    latitude=40.0,
):
    """A vehicle at 0.25 m/s; `fix` is the noise of a displacement, m per component."""
    rng = np.random.default_rng(seed)
    time, dives, current = 1.6e9, [], np.array(STEADY)
    phase, inertial = rng.uniform(0, 2 * math.pi), flow == "inertial"
    w = 2 * EARTH * math.sin(math.radians(latitude)) if inertial else M2
    for k in range(count):
        T = 3600 * hours * rng.uniform(0.8, 1.2)
        t = np.linspace(time + 600, time + 600 + T, 101)
        u = np.tile(current, (101, 1))
        if walk:
            steps = walk * math.sqrt(T / 100 / 21600) * rng.normal(size=(101, 2))
            u += np.cumsum(steps, axis=0)
        current = u[-1]
        if flow != "steady":
            turned = [
                np.cos(w * t + phase),
                (-1 if inertial else 0.5) * np.sin(w * t + phase),
            ]
            u = u + 0.15 * np.stack(turned, 1)
        angle = (
            rng.uniform(0, 2 * math.pi)
            if heading == "any"
            else 0.6 + 0.1 * rng.normal()
        )
        dr = 0.25 * T * np.array([math.cos(angle), math.sin(angle)])
        f = factor * (1 - lost if fault is not None and k >= fault else 1)
        gps = f * dr + trapezoid(u, t, axis=0) + fix * rng.normal(size=2)
        gps += noise * T * rng.normal(size=2)
        current = current + walk * math.sqrt(600 / 21600) * rng.normal(size=2)
        dives.append(Dive(k, t[0], latitude, 8.0, t[-1], latitude, 8.0, *gps, *dr))
        time = t[-1]
    return dives


def further(dive, east, north=0.0):
    """A dive that came up further to the east and north, m."""
    return replace(
        dive, gps_east=dive.gps_east + east, gps_north=dive.gps_north + north
    )


def turned(dive, response):
    """A dive that goes by a number, complex, times what it reckons."""
    more = (response - 1) * (dive.dr_east + 1j * dive.dr_north)
    return further(dive, more.real, more.imag)


def clpe_rms(replay, after=3, model="adaptive"):
    """Return the rms of the position errors after the first dives, m."""
    errors = [step.clpe[model] for step in replay.steps[after:]]
    return math.sqrt(np.mean(np.square(errors)))


def told(dives, *targets):
    """Return what `clpt replay --json` prints of dives, and of waypoints to aim at."""
    return Job(replay_dives(dives), targets=list(targets)).summary()


def page_and_sentence(found):
    """Return the page of `clpt report` on a replay, and its sentence on the next surfacing."""
    with TemporaryDirectory() as folder:
        path = Path(folder, "replay.html")
        (sentence,) = clpt.report(dataset_of(found), path)["sentences"]
        return path.read_text("utf-8"), sentence


def map_of(found):
    """Return the Axes of the map of a replay."""
    return dataset_of(found).clpt.plot("map")


def one_file_each(folder, dives):
    for dive in dives:
        write_dive_table([dive], folder / f"dive{dive.number}.csv")


def chained(ways, place=(40.0, 8.0), time=1.6e9, stay=600.0, drift=(0.0, 0.0), first=0):
    """Dives of (reckoned, gone: m; duration: s), each from where the surface left the vehicle."""
    dives = []
    for k, (reckoned, gone, T) in enumerate(ways, first):
        end = place_from(*place, *gone)
        dives.append(make_dive(k, (time, *place), (time + T, *end), tuple(reckoned)))
        time, place = time + T + stay, place_from(*end, *drift)
    return dives


def along(degrees, metres):
    """East and north of a way on a course, m."""
    return metres * np.array([np.sin(np.radians(degrees)), np.cos(np.radians(degrees))])


def fixes_of(count, latitude=40.0, longitude=8.0, seed=1):
    """Dives to the east in a current that changes, of about four hours; fixes good to 200 m."""
    rng, ways = np.random.default_rng(seed), []
    for k in range(count):
        T = 14400 * rng.uniform(0.8, 1.2)
        dr = along(math.degrees(1.2 + 0.8 * math.sin(k / 9)), 0.25 * T)
        current = np.array(
            [0.1 + 0.08 * math.sin(k / 7), -0.05 + 0.06 * math.cos(k / 5)]
        )
        ways.append((dr, dr + T * current + 200 * rng.normal(size=2), T))
    return chained(ways, (latitude, longitude), 1.7e9, drift=(30.0, 20.0), first=1)
