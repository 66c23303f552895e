"""Arguments of a diagram's run in other forms: by name, as a response, with jumps of the inputs.

Inputs and initial states may be mappings by label or port, inputs a `control.TimeResponseData`.
Two samples at one time are a jump of the inputs, as in tables of Modelica.
"""

from collections.abc import Mapping
from typing import Any

import control
import numpy as np

from ..base.arguments import numbers
from ..base.errors import ArgumentError, SimulationError
from ..base.progress import warn
from ..engine.diagram.named_values import check_rows, columns_of
from ..engine.solver.schedule import (
    Inputs,
    checked_state,
    checked_times,
    read_inputs,
    stacked,
)


def inputs_count(diagram: Any, inputs: Any, times: np.ndarray) -> int:
    """Return the number of a diagram's inputs; an open number is that of the inputs given."""
    if diagram.ninputs is not None:
        return diagram.ninputs
    if isinstance(inputs, Inputs):
        return len(inputs.samples[1])
    shape = np.shape(stacked(inputs, times))
    return shape[0] if shape and shape != times.shape else 1


def states_count(diagram: Any, state: Any) -> int:
    """Return the number of a diagram's states; an open number is that of the states given."""
    if diagram.nstates is not None:
        return diagram.nstates
    if not isinstance(state, list | tuple):
        state = [0.0 if state is None else state]
    return sum(map(np.size, state))


def with_jumps(diagram: Any, timepts: Any, inputs: Any) -> tuple[Any, Any]:
    """Return times without repetition, checked, and inputs that jump at repeated times."""
    try:
        return checked_times("timepts", timepts), inputs
    except SimulationError:
        times = np.atleast_1d(numbers("timepts", timepts))
        if times.ndim != 1 or not np.all(np.diff(times) >= 0):
            raise
    if inputs is not None:
        inputs = read_inputs(inputs, times, inputs_count(diagram, inputs, times))
    return checked_times("timepts", np.unique(times)), inputs


def stacked_state(name: str, state: Any, count: int) -> np.ndarray:
    """Return `count` states in the forms of python-control; None is zero.

    A list, ``[x0, 0]``, is a sequence of numbers and arrays; a last zero is repeated.
    """
    if state is None:
        return np.zeros(count)
    if isinstance(state, list | tuple) and not all(map(np.isscalar, state)):
        state = np.concatenate([numbers(name, value).ravel() for value in state])
    else:
        state = numbers(name, state)
        if state.shape == (count,):
            return state.copy()
        state = state.ravel() if state.ndim else state
    if 0 < np.size(state) < count and np.ndim(state) == 1:
        if state[-1] != 0:
            warn(f"{name} is too short: filled with zeros")
        state = np.pad(state, (0, count - len(state)))
    return checked_state(name, state, (count,))


# --- by name -------------------------------------------------------------------------------------


def inputs_by_name(diagram: Any, inputs: Any, timepts: Any) -> Any:
    """Return inputs given by name or as a response as rows; others are as they are."""
    if isinstance(inputs, control.TimeResponseData):
        return _inputs_of_response(diagram, inputs, timepts)
    if not isinstance(inputs, Mapping):
        return inputs
    rows: list[Any] = [0.0] * len(diagram.input_labels)
    for name, value in inputs.items():
        columns = columns_of(diagram, "input", diagram.input_labels, name)
        values = numbers(f"inputs['{name}']", value)
        if len(columns) == 1 and values.ndim == 2:
            values = values.ravel()
        if len(columns) == 1 or values.ndim == 0:
            values = np.array([values] * len(columns))
        check_rows("inputs", name, values, len(columns))
        count = np.size(getattr(timepts, "time", timepts))
        if values.ndim > 1 and values.shape[1:] not in ((1,), (count,)):
            raise ArgumentError(
                f"inputs['{name}']: has {values.shape[-1]} values; there are {count} times"
            )
        for column, row in zip(columns, values, strict=True):
            rows[column] = row if row.ndim else float(row)
    return rows


# --- responses -----------------------------------------------------------------------------------


def _inputs_of_response(diagram: Any, response: Any, timepts: Any) -> Inputs:
    """Return the signals of a response that have the names of a diagram's inputs."""
    times = np.asarray(response.time, dtype=float)
    rows: dict[str, Any] = {}
    for labels, values in (
        (response.input_labels, response.u),
        (response.output_labels, response.y),
    ):
        if values is not None and labels is not None:
            rows |= zip(labels, _one_trace(values), strict=True)
    missing = [label for label in diagram.input_labels if label not in rows]
    if missing:
        raise SimulationError(
            f"inputs: the response has no signal '{missing[0]}', but {', '.join(rows)}. "
            f"Give inputs by name, {{'{missing[0]}': response.outputs}}"
        )
    span = numbers("timepts", timepts).ravel()
    margin = 1e-9 * max(1.0, abs(times[-1]))
    if len(span) and (span[0] < times[0] - margin or span[-1] > times[-1] + margin):
        raise SimulationError(
            f"inputs: the response is from {times[0]:.9g} to {times[-1]:.9g}. "
            "Give timepts within these times"
        )
    values = [rows[label] for label in diagram.input_labels]
    return read_inputs(np.reshape(values, (-1, len(times))), times, len(values))


def _one_trace(values: Any) -> np.ndarray:
    """Return signals (n, nt) of a response with one trace."""
    values = np.asarray(values, dtype=float)
    if values.ndim < 3:
        return values
    if values.shape[1] != 1:
        raise SimulationError(
            f"inputs: the response has {values.shape[1]} traces. Give one, as response[:, 0]"
        )
    return values[:, 0]
