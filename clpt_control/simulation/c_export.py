"""A diagram as one file of C99, for a board or another simulator.

What runs here as machine code is printed as C (`c_text`): outputs, rates or the next state,
a step of Runge and Kutta's method of order 4 or of the diagram's own time, and what sampled parts
do between two steps.  Nothing is allocated, and of the C library only math.h is used.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from importlib import resources
from pathlib import Path
from string import Template
from typing import Any

import control
import numpy as np

from ..base.arguments import public
from ..base.errors import DiagramError, Uncompiled
from ..base.files import write_file
from ..engine.codegen.c_text import CProgram, CRecord, c_number
from ..engine.codegen.diagram_record import LARGE, lay_out
from ..engine.codegen.directional_derivatives import read_as_number
from ..engine.model.declaration import Each
from ..engine.model.ports import ports_of
from ..engine.solver.engine_choice import beside, misread_function
from ..paper.scenario.experiment import Scenario
from .diagram_runs import DiagramRun, compiled
from .initial_states import stacked_state
from .integrate import as_diagram

FIXED = " fixed"
LONGEST = 60  # letters of a name in C, of which 63 count
# of a period, by which a time may be off a sample; in a step, half of it
ROUNDING = "1e-6"
PARTS = (
    (resources.files("clpt_control.data") / "diagram.c")
    .read_text("utf-8")
    .split("//\n")
)
# and ends of a step of each kind
FILE, RUNGE_KUTTA, DISCRETE, JUMP, BEGINS = map(Template, PARTS)


@public
def export_c(
    system: Scenario | control.InputOutputSystem,
    path: str | Path | None = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
) -> str:
    """Write a diagram as one self-contained file of C99.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        A scenario, a diagram, a block or a system of python-control.
    path : str or Path, optional
        The file; without it nothing is written.
    initial_state : array_like, optional
        The state that the file has as its start; without, a scenario's own, or that of the run
        that `load_diagram` read.
    params : mapping, optional
        Call-time parameters that the file has as its own.

    Returns
    -------
    str
        The text, which says in its head how it is called. Names of states, inputs, outputs and
        parameters are enums; parameters are an array that the caller may change.

    Raises
    ------
    DiagramError
        If a function is not read, or a block jumps at times that only a function of Python knows.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> text = clpt.export_c(control.tf(1, [0.5, 1], name="lag"))
    >>> [line for line in text.splitlines() if line.startswith("void lag_step")]
    ['void lag_step(double t, double dt, double *x, const double *u, const double *p) {']
    """
    text = c_file(system, initial_state, params).text
    if path is not None:
        write_file(path, text)
    return text


def c_file(system: Any, initial_state: Any, params: Any) -> "CFile":
    """Return a diagram's C; one that has none is an error."""
    system, known = as_diagram(system)
    own = known.get("initial_state", 0.0) if initial_state is None else initial_state
    try:
        run = compiled(system, params)
        start = stacked_state("initial_state", own, run.runner.nstates)
        numbers = {f"params: {name}": value for name, value in (params or {}).items()}
        for node, given in zip(
            run.wiring.nodes, run.runner.sweep.parameters, strict=True
        ):
            for (
                name,
                value,
            ) in given._asdict().items():  # which may have no limit, an infinite one
                numbers[f"{node.name}.{name}"] = np.where(np.isinf(value), 0.0, value)
        for name, value in {**numbers, "initial_state": start}.items():
            if (one := np.asarray(value)).dtype.kind == "f" and not np.isfinite(
                one
            ).all():
                raise DiagramError(
                    f"{name} = {value}: must be finite, to be written as C"
                )
        return CFile(run, start)
    except Uncompiled as error:
        raise DiagramError(f"{system.name}: has no C: {error}") from None


