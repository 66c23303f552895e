"""Sampled systems: a discrete system as a block of continuous time.

    at t_k = k dt     x = f(t_{k-1}, x, held), then held = u(t_k)
    between           x and held are constant, y = h(t_k, x, held)

All blocks with a sample at the same time first update their states, from the inputs that they held
before.  Then each samples its inputs, and a block that is fed by another one reads its new output
(`Sweep.jump`).  So a diagram of blocks with the same period is, at its samples, the diagram of
discrete time.  k is the block's `interval`.  A run that begins at a sample begins by sampling.  A
run that begins between two samples has the held inputs in its initial state.
"""

from typing import Any

import numpy as np

from ...base.arguments import public
from ...base.errors import DiagramError
from ..record.graph import Operation, Shape, compact, replayed
from ..trace.arrays import Tape, operand
from .block import Block
from .declaration import Each, Parameters

HELD = "held_"  # prefix of the states that hold inputs
ROUNDING = 1e-12  # times are equal if they differ by less, relative to the time or to 1


def other_equations(*arguments):
    """Stand for equations of a block that computes its values from another block or a record."""
    raise NotImplementedError


@public
class Sampled(Block):
    """A block that updates an inner block at multiples of a period.

    Its inputs are sampled then, its outputs are held until the next sample.

    Parameters
    ----------
    inner : Block
        A continuous block is updated by Euler's step, x += period * rate, as in a digital
        controller.  A discrete block, which `connect` makes from ``control.ss(..., dt=)``, has its
        own update.
    period : float
        Time between two samples; time 0 is a sample.

    Raises
    ------
    DiagramError
        If the block has jumps of its own or a guard, or the period is not positive.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> (law,) = (b for b in clpt.paper_blocks(scenario) if b.name == "adaptation")
    >>> run = clpt.simulate(clpt.closed_loop(scenario, law=clpt.Sampled(law, 1.0)))
    >>> run.attrs["engine"]
    'native'
    """

    def __init__(self, inner: Block, period: float):
        if not 0 < float(period) < np.inf:
            raise DiagramError(
                f"{inner.name}: period = {period}: must be a positive time"
            )
        if inner.breakpoints_function is not None or inner.guard is not None:
            raise DiagramError(
                f"{inner.name}: has breakpoints or a guard of its own, so it cannot be sampled"
            )
        self.inner = inner
        self.period = float(period)
        self.of_package = inner.of_package
        self.stepped = inner.dt == 0  # by Euler's step
        inputs = inner.declared["inputs"]
        held_inputs = {HELD + port: shape for port, shape in inputs.items()}
        states = inner.declared["states"] | held_inputs
        super().__init__(
            inner.name,
            update=other_equations if states else None,
            output=other_equations,
            inputs=inputs,
            outputs=inner.declared["outputs"],
            states=states,
            parameters={**inner.parameters._asdict(), "interval": -1.0},
            shapes=inner.parameter_shapes,
            sizes=inner.sizes,
            breakpoints=Each(self.period),
            jump=other_equations if states else None,
        )
        self.first_held = inner.nstates if inner.ninputs else None
        self.raised, self.rules = inner.raised, inner.rules
        self.set_inputs(inner.input_labels)
        self.set_outputs(inner.output_labels)
        if states:
            self.set_states([*inner.state_labels, *self.state_labels[inner.nstates :]])
        self.units = inner.units

    def samples_at(self, t: float) -> bool:
        """Return whether a time is a sample."""
        k = np.round(t / self.period)
        tolerance = ROUNDING * max(1.0, abs(t))
        is_near = abs(t - k * self.period) <= tolerance
        return bool(k >= 0 and is_near)

    # --- values and records -----------------------------------------------------------------

    def _try_equations(self) -> None:
        """Do nothing: the inner block has run its equations."""

    def read_anew(self) -> None:
        """Trace the functions again, as their objects may have changed."""
        if not self.of_package:
            self.inner.read_anew()
            self._forget()

    def values(
        self, role: str, size: int, t: float, x: Any, u: Any, p: Any
    ) -> np.ndarray:
        """Return the inner block's values with the held inputs."""
        if role == "update":
            return np.zeros(size)
        inner = self.inner
        n = inner.nstates
        fields = inner.parameters._fields
        parameters = Parameters(**{field: getattr(p, field) for field in fields})
        x, inputs = np.split(np.asarray(x), [n])
        if role == "output":
            t = p.interval * self.period
            return inner.values(role, size, t, x, inputs, parameters)
        if not n:
            return np.array(u)
        t = (p.interval - 1.0) * self.period
        new_states = inner.values("update", n, t, x, inputs, parameters)
        self.raised["jump"] = self.raised.get("update", "")
        if self.stepped:
            new_states = new_states * self.period + x
        return np.append(new_states, u)

    def _read(self, role: str) -> Any:
        """Write the inner block's record with the held inputs, at a sample or the sample before."""
        tape = Tape()
        inner = self.inner
        is_output = role == "output"
        interval = tape.add("leaf", (), (), ("p", "interval"))
        t = (interval - (0.0 if is_output else 1.0)) * self.period

        def leaf(group: str, name: str, shape: Shape) -> Any:
            at = ("x", HELD + name) if group == "u" else (group, name)
            return operand(t if group == "t" else tape.add("leaf", (), shape, at))

        def put(operation: Operation, refs: list[Any]) -> Any:
            return operand(tape.add(operation.kind, refs, *operation[2:]))

        values, shapes = list[Any](), list[Shape]()  # of ports, whose sizes may be open
        if role == "update":
            shapes = [*self.declared["states"].values()]
            values = [0.0] * len(shapes)
        elif is_output or inner.nstates:
            record = inner.array_record("output" if is_output else "update")
            values = [tape.value(ref) for ref in replayed(record, leaf, put)]
            shapes = [*record.shapes]
        if role == "jump" and self.stepped:
            ports = inner.declared["states"]
            for k, (port, shape) in enumerate(zip(ports, shapes, strict=True)):
                increment = values[k] * self.period
                values[k] = increment + tape.add("leaf", (), shape, ("x", port))
        if role == "jump":
            for port, shape in inner.declared["inputs"].items():
                values.append(tape.add("leaf", (), shape, ("u", port)))
                shapes.append(shape)
        return self._outside(compact(tape.operations, [*map(operand, values)], shapes))
