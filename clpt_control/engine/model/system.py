"""python-control's systems as blocks: systems of functions, and linear systems.

    dx/dt, or the next x, = updfcn(t, x, u, params),    y = outfcn(t, x, u, params)
    dx/dt, or the next x, = A x + B u,                  y = C x + D u

Numbers and arrays of numbers in `params` are parameters of the block, also whole numbers; all other
values do not change.  Sizes that the system leaves open follow from the inputs and the initial
state of a run, as in python-control.  If D = 0, a linear system has no direct feedthrough, and its
block has no parameter D.
"""

from collections.abc import Callable, Iterator, Mapping
from itertools import product
from typing import Any

import control
import numpy as np
from scipy.linalg import block_diag

from ...base.arguments import brief
from ...base.errors import BlockError, DiagramError
from ...base.labelled import axes_of
from ...base.progress import warn
from ..record.graph import MOST_NUMBERS, Shape
from ..record.unread import Unread, active
from ..trace.tracing import Read
from .block import Block
from .declaration import EVERY, Parameters
from .ports import flattened, spans_of
from .sampled import Sampled


class System(Block):
    """A `control.nlsys`, a flat system, a feedback or an estimator that python-control made.

    Its ports are x, u and y; with `shapes`, the ports that its labels form, each a row of numbers
    or of its shape.
    """

    def __init__(
        self,
        system: control.NonlinearIOSystem,
        params: Mapping[str, Any] | None = None,
        sizes: tuple[int | None, int | None] = (None, None),
        shapes: Mapping[str, Shape] | None = None,
    ):
        n = _size(system, "states", system.nstates, sizes[0])
        m = _size(system, "inputs", system.ninputs, sizes[1])
        self.name = system.name
        self._params = dict(system.params if params is None else params)
        for key, value in self._params.items():
            no_number = isinstance(value, str | None) or axes_of(value)
            if np.iscomplexobj(value) or (
                no_number and _is_number(key, system.params.get(key))
            ):
                raise BlockError(
                    f"{self.name}.{key} = {brief(value)}: must be a number"
                )
            if axes_of(value) == []:
                self._params[key] = value.item()
        self.declared_names = {*system.params}  # which a run may set
        self._spread: set[str] = set()  # roles that were warned of
        # role -> params that it asks for, texts in its code
        self._reads: dict[str, tuple[frozenset[Any], frozenset[Any]]] = {}
        updfcn, outfcn = _functions(system)
        if (q := system.noutputs) is None:  # it is not declared
            arguments = 0.0, np.zeros(n), np.zeros(m), dict(self._params)
            q = n if outfcn is None else np.size(outfcn(*arguments))
        q = int(q)
        ports = {}
        for kind, letter, size in (
            ("input", "u", m),
            ("output", "y", q),
            ("state", "x", n),
        ):
            labels = dict(getattr(system, f"{kind}_index"))
            if len(labels) != size:
                labels = {f"{letter}[{k}]": k for k in range(size)}
            setattr(self, f"{kind}_index", labels)
            setattr(self, f"n{kind}s", size)
            ports[f"{kind}s"] = {letter: (size,)} if size else {}
            if shapes is not None:
                spans = spans_of([*labels]).items()
                ports[f"{kind}s"] = {
                    port: shapes.get(port, (span.stop - span.start,))
                    for port, span in spans
                }
        # of the states, as python-control takes them
        returns_first_states = outfcn is None and (
            q < n or (shapes is not None and ports["outputs"] != ports["states"])
        )
        self.update_function = updfcn if n else None
        self.output_function = (
            (lambda t, x, u, params: x[:q]) if returns_first_states else outfcn
        )
        self._inner = {}
        self.raised: dict[str, str] = {}
        if self.output_function is None:
            ports["outputs"] = ports["states"]
        self.declared = ports
        # params that are numbers, which the block has as parameters
        self.parameters = Parameters(**_numbers(self._params))
        self.dt = system.dt or 0
        self.declare_units(given_units(system))

    # --- parameters -------------------------------------------------------------------------

    def _checked(self, value):
        return value  # of the numbers among the system's params

    @property  # type: ignore[misc]  # nobody sets it
    def params(self) -> Mapping[str, Any]:
        """Return the system's params."""
        return self._params

    def with_params(self, params: Mapping[str, Any] | None) -> Any:
        """Return the parameters with some changed; python-control passes unknown ones on."""
        return self.with_values(params or {})

    def having(self, values: Mapping[str, Any], complete: bool = True) -> Any:
        """Return the system with other numbers among its params."""
        changed = super().having(values, complete)
        changed._params = self._params_with(changed._parameters)
        return changed

    def with_values(self, changes: Mapping[str, Any], complete: bool = True) -> Any:
        """Return the parameters with some changed, except names that are no numbers."""
        changed = {
            key: _leaf(value)
            for key, value in changes.items()
            if key in self._parameters and value is not self._params[key]
        }
        return self._parameters._replace(**changed) if changed else self._parameters

    def mentions(self, name: str) -> bool:
        """Return whether the functions could read a param of a name."""
        return (
            name in self.declared_names
            or self.reads(name)
            or any(name in texts for _, texts in self._names_read())
        )

    def reads(self, name: str) -> bool:
        """Return whether a function read a param of a name, or was not read itself."""
        return any(name in names or EVERY in names for names, _ in self._names_read())

    @property
    def names(self) -> set[str]:
        """Return the params that it declares, or reads."""
        return self.declared_names.union(
            *(names for names, _ in self._names_read())
        ) - {EVERY}

    def _names_read(self) -> Iterator[tuple[frozenset[Any], frozenset[Any]]]:
        """Yield the params that each function reads, any where it is not read itself, and texts."""
        for role in self._roles:
            try:
                self.array_record(role)
            except Unread:
                yield frozenset([EVERY]), frozenset()
            else:
                yield self._reads[role]

    def _params_with(self, p: Any) -> dict[str, Any]:
        """Return the params that python-control would hand to the functions."""
        if p is self._parameters:
            return self._params
        changed = {
            key: _as_given(value, self._params[key])
            for key, value in p._asdict().items()
            if value is not getattr(self._parameters, key)
        }
        return {**self._params, **changed}

    # --- readings ---------------------------------------------------------------------------

    def _note(self, role: str, result: Read) -> None:
        if result.spreads:
            self._warn_of_spread(role)
        self._reads[role] = result.names, result.texts

    def _evaluate(
        self, role: str, size: int, t: float, x: Any, u: Any, p: Any
    ) -> np.ndarray:
        function, where = self._plan[role]
        returned = function(t, np.array(x), np.array(u), self._params_with(p))
        values = flattened(f"{self.name}.{role}", returned, where, size, spreads=True)
        is_one = size > 1 and values[0] == values[-1] and np.size(returned) == 1
        if is_one and active() is None:
            self._warn_of_spread(role)
        return values

    def _warn_of_spread(self, role: str) -> None:
        """Warn once of a function that returns one number for several states or outputs."""
        if role not in self._spread:
            self._spread.add(role)
            count, signals = (
                (self.nstates, "states")
                if role == "update"
                else (self.noutputs, "outputs")
            )
            warn(
                f"{self.name}.{role} returns one number, which each of its {count} {signals} gets. "
                "Return a number for each"
            )


