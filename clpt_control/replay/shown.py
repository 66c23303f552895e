"""A replay in a line, and as a notebook shows it: its last dives."""

from typing import Any

from ..html.fragment import facts, fragment
from ..html.text import paragraphs

SHOWN = 10  # dives


def replay_line(replay: Any) -> str:
    """Return what a replay is, in a line."""
    return f"<Replay of {_said(replay)}>"


def replay_html(replay: Any) -> str:
    """Return the last dives of a replay as a table, the last one first."""
    rows = []
    for step in replay.steps[: -SHOWN - 1 : -1]:
        east, north = step.current
        clpe = [step.clpe[name] for name in replay.models]
        misses = ["" if size is None else f"{size:.0f}" for size in clpe]
        factor = [f"{step.speed:.2f}"] if replay.model.learn_speed else []
        rows.append((step.dive.number, *misses, f"{east:.2f}, {north:.2f}", *factor))
    head = ["dive", *(f"CLPE (m), {name.replace('_', ' ')}" for name in replay.models)]
    head += ["current east, north (m/s)"]
    head += ["factor on speed"] if replay.model.learn_speed else []
    last = [f"The last {SHOWN} of {len(replay.steps)} dives."] if replay.steps[SHOWN:] else []
    pieces = facts(rows, head) if rows else "", paragraphs(last)
    return fragment("Replay", f"of {_said(replay)}", *pieces)


def _said(replay: Any) -> str:
    if not replay.steps:
        return f"no dive yet, {replay.estimator}"
    first, last = replay.steps[0].dive, replay.steps[-1].dive
    count = f"{len(replay.steps)} dives, {first.number} to {last.number}"
    return f"{last.vehicle or 'a glider'}: {count}, {replay.estimator}"
