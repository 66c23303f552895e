"""A block: one set of equations, wired by python-control.

    dx/dt = update(t, x, u, p),    y = output(t, x, u, p)

and, right after the block's own breakpoints, x = jump(t, x, u, p) where it has a jump.
The functions fill their last argument, zero at first, and have no side effects.  They
are recorded when the block is made (`trace`), and refused there if they cannot be.  The
block adds what a diagram needs to know: the ports with
their labels, the typed parameters `p`, whether inputs reach the outputs at once
(`feedthrough`), when the block jumps (`breakpoints`), and whether it is a source
of time or tables that SymPy reads as an undefined function (`opaque`).
"""

from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import cached_property
from typing import Any

import control
import numpy as np

from ..arguments import public, shown
from ..errors import BlockError
from .declaration import (
    Equations,
    Guard,
    NoParameters,
    check_guard,
    check_names,
    checked_parameters,
    labels,
    states_as_outputs,
)
from .ieee import in_ieee
from .record import Record
from .rules import check_equations
from .shown import block_html, block_line
from .trace import trace
from .tracers import TooLong


@public
class Block(control.NonlinearIOSystem):
    """Equations with ports, which python-control can run.

    Parameters
    ----------
    name : str
        Name of the block in a diagram; parameters are ``"name.field"``.
    update : callable, optional
        ``update(t, x, u, p, dx)`` fills the time derivative of the states.
    output : callable, optional
        ``output(t, x, u, p, y)`` fills the outputs; without it y = x.
    inputs, outputs, states : mapping of str to int, optional
        Port name -> number of signals; `outputs` without `output` are the
        states, under their names.
    parameters : NamedTuple, optional
        Numbers and arrays; a field ``interval`` is kept by the integrator.
    feedthrough : bool, optional
        Whether outputs depend on inputs at once; by default they do unless
        the outputs are the states.
    opaque : bool, optional
        True for a source of time or tables: an undefined function to SymPy.
    breakpoints : callable, optional
        ``breakpoints(p, t0, t1)``: sorted times in (t0, t1] at which the block
        jumps. Interval k ends at breakpoint k + 1, counted from time 0.
    jump : callable, optional
        ``jump(t, x, u, p, new)`` fills all states right after a breakpoint, from
        the states x right before it and the inputs u that follow from states right
        before it; ``p.interval`` is the interval that begins. `clpt.simulate` runs
        it, python-control does not.
    guard : Guard, optional
        Where the block may be used.

    Attributes
    ----------
    update_function, output_function, jump_function : callable or None
        The equations (the name ``output`` belongs to python-control).
    parameters : NamedTuple
        The block's own parameters.

    Raises
    ------
    BlockError
        If the equations cannot be recorded, or ports and parameters do not fit.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks import vehicle
    >>> block = clpt.Block("vehicle", update=vehicle.kinematics,
    ...                    inputs={"flow_x": 2, "v_x": 2}, states={"x": 2})
    >>> block.dynamics(0, [0, 0], [1, 2, 0.5, 0.5])
    array([1.5, 2.5])
    """

    def __init__(
        self,
        name: str,
        *,
        update: Equations | None = None,
        output: Equations | None = None,
        inputs: Mapping[str, int] | None = None,
        outputs: Mapping[str, int] | None = None,
        states: Mapping[str, int] | None = None,
        parameters: Any = None,
        feedthrough: bool | None = None,
        opaque: bool = False,
        breakpoints: Callable[[Any, float, float], np.ndarray] | None = None,
        jump: Equations | None = None,
        guard: Guard | None = None,
    ):
        check_names(name, inputs, outputs, states)
        if output is None and not states:
            raise BlockError(f"{name}: a block without states needs `output`")
        if (update is None) != (not states):
            raise BlockError(f"{name}: `update` and `states` belong together; give both or none")
        if output is None and outputs is not None and dict(outputs) != dict(states or {}):
            raise BlockError(f"{name}: without `output` the outputs are the states; leave them out")
        if jump is not None and (breakpoints is None or not states):
            raise BlockError(
                f"{name}: a jump sets states at the block's own breakpoints; give `breakpoints` "
                "and `states` with it, or leave `jump` out"
            )
        self.update_function = update
        self.jump_function = jump
        self.output_function: Equations = states_as_outputs if output is None else output
        check_guard(name, guard)
        distance = None if guard is None else guard.distance
        roles = ("update", update), ("output", output), ("jump", jump), ("guard", distance)
        for role, function in roles:
            if function is not None:
                check_equations(function, f"{name}.{role}")
        self.input_ports = dict(inputs or {})
        self.output_ports = dict(states or {}) if output is None else dict(outputs or {})
        self.state_ports = dict(states or {})
        self.feedthrough = (output is not None) if feedthrough is None else feedthrough
        self.opaque = opaque
        self.breakpoints_function = breakpoints
        self.guard = guard
        self.name = name
        self.parameters = NoParameters() if parameters is None else parameters
        if breakpoints is not None and "interval" not in self.parameters._fields:
            raise BlockError(
                f"{name}: a block with breakpoints needs a parameter `interval = -1.0`"
            )
        record = self._equations["output"][1]
        if not self.feedthrough and record is not None and record.reads_inputs():
            raise BlockError(
                f"{name}: outputs change with inputs at once: declare feedthrough=True"
            )
        super().__init__(
            self._updfcn,
            self._outfcn,
            inputs=labels(self.input_ports),
            outputs=labels(self.output_ports),
            states=labels(self.state_ports) or 0,
            name=name,
            dt=0,
        )

    # --- how it is shown ----------------------------------------------------------------

    def __repr__(self) -> str:
        return block_line(self)

    def _repr_html_(self) -> str:
        return block_html(self)

    def _repr_markdown_(self) -> None:
        """Leave python-control's, which would be the same again."""

    # --- the record -------------------------------------------------------------------

    @cached_property
    def _equations(self) -> dict[str, tuple[Callable, Record | None]]:
        """Return for each role the equations as Python runs them, and their record."""
        states, inputs = (sum(ports.values()) for ports in (self.state_ports, self.input_ports))
        given: dict[str, tuple[Any, int]] = {
            "update": (self.update_function, states),
            "output": (self.output_function, sum(self.output_ports.values())),
            "guard": (None if self.guard is None else self.guard.distance, 1),
            "jump": (self.jump_function, states),
        }
        found: dict[str, tuple[Callable, Record | None]] = {}
        for role, (function, size) in given.items():
            if function is not None:
                record = None
                with suppress(TooLong):  # Python runs it all the same
                    sizes = (states, inputs, size)
                    record = trace(function, f"{self.name}.{role}", sizes, self.parameters)
                found[role] = in_ieee(function), record
        return found

    def _record(self, role: str) -> Record | None:
        if role not in self._equations:
            return None
        record = self._equations[role][1]
        if record is None:
            raise TooLong(f"{self.name}.{role}: takes more operations than a record may have")
        return record

    @property
    def update_record(self) -> Record | None:
        """Return the record of `update`, or None without states."""
        return self._record("update")

    @property
    def output_record(self) -> Record:
        """Return the record of `output`."""
        record = self._record("output")
        assert record is not None
        return record

    @property
    def guard_record(self) -> Record | None:
        """Return the record of the guard's distance, or None."""
        return self._record("guard")

    @property
    def jump_record(self) -> Record | None:
        """Return the record of `jump`, or None."""
        return self._record("jump")

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_equations"}

    # --- parameters -------------------------------------------------------------------

    @property
    def parameters(self) -> Any:
        """Return the block's own parameters, checked when set."""
        return self._parameters

    @parameters.setter
    def parameters(self, value: Any) -> None:
        self._parameters = checked_parameters(self.name, value)
        self.__dict__.pop("_equations", None)
        self._current = self._parameters
        self._jumps, self._jumps_until = np.zeros(0), 0.0
        self._seen: tuple[float, float] | None = None  # time and interval of the first rate

    @property
    def params(self) -> dict[str, Any]:
        """Return the parameters under the name, for python-control."""
        return {self.name: self.parameters}

    @params.setter
    def params(self, value: dict[str, Any]) -> None:
        """Ignore python-control's own empty default."""

    def with_params(self, params: Mapping[str, Any] | None) -> Any:
        """Return the parameters, changed by {"block.field": value}."""
        params = params or {}
        within_diagram = self.name in params
        changes = {}
        for key, value in params.items():
            owner, _, field = key.rpartition(".")
            if owner == self.name and field in self.parameters._fields:
                changes[field] = value
            elif key == self.name and hasattr(value, "_fields"):
                continue  # what python-control hands to every block of a diagram
            elif self.name in (owner, key) or not within_diagram:
                known = ", ".join(f"{self.name}.{f}" for f in self.parameters._fields) or "none"
                raise BlockError(f"unknown parameter '{key}': block {self.name} knows {known}")
        return self.with_values(changes)

    @public
    def with_values(self, changes: Mapping[str, Any]) -> Any:
        """Return the parameters with some fields changed."""
        for field, value in changes.items():
            if field not in self.parameters._fields:
                known = ", ".join(self.parameters._fields) or "none"
                raise BlockError(f"{self.name}: unknown parameter {field!r}; it has {known}")
            fixed = getattr(self.parameters, field)
            if isinstance(fixed, int) and not np.array_equal(value, fixed):
                raise BlockError(
                    f"{self.name}.{field} = {value}: is {fixed} since the block was made; "
                    "make another block, or declare the parameter as a float"
                )
        if not changes:
            return self.parameters
        return checked_parameters(self.name, self.parameters._replace(**changes), self.parameters)

    def _update_params(self, params: Mapping[str, Any] | None) -> None:
        self._current, self._seen = self.with_params(params), None

    # --- jumps in time ----------------------------------------------------------------

    @public
    def breakpoints(self, t0: float, t1: float, p: Any = None) -> np.ndarray:
        """Return the sorted times in (t0, t1] at which the block jumps."""
        if self.breakpoints_function is None:
            return np.zeros(0)
        given = self.breakpoints_function(self.parameters if p is None else p, t0, t1)
        try:
            times = np.asarray(given, dtype=float)
        except (TypeError, ValueError):
            times = np.full(1, np.nan)
        if times.ndim != 1 or not np.all(times[1:] >= times[:-1]) or np.any(np.isnan(times)):
            raise BlockError(
                f"{self.name}: breakpoints gives {shown(given)}; must be increasing times"
            )
        return times

    def interval_at(self, t: float, p: Any = None) -> np.float64:
        """Return the number of the interval that holds t, by bisection.

        A breakpoint belongs to the interval that it starts.
        """
        if p is not None and p is not self.parameters:
            return np.float64(len(self.breakpoints(0.0, t, p)))
        if t >= self._jumps_until:
            self._jumps_until = max(2.0 * t, t + 1.0)
            self._jumps = self.breakpoints(0.0, self._jumps_until)
        return np.float64(np.searchsorted(self._jumps, t, side="right"))

    def parameters_at(self, t: float, p: Any = None) -> Any:
        """Return the parameters with `interval` filled in for time t."""
        p = self._current if p is None else p
        if self.breakpoints_function is None or p.interval >= 0:
            return p
        return p._replace(interval=self.interval_at(t, p))

    # --- the reading that python-control runs -------------------------------------------

    def equations(self, role: str) -> Callable:
        """Return "update", "output", "guard" or "jump" as Python runs it."""
        return self._equations[role][0]

    @np.errstate(all="ignore")
    def values(self, role: str, size: int, t: float, x: Any, u: Any, p: Any) -> np.ndarray:
        """Return what the equations of a role fill in Python."""
        out = np.zeros(size)
        x, u = np.asarray(x, dtype=float), np.asarray(u, dtype=float)
        self.equations(role)(np.float64(t), x, u, p, out)
        return out

    def _rhs(self, t, x, u):
        if self.update_function is None:
            return np.zeros(0)
        p = self.parameters_at(t)
        if self.jump_function is not None and not self._current.interval >= 0:
            self._refuse_jumps(float(t), float(p.interval))
        return self.values("update", self.nstates, t, x, u, p)

    def _refuse_jumps(self, t: float, interval: float) -> None:
        """Refuse rates on both sides of a jump, which is what an integration asks for."""
        since, first = self._seen = self._seen or (t, interval)
        if interval != first:
            raise BlockError(
                f"{self.name}: its states jump between t = {since:.9g} and t = {t:.9g}, and "
                "python-control integrates over jumps as if there were none; run the diagram with "
                "clpt.simulate"
            )

    def _out(self, t, x, u):
        return self.values("output", self.noutputs, t, x, u, self.parameters_at(t))

    def _updfcn(self, t, x, u, params):
        self._update_params(params)
        return self._rhs(t, x, u)

    def _outfcn(self, t, x, u, params):
        self._update_params(params)
        return self._out(t, x, u)
