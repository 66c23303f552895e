"""A diagram of any blocks, ready to run: python-control's systems as they stand.

A second call of the same need not wire, read and lay out again: runs are kept `ready`.
"""

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any
from warnings import catch_warnings, simplefilter

import control
import numpy as np

from ..diagrams.stopping import with_stop
from ..diagrams.unchanged import key_of
from ..diagrams.wiring import Wiring, read_anew, units_of, wiring_of
from ..equations.declaration import ports_of, whole_labels
from ..equations.system import linear
from ..native.engines import VARIABLE, chosen, run_as_read
from ..native.native_diagram import NativeDiagram
from ..native.schedule import Inputs, open_sizes, read_inputs, stacked_state
from ..scenario.file import EQUATIONS, OWN_PARTS, REFERENCE
from .dataset import Frame, columns_of, diagram_frame, run_frame
from .loops import LoopOf
from .repeating import CONDITIONS, Ran
from .scenario_run import limit_of, note_speeds, speeds_of
from .starts import initial_state

if TYPE_CHECKING:
    import xarray

MOST = 16  # runs that are ready
_READY: dict[Any, Any] = {}


class DiagramRun:
    """A diagram as it was read: run it, make a Dataset."""

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        params: Mapping[str, Any] | None,
        sizes: tuple[int | None, int | None],
        by_function: bool,
        engine: str | None,
        stop: Callable | None = None,
    ):
        read_anew(diagram)
        self.diagram, self.params = diagram, params and dict(params)
        self.made_of: LoopOf | None = getattr(diagram, "made_of", None)
        self.wiring = wiring_of(diagram, params, sizes)
        if stop is not None:
            self.wiring = with_stop(self.wiring, stop)
        self.runner = chosen(self.wiring, params, by_function, engine, diagram.name)
        made, given, self.states = labels_of(diagram, self.wiring)
        self.called = {"name": diagram.name, "inputs": given, "outputs": made}
        self.called["states"] = self.states
        made, given = map(whole_labels, (made, given))
        taken = ports_of(made)  # an input of the name of an output is told apart, all its signals
        parts = [one.partition("[") for one in given]
        self.labels = made + [
            "".join((f"{port}_input" if port in taken else port, *rest)) for port, *rest in parts
        ]

    def run(self, times: np.ndarray, inputs: Any, x0: Any, **given: Any) -> "xarray.Dataset":
        """Run from a state at the first time to the last."""
        read = isinstance(inputs, Inputs)
        u = inputs if read else read_inputs(inputs, times, self.wiring.ninputs)
        state = stacked_state("initial_state", 0.0 if x0 is None else x0, self.runner.nstates)
        name = self.diagram.name
        given["inputs"] = u
        found, signals = run_as_read(self.runner, name, state, times, self.params, **given)
        every = np.concatenate([signals.T, u.along(found.t)])
        made = self.frame.filled(found, (self._shown @ every).T)
        own = {"timepts": times.copy(), "initial_state": state}
        conditions = {name: value for name, value in given.items() if name in CONDITIONS}
        made.encoding[EQUATIONS] = Ran(self, found.engine, u, {**conditions, **own})
        return made

    @cached_property
    def _shown(self) -> Any:
        """What a run shows, outputs and then inputs, of all block outputs and inputs."""
        made, n = self.wiring.output_map, self.wiring.ninputs
        if isinstance(made, np.ndarray):
            return np.vstack([made, np.eye(n, made.shape[1], made.shape[1] - n)])
        from scipy.sparse import eye_array, vstack

        return vstack([made, eye_array(n, made.shape[1], k=made.shape[1] - n)], format="csr")

    @cached_property
    def frame(self) -> Frame:
        """The Dataset of its runs; of `closed_loop` it is its scenario's."""
        diagram = self.diagram
        if self.made_of is None:
            own = tuple(self.labels), tuple(units_shown(self.wiring)), tuple(self.states)
            return diagram_frame(diagram.name, *own)
        found = columns_of(self.labels, self.wiring, self.runner.sweep.given)
        every, params = ports_of(self.labels), self.params or {}
        scenario, changes, _ = self.made_of
        return run_frame(scenario, found, params, changes, every, self.states)

    @cached_property
    def as_made(self) -> bool:
        """Whether a closed loop of a scenario is as it was made, with nothing from outside."""
        made = self.made_of
        return made is not None and not made.external and made.is_still(self.wiring)


