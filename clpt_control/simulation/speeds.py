"""How much of a run the vehicle was at its speed limit, and when the flow was faster than it.

    at the limit      |v_c| > v_max: not all that Eq. (7) commands is flown
    faster            |F_R| > v_max at the vehicle: it cannot hold its place, whatever it does

Each sample counts until the next one.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..diagrams.wiring import Wiring
from ..scenario.tables import Units

if TYPE_CHECKING:
    import xarray


class SpeedWatch:
    """Counts time at the limit and in a faster flow, samples given in order, in parts."""

    def __init__(self, max_speed: float):
        self.max_speed = max_speed
        self.start: float | None = None
        self.held = self.faster = self.longest = 0.0  # times
        self.first: float | None = None  # when the flow was first faster
        self._since: float | None = None  # when the stretch that goes on began
        self._last: tuple[float, bool, bool] | None = None

    def add(self, times: np.ndarray, commanded: np.ndarray, flow: np.ndarray) -> None:
        """Take samples that follow those before: (n,), commanded velocity and flow (n, 2)."""
        held, faster = (np.hypot(*one.T) > self.max_speed for one in (commanded, flow))
        if self.start is None:
            self.start = float(times[0])
        if self.first is None and faster.any():
            self.first = float(times[np.argmax(faster)])
        if self._last is not None:
            before = zip(self._last, (times, held, faster), strict=True)
            times, held, faster = (np.concatenate([[one], more]) for one, more in before)
        self._last = float(times[-1]), bool(held[-1]), bool(faster[-1])
        spans, held, faster = np.diff(times), held[:-1], faster[:-1]
        self.held += float(spans[held].sum())
        self.faster += float(spans[faster].sum())
        edges = np.flatnonzero(np.diff(np.concatenate([[False], faster, [False]])))
        for begin, end in edges.reshape(-1, 2).tolist():
            began = times[begin] if begin or self._since is None else self._since
            self.longest = max(self.longest, float(times[end] - began))
            if end == len(faster):
                self._since = began
        if len(faster) and not faster[-1]:
            self._since = None

    def figures(self) -> dict[str, Any]:
        """Return the figures, ready for JSON; times in units.time, shares of the time watched."""
        whole = 0.0 if self._last is None or self.start is None else self._last[0] - self.start
        faster = None
        if self.first is not None:
            share = self.faster / whole if whole else 1.0
            faster = {"first": self.first, "longest": self.longest, "share": share}
        share = self.held / whole if whole else float(self._last is not None and self._last[1])
        return {"max_speed": self.max_speed, "share_at_limit": share, "faster_flow": faster}


def faster_flow(figures: dict[str, Any], units: Units) -> str:
    """Return a sentence where the flow was faster than the vehicle, or nothing."""
    found, time = figures["faster_flow"], units.time
    if found is None:
        return ""
    return (
        f"the flow was faster than the vehicle ({figures['max_speed']:g} {units.length}/{time}), "
        f"which cannot hold its place there: first at t = {found['first']:g} {time}, "
        f"{100 * found['share']:.3g} % of the time, at most {found['longest']:.3g} {time} long"
    )


def limit_of(wiring: Wiring, given: Sequence[Any]) -> float | None:
    """Return the vehicle's largest speed, if it has one; `given` are the blocks' parameters."""
    nodes = zip(wiring.nodes, given, strict=True)
    return next((p.max_speed for node, p in nodes if node.name == "speed_limit"), None)


def speeds_of(run: "xarray.Dataset", max_speed: float) -> dict[str, Any]:
    """Return the figures of a run at its own samples."""
    watch = SpeedWatch(max_speed)
    watch.add(run.time.values, run.commanded_velocity.values, run.true_flow.values)
    return watch.figures()


def note_speeds(run: "xarray.Dataset", figures: dict[str, Any], units: Units) -> None:
    """Put the share at the limit and, where there is one, the sentence into a run's attributes."""
    run.attrs["share_at_speed_limit"] = figures["share_at_limit"]
    sentence = faster_flow(figures, units)
    if sentence:
        run.attrs["message"] = f"{run.attrs['message']}; {sentence}"
