"""Axes of a chart of a local plane, labelled in degrees, with a bar of a length.

Ticks are at even degrees, converted at the middle of the chart: meridians and parallels are
drawn as straight lines.
"""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import Locator, MaxNLocator
from mpl_toolkits.axes_grid1.anchored_artists import AnchoredSizeBar

from ..geodesy import LocalPlane, east_of

BARS_PER_WIDTH = 5  # about
LABEL = 0.85  # inches of a longitude


class _Degrees(Locator):
    """Ticks of one axis of a chart at even degrees, at the middle of the other axis."""

    def __init__(self, ax: Axes, plane: LocalPlane, is_longitude: bool):
        self.ax, self.plane, self.is_longitude = ax, plane, is_longitude
        self.degrees_at: dict[float, float] = {}  # coordinate of a tick -> its degrees

    def _centre(self) -> tuple[float, float]:
        return float(np.mean(self.ax.get_xlim())), float(np.mean(self.ax.get_ylim()))

    def of_point(self, coordinate: float) -> float:
        """Return the longitude or latitude of a coordinate."""
        x1, x2 = self._centre()
        point = (coordinate, x2) if self.is_longitude else (x1, coordinate)
        return float(self.plane.to_earth(*point)[int(self.is_longitude)])

    def to_point(self, degrees: float) -> float:
        """Return the coordinate of a longitude or latitude."""
        lat, lon = map(float, self.plane.to_earth(*self._centre()))
        position = (lat, degrees) if self.is_longitude else (degrees, lon)
        return float(self.plane.to_plane(*position)[int(not self.is_longitude)])

    def __call__(self) -> list[float]:
        axis: Any = self.axis
        return self.tick_values(*axis.get_view_interval())

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        """Return the coordinates of even degrees between two coordinates."""
        edges = map(self.of_point, (vmin, vmax))
        labels = self.ax.bbox.width / self.ax.figure.dpi / LABEL
        bins = int(np.clip(labels, 2, 5)) if self.is_longitude else 5
        ticks = MaxNLocator(bins, steps=[1, 2, 5, 10]).tick_values(*edges)
        self.degrees_at = {self.to_point(degrees): float(degrees) for degrees in ticks}
        return [*self.degrees_at]

    def label(self, x: float, position: int) -> str:
        """Return the degrees of a tick with their letter."""
        angle = self.degrees_at.get(x, self.of_point(x))
        if self.is_longitude:
            angle = east_of(angle)
        angle = round(angle, 7)  # a centimetre
        letter = ("EW" if self.is_longitude else "NS")[int(angle < 0)]
        return f"{abs(angle):.10g}\N{DEGREE SIGN} {letter}"


def degree_axes(ax: Any, plane: LocalPlane, unit: str) -> None:
    """Label the axes of a chart in degrees, and draw a bar with its length."""
    for axis, is_longitude in ((ax.xaxis, True), (ax.yaxis, False)):
        degrees = _Degrees(ax, plane, is_longitude)
        axis.set_major_locator(degrees)
        axis.set_major_formatter(degrees.label)
    ax.set(xlabel="longitude ($x_1$, east)", ylabel="latitude ($x_2$, north)")
    scale_bar(ax, unit)


def scale_bar(ax: Any, unit: str, size: float = 1.0) -> None:
    """Draw a bar with its length; `size` is that of a unit of length along the axis."""
    length = float(f"{np.ptp(ax.get_xlim()) / size / BARS_PER_WIDTH:.0e}")
    text = f"{length:g} {unit}"
    bar = AnchoredSizeBar(ax.transData, length * size, text, "lower right", sep=3)
    bar.patch.set(edgecolor="none", alpha=0.8)
    ax.add_artist(bar)
