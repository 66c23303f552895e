"""`dataset.clpt`: what clpt does with its own runs, ensembles and replays.

Their attributes tell which of them a dataset is.

A run is a wide table too, one column a signal, units in its header.  It is written as CSV, or for
MATLAB with a matrix for each port, whose columns are its signals.
"""

import re
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.arguments import public
from ...base.errors import ArgumentError, DataError, refuse_unused
from ...base.files import atomic_path, check_writable, write_file
from ...base.run_attributes import DIAGRAM, RunDiagram, beyond_scenario
from ...engine.diagram.wiring import columns_of
from ...paper.scenario.recorded_run import kind_of
from ...simulation.comparison import (
    ports_along,
    response_of,
    signals_of,
    signals_plot,
    with_unit,
)
from ...simulation.initial_states import state_at
from ...simulation.loops import closed_loop

if TYPE_CHECKING:
    import pandas
    import xarray

    from ...paper.scenario.experiment import Scenario
    from ...paper.scenario.team import Team


# kind of dataset -> name of a plot -> its function; "" is the plot that shows most
PLOTS: dict[str, dict[str, str]] = {
    "team": {"": "simulation.run_plots:team_plot"},
    "ensemble": {"": "ensemble.ensemble_plots:ensemble_plot"},
    "run": {
        "": "simulation.run_plots:run_plot",
        "track": "simulation.track_chart:track_plot",
        "map": "simulation.flow_map:flow_map_plot",
        "clpe": "simulation.run_plots:clpe_plot",
        "learning": "simulation.run_plots:learning_plot",
        "signals": "simulation.comparison:response_plot",
    },
    "fixes": {
        "": "app.pages.fixes_page:learned_flow_plot",
        "map": "simulation.flow_map:flow_map_plot",
    },
    "replay": {
        "": "ocean.forecast.plots:replay_plot",
        "map": "ocean.forecast.track_map:map_plot",
        "clpe": "ocean.forecast.plots:dive_clpe_plot",
        "current": "ocean.forecast.plots:current_plot",
    },
    "diagram": {"": "simulation.comparison:response_plot"},
    "tube": {"": "simulation.enclosures:tube_plot"},
}
LONGEST = 60  # letters of a name in MATLAB, of which 63 count


# --- as a table ----------------------------------------------------------------------------------


def signal_table(run: "xarray.Dataset") -> "pandas.DataFrame":
    """Return a run as a table, one column a signal, which is named with its unit.

    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 5}))
    >>> found = signal_table(run[["clpe"]])
    >>> [*found.columns], found.shape
    (['time (s)', 'clpe axis 1 (m)', 'clpe axis 2 (m)'], (6, 3))
    """
    from pandas import DataFrame

    ports = [run[name] for name in ports_along(run)]
    if not ports and "member" in run.dims:
        return _table_of_members(run)
    if "time" not in run.dims or not ports:
        raise DataError("the dataset has no signal along time, so it has no table")
    columns = [(with_unit("time", run.time), run.time.values)]
    for port in ports:
        signals = signals_of(port).items()
        columns += [(with_unit(name, port), values) for name, values in signals]
    names, values = zip(*columns, strict=True)
    return DataFrame(np.column_stack(values), columns=[*names])


def _table_of_members(data: "xarray.Dataset") -> "pandas.DataFrame":
    """Return varied parameters and summaries of an ensemble, one row a member."""
    from pandas import DataFrame

    columns = {"member": np.arange(data.sizes["member"])}
    for name in ("status", *data.coords, *data.data_vars):
        values = data[name]
        if "member" not in values.dims or name == "member":
            continue
        if "flag_meanings" in values.attrs:
            meanings = np.array(values.attrs["flag_meanings"].split())
            values = values.copy(data=meanings[values])
        for label, column in signals_of(values, "member").items():
            columns[with_unit(label, values)] = column
    return DataFrame(columns)


def write_mat(run: "xarray.Dataset", path: Path) -> None:
    """Write a file for MATLAB: ``time``, a matrix for each port, ``units`` and ``signals``.

    Names are those of the ports, where MATLAB allows them.
    """
    from scipy.io import savemat

    arrays: dict[str, Any] = {
        "title": str(run.attrs.get("title", "")),
        "units": {},
        "signals": {},
    }
    for port in ("time", *ports_along(run)):
        signals = signals_of(run[port]) if port != "time" else {"time": run.time.values}
        name = _valid(port, arrays)
        arrays[name] = np.column_stack([*signals.values()])
        arrays["units"][name] = str(run[port].attrs.get("units", ""))
        arrays["signals"][name] = np.array([*signals], dtype=object)
    with atomic_path(path) as temporary:
        savemat(temporary, arrays, appendmat=False, long_field_names=True)


def _valid(name: str, used_names: Any) -> str:
    """Return a name that MATLAB allows, and that is not taken.

    >>> _valid("K", []), _valid("2nd flow", []), _valid("e", ["e"])
    ('K', 'x_2nd_flow', 'e_')
    """
    word = re.sub(r"\W", "_", name, flags=re.ASCII)[:LONGEST]
    word = word if word[:1].isalpha() else f"x_{word}"
    while word in used_names:
        word += "_"
    return word


# --- what a dataset has ---------------------------------------------------------------------------


