"""Study of positions that are no fixes: false questions of measured ones, misses of computed ones.

    python -m benchmarks.positions --missions 2000 --seed 1    # measured positions
    python -m benchmarks.positions --computed 6 --seed 1       # computed ones, of each kind

Measured positions have noise of 1 to 50 m on each axis, white or smoothed by the receiver, wild
fixes, gaps, 4 to 7 decimals, rows each 1 s to 10 min; vehicles that cruise, drift, keep a station
or are moored, in tides, eddies and scatter.  A mission is wrong if a row is left out, or if the
positions are a question.

Computed positions are those of a mission with 16 fixes each 3 h, in a current of (0.15, -0.10) m/s.
They are right if they are a question, or if the mean drift between the rows that stay is off by
less than 0.025 m/s, by as many legs as there are, or two more or less.
"""

import argparse
from collections import Counter
from itertools import pairwise

import numpy as np
from scipy.interpolate import (
    Akima1DInterpolator,
    CubicSpline,
    PchipInterpolator,
    interp1d,
)
from scipy.signal import lfilter

from clpt_control.ocean.gliders.unmeasured import question, unmeasured

A, E2 = 6378137.0, 0.00669437999014  # WGS84
CURRENT = 0.15 - 0.10j  # m/s, of computed positions
VEHICLES = (
    *("lawn", "random", "straight", "circle", "drifter", "moored", "moored log"),
    *("station", "relocates", "slow", "line", "still"),
)


def to_degrees(track, start):
    """Return places (n, 2) of a track by steps along parallel and meridian, east + i north in m."""
    north = np.empty(len(track))
    north[0] = start[0]
    steps = np.diff(track)
    for k, step in enumerate(steps):  # radii at the latitude of the step
        w = 1.0 - E2 * np.sin(np.radians(north[k])) ** 2
        north[k + 1] = north[k] + np.degrees(step.imag * w**1.5 / (A * (1.0 - E2)))
    middle = np.radians((north[1:] + north[:-1]) / 2)
    radius = A / np.sqrt(1.0 - E2 * np.sin(middle) ** 2) * np.cos(middle)
    east = start[1] + np.append(0.0, np.cumsum(np.degrees(steps.real / radius)))
    return np.column_stack([north, east])


def moved(places, offsets):
    """Return places moved by small offsets, m."""
    w = 1.0 - E2 * np.sin(np.radians(places[:, 0])) ** 2
    north = np.degrees(offsets.imag * w**1.5 / (A * (1.0 - E2)))
    east = np.degrees(offsets.real * w**0.5 / (A * np.cos(np.radians(places[:, 0]))))
    return places + np.column_stack([north, east])


# --- measured ---------------------------------------------------------------------------------


def noise_of(random, time, size):
    """White noise, or of a receiver that smooths, on each axis."""
    n, span = len(time), np.median(np.diff(time))
    white = random.normal(0, size, (n, 2)) @ [1, 1j]
    if span >= 60 and random.random() < 0.6:
        return white
    lasts = random.choice([20.0, 60.0, 300.0, 900.0])
    keep = np.exp(-span / lasts)
    slow = lfilter([np.sqrt(1 - keep**2)], [1, -keep], white[::-1])
    return slow + 0.1 * white * (random.random() < 0.5)


def flow_of(random, time):
    """Current along the track: steady, tides, eddies, scatter that lasts."""
    flow = random.choice([0.0, 0.02, 0.2]) * random.normal(size=2) @ [1, 1j]
    flow = np.full(len(time), flow)
    for period in (12.42 * 3600, 23.93 * 3600, 16 * 3600):
        if random.random() < 0.4:
            phase = 2 * np.pi * (time / period + random.random())
            size = random.uniform(0, 0.3)
            flow = flow + size * (
                np.cos(phase) + 1j * random.uniform(-1, 1) * np.sin(phase)
            )
    if random.random() < 0.6:
        keep = np.exp(-np.median(np.diff(time)) / random.choice([1800.0, 3 * 3600.0]))
        made = random.normal(0, 0.02, (len(time), 2)) @ [1, 1j]
        flow = flow + lfilter([np.sqrt(1 - keep**2)], [1, -keep], made)
    return flow