class CFile:
    """The parts of a file of C."""

    def __init__(self, run: DiagramRun, start: np.ndarray):
        self.run, self.wiring, self.start = run, run.wiring, start
        sweep = run.runner.sweep
        sweep.enter(0.0)
        for x in (start, *beside(start)):
            sweep.derivative(0.0, x)
            if not (found := misread_function(run.runner, 0.0, x)):
                break
        else:
            raise Uncompiled(found)
        sweep.derivative(0.0, start)
        self.given = sweep.parameters
        fields = (
            (k, *one) for k, p in enumerate(self.given) for one in p._asdict().items()
        )
        # of equal ones too; long arrays are tables
        apart = {(k, field): k for k, field, value in fields if np.size(value) <= LARGE}
        self.layout = lay_out(self.wiring, self.given, apart)
        self.record = CRecord(self.wiring, self.layout)
        self.program = CProgram(self.record, run.runner.nsignals)
        self.name = _word(run.name)[:LONGEST]
        self.room = max(1, self.program.components.room)
        self.kept = max(1, len(self.record.set_by_integrator))
        outputs, ports = len(self.wiring.outputs), run.signal_labels
        u, y = _labels(ports[outputs:]), _labels(ports[:outputs])
        self.labels = {"x": _labels(run.states), "u": u, "y": y}
        self.periods = [(k, self.period_of(k)) for k in self.layout.intervals]

    @property
    def text(self) -> str:
        """The text."""
        discrete, jumping = bool(self.wiring.dt), bool(self.layout.jumps)
        (named, values), states = self.parameters(), len(self.start)
        enums = [
            self.enum(letter, own, len(own)) for letter, own in self.labels.items()
        ]
        functions = [
            f"\n{self.program.function(name)}" for name in self.program.functions
        ]
        fields: dict[str, Any] = {
            **{
                "name": self.name,
                "title": _comment(self.run.name),
                "within": "t + 0.5 * dt",
            },
            **{
                "kept": self.kept,
                "room": self.room,
                "states": states,
                "n": max(1, states),
            },
            "rates": "dx/dt",
            "step": "one step of Runge and Kutta's method of order 4, inputs held",
            "enums": "".join([*enums, self.enum("p", named, len(values))]),
            **{"p0": _numbers(values), "x0": _numbers(self.start)},
            "functions": "".join([*self.program.shared(self.layout.T), *functions]),
            **{
                "intervals": as_lines(self.intervals()),
                "outputs": as_lines(self.outputs()),
            },
            **{"asked": as_lines(self.asked()), "begin": as_lines(self.sampling())},
            "some": " + ".join(f"after[{self.place(k)}]" for k in self.layout.jumps),
        }
        if discrete:
            step = "one step of the diagram's own time; dt is not used"
            fields |= {"rates": "the next state", "step": step, "within": "t"}
        ending = [DISCRETE if discrete else RUNGE_KUTTA, *([JUMP] if jumping else [])]
        fields["ending"] = "".join(part.substitute(fields) for part in ending)
        fields["begins"] = BEGINS.substitute(fields) if jumping else ""
        return FILE.substitute(fields)

    def parameters(self) -> tuple[list[str], np.ndarray]:
        """Return the names of parameters by place, and their values."""
        named = {}
        for (k, field), (array, first) in self.layout.slots.items():
            if array == "P" and first not in self.record.set_by_integrator:
                label = f"{self.wiring.nodes[k].name}.{field}"
                if read_as_number(self.wiring.nodes[k].system, field):
                    label += FIXED
                at = self.record.place(first)
                shape = np.shape(getattr(self.given[k], field))
                for j, place in enumerate(np.ndindex(shape)):
                    named[at + j] = (
                        f"{label}[{','.join(map(str, place))}]" if place else label
                    )
        values = np.delete(self.layout.P, self.record.set_by_integrator)
        return [named[at] for at in sorted(named)], values

    def enum(self, letter: str, labels: list[str], count: int) -> str:
        """Return an enum of names, with their number."""
        words: list[str] = []
        for label in labels:
            word = own = f"{self.name}_{letter}_{_word(label)}"
            while word in words:
                word = f"{own}_{len(words)}"
            words.append(word)
        named = zip(words, map(_comment, labels), strict=True)
        lines = [f"    {word},  /* {label} */\n" for word, label in named]
        return f"enum {{\n{''.join(lines)}    {self.name}_n{letter} = {count}\n}};\n"

    def outputs(self) -> Iterator[str]:
        """Yield what outputs are of signals and inputs."""
        for k, row in enumerate(self.wiring.outputs):
            terms = [
                (f"w[{at}]" if at >= 0 else f"u[{~at}]", gain)
                for at, gain in row.items()
            ]
            parts = [
                one if gain == 1.0 else f"{c_number(gain)} * {one}"
                for one, gain in terms
            ]
            yield f"y[{k}] = {' + '.join(parts) or '0.0'};"
        yield "(void)u; (void)y;"

    def intervals(self) -> Iterator[str]:
        """Yield what says in which interval each block is."""
        for j, (k, period) in enumerate(self.periods):
            fixed = c_number(float(self.given[k].interval))
            reckoned = f"floor(t / ({period}) + {ROUNDING})" if period else fixed
            yield f"kept[{j}] = {reckoned};"
        for k in self.layout.jumps:
            yield f"kept[{self.place(k)}] = 0.0;"

    def period_of(self, k: int) -> str:
        """Return the period of a block that has intervals; "" where its interval is fixed."""
        node, each = (
            self.wiring.nodes[k],
            self.wiring.nodes[k].system.breakpoints_function,
        )
        if self.given[k].interval >= 0.0:
            return ""
        if not isinstance(each, Each):
            raise Uncompiled(
                f"{node.name} jumps at times that a function of Python says; C knows "
                "multiples of a period, clpt.equations.Sampled or Each"
            )
        if isinstance(each.period, str):
            period = f"p[{self.record.place(self.layout.slots[k, each.period].offset)}]"
        else:
            period = c_number(float(each.period))
        return period if each.part == 1.0 else f"{c_number(each.part)} * {period}"

    def place(self, k: int) -> int:
        """Return where it stands whether a block jumps."""
        return len(self.layout.intervals) + list(self.layout.jumps).index(k)

    def asked(self) -> list[str]:
        """Return what asks of each block whether it jumps."""
        at = {k: j for j, k in enumerate(self.layout.intervals)}
        return [
            f"after[{self.place(k)}] = after[{at[k]}] != kept[{at[k]}];"
            for k in self.layout.jumps
        ]

    def sampling(self) -> Iterator[str]:
        """Yield what asks of each block, as a run begins, whether it samples."""
        for k in self.layout.jumps:
            block = self.wiring.nodes[k].system
            if block.first_held is not None:
                turns = f"t / {c_number(block.period)}"
                off = f"fabs({turns} - floor({turns} + 0.5))"
                yield f"kept[{self.place(k)}] = {off} < {ROUNDING} ? -1.0 : 0.0;"


def as_lines(lines: Iterable[str]) -> str:
    """Return lines of a function."""
    return "".join(f"    {line}\n" for line in lines)


def _word(text: str) -> str:
    """Return a name as C takes it."""
    word = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_")
    return word if word[:1].isalpha() else f"n{word}"


def _comment(text: str) -> str:
    """Return a name as it may stand in a comment of C."""
    return " ".join(text.replace("*/", "* /").replace("/*", "/ *").split())


def _labels(given: Sequence[str]) -> list[str]:
    """Return labels, of a port of one signal its name."""
    ports = ports_of(given)
    alone = {f"{port}[0]": port for port, places in ports.items() if len(places) == 1}
    return [alone.get(label, label) for label in given]


def _numbers(values: Iterable[float]) -> str:
    return ", ".join(map(c_number, values)) or "0.0"
