"""The picture of any diagram's run: each port over time."""

from typing import TYPE_CHECKING, Any

from ..arguments import public
from ..errors import DataError
from ..figures import COLOURS, STYLES, axes_for

if TYPE_CHECKING:
    import xarray

MOST = 16  # ports of a picture
STATES = "states"


@public
def response_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw each port of a diagram's run over time.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it for a diagram.
    ax : array of Axes, optional
        Where to draw, one for each port; by default a new figure of pyplot's.

    Returns
    -------
    Axes or ndarray of Axes, shape (n,)
        One for each of the n ports, in the order of the run's variables.

    Raises
    ------
    DataError
        If the dataset has no signal along time, or more than 16: choose some, ``run[["x", "e"]]``.
    ClptError
        If `ax` are fewer or more Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> loop = clpt.closed_loop(clpt.paper_scenario())
    >>> run = clpt.simulate(loop, [0.0, 1.0, 2.0])
    >>> x, e = clpt.simulation.response_plot(run[["position", "clpe"]])
    """
    signals = getattr(run, "data_vars", {}).items()
    ports = [str(n) for n, one in signals if "time" in one.dims and n != STATES]
    if not 0 < len(ports) <= MOST:
        raise DataError(
            f"the run has {len(ports)} signals along time; one picture shows 1 to {MOST}: choose "
            "some, as run[['x', 'e']]"
        )
    axes = axes_for(ax, 6.4, 1.2 + 1.3 * len(ports), nrows=len(ports), sharex=True)
    for one, port in zip([axes] if len(ports) == 1 else axes, ports, strict=True):
        values = run[port].values.reshape(run.sizes["time"], -1)
        for k, column in enumerate(values.T):
            line: Any = {"color": COLOURS[k % 6], "linestyle": STYLES[k % 6], "linewidth": 1.1}
            one.plot(run.time.values, column, label=f"{k + 1}", **line)
        one.set_ylabel(_named(port, run[port].attrs.get("units")))
        if 1 < values.shape[1] <= 6:
            one.legend(frameon=False, fontsize=8, ncols=6, loc="upper right")
    last = axes if len(ports) == 1 else axes[-1]
    last.set_xlabel(_named("time", run.time.attrs.get("units")))
    return axes


def _named(name: str, units: str | None) -> str:
    return f"{name} ({units})" if units else name
