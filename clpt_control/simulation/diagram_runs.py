"""Prepared runs of wired systems: blocks, their engine and the template of their Dataset.

A prepared run integrates its system, computes all signals, and returns them as an
`xarray.Dataset` with names, units and attributes.  A `DiagramRun` has any blocks, also systems of
python-control without change.  The Dataset of a `closed_loop` has the variables of its scenario's
run; that of any other diagram has a variable for each port.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.errors import SimulationError
from ..base.run_attributes import LABELS, MOST_BYTES, OWN_PARTS, REFERENCE
from ..engine.diagram.block_numbers import call_names
from ..engine.diagram.interconnection import with_stop
from ..engine.diagram.wiring import (
    Params,
    Sizes,
    Wiring,
    read_anew,
    units_of,
    wiring_of,
)
from ..engine.model.ports import ports_of, whole_labels
from ..engine.model.sampled import Sampled
from ..engine.solver.engine_choice import (
    make_runner,
    run_compared,
    run_in_python,
    warn_python,
)
from ..engine.solver.inputs import Inputs
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.runner import Runner, RunOptions
from ..engine.solver.termination import Solution
from .dataset_template import DatasetTemplate, Signals, diagram_template

if TYPE_CHECKING:
    import xarray

    from .loops import ClosedLoop
    from .requests import Request

COPIES = 4  # copies of each number in memory during a run, measured


class SystemRun:
    """A wired system that is ready to run."""

    initial_state: np.ndarray  # of a scenario
    template: Any  # a `DatasetTemplate`
    scenario: Any = None  # of a single vehicle

    def __init__(
        self,
        name: str,
        wiring: Wiring,
        params: Any,
        engine: str | None,
        varied: Sequence[str] = (),
    ):
        self.name = name
        self.wiring = wiring
        self.params = params
        self.runner = self.made_runner(engine, varied)

    def made_runner(self, engine: str | None, varied: Sequence[str]) -> Runner:
        """Return the engine of this system."""
        varied_fields = fields_of(self.wiring, varied)
        return make_runner(self.wiring, engine, self.name, varied_fields)

    @property
    def labels(self) -> list[str]:
        """The labels of all signals."""
        blocks = [node.system for node in self.wiring.nodes]
        return [
            label for block in blocks for label in whole_labels(block.output_labels)
        ]

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of each block, by name."""
        names = [node.name for node in self.wiring.nodes]
        return dict(zip(names, self.runner.sweep.parameters, strict=True))

    def signals(self, labels: list[str]) -> Signals:
        """Return the columns of labelled signals, and the parameters of the blocks."""
        return Signals({label: k for k, label in enumerate(labels)}, self.parameters)

    @cached_property
    def max_speed(self) -> float | None:
        """The largest speed of a single vehicle, units.length per units.time, or None."""
        return getattr(self.parameters.get("speed_limit"), "max_speed", None)

    def check_memory(self, samples: int) -> None:
        """Raise `SimulationError` if the samples would not fit into memory."""
        numbers = self.runner.nstates + self.runner.nsignals
        size = 8 * COPIES * numbers * samples
        if size > MOST_BYTES:
            raise SimulationError(
                f"timepts: {samples} samples of {numbers} states and signals would take "
                f"{size / 1e9:.3g} GB of memory; at most {MOST_BYTES / 1e9:g} are allowed: give "
                "fewer times, or a smaller system"
            )

    def run(
        self,
        start: np.ndarray,
        times: np.ndarray,
        inputs: Inputs,
        options: RunOptions,
        runner: Runner | None = None,
        is_compared: bool = True,
    ) -> tuple[Solution, np.ndarray]:
        """Integrate; return the solution and all signals along it.

        Where machine code has misread a function, the system runs in Python.
        """
        self.check_memory(len(times))
        runner = runner or self.runner
        request = start, times, inputs, options
        if isinstance(runner, NativeDiagram):
            solution, why = run_compared(runner, *request, is_compared)
            if not why:
                return solution, runner.signals(solution, inputs)
            self.leave_machine_code(why)
            from ..engine.solver.python_diagram import PythonDiagram

            parameters = runner.block_parameters
            runner = PythonDiagram(self.wiring).with_parameters(parameters)
        return run_in_python(runner, self.name, *request)

    def leave_machine_code(self, why: str) -> None:
        """Warn that the system runs in Python."""
        warn_python(self.name, why)

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution and its signals with names, units and attributes."""
        return self.template.filled(solution, signals)


class DiagramRun(SystemRun):
    """A diagram of any blocks, ready to run; parameters in `varied` differ from run to run."""

    complete = True  # the numbers of its blocks; their rules are checked

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        params: Params,
        sizes: Sizes = (None, None),
        engine: str | None = None,
        stop: Callable | None = None,
        varied: Sequence[str] = (),
    ):
        read_anew(diagram)
        self.diagram = diagram
        self.loop: ClosedLoop | None = getattr(diagram, "origin", None)
        self.scenario = self.loop and self.loop.scenario
        wiring = wiring_of(diagram, params, sizes, self.complete)
        if stop is not None:
            wiring = with_stop(wiring, stop, *labels_of(diagram, wiring)[:2])
        outputs, inputs, self.states = labels_of(diagram, wiring)
        super().__init__(diagram.name, wiring, params and dict(params), engine, varied)
        ports = {"inputs": inputs, "outputs": outputs, "states": self.states}
        self.names = {"name": self.name, **ports}
        self.output_labels = whole_labels(outputs)
        self.input_labels = distinct_labels(inputs, self.output_labels)

    def solve(
        self, request: "Request", runner: Runner | None = None, is_compared: bool = True
    ) -> tuple[Solution, np.ndarray]:
        """Integrate; return the solution, and the diagram's outputs and inputs along it."""
        if self.loop is not None:
            from .initial_states import check_initial_alpha

            check_initial_alpha(self, request.start)
        arguments = request.start, request.times, request.inputs, request.options
        solution, signals = self.run(*arguments, runner, is_compared)
        if request.steps is not None:
            steps = request.steps[request.steps < len(solution.t)]
            solution = replace(solution, t=solution.t[steps], x=solution.x[steps])
            signals = signals[steps]
        u = request.inputs.along(solution.t).T if self.wiring.ninputs else None
        if not self._outputs_are_signals:
            signals = self.wiring.outputs_of(signals, u)
        return solution, signals if u is None else np.hstack([signals, u])

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution, outputs and inputs with names, units and attributes."""
        run = super().dataset(solution, signals)
        if self.loop is not None and {"x", "zc"} <= {*self.loop.external}:
            from .flows import unlike_controller

            sentence = unlike_controller(run, self.loop.scenario)
            run.attrs["message"] += sentence and f"; {sentence}"
        run.encoding[LABELS] = self.names
        return run

    @cached_property
    def is_unchanged(self) -> bool:
        """True for a loop as `closed_loop` returned it."""
        loop: Any = self.loop
        return not loop.external and loop.is_unchanged(wiring_of(self.diagram))

    @property
    def beyond_scenario(self) -> dict[str, str]:
        """Attributes of a closed loop's run for changes that are not in its scenario."""
        loop: Any = self.loop
        external = f"{REFERENCE}: from outside" if "zc" in loop.external else ""
        changes = [loop.changes.description, external, f"{self.name}: run as a diagram"]
        return {OWN_PARTS: ", ".join(filter(None, changes))}

    @cached_property
    def _outputs_are_signals(self) -> bool:
        """True if the outputs are all outputs of blocks, in their order."""
        all_signals = range(self.runner.nsignals)
        return self.wiring.outputs == tuple({column: 1.0} for column in all_signals)

    @property
    def _held(self) -> frozenset[int]:
        """The outputs that are those of sampled blocks."""
        systems = [node.system for node in self.wiring.nodes]
        held = [isinstance(s, Sampled) for s in systems for _ in range(s.noutputs)]
        rows = enumerate(self.wiring.outputs)
        return frozenset(k for k, row in rows if all(j >= 0 and held[j] for j in row))

    @cached_property
    def template(self) -> DatasetTemplate:
        """The template of the Dataset."""
        labels = self.output_labels + self.input_labels
        units = signal_units(self.wiring)
        if self.loop is None:
            texts = map(tuple, (labels, units, self.states))
            return diagram_template(self.name, *texts, self._held)

        from .dataset import changed_parameters, scenario_template

        attributes = changed_parameters(self.params, self.loop.beyond_scenario)
        ports = {port: units[columns[0]] for port, columns in ports_of(labels).items()}
        return scenario_template(
            self.loop.scenario, self.signals(labels), attributes, ports, self.states
        )