def labels_of(diagram: Any, wiring: Wiring) -> tuple[list[str], list[str], list[str]]:
    """Return the labels of outputs, inputs and states, also where the system leaves them open."""
    first = wiring.nodes[0].system
    named = first if None in (diagram.ninputs, diagram.noutputs) else diagram
    states = (first if diagram.nstates is None else diagram).state_labels
    if len(states) != wiring.nodes[-1].states.stop:  # python-control keeps one of equal labels
        states = [
            f"{node.name.replace('.', '_')}_{label}"
            for node in wiring.nodes
            for label in node.system.state_labels
        ]
    return named.output_labels, named.input_labels, states


def units_shown(wiring: Wiring) -> list[str]:
    """Return the units of outputs, then of inputs; of a sum of several none is known."""
    made, given = units_of(wiring)
    alone = [next(iter(row)) if [*row.values()] == [1.0] else None for row in wiring.outputs]
    own = ["" if k is None else made[k] if k >= 0 else given[~k] for k in alone]
    return own + given


def compiled(
    diagram: control.NonlinearIOSystem,
    params: Mapping[str, Any] | None,
    sizes: tuple[int | None, int | None] = (None, None),
) -> DiagramRun:
    """Return a diagram that runs as machine code; what cannot be that is `Uncompiled`."""
    with catch_warnings():
        simplefilter("ignore")  # that it runs in Python
        run = DiagramRun(diagram, params, sizes, False, "native")
    if run.runner.engine != "native":
        NativeDiagram(run.wiring, params)
    return run


@contextmanager
def ready(found: tuple[Any, Any] | None, make: Callable[[], Any]) -> Iterator[Any]:
    """Yield the run of a key, made where there is none; until it is given back it is one's own.

    `found` is a key, with the objects whose places are in it.  Without one a run is made each time,
    and so is what runs in Python, of which a warning tells each time.
    """
    key = found and (found[0], os.environ.get(VARIABLE))
    held, run = _READY.pop(key, (None, None))
    if run is None:
        held, run = found, make()
    yield run
    if found and run.runner.engine == "native":
        _READY[key] = held, run
        for oldest in list(_READY)[:-MOST]:
            _READY.pop(oldest, None)


def simulate_diagram(
    diagram: Any,
    times: np.ndarray,
    inputs: Any,
    x0: Any,
    params: Mapping[str, Any] | None,
    engine: str | None,
    stop: Callable | None = None,
    **given: Any,
) -> "xarray.Dataset":
    """Run a diagram; one that is as it was at its last run is ready."""
    if isinstance(diagram, control.TransferFunction):
        diagram = linear(diagram)
    loop: LoopOf | None = getattr(diagram, "made_of", None)
    alone = loop is not None and inputs is x0 is stop is None
    if loop is not None:
        x0 = initial_state(diagram) if x0 is None else x0
        for name, own_value in loop.scenario.run.solver.items():
            alone = alone and given[name] is None
            given[name] = own_value if given[name] is None else given[name]
    own = open_sizes(diagram, inputs, x0, times), callable(inputs), engine
    key = None if stop is not None else key_of(diagram, params, *own)
    with ready(key, lambda: DiagramRun(diagram, params, *own, stop)) as run:
        found = run.run(times, inputs, x0, **given)
        if loop is None:
            return found
        if not (alone and run.as_made):
            outside = f"{REFERENCE}: from outside" if "zc" in loop.external else ""
            said = [loop.changes.in_words, outside, f"{diagram.name}: run as a diagram"]
            found.attrs[OWN_PARTS] = ", ".join(filter(None, said))
        limit = limit_of(run.wiring, run.runner.sweep.given)
    if limit is not None and {"commanded_velocity", "true_flow"} <= set(found):
        note_speeds(found, speeds_of(found, limit), loop.scenario.units)
    return found
