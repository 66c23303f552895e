"""A vehicle in calm water between held waypoints, whose track is known in closed form."""

import numpy as np

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


def exact_positions(times, x0=(4.0, -2.0)):
    """x' = -KD x + GammaD zc, zc held: an exponential in each interval."""
    out = []
    for t in times:
        x, start, k = np.array(x0), 0.0, 0
        while True:
            end = min(t, DWELL * (k + 1))
            rest = GammaD * POINTS[k % 3] / KD
            x = rest + (x - rest) * np.exp(-KD * (end - start))
            if end == t:
                break
            start, k = end, k + 1
        out.append(x)
    return np.array(out)
