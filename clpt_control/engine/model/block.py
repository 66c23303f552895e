"""Blocks: equations on named ports, run by python-control.

    dx/dt = update(t, x, u, p),    y = output(t, x, u, p)

and x = jump(t, x, u, p) after the block's own breakpoints or at its guard's edge, if the block
has a jump.
The functions return a mapping by port, or numbers in the order of the ports, and have no side
effects.  Each function is traced into a record of array operations; machine code, SymPy expressions
and derivatives are made from the record.  A block also has what a diagram needs: ports with their
shapes and labels, parameters, breakpoints, and the mark `opaque` for sources of time and tables,
which are undefined functions in SymPy.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from copy import copy
from threading import local
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...base.arguments import brief, check_known, has, known, numbers, public
from ...base.errors import ArgumentError, BlockError
from ..record.graph import Record, evaluated
from ..record.unread import Unread, line_of
from ..trace.tracing import RAISED, check_distance
from .declaration import (
    POLICIES,
    Each,
    Equations,
    Guard,
    block_line,
    check_names,
    check_rules,
    check_units,
    checked_parameters,
)
from .ports import (
    Declared,
    Vector,
    flattened,
    labels,
    places,
    shapes_of,
    sizes_of,
    vector,
)
from .traced_block import READ, ReadBlock


class Call(local):
    """Parameters of python-control's call, one object for each thread that shares a block."""

    def __init__(self, parameters: Any) -> None:
        self.parameters = parameters
        # time, interval and distance of the guard of the first rate
        self.start: tuple[float, float, float] | None = None


