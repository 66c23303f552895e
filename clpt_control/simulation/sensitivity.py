"""How a run varies with parameters and with its start: the derivatives of its outputs.

    S' = A S + B,  A = df/dx, B = df/dp along the run;   dy/dp = C S + D

S is integrated with the run itself (`diagrams.varied`), by the same engine, from the exact
derivative of what was read.  Where functions may jump, the same run is taken a little to both
sides, and what the differences do not confirm is refused.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..arguments import public
from ..diagrams.varied import fields_by_name, may_jump, read_as_number, varied
from ..diagrams.wiring import Wiring
from ..equations.arrays import Unread
from ..equations.declaration import ports_of
from ..equations.linear import linear
from ..errors import SimulationError, Uncompiled
from ..native.ending import Solution
from ..native.engines import difference
from ..native.native_diagram import NativeDiagram
from ..native.schedule import checked_times, open_sizes, read_inputs, stacked_state
from ..scenario.experiment import Scenario
from .dataset import diagram_frame
from .diagram_run import compiled, units_shown
from .loops import closed_loop
from .starts import initial_state as start_of

if TYPE_CHECKING:
    import xarray

START = "x0"  # all states of the start
STEPS = (1e-3, 1e-5)  # of the differences, of what is varied
CLOSE, SHARE = 1e-2, 0.02  # how far off they may be, and at which share of the samples
EXACT = {"rtol": 1e-10, "atol": 1e-13}  # of their runs


class Way(NamedTuple):
    """One number that is varied: an element of fields of blocks, or a state of the start."""

    name: str
    fields: tuple[tuple[int, str], ...]
    at: tuple[int, ...] = ()
    state: int = -1


class Varying(NamedTuple):
    """Outputs (nt, ny) of a run, and how they and the states vary: (nt, ny, ways)."""

    solution: Solution
    outputs: np.ndarray
    along: np.ndarray
    states: np.ndarray


def ways_of(names: str | Iterable[str], wiring: Wiring, states: Sequence[str]) -> list[Way]:
    """Return what is varied by these names: parameters, their elements, states of the start."""
    known = fields_by_name(wiring)
    found: list[Way] = []
    for name in [names] if isinstance(names, str) else names:
        if name in known and name in states:
            raise SimulationError(
                f"{name}: is a parameter and a state; {START}.{name} is the state"
            )
        bare, _, element = name.partition("[")
        state = name.removeprefix(f"{START}.")
        if state in states or (name == START and name not in known):
            own = states if name == START else [state]
            found += [Way(f"{START}.{one}", (), state=states.index(one)) for one in own]
        elif bare in known:
            (k, field), *_ = fields = known[bare]
            shape = np.shape(getattr(wiring.nodes[k].system.parameters, field))
            places = {f"{bare}[{','.join(map(str, at))}]" if at else bare: at
                      for at in np.ndindex(shape)}  # fmt: skip
            if element and name.replace(" ", "") not in places:
                raise SimulationError(f"{name}: {bare} has the shape {shape}, counted from 0")
            for label, at in places.items():
                if not element or label == name.replace(" ", ""):
                    found.append(Way(label, tuple(fields), at))
        else:
            several = sorted({*known, *states, START})
            raise SimulationError(f"{name}: must be among {', '.join(several)}")
    for way in found:
        for k, field in way.fields:
            if role := read_as_number(wiring.nodes[k].system, field):
                raise SimulationError(
                    f"{way.name}: {wiring.nodes[k].name}.{role} asks for its value (a count, an "
                    "index, an `if`, or a library that is no NumPy), so its derivative is not known"
                )
    return found


class Sensitive:
    """A diagram with what it is varied by, ready to run at any values of that."""

    def __init__(
        self,
        system: Any,
        times: np.ndarray,
        to: str | Iterable[str],
        inputs: Any,
        initial_state: Any,
        params: Mapping[str, Any] | None,
        **solver: Any,
    ):
        if isinstance(system, Scenario):
            system = closed_loop(system)
        if isinstance(system, control.TransferFunction):
            system = linear(system)
        loop = getattr(system, "made_of", None)
        self.skipped = 0
        if loop is not None:
            own = loop.scenario.run.solver
            solver = {name: own.get(name) if v is None else v for name, v in solver.items()}
            if initial_state is None:
                initial_state = start_of(system)
                self.skipped = int(times[0] != 0)
                times = np.concatenate([np.zeros(self.skipped), times])
        self.times, self.name = times, system.name
        self.solver = {name: value for name, value in solver.items() if value is not None}
        if callable(inputs):
            raise SimulationError("inputs: a sensitivity takes no function; give samples")
        sizes = open_sizes(system, inputs, initial_state, times)
        try:
            run = compiled(system, params, sizes)
        except Uncompiled as error:
            raise SimulationError(f"{self.name}: has no known derivative: {error}") from None
        self.wiring, self.given, self.states = run.wiring, run.runner.sweep.given, run.states
        outputs = slice(self.wiring.output_map.shape[0])
        self.labels, self.units = run.labels[outputs], units_shown(run.wiring)[outputs]
        self.inputs = read_inputs(inputs, times, self.wiring.ninputs)
        state = 0.0 if initial_state is None else initial_state
        self.start = stacked_state("initial_state", state, run.runner.nstates)
        self.ways = ways_of(to, self.wiring, self.states)
        seeds: list[dict[str, np.ndarray]] = [{} for _ in self.wiring.nodes]
        for j, way in enumerate(self.ways):
            for k, field in way.fields:
                shape = np.shape(getattr(self.given[k], field))
                seed = seeds[k].setdefault(field, np.zeros((len(self.ways), *shape)))
                seed[(j, *way.at)] = 1.0
        try:
            self.made = varied(self.wiring, self.given, seeds, len(self.ways))
            NativeDiagram(self.made.wiring)
        except Unread as error:
            raise SimulationError(f"{self.name}: has no known derivative: {error}") from None
        blocks = [node.system for node in self.wiring.nodes]
        self.doubtful = [  # blocks in which something may jump
            block.name
            for block, seed in zip(blocks, seeds, strict=True)
            if may_jump(block) or (seed and block.breakpoints_function is not None)
        ]

    @property
    def values(self) -> np.ndarray:
        """What is varied, as it was given."""
        return np.array([
            self.start[way.state] if way.state >= 0
            else getattr(self.given[way.fields[0][0]], way.fields[0][1])[way.at]
            for way in self.ways
        ])  # fmt: skip

    def run(self, values: np.ndarray, **solver: Any) -> Varying:
        """Run with other values of what is varied."""
        start, changed = self.start.copy(), dict[tuple[int, str], Any]()
        for way, value in zip(self.ways, values, strict=True):
            if way.state >= 0:
                start[way.state] = value
            for place in way.fields:
                k, field = place
                own = changed.setdefault(place, np.array(getattr(self.given[k], field)))
                own[way.at] = value
        nodes, varied_fields = self.made.wiring.nodes, {field for _, field in changed}
        params = {  # of all blocks that have such a field: a short name would reach several
            f"{node.name}.{field}": changed.get((k, field), getattr(self.given[k], field))
            for k, node in enumerate(nodes)
            for field in varied_fields.intersection(node.system.parameters._fields)
        }
        runner = NativeDiagram(self.made.wiring, params)
        x = np.zeros(self.made.states.size)
        x[self.made.states[0]] = start
        for j, way in enumerate(self.ways):
            if way.state >= 0:
                x[self.made.states[1 + j, way.state]] = 1.0
        solution = runner.run(x, self.times, inputs=self.inputs, **{**self.solver, **solver})
        signals = runner.signals(solution, self.inputs)
        if found := difference(runner, solution, signals, self.inputs):
            raise SimulationError(f"{self.name}: its derivative is not known: {found}")
        every = signals[:, self.made.signals]  # (nt, 1 + ways, signals)
        u = np.zeros((len(solution.t), every.shape[1], self.wiring.ninputs))
        u[:, 0] = self.inputs.along(solution.t).T
        made = np.concatenate([every, u], axis=2).transpose(2, 1, 0)
        outputs = np.array([self.wiring.output_map @ made[:, j] for j in range(made.shape[1])])
        outputs = outputs.transpose(2, 1, 0)[self.skipped :]
        states = solution.x[:, self.made.states].transpose(0, 2, 1)[self.skipped :]
        solution = replace(solution, t=solution.t[self.skipped :], x=states[..., 0])
        return Varying(solution, outputs[..., 0], outputs[..., 1:], states[..., 1:])

    def check(self, values: np.ndarray, found: Varying) -> None:
        """Refuse what differences do not confirm, where a function may jump."""
        if not self.doubtful or not self.ways:
            return
        solver = {} if self.wiring.dt else EXACT
        size = np.where(values == 0.0, 1.0, np.abs(values))
        size *= np.random.default_rng(0).choice([-1.0, 1.0], len(size))
        along = np.concatenate([found.along, found.states], axis=1) @ size
        largest = np.abs(along).max(axis=0)
        wrong = []
        for h in STEPS:
            (more, x_more), (less, x_less) = (
                (run.outputs, run.solution.x)
                for run in (self.run(values + step * size, **solver) for step in (h, -h))
            )
            n = min(len(more), len(less), len(along))
            moved = np.concatenate([more[:n] - less[:n], x_more[:n] - x_less[:n]], axis=1)
            level = 10 * EXACT["rtol"] / h * np.abs(np.concatenate([more, x_more], axis=1)).max(0)
            off = np.abs(moved / (2.0 * h) - along[:n]) > CLOSE * largest + level
            wrong.append(off.sum(axis=0) > max(1, SHARE * n))
        if np.any(np.logical_and(*wrong)):
            worst = [*self.labels, *self.states][int(np.argmax(np.logical_and(*wrong)))]
            raise SimulationError(
                f"{worst}: differences of runs do not confirm its derivative, for a function jumps "
                f"where the run crosses something that moves with what is varied (look in "
                f"{', '.join(self.doubtful)}); make the jump steep but smooth, such as np.tanh"
            )


@public
def sensitivity(
    system: Scenario | control.InputOutputSystem,
    timepts: Sequence[float] | np.ndarray,
    of: str | Sequence[str] | None = None,
    to: str | Sequence[str] = START,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
    progress: Callable[[float], None] | None = None,
) -> "xarray.Dataset":
    """Differentiate a run by parameters and by its start.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        A scenario, a diagram, a block or a system of python-control, of continuous or discrete
        time.
    timepts : array_like
        Times of the samples, increasing.
    of : str or sequence of str, optional
        Output ports, ``"e"``, or signals, ``"e[0]"``; ``"states"`` are all states. All without.
    to : str or sequence of str, optional
        Parameters by their call-time names, ``"adaptation.gain"``, of an array all elements or
        one, ``"plant.A[0,1]"``; states of the start by their labels, or ``"x0"`` for all.
    inputs, initial_state, params, rtol, atol, method, progress
        As `simulate` takes them; inputs are samples or numbers.

    Returns
    -------
    xarray.Dataset
        A variable for each port, with a last dimension ``parameter``: its derivative by each, in
        the port's unit over the parameter's.

    Raises
    ------
    SimulationError
        If a name is unknown, a derivative is not known, or the run cannot go on. Where a function
        jumps as a state crosses something, the derivative has a term that is not computed:
        differences of four more runs then decide whether it counts.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> decay = control.nlsys(lambda t, x, u, p: [-p["k"] * x[0]], name="decay",
    ...                       inputs=0, states=["y"], outputs=["y"], params={"k": 2.0})
    >>> found = clpt.sensitivity(decay, [0.0, 0.5, 1.0], to=["k", "x0"], initial_state=[3.0])
    >>> found.y.sel(parameter="k").values[1:].round(6)  # -t x0 exp(-k t)
    array([-0.551819, -0.406006])
    """
    times = checked_times("timepts", timepts)
    solver = {"rtol": rtol, "atol": atol, "method": method, "progress": progress}
    ready = Sensitive(system, times, to, inputs, initial_state, params, **solver)
    found = ready.run(ready.values)
    ready.check(ready.values, found)
    return dataset_of(ready, found, of)


def dataset_of(
    ready: Sensitive, found: Varying, of: str | Sequence[str] | None
) -> "xarray.Dataset":
    """Return the derivatives of ports, signals and states as a Dataset."""
    import xarray

    frame = diagram_frame(ready.name, *map(tuple, (ready.labels, ready.units, ready.states)))
    each = [
        frame.filled(replace(found.solution, x=found.states[..., j]), found.along[..., j])
        for j in range(len(ready.ways))
    ]
    names = xarray.Variable("parameter", [way.name for way in ready.ways])
    every = xarray.concat(each, names, combine_attrs="override").transpose(..., "parameter")
    every.attrs["title"] = f"Sensitivities of {ready.name}"
    for name, one in every.data_vars.items():
        one.attrs["long_name"] = f"derivative of {name} by each parameter"
        if unit := one.attrs.get("units"):
            one.attrs["units"] = f"{unit} per unit of the parameter"
    if of is None:
        return every
    chosen = {}
    for name in [of] if isinstance(of, str) else of:
        port = name.partition("[")[0]
        if name in every:
            chosen[name] = every[name]
        elif name in ready.labels and port in every:
            place = ports_of(ready.labels)[port].index(ready.labels.index(name))
            at = dict.fromkeys(every[port].dims[1:-1], place)
            chosen[name] = every[port].isel(at, drop=True)
        else:
            shown = ", ".join(map(str, every.data_vars))
            raise SimulationError(f"of = {name!r}: must be among {shown}, or a signal of them")
    return xarray.Dataset(chosen, attrs=every.attrs)
