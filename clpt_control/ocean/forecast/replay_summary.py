"""Results of a replay by name, and in sentences made of what `clpt replay --json` prints.

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
from ..estimation.fix_model import LEVEL, OTHERS, PERCENT
from ..gliders.dives import Skipped
from .aim import Aim, aim_sentence
from .flow_models import FlowModel
from .step import FLOW_MODEL, Step
from .surfacing import NextDive
from .table_rows import BASES, Report, Row, ellipse_words, place, velocity, when, wide

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


def learned_words(replay: Any) -> str:
    """Return what was learned, of the flow part by part, as a sentence."""
    if not replay.steps:
        return "nothing"
    step = replay.steps[-1]
    words = [f"{velocity(*map(float, step.current))} over the last dive"]
    for component in replay.model.flow[1:]:
        # all tides come or go together
        p = step.parts.get(component if component in OTHERS else "tides")
        words.append(
            f"{component}{strength(component, step.parameters)}"
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
    off = step.speed - 1
    error = step.speed_error
    means = f": your flight model is too {'slow' if off > 0 else 'fast'}"
    return f"speed {step.speed:.2f} +- {error:.2f}{means if abs(off) > FAR * error else ''}"


def compass_words(step: Step) -> str:
    """Return the error of the compass, and what it means where it is far from 0."""
    off = step.compass
    error = step.compass_error
    means = f": it goes to the {'right' if off > 0 else 'left'} of its heading"
    return f"compass {off:+z.1f} +- {error:.1f} degrees{means if abs(off) > FAR * error else ''}"


def clpe_rms(replay: Any, after: int = 3) -> dict[str, float | None]:
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
    rms = {}
    for name in models:
        sizes = np.array([clpe[name] for clpe in errors], float)
        finite = sizes[~np.isnan(sizes)]
        rms[name] = float(np.sqrt(np.mean(finite**2))) if finite.size else None
    return rms


@public
def summary(
    self: Any,
    skipped: Sequence[Skipped] = (),
    next_dive: NextDive | None = None,
    aims: Sequence[Aim] = (),
) -> Row:
    """Summarize a replay, as `clpt replay --json` prints it.

    Parameters
    ----------
    skipped : sequence of Skipped, optional
        Dives that were not fed, as `read_dives` returns them.
    next_dive : NextDive, optional
        By default as the replay expects it.
    aims : sequence of Aim, optional
        As `Replay.aims` returns them.

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
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> found = replay.summary()
    >>> found["used"], found["held"], sorted(found["parts"])[:3]
    (14, ['compass'], ['compass', 'eddies', 'inertial'])
    """
    steps = self.steps
    if steps and next_dive is None:
        next_dive = self.next_dive()
    differences = [*filter(isfinite, (step.dive.dac_difference for step in steps))]
    judged = [step.headline_held for step in steps if step.headline_held]
    last = steps[-1] if steps else None
    factor = last if self.model.learn_speed else None
    model = self.flow_model
    modelled = {} if model is None else {"flow_model": _of_flow_model(self, model)}
    return {
        "vehicle": (last.dive.vehicle if last else "") or "glider",
        "kind": last.dive.kind if last else None,
        "estimator": "gaussian-process",
        "flow": list(self.model.flow),
        "learn_speed": self.model.learn_speed,
        "dives": len(steps) + len(skipped),
        "used": len(steps),
        "clpe_rms": clpe_rms(self, 1),
        "clpe_rms_all": clpe_rms(self, 0),
        "clpe_rms_after_3": clpe_rms(self, 3),
        **modelled,
        "dac_identity_median": float(np.median(differences)) if differences else None,
        "level": LEVEL,
        "forecast": {
            "judged": len(judged),
            "inside": sum(inside for inside, _ in judged),
            "on_time": sum(on_time for _, on_time in judged),
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
        "said": learned_words(self),
        "held": list(last.not_learned) if last else [],
        "notes": [
            {"dive": step.dive.number, "note": note}
            for step in steps
            for note in step.dive.notes
        ],
        "skipped": [{"dive": s.dive, "why": s.why} for s in skipped],
        "each_dive": [dict(step.row) for step in steps],
        "next_dive": next_dive and next_dive.as_dict(),
        "aim": [leg.as_dict() for leg in aims],
    }


def _of_flow_model(replay: Any, model: FlowModel) -> Row:
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


# --- sentences ------------------------------------------------------------------------------------


def next_surfacing(ahead: Row) -> str:
    """Return the sentence on `NextDive.as_dict`."""
    remarks = "".join(
        f"; {remark}" for remark in (wide(ahead), uncovered(ahead)) if remark
    )
    return (
        f"next surfacing {when(ahead)}, "
        f"after {ahead['duration'] / 3600:.2f} h and {ahead['dr_east']:+z.0f} m "
        f"east, {ahead['dr_north']:+z.0f} m north through the water ({BASES[ahead['basis']]}): "
        f"{place(ahead['latitude'], ahead['longitude'])}, {ellipse_words(ahead)}{remarks}"
    )


def uncovered(ahead: Row) -> str:
    """Return why the flow model does not cover the next dive, empty if it does."""
    why = ahead["why_uncovered"]
    return f"the flow model does not cover the next dive: {why}" if why else ""


def record_sentence(forecast: Row) -> str:
    """Return how many surfacings were as forecast.

    >>> record_sentence({"judged": 13, "inside": 12, "on_time": 13}).replace(PERCENT, "P %")
    'forecast, made before the dive: 12 of 13 inside their P % ellipse, 13 within their P % time'
    """
    count = forecast["judged"]
    if not count:
        return "no forecast has been checked yet: ellipse and time are those of any vehicle"
    inside = f"{forecast['inside']} of {count} inside their {PERCENT} ellipse"
    on_time = f"{forecast['on_time']} within their {PERCENT} time"
    return f"forecast, made before the dive: {inside}, {on_time}"


def coming(report: Report) -> list[str]:
    """Return what comes of what `--json` prints: the next surfacing and aims."""
    sentences = [next_surfacing(report["next_dive"])] if report["next_dive"] else []
    return [*sentences, *map(aim_sentence, report["aim"])]


def beyond_cards(report: Report) -> list[str]:
    """Return sentences on what no card has: later aims, and a flow model without the next dive."""
    why = uncovered(report["next_dive"])
    return [*([why] if why else []), *map(aim_sentence, report["aim"][1:])]


def remarks(summary: Report) -> list[str]:
    """Return lines on what was learned, noted and skipped, of what `--json` prints."""
    lines = []
    if "flow_model" in summary and summary["each_dive"]:
        model = summary["flow_model"]
        lines.append(
            f"flow model {model['source']} ({model['about']}) covers {model['covered']} of "
            f"{summary['used']} dives"
        )
        lines += by_reason(model["uncovered"], "why", "no flow model for ")
    if (summary["dac_identity_median"] or 0.0) > 1e-9:  # else computed from it
        lines.append(
            "position error / duration differs from the file's depth-averaged current by "
            f"{1000 * summary['dac_identity_median']:.2g} mm/s (median)"
        )
    if summary["each_dive"]:
        lines.append(record_sentence(summary["forecast"]))
        lines.append(
            "hindsight, with the dead reckoning and duration of each dive: "
            "{inside} of {judged} inside".format(**summary["hindsight"])
        )
        if summary["parts"]:
            chances = ", ".join(
                f"{name} {p:.2f}" for name, p in summary["parts"].items()
            )
            lines.append(f"probability that a part is present: {chances}")
        lines.append(f"learned: {summary['said']}")
    if summary["held"]:
        lines.append(f"not yet known from these dives: {', '.join(summary['held'])}")
    lines += by_reason(summary["notes"], "note")
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        lines.append(f"skipped {name}: {entry['why']}")
    return lines


def by_reason(entries: list[Row], key: str, before: str = "") -> list[str]:
    """Return a line for each reason, with the dives that share it.

    >>> by_reason([{"dive": 3, "note": "odd"}, {"dive": 5, "note": "odd"}], "note")
    ['dives 3, 5: odd']
    >>> by_reason([{"dive": 7, "why": "outside"}], "why", "no flow model for ")
    ['no flow model for dive 7: outside']
    """
    reasons: dict[str, list[str]] = {}
    for entry in entries:
        reasons.setdefault(entry[key], []).append(str(entry["dive"]))
    lines = []
    for why, dives in reasons.items():
        named = f"dive{'s'[: len(dives) > 1]} {', '.join(dives)}"
        if len(dives) > 6:
            named = f"{len(dives)} dives from {dives[0]} to {dives[-1]}"
        lines.append(f"{before}{named}: {why}")
    return lines
