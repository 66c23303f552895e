"""The results of a replay by name: root mean squares, what was learned, a row for each dive.

    rms = sqrt(mean |x - z|^2)

over used dives.  The first used dive has no dive before it: its forecast is the
dead reckoning, and it stands in `clpe_rms_all` only.  A flow model is
compared on the dives that it covers.

What was learned is a sentence for a pilot:

    0.21 m/s to 184 over the last dive; M2 0.03 m/s (odds 1:9); speed 1.48 +- 0.11: ...

A tide is as large as the longer half axis of its ellipse, the greatest singular value of
[[cos_east, sin_east], [cos_north, sin_north]].  Odds p : 1 - p are of a part's presence; all
tides come or go together.  A speed or a compass more than `FAR` standard errors from what it
should be is put into words.
"""

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any

import numpy as np

from ...base.arguments import public
from ..estimation.fix_model import LEVEL, OTHERS
from ..gliders.dives import Skipped, dac_difference
from .flow_models import FlowModel
from .replay import Replay
from .step import FLOW_MODEL, Step
from .table_rows import velocity

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


def learned_words(replay: Replay) -> str:
    """Return what was learned, of the flow part by part, as a sentence."""
    if not replay.steps:
        return "nothing"
    step, parameters = replay.steps[-1], replay.known()
    words = [f"{velocity(*map(float, step.current))} over the last dive"]
    for component in replay.model.flow[1:]:
        # all tides come or go together
        p = step.parts.get(component if component in OTHERS else "tides")
        words.append(
            f"{component}{strength(component, parameters)}"
            + ("" if p is None else f" (odds {odds(p)})")
        )
    if replay.model.learn_speed:
        words += [speed_words(step), compass_words(step)]
    return "; ".join(words)


def strength(component: str, parameters: Mapping[str, float]) -> str:
    """Return how strong an optional part of the flow is now: m/s, the factor of a model."""
    if component == "gaussians":
        return ""
    if component == "model":
        return f" {parameters[component]:z.2f}"
    waves = ("",) if component in OTHERS else ("_cos", "_sin")
    axes = [
        [parameters[f"{component}{wave}_{axis}"] for wave in waves]
        for axis in ("east", "north")
    ]
    return f" {np.linalg.norm(np.array(axes), 2):z.2f} m/s"


def speed_words(step: Step) -> str:
    """Return the factor on speed, and what it means where it is far from 1."""
    off, error = step.speed - 1, step.speed_error
    means = f": your flight model is too {'slow' if off > 0 else 'fast'}"
    return f"speed {step.speed:.2f} +- {error:.2f}{means if abs(off) > FAR * error else ''}"


def compass_words(step: Step) -> str:
    """Return the error of the compass, and what it means where it is far from 0."""
    off, error = step.compass, step.compass_error
    means = f": it goes to the {'right' if off > 0 else 'left'} of its heading"
    return f"compass {off:+z.1f} +- {error:.1f} degrees{means if abs(off) > FAR * error else ''}"


def clpe_rms(replay: Replay, after: int = 3) -> dict[str, float | None]:
    """Return the CLPE rms of each flow model after the first dives, m; None without a dive.

    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> {name: round(rms) for name, rms in clpe_rms(replay).items() if name != "adaptive"}
    {'no_flow': 1770, 'previous_dive': 1167}
    """
    return rms_of([step.clpe for step in replay.steps[after:]], replay.models)


def rms_of(
    errors: Sequence[Mapping[str, float | None]], models: Sequence[str]
) -> dict[str, float | None]:
    """Return the rms of the known misses of each model, m; None where there is none."""
    rms: dict[str, float | None] = {}
    for name in models:
        finite = np.array(
            [size for size in (clpe[name] for clpe in errors) if size is not None]
        )
        rms[name] = float(np.sqrt(np.mean(finite**2))) if len(finite) else None
    return rms


@public
def summary(replay: Replay, skipped: Sequence[Skipped] = ()) -> dict[str, Any]:
    """Summarize a replay, as `clpt replay --json` prints it.

    Parameters
    ----------
    replay : Replay
        With any number of dives.
    skipped : sequence of Skipped, optional
        Dives that were not fed, as `read_dives` returns them.

    Returns
    -------
    dict
        Lengths in m; what does not exist is None. ``flow_model`` is there if
        one was given; ``parts`` has probabilities; ``each_dive`` a row for each.
        ``forecast`` counts surfacings inside the ellipse and time that were
        forecast before the dive, of probability ``level``; ``hindsight`` those
        inside the ellipse that has the dead reckoning of the dive.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = summary(clpt.replay.replay_dives(clpt.gliders.sample_dives()))
    >>> found["used"], found["held"], sorted(found["parts"])[:3]
    (14, ['compass'], ['compass', 'eddies', 'inertial'])
    """
    steps = replay.steps
    differences_of_dives = (dac_difference(step.dive) for step in steps)
    differences = [
        difference for difference in differences_of_dives if isfinite(difference)
    ]
    held = [step.headline_held for step in steps if step.headline_held]
    last = steps[-1] if steps else None
    factor = last if replay.model.learn_speed else None
    model = replay.flow_model
    modelled = {} if model is None else {"flow_model": _of_flow_model(replay, model)}
    return {
        "vehicle": (last.dive.vehicle if last else "") or "glider",
        "kind": last.dive.kind if last else None,
        "estimator": replay.estimator,
        "flow": list(replay.model.flow),
        "learn_speed": replay.model.learn_speed,
        "dives": len(steps) + len(skipped),
        "used": len(steps),
        "clpe_rms": clpe_rms(replay, 1),
        "clpe_rms_all": clpe_rms(replay, 0),
        "clpe_rms_after_3": clpe_rms(replay, 3),
        **modelled,
        "dac_identity_median": float(np.median(differences)) if differences else None,
        "level": LEVEL,
        "forecast": {
            "judged": len(held),
            "inside": sum(inside for inside, _ in held),
            "on_time": sum(on_time for _, on_time in held),
        },
        "hindsight": {
            "judged": len(steps),
            "inside": sum(step.inside_hindsight for step in steps),
        },
        "speed_factor": {
            "value": factor and factor.speed,
            "standard_error": factor and factor.speed_error,
        },
        "parts": dict(last.parts) if last else {},
        "said": learned_words(replay),
        "held": list(last.not_learned) if last else [],
        "notes": [
            {"dive": step.dive.number, "note": note}
            for step in steps
            for note in step.dive.notes
        ],
        "skipped": [{"dive": s.dive, "why": s.why} for s in skipped],
        "each_dive": [dict(step.row) for step in steps],
    }


def _of_flow_model(replay: Replay, model: FlowModel) -> dict[str, Any]:
    """Return what the flow model is, how many dives it covers, and why not the others."""
    steps = replay.steps
    bare = [step.dive for step in steps if step.clpe[FLOW_MODEL] is None]
    covered = [step.clpe for step in steps[1:] if step.clpe[FLOW_MODEL] is not None]
    return {
        "source": model.source,
        "about": model.about,
        "clpe_rms": rms_of(covered, replay.models),
        "covered": len(steps) - len(bare),
        "uncovered": [{"dive": dive.number, "why": dive.uncovered} for dive in bare],
    }
