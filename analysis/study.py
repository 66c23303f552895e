"""What studies share: figures in the house style, their files, how far they are, places at sea."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pyproj
from matplotlib.figure import Figure
from rich.console import Console
from rich.progress import Progress

HOUSE = "clpt_control.data.house"
with plt.style.context(HOUSE):
    COLOURS = plt.rcParams["axes.prop_cycle"].by_key()["color"]
BLUE, RED, GREEN, ORANGE, *_ = COLOURS
GREY = "#666666"
EARTH = pyproj.Geod(ellps="WGS84")


def new_figure(
    width: float = 6.4, height: float = 4.2, **subplots: Any
) -> tuple[Figure, Any]:
    """Return a figure (inches) and its axes."""
    with plt.style.context(HOUSE):
        figure = Figure(figsize=(width, height))
        return figure, figure.subplots(**subplots)


def make_folder(path: str | Path) -> Path:
    """Make a folder where there is none."""
    Path(path).mkdir(parents=True, exist_ok=True)
    return Path(path)


def leave(out: str | Path, name: str, text: str, figure: Figure) -> None:
    """Leave a study's table, NAME.md, and its figure, NAME.png, in a folder."""
    folder = make_folder(out)
    (folder / f"{name}.md").write_text(text, "utf-8")
    figure.savefig(folder / f"{name}.png", dpi=150)


@contextmanager
def progress_bar(what: str, total: float) -> Iterator[Callable[[float], None]]:
    """Show how far a study is, on standard error."""
    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=total)
        yield lambda done: bar.update(task, completed=done)


def displacement(
    lat1: float, lon1: float, lat2: float, lon2: float
) -> tuple[float, float]:
    """Return the way east and north (m) from one place to another (degrees)."""
    azimuth, _, length = EARTH.inv(lon1, lat1, lon2, lat2)
    return length * np.sin(np.radians(azimuth)), length * np.cos(np.radians(azimuth))


def place_from(
    lat: float, lon: float, east: float, north: float
) -> tuple[float, float]:
    """Return the place (degrees) at the end of a way (m) from a place."""
    azimuth = np.degrees(np.arctan2(east, north))
    lon2, lat2, _ = EARTH.fwd(lon, lat, azimuth, np.hypot(east, north))
    return lat2, lon2
