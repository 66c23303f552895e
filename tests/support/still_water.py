"""A vehicle in calm water between held waypoints, whose track is known in closed form."""

import numpy as np
from scipy.linalg import expm

import clpt_control as clpt

PAPER = clpt.paper_scenario()
KD, GammaD = np.array([0.5, 2.0]), np.array([1.5, -1.0])
POINTS = [[1.0, 2.0], [-3.0, 0.5], [0.0, -1.0]]
DWELL = 0.7
CALM = PAPER.with_values(
    {
        "flow.parameters": [[0.0] * 3] * 2,
        "vehicle.feedback": KD,
        "vehicle.feedforward": GammaD,
        "vehicle.position": [4.0, -2.0],
        "reference": {"kind": "waypoints", "points": POINTS, "dwell": DWELL},
        "run.duration": 5.0,
        "run.output_step": 0.1,
    }
)


def exact_positions(times, lag=0.0):
    """x' = v, v = GammaD zc - KD x or lag v' + v = that, zc held: an exponential a waypoint."""
    found = np.zeros((len(times), 2))
    for i, (k, g) in enumerate(zip(KD, GammaD, strict=True)):
        M = np.array([[-k, g], [0, 0]])
        if lag:
            M = np.array([[0, 1, 0], [-k / lag, -1 / lag, g / lag], [0, 0, 0]])
        for row, t in enumerate(times):
            state, start, j = np.eye(len(M))[0] * CALM.vehicle.position[i], 0.0, 0
            while start < t:
                end = min(t, DWELL * (j + 1))
                state[-1] = POINTS[j % 3][i]
                state = expm(M * (end - start)) @ state
                start, j = end, j + 1
            found[row, i] = state[0]
    return found