def _functions(system: control.NonlinearIOSystem) -> tuple[Callable, Callable | None]:
    """Return update and output of a system, or the methods that its class has in their place."""
    kind = type(system)
    plain = control.NonlinearIOSystem
    update = system.updfcn
    output = system.outfcn
    if kind._rhs is not plain._rhs:

        def update(t, x, u, params):
            params.keys()  # any may be a param of the object
            return system._rhs(t, x, u)

    if kind._out is not plain._out:

        def output(t, x, u, params):
            params.keys()
            return system._out(t, x, u)

    return update, output


def given_units(system: Any) -> Mapping[str, str]:
    """Return the units that a user gave a system of python-control."""
    units = getattr(system, "units", {})
    return units if isinstance(units, Mapping) else {}


def _size(system: Any, kind: str, declared: int | None, of_run: int | None) -> int:
    size = declared if declared is not None else of_run
    if size is None:
        raise BlockError(
            f"{system.name}: the number of {kind} is unknown. Give {kind}= to control.nlsys"
        )
    return int(size)  # python-control takes NumPy's too


def _leaf(value):
    return np.asarray(value, dtype=float) if np.ndim(value) else np.float64(value)


def _numbers(params: Mapping[str, Any]) -> dict[str, Any]:
    """Return the params that a block has as parameters."""
    return {
        name: _leaf(value) for name, value in params.items() if _is_number(name, value)
    }


def _as_given(value, like):
    """Return a number as Python's, whole where the one in its place is."""
    if np.ndim(value):
        return value
    is_whole = isinstance(like, int | np.integer) and float(value).is_integer()
    return int(value) if is_whole else float(value)


