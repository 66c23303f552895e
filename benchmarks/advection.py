"""Passive particles in a gridded current: the same grid, method and step for all.

Run by its own name it is the child process of one engine:
`python -m benchmarks.advection ENGINE PARTICLES` prints one JSON object.

The current turns and breathes on a square of 100 km, hourly for a week; values
are rounded to 32 bits, as Parcels keeps them.
"""

import ctypes
import json
import sys
import time
from ctypes import POINTER, byref, c_double, c_int64

import numpy as np

from .build import library
from .measure import peak_memory

STEP, STEPS = 300.0, 2000  # seconds; a week
SIDE, POINTS, HOURS = 1e5, 101, 169


def current() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return time (s), axis (m) of both directions, u and v (m/s), shape (time, x2, x1)."""
    seconds, axis = 3600.0 * np.arange(HOURS), np.linspace(0.0, SIDE, POINTS)
    t, x2, x1 = np.meshgrid(seconds, axis, axis, indexing="ij")
    breath = 1 + 0.4 * np.cos(2 * np.pi * t / 44712.0)
    u = -0.3 * np.sin(np.pi * x1 / SIDE) * np.cos(np.pi * x2 / SIDE) * breath
    v = 0.3 * np.cos(np.pi * x1 / SIDE) * np.sin(np.pi * x2 / SIDE) * breath
    return seconds, axis, *(f.astype(np.float32).astype(float) for f in (u, v))


def starts(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the particles' first positions, metres."""
    draw = np.random.default_rng(3)
    return draw.uniform(0.1 * SIDE, 0.9 * SIDE, count), draw.uniform(
        0.1 * SIDE, 0.9 * SIDE, count
    )


class _Grid(ctypes.Structure):
    _fields_ = (
        ("shape", c_int64 * 3),
        ("start", c_double * 3),
        ("scale", c_double * 3),
        ("u", POINTER(c_double)),
        ("v", POINTER(c_double)),
    )


def run_c(count: int) -> tuple[np.ndarray, float]:
    """Move the particles in C; return final positions (2, count) and seconds."""
    function = ctypes.CDLL(str(library("advect"))).advect_particles
    function.restype = c_double
    function.argtypes = (
        POINTER(_Grid),
        c_int64,
        c_int64,
        c_double,
        POINTER(c_double),
        POINTER(c_double),
    )
    seconds, axis, u, v = current()
    pointers = [f.ctypes.data_as(POINTER(c_double)) for f in (u, v)]
    steps = [1 / (a[1] - a[0]) for a in (seconds, axis, axis)]
    grid = _Grid((HOURS, POINTS, POINTS), (0, 0, 0), tuple(steps), *pointers)
    ends = np.array(starts(count))
    x1, x2 = (row.ctypes.data_as(POINTER(c_double)) for row in ends)
    spent = function(byref(grid), count, STEPS, STEP, x1, x2)
    return ends, spent


def run_parcels(count: int) -> tuple[np.ndarray, float]:
    """Move the particles with Parcels 3, JIT; the second run is timed, compiled."""
    import warnings
    from datetime import timedelta

    warnings.simplefilter("ignore")
    import parcels

    seconds, axis, u, v = current()
    fields = parcels.FieldSet.from_data(
        {"U": u.astype(np.float32), "V": v.astype(np.float32)},
        {"lon": axis, "lat": axis, "time": seconds},
        mesh="flat",
    )
    spent = ends = None
    for _ in range(2):
        x1, x2 = starts(count)
        particles = parcels.ParticleSet(
            fields, parcels.JITParticle, lon=x1, lat=x2, lonlatdepth_dtype=np.float64
        )
        begin = time.perf_counter()
        particles.execute(
            parcels.AdvectionRK4,
            runtime=timedelta(seconds=STEP * STEPS),
            dt=timedelta(seconds=STEP),
            verbose_progress=False,
        )
        spent = time.perf_counter() - begin
        # positions of the last step stand under these names until the next one begins
        left = particles.particledata.data
        ends = np.array([left["lon_nextloop"], left["lat_nextloop"]])
    return ends, spent


def run_native(count: int) -> tuple[np.ndarray, float]:
    """Move the particles with the native engine; see `benchmarks.drifter`."""
    from .drifter import advect

    return advect(*current(), *starts(count), STEP, STEPS)


PARTICLE_ENGINES = {"c": run_c, "native": run_native, "parcels": run_parcels}


def main(engine: str, particles: str) -> None:
    """Run one engine and print its figures."""
    count = int(particles)
    run = PARTICLE_ENGINES[engine]
    if engine == "c":
        run(1)
    ends, spent = run(count)
    figures = {
        "engine": engine,
        "particles": count,
        "seconds": spent,
        "rate": count * STEPS / spent,
        "peak_mb": peak_memory(),
        "ends": ends[:, :8].tolist(),
    }
    print(json.dumps(figures))


if __name__ == "__main__":
    main(*sys.argv[1:])