class ClptAccessor:
    """Accessor ``run.clpt`` of datasets that clpt made."""

    def __init__(self, data: "xarray.Dataset"):
        self._data = data

    @property
    def kind(self) -> str:
        """Kind of dataset: "run", "team", "diagram", "tube", "ensemble", "fixes", "replay"."""
        if kind := kind_of(self._data):
            return kind
        raise DataError(
            "the dataset is not a run, ensemble or replay of clpt. "
            "Read a run with clpt.load_run"
        )

    @property
    def scenario(self) -> "Scenario | Team":
        """The scenario that a run or an ensemble carries; the team of a team's run."""
        from ...paper.scenario.team import system_of_run

        return system_of_run(self._data)

    @public
    def plot(
        self, name: str | Sequence[str] = "", *, ax: Any = None, **options: Any
    ) -> Any:
        """Draw a run, team, diagram, tube, ensemble, estimate or replay.

        `name` chooses one plot: "track", "map", "clpe", "learning" or "signals" of a run, "map" of
        an estimate, "map", "clpe" or "current" of a replay; or ports, signals and states of a run,
        "pos" or ["pos", "vel"].  It is drawn on given axes or on a new figure; the Axes are
        returned.
        A run takes a `label` and a `color` too, as `clpt_control.compare` gives them.
        """
        plots, is_run = PLOTS[self.kind], self.kind in ("run", "diagram")
        if not isinstance(name, str) or name not in plots:
            names = [*filter(None, plots)]
            if is_run:
                options["plots"] = names
                return signals_plot(self._data, name, ax=ax, **options)
            advice = f"there is one plot of this {self.kind}. Leave the name out"
            if names:
                advice = f"must be {', '.join(names)}, for a {self.kind}"
            raise ArgumentError(f"plot '{name}': {advice}")
        if not is_run:
            refuse_unused(
                f"is for a run, not for a {self.kind}. Leave it out", **options
            )
        draw = resolve_name(f"clpt_control.{plots[name]}")
        return draw(self._data, ax=ax, **options)

    @public
    def state(self, t: float) -> np.ndarray:
        """Return the state of a run's diagram at one of its times, shape (nstates,).

        At a jump it is the state after it.  ``control.linearize(loop, state, inputs, t=t)`` and
        `simulate` take it.
        """
        return state_at(self._data, t)

    def linearize(
        self,
        t: float,
        input: str | None = None,
        output: str | None = None,
        minimal: bool = False,
    ) -> Any:
        """Linearize a run's diagram about where it is at a time, as `clpt_control.linearize`.

        `input` names a port that comes from outside then, such as "zc", `output` one that is
        looked at, such as "e".  Without them a scenario's run has no input, another diagram in
        memory, as it is now, its own inputs; every signal is an output.
        """
        from ...engine.diagram.linearization import linearize, minimal_of

        state = state_at(self._data, t)
        beyond = beyond_scenario(self._data.attrs)
        if self.kind != "run" or beyond:
            description = f"{self.kind} with {beyond[0]}" if beyond else self.kind
            linear = self._linear_in_memory(state, t, description)
        else:
            scenario = self.scenario
            loop = closed_loop(scenario)
            system = closed_loop(scenario, external=input or ())
            states = dict(zip(loop.state_labels, state, strict=True))
            outputs = loop.output(t, state, [])
            signals = dict(zip(loop.output_labels, outputs, strict=True))
            x = [states[label] for label in system.state_labels]
            u = [signals[label] for label in system.input_labels]
            linear = linearize(system, x, u, t)
        if input is not None:
            labels = linear.input_labels
            columns = columns_of(linear, "input", labels, input)
            linear.B, linear.D = linear.B[:, columns], linear.D[:, columns]
            linear.set_inputs([labels[k] for k in columns])
        if output is not None:
            labels = linear.output_labels
            rows = columns_of(linear, "output", labels, output)
            linear.C, linear.D = linear.C[rows], linear.D[rows]
            linear.set_outputs([labels[k] for k in rows])
        return minimal_of(linear) if minimal else linear

    def _linear_in_memory(self, state: Any, t: float, description: str) -> Any:
        """Return the linearization of the diagram that a run in memory has."""
        from ...engine.diagram.linearization import linearize

        noted = self._data.encoding.get(DIAGRAM, RunDiagram())
        response = self.response()
        at_time = {}
        if response.input_labels:
            k = int(np.abs(response.time - t).argmin())
            rows = response.u.reshape(-1, len(response.time))
            at_time = dict(zip(response.input_labels, rows[:, k], strict=True))
        labels = [] if noted.diagram is None else noted.diagram.input_labels
        if noted.diagram is None or not at_time.keys() >= {*labels}:
            raise DataError(
                f"the dataset of a {description} does not contain its diagram. Give the "
                "diagram, and the "
                "state of run.clpt.state(t), to clpt.linearize"
            )
        u = [at_time[label] for label in labels]
        return linearize(noted.diagram, state, u, t, noted.params)

    def response(self) -> Any:
        """Return a run as a `control.TimeResponseData`, for python-control's plots.

        It has the outputs, inputs and states of a diagram's run at its times.
        """
        return response_of(self._data)

    @public
    def table(self, path: str | PathLike[str] | None = None) -> "pandas.DataFrame":
        """Return a run as a table, one column a signal; an ensemble, one row a member.

        An ensemble with trajectories has the columns of a run. With a path the table is written,
        as .csv, or signals as .mat.
        """
        table = signal_table(self._data)
        if path is not None:
            path = Path(path)
            has_mat = bool(ports_along(self._data))
            check_writable(path, "a table", (".csv", ".mat") if has_mat else (".csv",))
            if path.suffix.lower() == ".mat":
                write_mat(self._data, path)
            else:
                write_file(path, table.to_csv(index=False, lineterminator="\n"))
        return table

    def __repr__(self) -> str:
        kind = kind_of(self._data)
        description = (
            f"{kind} {self._data.attrs.get('title', '')}".strip()
            if kind
            else "none of clpt's"
        )
        return f"<clpt of a dataset: {description}>"