class CompiledRun(DiagramRun):
    """A diagram in machine code; one that cannot be compiled raises `Uncompiled`."""

    def made_runner(self, engine: str | None, varied: Sequence[str]) -> Runner:
        """Return the machine code."""
        return NativeDiagram(self.wiring)


def fields_of(
    wiring: Wiring, names: Sequence[str]
) -> dict[tuple[int, str], tuple[str, ...]]:
    """Return the parameters of blocks, (block, field), that call-time names change, with these."""
    fields: dict[tuple[int, str], tuple[str, ...]] = {}
    for k, (name, block) in enumerate(wiring.blocks):
        called = call_names(name, block)
        for key in names:
            if key in called:
                field = k, called[key]
                fields[field] = (*fields.get(field, ()), key)
    return fields


def distinct_labels(
    labels: list[str], outputs: list[str], suffix: str = "_input"
) -> list[str]:
    """Return labels; a port with the name of an output port gets a suffix."""
    ports = (output.rpartition("[")[0] for output in outputs)
    return whole_labels(labels, {port: port + suffix for port in ports})


def labels_of(diagram: Any, wiring: Wiring) -> tuple[list[str], list[str], list[str]]:
    """Return the labels of outputs, inputs and states; open sizes are those of its block."""
    block = wiring.nodes[0].system
    has_open_ports = None in (diagram.ninputs, diagram.noutputs)
    labelled = block if has_open_ports else diagram
    states = (block if diagram.nstates is None else diagram).state_labels
    if len(states) != wiring.nodes[-1].states.stop:
        # python-control has a single label of several equal ones
        states = state_labels(wiring)
    return labelled.output_labels, labelled.input_labels, states


def state_labels(wiring: Wiring) -> list[str]:
    """Return the names of all states in python-control's form, block_state."""
    nodes = [(node.name.replace(".", "_"), node.system) for node in wiring.nodes]
    return [
        f"{name}_{label}" for name, system in nodes for label in system.state_labels
    ]


def signal_units(wiring: Wiring) -> list[str]:
    """Return the units of outputs, then of inputs; "" for a sum of signals."""
    block_units, input_units = units_of(wiring)

    def unit_of(row: Mapping[int, float]) -> str:
        if [*row.values()] != [1.0]:
            return ""
        (column,) = row
        return block_units[column] if column >= 0 else input_units[~column]

    return [unit_of(row) for row in wiring.outputs] + input_units
