"""Scenarios of points of the unit cube: start, track, flow, disturbance, gains, settings."""

import numpy as np

import clpt_control as clpt
from clpt_control.paper.blocks.disturbance import KINDS

NUMBERS = 120  # of a point; more than a scenario uses
UNIFORM = 1e8  # width of a function that is constant on every track
NEAR_0 = 1e-3  # a start at 0 is a non-smooth point of some laws
SAMPLES = 400
RESOLVED = 0.02  # longest time between samples


class CubeNumbers:
    """Iterator over the numbers of a point of the unit cube, scaled to ranges."""

    def __init__(self, point):
        self.numbers = iter(point)

    def uniform(self, low, high, *shape):
        """Return numbers between two."""
        shares = [next(self.numbers) for _ in range(int(np.prod(shape)))]
        return low + (high - low) * np.reshape(shares, shape)

    def log_uniform(self, low, high, *shape):
        """Return positive numbers between two, uniform on a logarithmic scale."""
        return np.exp(self.uniform(np.log(low), np.log(high), *shape))

    def choice(self, *options):
        """Return one of several options."""
        return options[int(next(self.numbers) * len(options))]


def drawn(law, point):
    """Return the scenario of a point, with a law of the table."""
    row, draw = clpt.laws()[law], CubeNumbers(point)
    # Step 1: vehicle, track, basis and flow; the order of the numbers is fixed
    N, count = draw.choice(1, 2, 3), draw.choice(1, 2, 3, 4, 5, 6)
    KD, GammaD = draw.log_uniform(0.3, 3, 2), draw.uniform(0, 4, 2)
    dwell, duration = draw.log_uniform(1, 20), draw.log_uniform(10, 300)
    waypoints = draw.uniform(-4, 4, 6, 2)[:count]
    if draw.choice(True, False):  # one round, then the last waypoint
        rest = np.tile(waypoints[-1], (int(duration / dwell), 1))
        waypoints = np.vstack([waypoints, rest])
    widths = draw.log_uniform(1, 10, 3) * draw.choice(1, 1, 1, 2 * UNIFORM)
    periods = [draw.choice(np.inf, draw.log_uniform(5, 50)) for _ in range(3)]
    theta, start, alpha_M = draw.uniform(-1.5, 1.5, 3, 2, 3)[..., :N]
    positions = draw.uniform(-3, 3, 2, 2)
    kind = draw.choice(None, None, None, None, *KINDS)
    amplitude = draw.log_uniform(1e-3, 1, 2)
    period = draw.log_uniform(1, 50)
    values = {
        "basis.centers": draw.uniform(-5, 5, 3, 2)[:N],
        "basis.widths": widths[:N],
        "basis.periods": np.array(periods[:N]),
        "basis.phases": None,
        "flow.parameters": theta,
        "model.parameters": alpha_M * draw.choice(0, 1),
        "vehicle.feedback": KD,
        "vehicle.feedforward": GammaD,
        "vehicle.position": positions[0],
        "reference.kind": "waypoints",
        "reference.points": waypoints,
        "reference.dwell": dwell,
        "run.duration": duration,
        "run.output_step": min(RESOLVED, duration / SAMPLES),
    }
    if kind is not None:
        values["flow.disturbance.kind"] = kind
        values["flow.disturbance.amplitude"] = amplitude
        if KINDS[kind].keys.get("period"):
            values["flow.disturbance.period"] = period
    # Step 2: the learner
    learning = {"law": law, "position": positions[draw.choice(0, 1)]}
    gains = draw.log_uniform(0.05, 20), *draw.log_uniform(0.02, 5, 2)
    adapts = draw.choice(True, False)
    start_gains = draw.uniform(0, 3, 2, 2) * draw.choice(NEAR_0, 1)
    noise = draw.choice(0, 0, 0, 0.02)
    if row.at_fixes:
        values["localization"] = {"interval": dwell / 3, "noise": noise}
    else:
        feedback, feedforward = start_gains if adapts else (KD, GammaD)
        learning |= {"feedback": feedback, "feedforward": feedforward}
        learning["adapt_gains"] = adapts
        names = ("parameters", "feedback", "feedforward")
        uses = zip(names, gains, (row.alpha_by_gain, adapts, adapts), strict=True)
        learning["gains"] = {name: gain for name, gain, used in uses if used} or None
        if noise:
            values["localization"] = {"noise": noise, "noise_period": 1.0}
    if row.given_estimate:
        learning["theta_estimate"] = start
    elif not row.alpha_is_constant:
        learning["parameters"] = start * draw.choice(NEAR_0, 1)
    scenario = clpt.paper_scenario().with_values({**values, "learning": learning})
    # Step 3: some of the law's settings
    settings = {
        key: _setting(setting, scenario, key, draw)
        for key, setting in row.settings.items()
        if setting.allowed != "row" and draw.choice(True, False)
    }
    return scenario.with_values({f"learning.{row.table}": settings} if settings else {})


def _setting(setting, scenario, key, draw):
    """Return a share of 1, or 0.1 to 10 times the default of a law's setting."""
    if setting.allowed in ("below 1", "at most 1"):
        return float(draw.uniform(0.02, 0.98))
    default = float(setting.of(scenario.known_to_law, key))
    return float(draw.log_uniform(0.1, 10)) * default
