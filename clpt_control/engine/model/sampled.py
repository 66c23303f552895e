"""A system of discrete time as a block of continuous time: inputs sampled, outputs held.

    at t_k = k dt     x = f(t_{k-1}, x, held), then held = u(t_k)
    between           x and held stay, y = h(t_k, x, held)

All blocks that sample at one time move their states at once, with what they held before; then each
holds what feeds it, and one that is fed by another finds its new output (`Sweep.jump`).  So a
diagram of blocks sampled alike is, at its samples, the diagram of discrete time.  k is the block's
`interval`.  A run that begins at a sample begins with what is held there; one that begins between
two has it in its initial state.
"""

from typing import Any

import numpy as np

from ...arguments import public
from ...errors import DiagramError
from ..record.graph import Shape, compact
from ..trace.arrays import Tape, operand
from .block import Block
from .declaration import Each, Parameters

HELD = "held_"  # with the name of an input port: the state that keeps it
ROUNDING = 1e-12  # of a time, or of 1: times that differ by less are one


def other_equations(*arguments: Any) -> Any:
    """Do what the inner block does, or what is recorded."""
    raise NotImplementedError


def inner_parameters(block: "Sampled", p: Any) -> Parameters:
    """Return the parameters of the inner block among those of the sampled one."""
    return Parameters(**{field: getattr(p, field) for field in block.inner.parameters._fields})


@public
class Sampled(Block):
    """A block that runs another at each multiple of a period.

    Its inputs are sampled there, its outputs are held between.

    Parameters
    ----------
    inner : Block
        One of continuous time moves by Euler's step, x += period * rate, as a controller on
        board does; of discrete time, as `connect` makes it of ``control.ss(..., dt=)``, by its
        own.
    period : float
        From one sample to the next; time 0 is one.

    Raises
    ------
    DiagramError
        If the block jumps by itself or has a guard, or the period is none.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> (law,) = (b for b in clpt.paper_blocks(scenario) if b.name == "adaptation")
    >>> run = clpt.simulate(clpt.closed_loop(scenario, law=clpt.equations.Sampled(law, 1.0)))
    >>> run.attrs["engine"]
    'native'
    """

    def __init__(self, inner: Block, period: float):
        if not 0 < float(period) < np.inf:
            raise DiagramError(f"{inner.name}: period = {period}: must be a positive time")
        if inner.breakpoints_function is not None or inner.guard is not None:
            raise DiagramError(
                f"{inner.name}: has breakpoints or a guard of its own, so it cannot be sampled"
            )
        self.inner, self.period, self.of_package = inner, float(period), inner.of_package
        self.stepped = inner.dt == 0  # its rates are taken for a period, as Euler does
        held = {HELD + port: shape for port, shape in inner.declared["inputs"].items()}
        states = {**inner.declared["states"], **held}
        super().__init__(
            inner.name,
            update=other_equations if states else None,
            output=other_equations,
            inputs=inner.declared["inputs"],
            outputs=inner.declared["outputs"],
            states=states,
            parameters={**inner.parameters._asdict(), "interval": -1.0},
            shapes=inner.parameter_shapes,
            sizes=inner.sizes,
            breakpoints=Each(self.period),
            jump=other_equations if states else None,
            units=inner.units,
        )
        self.first_held, self.raised = inner.nstates if inner.ninputs else None, inner.raised

        for kind, rename in (("input", self.set_inputs), ("output", self.set_outputs)):
            rename(getattr(inner, f"{kind}_labels"))
        if states:
            self.set_states([*inner.state_labels, *self.state_labels[inner.nstates :]])

    def samples_at(self, t: float) -> bool:
        """Whether a time is one at which inputs are sampled."""
        k = np.round(t / self.period)
        return bool(k >= 0 and abs(t - k * self.period) <= ROUNDING * max(1.0, abs(t)))

    # --- readings ---------------------------------------------------------------------------

    def _try_equations(self) -> None:
        """Leave it to the inner block, which was tried."""

    def read_anew(self) -> None:
        """Read the functions again: what they use may have changed."""
        if not self.of_package:
            self.inner.read_anew()
            self._forget()

    def values(self, role: str, size: int, t: float, x: Any, u: Any, p: Any) -> np.ndarray:
        """Return what the inner block does with what is held."""
        if role == "update":
            return np.zeros(size)
        x, inner, parameters = np.asarray(x), self.inner, inner_parameters(self, p)
        states, held = x[: inner.nstates], x[inner.nstates :]
        if role == "output":
            return inner.values(role, size, p.interval * self.period, states, held, parameters)
        if not inner.nstates:
            return np.array(u)
        before = (p.interval - 1.0) * self.period
        new = inner.values("update", inner.nstates, before, states, held, parameters)
        self.raised["jump"] = self.raised.get("update", "")
        return np.append(new * self.period + states if self.stepped else new, u)

    def _read(self, role: str) -> Any:
        tape, inner = Tape(), self.inner
        states, inputs = inner.declared["states"], inner.declared["inputs"]

        def leaf(group: str, name: str, shape: Shape = ()) -> Any:
            return tape.add("leaf", (), shape, (group, name))

        def replayed(role: str, ago: float) -> list[Any]:
            """Return what the inner block does with what is held, at a sample or one before."""
            t = (leaf("p", "interval") - ago) * self.period

            def held(group: str, name: str, shape: Shape) -> Any:
                if group == "t":
                    return t
                return leaf(*(("x", HELD + name) if group == "u" else (group, name)), shape)

            return tape.replayed(inner.array_record(role), held)

        if role == "update":
            shapes = [*self.declared["states"].values()]
            return compact([], [0.0] * len(shapes), shapes)
        if role == "output":
            values, shapes = replayed("output", 0.0), [*inner.array_record("output").shapes]
        else:
            values = replayed("update", 1.0) if inner.nstates else []
            own = [*inner.array_record("update").shapes] if inner.nstates else []  # N may be bound
            if self.stepped:
                before = [leaf("x", port, shape) for port, shape in zip(states, own, strict=True)]
                values = [r * self.period + x for r, x in zip(values, before, strict=True)]
            values += [leaf("u", *port) for port in inputs.items()]
            shapes = [*own, *inputs.values()]
        return self._outside(compact(tape.operations, [operand(one) for one in values], shapes))