@public
class Block(ReadBlock):
    """Equations with ports, which python-control can run.

    Parameters
    ----------
    name : str
        Name of the block in a diagram; parameters are ``"name.field"``.
    update : callable, optional
        ``update(t, x, u, p)`` returns the time derivative of the states.
    output : callable, optional
        ``output(t, x, u, p)`` returns the outputs; without it y = x.
    inputs, outputs, states : mapping, optional
        Port name -> shape: a number of signals, the name of a size, or a tuple of
        both; without `output` the outputs are the states, under their names.
    parameters : dict, NamedTuple or dataclass, optional
        Numbers and arrays; the integrator sets a field ``interval``.
    shapes : mapping, optional
        Parameter -> shape with named sizes: ``{"theta": (2, "N")}``.
    sizes : mapping, optional
        Size by name, ``{"N": 3}``, of sizes that no parameter has.
    opaque : bool, optional
        True for a source of time or tables: an undefined function to SymPy.
    breakpoints : callable, optional
        ``breakpoints(p, t0, t1)``: sorted times in (t0, t1] at which the block
        jumps. Interval k ends at breakpoint k + 1, counted from time 0.
    jump : callable, optional
        ``jump(t, x, u, p)`` returns all states after a breakpoint, from the states x and
        the inputs u before it; ``p.interval`` is the interval that begins. With
        ``guard=Guard(distance, "jump")`` the states jump where the distance falls to 0.
        `clpt.simulate` runs the jump, python-control does not.
    guard : Guard, optional
        The domain of the block.
    units : mapping, optional
        Port or parameter -> unit, ``{"e": "m"}``, for runs, plots and drawings. A system of
        python-control has them as an attribute, ``pendulum.units = {"angle": "rad"}``.
    dt : float, optional
        Period of a discrete block, as python-control's: `update` then returns the next states.
        In a continuous diagram the block samples its inputs and holds its outputs.

    Attributes
    ----------
    update_function, output_function, jump_function : callable or None
        The equations (the name ``output`` belongs to python-control).
    parameters : Parameters
        The block's parameters.
    feedthrough : bool
        True if the outputs depend directly on inputs, according to the record.

    Raises
    ------
    BlockError
        If ports, parameters and results of the equations do not fit.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.paper.blocks import vehicle
    >>> block = clpt.Block("vehicle", update=vehicle.kinematics,
    ...                    inputs={"flow_x": 2, "v_x": 2}, states={"x": 2})
    >>> block.dynamics(0, [0, 0], [1, 2, 0.5, 0.5])
    array([1.5, 2.5])
    """

    # of a sampled block: the first state that holds an input
    first_held: int | None = None
    # each refuses values of parameters by name, of a call too
    rules: Sequence[Callable[[str, Mapping[str, Any]], None]] = ()
    units: Mapping[str, str] = MappingProxyType({})

    def __init__(
        self,
        name: str,
        *,
        update: Equations | None = None,
        output: Equations | None = None,
        inputs: Declared | None = None,
        outputs: Declared | None = None,
        states: Declared | None = None,
        parameters: Any = None,
        shapes: Declared | None = None,
        sizes: Mapping[str, int] | None = None,
        opaque: bool = False,
        breakpoints: Callable[[Any, float, float], np.ndarray] | None = None,
        jump: Equations | None = None,
        guard: Guard | None = None,
        units: Mapping[str, str] | None = None,
        dt: float = 0,
    ):
        declared = {
            "inputs": shapes_of(inputs),
            "outputs": shapes_of(states if output is None else outputs),
            "states": shapes_of(states),
        }
        check_names(name, *declared.values())

        def refuse(condition: Any, sentence: str) -> None:
            if condition:
                raise BlockError(f"{name}: {sentence}")

        refuse(output is None and not states, "a block without states needs `output`")
        refuse(output and outputs is None, "`output` needs `outputs={'y': 1}`")
        refuse(
            (update is None) != (not states),
            "`update` has the rates of `states`. Give both or neither",
        )
        refuse(
            output is None
            and outputs is not None
            and shapes_of(outputs) != declared["states"],
            "without `output` the outputs are the states. Leave them out",
        )
        at_level = guard is not None and guard.policy == "jump"
        refuse(
            jump is not None and not (states and (breakpoints is not None or at_level)),
            "a jump sets states at the block's own breakpoints or at the edge of its guard. Give "
            '`states`, and `breakpoints` or `guard=Guard(distance, "jump")`',
        )
        refuse(at_level and jump is None, 'a guard with policy "jump" needs a `jump`')
        refuse(
            not 0 <= dt < np.inf, f"dt = {dt}: must be a time, or 0 in continuous time"
        )
        refuse(
            dt and (breakpoints is not None or guard is not None),
            "a block of discrete time has no breakpoints and no guard. Leave them out",
        )
        refuse(
            guard is not None and guard.policy not in POLICIES,
            f"a guard's policy {guard and guard.policy!r} must be one of "
            f"{', '.join(POLICIES)}",
        )
        self.update_function, self.output_function, self.jump_function = (
            update,
            output,
            jump,
        )
        self.opaque, self.breakpoints_function, self.guard = opaque, breakpoints, guard
        self.name, self.units = name, dict(units or {})
        self.declared, self.parameter_shapes = declared, shapes_of(shapes)
        self.raised: dict[
            str, str
        ] = {}  # role -> error of its last call, which returned NaN
        self._inner = {}
        self._sizes = dict(sizes or {})
        self.parameters = parameters
        check_units(name, self.units, *declared.values(), self.parameters._asdict())
        refuse(
            breakpoints is not None and "interval" not in self.parameters._fields,
            "a block with breakpoints needs a parameter `interval = -1.0`",
        )
        super().__init__(
            self.dynamics,
            self.output,
            inputs=labels(sizes_of(self.input_shapes)),
            outputs=labels(sizes_of(self.output_shapes)),
            states=labels(sizes_of(self.state_shapes)) or 0,
            name=name,
            dt=dt,
        )
        self._try_equations()

    @np.errstate(all="ignore")
    def _try_equations(self) -> None:
        """Run the equations at a few points, to report mistakes when the block is made."""
        for port in (*self.declared["inputs"], *self.declared["states"]):
            if hasattr(Vector, port):
                raise BlockError(
                    f"{self.name}: the port '{port}' has a name that all arrays of NumPy have, so "
                    f"that u.{port} would be another thing. Rename it"
                )
        p = self.parameters_at(0.0)
        for role, (_, ports) in self._plan.items():
            size = sum(signals.stop - signals.start for signals, _ in ports.values())
            for value in (0.0, 0.3, 1.7, -0.6):  # a logarithm fails at some of them
                x, u = np.full(self.nstates, value), np.full(self.ninputs, value)
                try:
                    self._evaluate(role, size, abs(value), x, u, p)
                    break
                except BlockError:
                    raise
                except Exception as error:
                    last_error = error
            else:
                raise BlockError(self._sentence_of(role, last_error)) from last_error

    # --- as text ------------------------------------------------------------------------

    def __repr__(self) -> str:
        return block_line(self)

    def _repr_html_(self) -> None:
        """Return nothing, in place of python-control's text: `__repr__` is enough."""

    _repr_markdown_ = _repr_html_

    def __getstate__(self) -> dict[str, Any]:
        omitted = (*READ, "_call_of_thread")
        return {
            name: value for name, value in self.__dict__.items() if name not in omitted
        }

    # --- parameters -------------------------------------------------------------------

    @property
    def parameters(self) -> Any:
        """Return the block's parameters, checked when set."""
        return self._parameters

    @parameters.setter
    def parameters(self, value: Any) -> None:
        self._parameters = self._checked(value)
        check_rules(self, self._parameters)
        self._forget()
        self._bind()
        self.__dict__.pop("_call_of_thread", None)

    @property
    def _call(self) -> Call:
        if "_call_of_thread" not in self.__dict__:
            self.__dict__.setdefault("_call_of_thread", Call(self._parameters))
        return self._call_of_thread

    def _checked(self, value):
        return checked_parameters(self.name, value)

    @property
    def params(self) -> Mapping[str, Any]:
        """Return the parameters by name; `parameters` sets them."""
        return MappingProxyType({self.name: self.parameters})

    @params.setter
    def params(self, value: Mapping[str, Any]) -> None:
        """Ignore python-control's empty default; refuse any other value."""
        if value:
            raise BlockError(
                f"{self.name}.params: is read-only. Set {self.name}.parameters"
            )

    def with_params(self, params: Mapping[str, Any] | None) -> Any:
        """Return the parameters, changed by {"block.field": value}."""
        params = params or {}
        in_diagram = self.name in params
        changes = {}
        for key, value in params.items():
            owner, _, field = key.rpartition(".")
            if owner == self.name and field in self.parameters._fields:
                changes[field] = value
            elif key == self.name and has(value, "_fields"):
                continue  # python-control passes it to every block of a diagram
            elif self.name in (owner, key) or not in_diagram:
                names = [f"{self.name}.{f}" for f in self.parameters._fields]
                raise BlockError(
                    f"params: unknown parameter '{key}'. {known(key, names)}"
                )
        return self.with_values(changes)

    @public
    def with_values(self, changes: Mapping[str, Any], complete: bool = True) -> Any:
        """Return the parameters with some fields changed.

        They obey the rules if all of them are `complete`.
        """
        check_known(self.name, changes, self.parameters._fields)
        for field, value in changes.items():
            fixed = getattr(self.parameters, field)
            if isinstance(fixed, int) and not np.array_equal(value, fixed):
                raise BlockError(
                    f"{self.name}.{field} = {value}: is {fixed} since the block was made. "
                    "Make another block, or declare the parameter as a float"
                )
        if not changes:
            return self.parameters
        changed = checked_parameters(
            self.name, self.parameters._replace(**changes), self.parameters
        )
        if complete:
            check_rules(self, changed)
        return changed

    def having(self, values: Mapping[str, Any], complete: bool = True) -> Any:
        """Return the block with other numbers.

        Functions that read one of them are traced anew.
        """
        if not values:
            return self
        changed = copy(self)
        changed._parameters = self.with_values(values, complete)
        inner = self.unsampled
        with suppress(Unread):
            _ = inner.records
        if not any(names & values.keys() for names, _ in inner.read_with.values()):
            changed.__dict__["_read_records"] = self._records
        else:
            changed._forget()
            if inner is not self:
                changed.inner = inner.having(values, complete=False)
        return changed

    def _update_params(self, params: Mapping[str, Any] | None) -> None:
        self._call.parameters, self._call.start = self.with_params(params), None

    # --- jumps ------------------------------------------------------------------------

    @property
    def jumps_at_level(self) -> bool:
        """True if the states jump where the block's guard is left."""
        return self.guard is not None and self.guard.policy == "jump"

    @public
    def breakpoints(self, t0: float, t1: float, p: Any = None) -> np.ndarray:
        """Return the sorted times in (t0, t1] at which the block jumps."""
        if self.breakpoints_function is None:
            return np.zeros(0)
        returned = self.breakpoints_function(
            self.parameters if p is None else p, t0, t1
        )
        try:
            times = np.asarray(returned, dtype=float)
        except (TypeError, ValueError):
            times = np.full(1, np.nan)
        is_sorted = times.ndim == 1 and np.all(times[1:] >= times[:-1])
        if not is_sorted or np.any(np.isnan(times)):
            raise BlockError(
                f"{self.name}: breakpoints gives {brief(returned)}; must be increasing times"
            )
        if t0 < 0 and np.any(times <= 0):  # intervals are counted from 0 on
            raise BlockError(
                f"{self.name}: jumps at {times[0]:g}, and its intervals are counted from time 0 "
                f"on. Begin the run at 0 or later, not at {t0:g}"
            )
        return times

    def interval_at(self, t: float, p: Any = None) -> np.float64:
        """Return the number of the interval that contains t.

        A breakpoint belongs to the interval after it.
        """
        p = self.parameters if p is None else p
        if isinstance(self.breakpoints_function, Each):
            return np.float64(self.breakpoints_function.count(p, t))
        return np.float64(len(self.breakpoints(0.0, t, p)))

    def parameters_at(self, t: float, p: Any = None) -> Any:
        """Return the parameters with `interval` filled in for time t."""
        p = self._call.parameters if p is None else p
        if self.breakpoints_function is None or p.interval >= 0:
            return p
        return p._replace(interval=self.interval_at(t, p))

    # --- calls of the functions in Python -----------------------------------------------

    def values(
        self, role: str, size: int, t: float, x: Any, u: Any, p: Any
    ) -> np.ndarray:
        """Return a function's values, or NaN after an error of numbers.

        A run may try such numbers and continue without them; the error is stored in `raised`.
        """
        if role == "output" and self.states_are_outputs:
            return np.array(x, dtype=float)
        try:
            values = self._evaluate(role, size, t, x, u, p)
        except RAISED as error:  # as math.log(0.0) does
            self.raised[role] = self._sentence_of(role, error)
            return np.full(size, np.nan)
        except Exception as error:
            raise BlockError(self._sentence_of(role, error)) from error
        self.raised.pop(role, None)
        return values

    def _sentence_of(self, role: str, error: BaseException) -> str:
        """Return a sentence with the function, the line and the error."""
        if isinstance(error, BlockError):
            return str(error)
        function, _ = self._plan[role]
        return f"{self.name}.{role}: {line_of(function, error)}"

    def _evaluate(
        self, role: str, size: int, t: float, x: Any, u: Any, p: Any
    ) -> np.ndarray:
        function, ports = self._plan[role]
        returned = function(np.float64(t), vector(x, self._x), vector(u, self._u), p)
        if role == "guard":
            check_distance(self.name, returned)
        return flattened(f"{self.name}.{role}", returned, ports, size)

    @np.errstate(all="ignore")
    def _rhs(self, t, x, u):
        if self.update_function is None:
            return np.zeros(0)
        p = self.parameters_at(t)
        if self.jump_function is not None:
            self._refuse_jumps(float(t), x, u, p)
        return self.values("update", self.nstates, t, x, u, p)

    def _refuse_jumps(self, t: float, x: Any, u: Any, p: Any) -> None:
        """Refuse rates on both sides of a jump, which only an integration evaluates."""
        interval, distance = 0.0, 0.0
        if self.breakpoints_function is not None:
            fixed = self._call.parameters.interval >= 0
            interval = 0.0 if fixed else float(p.interval)
        if self.jumps_at_level:
            distance = float(self.values("guard", 1, t, x, u, p)[0])
        now = t, interval, distance
        start, first, above = self._call.start = self._call.start or now
        if interval != first or distance < 0.0 <= above:
            raise BlockError(
                f"{self.name}: its states jump between t = {start:.9g} and t = {t:.9g}, and "
                "python-control ignores the jumps. Run the diagram with "
                "clpt.simulate"
            )

    @np.errstate(all="ignore")
    def _out(self, t, x, u):
        return self.values("output", self.noutputs, t, x, u, self.parameters_at(t))

    # --- records in NumPy, at many points at once -----------------------------------------

    def on_arrays(
        self, role: str | Record, t: Any, x: Any, u: Any, p: Any = None
    ) -> np.ndarray:
        """Return the outputs of a record at many points at once.

        `t` has the times, x[k] a state and u[k] an input at these times; a row of the result has
        an output.  The parameters are the block's, or those given.
        """
        record = self.array_record(role) if isinstance(role, str) else role
        shape = np.broadcast_shapes(np.shape(t), np.shape(x)[1:], np.shape(u)[1:])
        count = int(np.prod(shape))

        def flat(vector: Any) -> np.ndarray:
            size = len(vector)
            return np.broadcast_to(vector, (size, *shape)).reshape(size, count)

        times = np.broadcast_to(t, shape).reshape(count)
        p = self.parameters if p is None else p
        if self.breakpoints_function is not None and p.interval < 0:
            intervals = [self.interval_at(time, p) for time in times]
            p = p._replace(interval=np.array(intervals))
        leaf = self._leaf_values(times, flat(x), flat(u), p)
        rows = evaluated(record, leaf, self.sizes, count)
        return rows.reshape((len(rows), *shape))

    def _leaf_values(
        self, t: Any, x: Any, u: Any, p: Any
    ) -> Callable[[str, str], np.ndarray]:
        """Return the function (group, name) -> array of a leaf.

        The last axis of the array has the points.
        """
        vectors = {
            "x": (x, places(self.state_shapes)),
            "u": (u, places(self.input_shapes)),
        }

        def leaf(group: str, name: str) -> np.ndarray:
            if group == "t":
                return np.asarray(t, dtype=float)
            if group == "p":
                value = np.asarray(getattr(p, name), dtype=float)
                varies = name == "interval" and value.ndim
                return value if varies else value[..., None]
            vector, ports = vectors[group]
            positions, shape = ports[name]
            values = vector[positions]
            return values.reshape((*shape, *values.shape[1:]))

        return leaf


@public
def evaluate(block: Block, timepts: ArrayLike, inputs: ArrayLike) -> np.ndarray:
    """Compute a static block's outputs at many times and inputs.

    >>> from clpt_control.paper.blocks.flow import flow_basis
    >>> p = np.zeros((1, 2)), np.ones(1), np.zeros(1), np.zeros(1)
    >>> evaluate(flow_basis("basis_x", "x", "gaussian", *p), [0, 5], [[0, 0], [1, 1]]).round(3)
    array([[1.   ],
           [0.368]])
    """
    u = np.atleast_2d(numbers("inputs", inputs, block.ninputs))
    t = numbers("timepts", timepts)
    allowed_shapes = (), (1,), u.shape[:1]
    if u.ndim > 2 or t.shape not in allowed_shapes:
        raise ArgumentError(
            f"evaluate: timepts has shape {t.shape}, inputs {u.shape}; must be a time, or n "
            f"of them, and (n, {block.ninputs})"
        )
    times = np.broadcast_to(t, len(u))
    no_states = np.zeros((0, len(u)))
    outputs = block.on_arrays("output", times, no_states, u.T)
    return outputs.T