def water_of(random, time, flow):
    """Velocity through the water and its kind."""
    n, leg = len(time), random.choice([900.0, 3600.0, 10800.0])
    number = (time // leg).astype(int)
    kind = random.choice(VEHICLES)
    speed = random.choice([0.3, 1.0, 1.5])
    courses = {
        "lawn": np.array([0, 1, 2, 1])[number % 4] * np.pi / 2,
        "random": random.uniform(0, 2 * np.pi, number[-1] + 1)[number],
        "circle": time / random.uniform(200, 3000),
    }
    course = courses.get(kind, np.full(n, random.uniform(0, 6.28)))
    course = course + np.radians(random.choice([0, 2, 8])) * random.normal(size=n)
    water = speed * np.exp(1j * course)
    if kind in ("drifter", "moored"):
        water = 0.0 * water
    elif kind in ("moored log", "station"):
        water = -flow
    elif kind == "relocates":
        water = -flow + water * (number % 8 == 7)
    elif kind == "slow":
        water = 0.03 * water
    elif kind == "line":  # over ground, by a pilot that crabs
        water = speed * np.exp(1j * courses["lawn"]) - flow
    return kind, water


def measured(random):
    """Return time, positions, steps and a name of a mission of measured positions."""
    span = random.choice([1.0, 10.0, 60.0, 300.0, 600.0])
    n = int(random.integers(40, {1.0: 4000, 10.0: 1500, 60.0: 900}.get(span, 300)))
    time = 1.7e9 + span * np.arange(n)
    if random.random() < 0.3:
        time = time + np.round(random.uniform(0, 0.4 * span, n))
    flow = flow_of(random, time - time[0])
    kind, water = water_of(random, time - time[0], flow)
    ground = 0.0 * flow if kind in ("moored", "moored log") else flow + water
    if kind == "still":
        ground = water
    spans = np.diff(time)
    track = np.append(0, np.cumsum(ground[:-1] * spans))
    steps = water[:-1] * spans
    if random.random() < 0.5 and kind not in ("drifter", "moored"):  # as a log has them
        course = np.round(np.degrees(np.angle(water)), int(random.integers(0, 2)))
        speed = np.round(np.abs(water), int(random.integers(1, 4)))
        steps = (speed * np.exp(1j * np.radians(course)))[:-1] * spans
    size = np.exp(random.uniform(0, np.log(50)))
    off = noise_of(random, time, size)
    if random.random() < 0.3:  # wild, some for a while
        for row in np.flatnonzero(random.random(n) < 0.01):
            wild = random.uniform(50, 2000) * np.exp(1j * random.uniform(0, 6.28))
            off[row : row + random.choice([1, 1, 3, 10])] += wild
    start = random.uniform(-70, 70), random.uniform(-180, 180)
    places = moved(to_degrees(track, start), off)
    digits = int(random.integers(4, 8))
    keep = random.random(n) < random.choice([1.0, 1.0, 0.8])
    keep[0] = True
    rows = np.flatnonzero(keep)
    steps = np.add.reduceat(np.append(steps, 0.0), rows)[:-1]
    if random.random() < 0.05:
        steps = steps * np.nan
    name = f"{kind}, rows {span:g} s, noise {size:.3g} m, {digits} decimals, {len(rows)} rows"
    return time[rows], np.round(places[rows], digits), steps, name


# --- computed ---------------------------------------------------------------------------------


def mission(random, span):
    """Return time, steps through the water, places of fixes and their rows."""
    per_leg = round(10800 / span)
    n = 16 * per_leg + 1
    course = np.repeat(random.uniform(0, 2 * np.pi, 16), per_leg)
    course = np.round(np.degrees(course + np.radians(2) * random.normal(size=n - 1)), 1)
    speed = random.choice([0.5, 1.0, 1.5])
    steps = speed * span * np.exp(1j * np.radians(90 - course))
    scatter = np.repeat(random.normal(0, 0.02, (16, 2)) @ [1, 1j], per_leg)
    track = np.append(0, np.cumsum(steps + (CURRENT + scatter) * span))
    start = random.uniform(-60, 60), random.uniform(-180, 180)
    places = to_degrees(track, start)
    at = np.arange(0, n, per_leg)
    offsets = random.choice([3.0, 10.0]) * random.normal(size=(17, 2)) @ [1, 1j]
    return 1.7e9 + span * np.arange(n), steps, moved(places[at], offsets), at


def reckoned(
    time, steps, fixes, at, current=0.0, scale=1.0, sphere=False, learns=False
):
    """Own way since the last fix and a current, and a jump to each fix."""
    places = np.empty((len(time), 2))
    for k, (a, b) in enumerate(zip(at, [*at[1:], len(time)], strict=True)):
        track = np.append(
            0, np.cumsum(scale * steps[a : b - 1] + current * np.diff(time[a:b]))
        )
        if sphere:
            north = np.degrees(track.imag / 6371e3)
            lat = fixes[k, 0] + north
            middle = np.radians((lat[1:] + lat[:-1]) / 2)
            east = np.degrees(np.diff(track.real) / 6371e3 / np.cos(middle))
            east = np.append(0, np.cumsum(east))
            places[a:b] = np.column_stack([lat, fixes[k, 1] + east])
        else:
            places[a:b] = to_degrees(track, fixes[k])
        if learns and b < len(time):
            end = to_degrees(np.append(0, np.cumsum(steps[a:b])), fixes[k])[-1]
            off = fixes[k + 1] - end
            north, east = np.radians(off) * 6.37e6
            current = (east * np.cos(np.radians(end[0])) + 1j * north) / (
                time[b] - time[a]
            )
    return places


def nudged(time, steps, fixes, at, share=lambda s: s):
    """Own way since the last fix, moved by a share of the miss."""
    places = np.empty((len(time), 2))
    places[-1] = fixes[-1]
    for k, (a, b) in enumerate(pairwise(at)):
        way = to_degrees(np.append(0, np.cumsum(steps[a:b])), fixes[k])
        part = share((time[a : b + 1] - time[a]) / (time[b] - time[a]))[:, None]
        places[a:b] = (way + part * (fixes[k + 1] - way[-1]))[:-1]
    return places


def filtered(time, steps, fixes, at, gain, current=0.0):
    """A filter that comes to each fix by a share of the gap in each row."""
    own = to_degrees(np.append(0, np.cumsum(steps + current * np.diff(time))), fixes[0])
    places, pending, number = own.copy(), np.zeros(2), 1
    off = np.zeros(2)
    for k in range(1, len(time)):
        off = off + gain * pending
        pending = (1 - gain) * pending
        places[k] = own[k] + off
        if number < len(at) and k == at[number]:
            pending = fixes[number] - places[k]
            number += 1
    return places


def through(make):
    """A curve through the fixes."""
    return lambda time, steps, fixes, at: make(time[at] - time[0], fixes)(
        time - time[0]
    )


def filled(which):
    """A fix of other rows: the last, the next or the nearest."""

    def places(time, steps, fixes, at):
        numbers = np.searchsorted(at, np.arange(len(time)), side="right") - 1
        after = np.minimum(numbers + (np.arange(len(time)) != at[numbers]), len(at) - 1)
        if which == "nearest":
            is_after = np.arange(len(time)) - at[numbers] > at[after] - np.arange(
                len(time)
            )
            return fixes[np.where(is_after, after, numbers)]
        return fixes[numbers if which == "last" else after]

    return places


def with_jitter(make, size):
    """Jitter of positions between fixes."""

    def places(time, steps, fixes, at):
        off = size * np.random.default_rng(1).normal(size=(len(time), 2)) @ [1, 1j]
        off[at] = 0.0
        return moved(make(time, steps, fixes, at), off)

    return places


def option(make, **options):
    """A kind with options."""
    return lambda *mission: make(*mission, **options)


def rounded_speed(time, steps, fixes, at):
    """The log has the speed to 0.01 m/s, the vehicle knew it to 0.001."""
    random = np.random.default_rng(2)
    return reckoned(
        time, steps * (1 + random.uniform(-5e-3, 5e-3, len(steps))), fixes, at
    )


KINDS = {
    "nudged": nudged,
    "nudged smoothly": option(nudged, share=lambda s: 3 * s**2 - 2 * s**3),
    "nudged by squares": option(nudged, share=lambda s: s**2),
    "last current": option(reckoned, learns=True),
    "assumed current": option(reckoned, current=0.10 - 0.05j),
    "assumed, true": option(reckoned, current=CURRENT),
    "filter 0.05": option(filtered, gain=0.05),
    "filter 0.1": option(filtered, gain=0.1),
    "filter 0.3": option(filtered, gain=0.3),
    "filter 0.6": option(filtered, gain=0.6),
    "filter 0.3, current": option(filtered, gain=0.3, current=0.10 - 0.05j),
    "spline": through(CubicSpline),
    "natural spline": through(lambda t, x: CubicSpline(t, x, bc_type="natural")),
    "pchip": through(PchipInterpolator),
    "akima": through(Akima1DInterpolator),
    "quadratic spline": through(lambda t, x: interp1d(t, x, "quadratic", axis=0)),
    "lines": through(lambda t, x: interp1d(t, x, axis=0)),
    "reckoned": reckoned,
    "sphere": option(reckoned, sphere=True),
    "sphere, current": option(reckoned, sphere=True, current=0.10 - 0.05j),
    "scale 1.003": option(reckoned, scale=1.003),
    "last fix": filled("last"),
    "next fix": filled("next"),
    "nearest fix": filled("nearest"),
    "held, jitter 1 m": with_jitter(filled("last"), 1.0),
    "reckoned, jitter 1 m": with_jitter(reckoned, 1.0),
    "speed rounded": rounded_speed,
}


def judged(time, positions, steps, name=""):
    """Return rows left out by kind, the question, and the rows that stay."""
    kinds = unmeasured(time, positions, steps)
    kept = np.flatnonzero(kinds == "")
    sums = np.add.reduceat(np.append(steps, 0.0), kept)[:-1]
    asked = question(time[kept], positions[kept], sums)
    return Counter(kinds[kinds != ""].tolist()), asked, kept, sums


def is_right(mission_of, places, digits):
    """Return whether computed positions are asked about, or their fixes found; and how."""
    time, steps, _, at = mission_of
    places = np.round(places, digits)
    counts, asked, kept, sums = judged(time, places, steps)
    if asked:
        return True, "asked"
    radians = np.radians(places[kept])
    north = np.diff(radians[:, 0]) * 6.371e6
    east = np.diff(radians[:, 1]) * 6.371e6 * np.cos(radians[1:, 0])
    flow = np.sum(east + 1j * north - sums) / (time[kept][-1] - time[kept][0])
    right = abs(flow - CURRENT) < 0.025 and abs(len(kept) - len(at)) <= 2
    return (
        right,
        f"{len(kept)} of {len(at)} fixes, off {abs(flow - CURRENT):.3f}, {dict(counts)}",
    )


def main():
    """Run what is chosen."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--missions", type=int, default=0)
    parser.add_argument("--computed", type=int, default=0, help="missions of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--verbose", action="store_true")
    chosen = parser.parse_args()
    asked = taken = 0
    for number in range(chosen.missions):
        time, positions, steps, name = measured(
            np.random.default_rng([chosen.seed, number])
        )
        counts, sentence, *_ = judged(time, positions, steps)
        asked += bool(sentence)
        taken += bool(counts)
        if sentence or counts:
            print(f"{number}: {name}: {dict(counts)} {sentence}")
    if chosen.missions:
        print(
            f"{chosen.missions} missions: {asked} questions, {taken} with rows left out"
        )
    right = Counter()
    for kind, make in KINDS.items() if chosen.computed else ():
        for digits in (7, 5):
            for number in range(chosen.computed):
                span = (60.0, 300.0, 600.0)[number % 3]
                of = mission(np.random.default_rng([chosen.seed, number]), span)
                good, how = is_right(of, make(*of), digits)
                right[kind, digits] += good
                right[digits] += good
                if not good or chosen.verbose:
                    print(f"  {kind}, {digits} decimals, rows {span:g} s: {how}")
        print(
            f"{kind:24} {right[kind, 7]:3} {right[kind, 5]:3} of {chosen.computed}",
            flush=True,
        )
    if chosen.computed:
        total = chosen.computed * len(KINDS)
        print(f"7 decimals: {right[7]} of {total}; 5 decimals: {right[5]} of {total}")


if __name__ == "__main__":
    main()