def _is_number(key: Any, value: Any) -> bool:
    """Return whether a param is a number, or an array of doubles, which signals may take part in.

    Other arrays stay as they are: NumPy cuts what is written into whole numbers.
    """
    if not isinstance(key, str) or hasattr(Parameters, key) or key == "interval":
        return False
    if type(value) in (int, float, np.int64, np.float64):
        return not np.isnan(value)
    return (
        type(value) is np.ndarray
        and value.dtype == float
        and 0 < value.size <= MOST_NUMBERS
        and not np.any(np.isnan(value))
    )


# --- linear systems ----------------------------------------------------------------------------


def rate(t, x, u, p):
    """x' = A x + B u, section "linear systems" of any textbook."""
    return p.A @ x.x + p.B @ u.u


def output(t, x, u, p):
    """y = C x + D u, section "linear systems"; a part that is zero is left out."""
    if "C" not in p:
        return p.D @ u.u
    return p.C @ x.x + p.D @ u.u if "D" in p else p.C @ x.x


RECORDS: dict[str, dict[str, Any]] = {}  # by what is left out
SHAPES = {"A": ("n", "n"), "B": ("n", "m"), "C": ("q", "n"), "D": ("q", "m")}


def linear(system: control.StateSpace | control.TransferFunction) -> Block:
    """Make a block of a linear system, with its name, labels and time."""
    parameters = dict(zip("ABCD", _matrices(system), strict=True))
    n = len(parameters["A"])
    outputs, inputs = parameters["D"].shape
    left_out = "ABC" if not n else "" if np.any(parameters["D"]) else "D"
    for name in left_out:
        del parameters[name]
    block = Block(
        system.name,
        update=rate if n else None,
        output=output,
        inputs={"u": "m"},
        outputs={"y": "q"},
        states={"x": "n"} if n else None,
        parameters=parameters,
        shapes={name: SHAPES[name] for name in parameters},
        sizes={"m": inputs, "q": outputs},
    )
    # the same for all sizes
    block.__dict__["_read_records"] = RECORDS.setdefault(left_out, {})
    block.set_inputs(system.input_labels)
    block.set_outputs(system.output_labels)
    if isinstance(system, control.StateSpace):
        block.set_states(system.state_labels)
    block.dt = system.dt
    block.declare_units(given_units(system))
    return block


def is_linear(part: control.NonlinearIOSystem) -> bool:
    """Return whether a part is a block that `linear` made."""
    block = getattr(part, "inner", part)  # of one that is sampled
    return getattr(block, "output_function", None) is output


def _matrices(
    system: control.StateSpace | control.TransferFunction,
) -> tuple[np.ndarray, ...]:
    """Return A, B, C, D; each entry of a matrix of transfer functions has states of its own."""
    if isinstance(system, control.StateSpace):
        return system.A, system.B, system.C, system.D
    rows, columns = np.indices((system.noutputs, system.ninputs)).reshape(2, -1)
    entries = zip(rows, columns, strict=True)
    try:
        subsystems = [
            control.tf2ss(system.num[i][j], system.den[i][j]) for i, j in entries
        ]
    except ValueError:
        raise DiagramError(
            f"{system.name}: a numerator of higher degree than its denominator differentiates, "
            "which a block cannot. Add a fast pole, such as tf([1, 0], [0.01, 1])"
        ) from None
    A, B, C, D = (
        block_diag(*(getattr(subsystem, name) for subsystem in subsystems))
        for name in "ABCD"
    )
    to = np.eye(system.noutputs)[:, rows]
    of = np.eye(system.ninputs)[columns]
    return A, B @ of, to @ C, to @ D @ of


def with_constants(block: Block) -> Block:
    """Return a linear block whose matrices are constants, not parameters."""
    if isinstance(block, Sampled):
        return Sampled(with_constants(block.inner), block.period)
    labels = {
        f"{kind}s": getattr(block, f"{kind}_labels")
        for kind in ("input", "output", "state")
    }
    matrices = _matrices_of(block)
    return System(control.ss(*matrices, block.dt, name=block.name, **labels))


def on_each_axis(block: Block, count: int) -> Block:
    """Return a linear block of one signal for so many signals, each with states of its own."""
    A, B, C, D = (np.kron(np.eye(count), matrix) for matrix in _matrices_of(block))
    linear_block = linear(control.ss(A, B, C, D, name=block.name))
    return (
        Sampled(linear_block, block.period)
        if isinstance(block, Sampled)
        else linear_block
    )


def _matrices_of(block: Block) -> list[np.ndarray]:
    """Return A, B, C, D of a linear block."""
    shapes = product((0, block.noutputs), (0, block.ninputs))
    return [
        getattr(block.parameters, name, np.zeros(shape))
        for name, shape in zip("ABCD", shapes, strict=True)
    ]
