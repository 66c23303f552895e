"""What a replay has learned, said as a pilot reads it.

    0.21 m/s to 184 over the last dive; M2 0.03 m/s (odds 1:9); speed 1.48 +- 0.11: ...

A tide is as large as the longer half axis of its ellipse, the greatest singular value of
[[cos_east, sin_east], [cos_north, sin_north]].  Odds p : 1 - p are of a part's presence; all
tides come or go together.  A speed or a compass more than `FAR` standard errors from what it
should be is said in words.
"""

from math import hypot
from typing import Any

import numpy as np

from .replay import Replay
from .step import Step
from .wording import velocity

FAR = 3.0  # standard errors
SURE = 99  # odds beyond which more digits say nothing


def odds(p: float) -> str:
    """Return a probability as odds of whole numbers.

    >>> odds(0.1), odds(0.75), odds(0.5), odds(0.0), odds(1.0)
    ('1:9', '3:1', '1:1', 'below 1:99', 'above 99:1')
    """
    small = min(p, 1 - p)
    ratio = round((1 - small) / small) if small > 0 else SURE + 1
    if ratio > SURE:
        return f"below 1:{SURE}" if p < 0.5 else f"above {SURE}:1"
    return f"1:{ratio}" if p < 0.5 else f"{ratio}:1"


def strengths(replay: Replay) -> dict[str, float]:
    """Return how strong each optional part of the flow is now: m/s, the factor of a model."""
    if not replay.steps:
        return {}
    known = replay.known()
    found: dict[str, float] = {}
    for part in replay.model.flow[1:]:
        if part == "model":
            found[part] = known[part]
        elif part == "inertial":
            found[part] = hypot(known["inertial_east"], known["inertial_north"])
        elif part != "gaussians":
            waves = [
                [known[f"{part}_{wave}_{axis}"] for wave in ("cos", "sin")]
                for axis in ("east", "north")
            ]
            found[part] = float(np.linalg.norm(np.array(waves), 2))
    return found


def learned(replay: Replay) -> dict[str, Any]:
    """Return what was learned, by name, for JSON, with the sentence that says it."""
    if not replay.steps:
        return {"sentence": "nothing", "strengths": {}, "odds": {}}
    step = replay.steps[-1]
    sizes = strengths(replay)
    chances = {part: step.parts.get(_of(part)) for part in replay.model.flow[1:]}
    words = [f"{velocity(*map(float, step.current))} over the last dive"]
    for part, p in chances.items():
        size = f" {round(sizes[part], 2) + 0.0:.2f}" if part in sizes else ""
        unit = " m/s" if size and part != "model" else ""
        words.append(f"{part}{size}{unit}" + ("" if p is None else f" (odds {odds(p)})"))
    if replay.model.learn_speed:
        words += [speed_said(step), compass_said(step)]
    return {
        "sentence": "; ".join(words),
        "strengths": sizes,
        "odds": {part: None if p is None else odds(p) for part, p in chances.items()},
    }


def speed_said(step: Step) -> str:
    """Return the factor on speed, and what it means where it is far from 1."""
    said = f"speed {step.speed:.2f} +- {step.speed_error:.2f}"
    if abs(step.speed - 1) <= FAR * step.speed_error:
        return said
    slow = "slow" if step.speed > 1 else "fast"
    return f"{said}: your flight model is too {slow}"


def compass_said(step: Step) -> str:
    """Return the error of the compass, and what it means where it is far from 0."""
    said = f"compass {step.compass:+.1f} +- {step.compass_error:.1f} degrees"
    if abs(step.compass) <= FAR * step.compass_error:
        return said
    side = "right" if step.compass > 0 else "left"
    return f"{said}: it goes to the {side} of its heading"


def _of(part: str) -> str:
    """Return the name of the part whose presence is asked; all tides are one."""
    return part if part in ("inertial", "gaussians", "model") else "tides"
