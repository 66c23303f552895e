"""The results of a replay by name: a row for each dive, root mean squares, what was learned.

    rms = sqrt(mean |x - z|^2)

over used dives.  The first used dive has no dive before it: its forecast is the
dead reckoning, and it stands in `clpe_rms_all` only.  A flow model is
compared on the dives that it covers.  In rows lengths are in m, times ISO 8601 UTC, currents
in m/s, angles in degrees clockwise from north; what is not known is None.

What was learned is a sentence for a pilot:

    0.21 m/s to 184 over the last dive; M2 0.03 m/s (odds 1:9); speed 1.48 +- 0.11: ...

A tide is as large as the longer half axis of its ellipse, the greatest singular value of
[[cos_east, sin_east], [cos_north, sin_north]].  Odds p : 1 - p are of a part's presence; all
tides come or go together.  A speed or a compass more than `FAR` standard errors from what it
should be is put into words.
"""

from collections.abc import Mapping, Sequence
from math import hypot, isfinite
from typing import Any

import numpy as np

from ..arguments import public
from ..estimation.dive import dac_difference
from ..estimation.fix_model import OTHERS
from ..geodesy import place_from
from ..gliders.dives import Skipped
from ..units import known
from .carried_dives import NOTE, why_uncovered
from .habits import Way
from .places import direction, placed, utc, vector, velocity
from .replay import Replay
from .step import FLOW_MODEL, Step
from .surfacing import ELLIPSE, NextDive, ellipse

SPEED = ("speed_factor", "speed_factor_error", "compass", "compass_error")
FAR = 3.0  # standard errors
SURE = 99  # odds beyond which more digits say nothing


def rows(replay: Replay) -> list[dict[str, Any]]:
    """Return a row for each dive of a replay."""
    unknown = {} if replay.model.learn_speed else dict.fromkeys(SPEED)
    for step in replay.steps:
        if not step.row:
            row = _row(step, replay.models) | unknown
            step.row.update({key: known(value) for key, value in row.items()})
    return [dict(step.row) for step in replay.steps]


def _row(step: Step, models: tuple[str, ...]) -> dict[str, Any]:
    dive = step.dive
    start = dive.lat_gps2, dive.lon_gps2
    reckoned = place_from(*start, dive.dr_east, dive.dr_north)
    forecast = place_from(*start, dive.dr_east + step.forecast[0], dive.dr_north + step.forecast[1])
    east, north = map(float, step.current)
    return {
        "dive": dive.number,
        "start": utc(dive.t_gps2),
        "end": utc(dive.t_gpse),
        "start_time": dive.t_gps2,
        "end_time": dive.t_gpse,
        "duration": dive.duration,
        **placed("start_", *start),
        **placed("end_", dive.lat_gpse, dive.lon_gpse),
        **placed("reckoned_", *reckoned),
        **placed("forecast_", *forecast),
        **vector("dr_", dive.dr_east, dive.dr_north),
        **vector("forecast_", *step.forecast),
        **vector("forecast_variance_", *np.diag(step.covariance)),
        "forecast_covariance": float(step.covariance[0, 1]),
        "flow_model_east": dive.model_east,
        "flow_model_north": dive.model_north,
        "file_current_east": dive.dac_east,
        "file_current_north": dive.dac_north,
        "clpe": {name: step.clpe[name] for name in models},
        **dict(zip(ELLIPSE, ellipse(step.covariance), strict=True)),
        "inside_90": step.inside,
        **vector("current_", east, north),
        "current_east_error": float(step.current_error[0]),
        "current_north_error": float(step.current_error[1]),
        "current_speed": hypot(east, north),
        "current_direction": direction(east, north),
        "speed_factor": step.speed,
        "speed_factor_error": step.speed_error,
        "compass": step.compass,
        "compass_error": step.compass_error,
        "drift": None if step.drift is None else step.drift.as_dict(),
        "over_ground": Way(dive.gps_east, dive.gps_north, dive.duration).as_dict(),
        "headline": None if step.headline is None else _headline(step.headline, step.headline_held),
        "anomaly": None if step.anomaly is None else step.anomaly._asdict(),
        "probability": step.parts,
        "depth_max": dive.depth_max,
        "notes": list(dive.notes),
    }


def _headline(headline: NextDive, held: tuple[bool, bool] | None) -> dict[str, Any]:
    """Return the headline before a surfacing, and whether its place and time held."""
    found = headline.as_dict()
    keys = ("time", "time_90", "latitude", "longitude", *ELLIPSE, "basis")
    place, time = held or (None, None)
    return {**{key: found[key] for key in keys}, "place_held": place, "time_held": time}


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
    known = replay.known()
    found: dict[str, float] = {}
    for part in replay.model.flow[1:]:
        if part == "model":
            found[part] = known[part]
        elif part in ("inertial", "shear"):
            found[part] = hypot(known[f"{part}_east"], known[f"{part}_north"])
        elif part != "gaussians":
            waves = [
                [known[f"{part}_{wave}_{axis}"] for wave in ("cos", "sin")]
                for axis in ("east", "north")
            ]
            found[part] = float(np.linalg.norm(np.array(waves), 2))
    return found


