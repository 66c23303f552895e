"""What a replay comes to: root mean squares, what was learned, what was left out.

    rms = sqrt(mean |x - z|^2)

over used dives.  The first used dive has no dive before it: its forecast is the
dead reckoning, and it stands in `clpe_rms_all` only.  A given flow model is
judged on the dives that it covers.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..arguments import public
from ..estimation.dive import miss
from ..gliders.dives import Skipped
from .flow_models import NOTE, why_uncovered
from .learned import learned
from .replay import Replay
from .rows import rows
from .step import FLOW_MODEL


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
    own = [
        float(np.hypot(*(miss(d) / d.duration - (d.dac_east, d.dac_north))))
        for d in (step.dive for step in steps)
        if d.dac_east is not None and d.dac_north is not None
    ]
    last = steps[-1] if steps else None
    factor = last is not None and replay.model.learn_speed
    given = {} if replay.flow_model is None else {"flow_model": _of_flow_model(replay)}
    return {
        "vehicle": (last.dive.vehicle if last else "") or "glider",
        "dives": len(steps) + len(skipped),
        "used": len(steps),
        "clpe_rms": clpe_rms(replay, 1),
        "clpe_rms_all": clpe_rms(replay, 0),
        "clpe_rms_after_3": clpe_rms(replay, 3),
        **given,
        "dac_identity_median": float(np.median(own)) if own else None,
        "inside_90": float(np.mean([step.inside for step in steps])) if steps else None,
        "speed_factor": {
            "value": last.speed if last and factor else None,
            "standard_error": last.speed_error if last and factor else None,
        },
        "parts": dict(last.parts) if last else {},
        "said": learned(replay),
        "learned": list(last.learned) if last else [],
        "held": list(last.held) if last else [],
        "standard_error_left": dict(last.left) if last else {},
        "anomalies": [step.anomaly.as_dict() for step in steps if step.anomaly],
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
    """Return what was given, how many dives it covers, and why not the others."""
    bare = [step.dive for step in replay.steps if step.clpe[FLOW_MODEL] is None]
    return {
        "source": replay.flow_model.source if replay.flow_model else None,
        "about": replay.flow_model.about if replay.flow_model else None,
        "clpe_rms": clpe_rms(replay, 1, covered=True),
        "covered": len(replay.steps) - len(bare),
        "uncovered": [{"dive": dive.number, "why": why_uncovered(dive)} for dive in bare],
    }