def learned_report(replay: Replay) -> dict[str, Any]:
    """Return what was learned, by name, for JSON, with the sentence that says it."""
    if not replay.steps:
        return {"sentence": "nothing", "strengths": {}, "odds": {}}
    step = replay.steps[-1]
    sizes = strengths(replay)
    chances = {  # all tides come or go together
        part: step.parts.get(part if part in OTHERS else "tides") for part in replay.model.flow[1:]
    }
    words = [f"{velocity(*map(float, step.current))} over the last dive"]
    for part, p in chances.items():
        size = f" {sizes[part]:z.2f}" if part in sizes else ""
        unit = " m/s" if size and part != "model" else ""
        words.append(f"{part}{size}{unit}" + ("" if p is None else f" (odds {odds(p)})"))
    if replay.model.learn_speed:
        words += [speed_words(step), compass_words(step)]
    return {
        "sentence": "; ".join(words),
        "strengths": sizes,
        "odds": {part: None if p is None else odds(p) for part, p in chances.items()},
    }


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


@public
def clpe_rms(replay: Replay, after: int = 3, covered: bool = False) -> dict[str, float | None]:
    """Return the CLPE rms of each flow model, m.

    Parameters
    ----------
    replay : Replay
        With any number of dives.
    after : int, optional
        How many first dives are left out.
    covered : bool, optional
        Whether to leave out what the given flow model does not cover, too.

    Returns
    -------
    dict
        By name of the model; None where no dive is left.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.usable(clpt.gliders.sample_dives())[0])
    >>> {name: round(rms) for name, rms in clpe_rms(replay).items() if name != "adaptive"}
    {'no_flow': 1770, 'previous_dive': 1167}
    """
    rest = [
        step.clpe
        for step in replay.steps[after:]
        if not covered or step.clpe[FLOW_MODEL] is not None
    ]
    return rms_of(rest, replay.models)


def rms_of(
    each: Sequence[Mapping[str, float | None]], models: Sequence[str]
) -> dict[str, float | None]:
    """Return the rms of the known misses of each model, m; None where there is none."""
    found: dict[str, float | None] = {}
    for name in models:
        known = np.array([size for size in (clpe[name] for clpe in each) if size is not None])
        found[name] = float(np.sqrt(np.mean(known**2))) if len(known) else None
    return found


@public
def summary(replay: Replay, skipped: Sequence[Skipped] = ()) -> dict[str, Any]:
    """Summarize a replay, as `clpt replay --json` prints it.

    Parameters
    ----------
    replay : Replay
        With any number of dives.
    skipped : sequence of Skipped, optional
        Dives that were not fed, from `usable` and the readers.

    Returns
    -------
    dict
        Lengths in m; what does not exist is None. ``flow_model`` is there if
        one was given; ``parts`` has probabilities; ``each_dive`` a row for each.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> dives, skipped = clpt.gliders.usable(clpt.gliders.sample_dives())
    >>> found = summary(clpt.replay.replay_dives(dives), skipped)
    >>> found["used"], found["held"], sorted(found["parts"])[:3]
    (14, ['compass'], ['compass', 'eddies', 'inertial'])
    """
    steps = replay.steps
    each = (dac_difference(step.dive) for step in steps)
    differences = [one for one in each if isfinite(one)]
    headlines = [step.headline_held for step in steps if step.headline_held]
    last = steps[-1] if steps else None
    factor = last if replay.model.learn_speed else None
    modelled = {} if replay.flow_model is None else {"flow_model": _of_flow_model(replay)}
    return {
        "vehicle": (last.dive.vehicle if last else "") or "glider",
        "kind": last.dive.kind if last else None,
        "estimator": replay.estimator,
        "flow": list(replay.model.flow),
        "learn_speed": replay.model.learn_speed,
        "gaussian_width": replay.model.width,
        "dives": len(steps) + len(skipped),
        "used": len(steps),
        "clpe_rms": clpe_rms(replay, 1),
        "clpe_rms_all": clpe_rms(replay, 0),
        "clpe_rms_after_3": clpe_rms(replay, 3),
        **modelled,
        "dac_identity_median": float(np.median(differences)) if differences else None,
        "headlines": {
            "judged": len(headlines),
            "place_held": sum(place for place, _ in headlines),
            "time_held": sum(time for _, time in headlines),
        },
        "inside_90": float(np.mean([step.inside for step in steps])) if steps else None,
        "speed_factor": {
            "value": factor and factor.speed,
            "standard_error": factor and factor.speed_error,
        },
        "parts": dict(last.parts) if last else {},
        "said": learned_report(replay),
        "learned": list(last.learned) if last else [],
        "held": list(last.not_learned) if last else [],
        "standard_error_left": dict(last.left) if last else {},
        "anomalies": [step.anomaly._asdict() for step in steps if step.anomaly],
        "notes": [
            {"dive": step.dive.number, "note": note}
            for step in steps
            for note in step.dive.notes
            if not note.startswith(NOTE)
        ],
        "skipped": [{"dive": s.dive, "why": s.why} for s in skipped],
        "each_dive": rows(replay),
    }


def _of_flow_model(replay: Replay) -> dict[str, Any]:
    """Return what the flow model is, how many dives it covers, and why not the others."""
    bare = [step.dive for step in replay.steps if step.clpe[FLOW_MODEL] is None]
    return {
        "source": replay.flow_model.source if replay.flow_model else None,
        "about": replay.flow_model.about if replay.flow_model else None,
        "clpe_rms": clpe_rms(replay, 1, covered=True),
        "covered": len(replay.steps) - len(bare),
        "uncovered": [{"dive": dive.number, "why": why_uncovered(dive)} for dive in bare],
    }
