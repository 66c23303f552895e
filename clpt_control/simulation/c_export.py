"""C99 source of a diagram in one file, for a microcontroller or another simulator.

The record of the diagram is printed as C (`c_text`): outputs, derivatives or the next state, a step
of the classical Runge-Kutta method of order 4 or of the diagram's own time, and updates of sampled
blocks between two steps.  The code allocates nothing and needs only math.h of the C library.
"""

import re
from collections.abc import Iterable, Iterator
from string import Template
from typing import Any

import numpy as np

from ..base.arguments import finite
from ..base.errors import DiagramError, Uncompiled
from ..base.html import asset
from ..engine.codegen.c_text import CProgram, CRecord, c_number
from ..engine.codegen.diagram_record import LARGE, lay_out
from ..engine.codegen.directional_derivatives import read_as_number
from ..engine.model.declaration import Each
from ..engine.model.ports import bare_labels
from .diagram_runs import CompiledRun, DiagramRun
from .requests import as_diagram, start_of

FIXED = " fixed"  # suffix of a parameter that must not change
MAX_NAME = 60  # characters of a name; C distinguishes 63
ROUNDING = "1e-6"  # tolerance of sample times, relative to a period
MOST_PARTS = 1000  # of the shortest period: the common period is no shorter
DIVIDES = " * dt must divide the periods at which blocks sample or jump.\n"
SECTIONS = map(Template, asset("diagram.c").split("//\n"))
HEAD, FILE, RUNGE_KUTTA, DISCRETE, JUMP, BEGINS, COUNTED, COUNT = SECTIONS
OPTIONAL = {  # fields that only some files fill
    **dict.fromkeys(("begins", "divides", "samples", "next"), ""),
    **dict.fromkeys(("counted", "count", "count_again"), ""),
    **dict.fromkeys(("u_middle", "u_end"), "u"),
}


def c_file(
    system: Any, initial_state: Any, params: Any, kind: type["CFile"] | None = None
) -> "CFile":
    """Return the C file of a diagram, or raise `DiagramError`.

    >>> import control
    >>> file = c_file(control.tf(1, [0.5, 1], name="lag"), None, None)
    >>> [line for line in file.text.splitlines() if line.startswith("void lag_step")]
    ['void lag_step(double t, double dt, double *x, const double *u, const double *p) {']
    """
    system, own_arguments = as_diagram(system)
    default_state = own_arguments.get("initial_state")
    try:
        run = CompiledRun(system, params)
        if kind is not None:
            refuse_levels(run)
        start = start_of(system, initial_state, default_state, run.runner.nstates)
        finite("initial_state", start)
        for name, value in (params or {}).items():
            # "block.high" may be infinite
            if "." not in name and np.asarray(value).dtype.kind == "f":
                finite(f"params: {name}", value)
        return (kind or CFile)(run, start)
    except Uncompiled as error:
        raise DiagramError(f"{system.name}: cannot be written as C: {error}") from None


def refuse_levels(run: DiagramRun) -> None:
    """Raise `DiagramError` if states jump at a level."""
    for name in run.runner.resetting:
        raise DiagramError(
            f"{name}: jumps at a level, which this file has not. Write the diagram as C"
        )


class CFile:
    """Sections of a C file: enums, functions, and updates of intervals and jumps."""

    def __init__(self, run: DiagramRun, start: np.ndarray):
        self.run = run
        self.wiring = run.wiring
        self.start = start
        self.parameters = run.runner.sweep.parameters
        # parameters have separate slots even if they are equal; long arrays are tables
        separate = {
            (k, field): k
            for k, parameters in enumerate(self.parameters)
            for field, value in parameters._asdict().items()
            if np.size(value) <= LARGE
        }
        self.layout = lay_out(self.wiring, self.parameters, separate, False)
        self.record = CRecord(self.wiring, self.layout)
        self.program = CProgram(self.record, run.runner.nsignals)
        self.name = _c_name(run.name)[:MAX_NAME]
        self.work_size = max(1, self.program.components.room)
        self.memory_size = max(1, len(self.record.set_by_integrator))
        self.labels = {
            "x": bare_labels(run.states),
            "u": bare_labels(run.input_labels),
            "y": bare_labels(run.output_labels),
        }
        self.periods = [(k, self._period_of(k)) for k in self.layout.intervals]
        # of a block's interval and of its jump in the memory between steps
        self.interval_index = {k: j for j, k in enumerate(self.layout.intervals)}
        first = len(self.interval_index)
        self.jump_index = {k: j for j, k in enumerate(self.layout.jumps, first)}
        self.rate, self.turns = self._counted()

    @property
    def text(self) -> str:
        """The file."""
        is_discrete = bool(self.wiring.dt)
        names, values = self.parameter_values()
        nstates = len(self.start)
        enums = [self._enum(key, labels) for key, labels in self.labels.items()]
        functions = [
            f"\n{self.program.function(name)}" for name in self.program.functions
        ]
        fields = {
            **OPTIONAL,
            "name": self.name,
            "title": _comment(self.run.name),
            "within": "t" if is_discrete else "t + 0.5 * dt",
            "kept": self.memory_size,
            "room": self.work_size,
            "states": nstates,
            "n": max(1, nstates),
            "rates": "the next state" if is_discrete else "dx/dt",
            "step": "one step of Runge and Kutta's method of order 4, inputs held",
            "enums": "".join([*enums, self._enum("p", names)]),
            "p0": _numbers(values),
            "x0": _numbers(self.start),
            "functions": "".join([*self.program.shared(self.layout.T), *functions]),
            "intervals": as_lines(self._intervals()),
            "outputs": as_lines(self.outputs()),
            "asked": as_lines(self.jump_tests()),
            "begin": as_lines(self._initial_samples()),
            "levels": self._level_line(),
            "some": " + ".join(
                f"after[{self.jump_index[k]}]" for k in self.layout.jumps
            ),
        }
        if self.turns:
            # whole intervals that the samples have counted
            intervals = as_lines(
                f"kept[{j}] = floor((n + 0.5) / ({turns} * steps));"
                for j, turns in self.turns.items()
            )
            fields["counted"] = COUNTED.substitute(intervals=intervals)
        return self.filled(fields)

    def filled(self, fields: dict[str, Any]) -> str:
        """Return the file from the fields of its templates."""
        endings = [RUNGE_KUTTA]
        if dt := self.wiring.dt:
            period = "" if dt is True else f", {float(dt):.12g}"
            fields["step"] = (
                f"one step of the diagram's own time{period}; dt is not used"
            )
            endings = [DISCRETE]
        elif self.turns:
            fields["count"] = COUNT.substitute(rate=self.rate)
            fields["count_again"] = "    counted_(n + 1.0, steps, after);\n"
        if self.layout.jumps:
            endings.append(JUMP)
            fields["begins"] = BEGINS.substitute(fields)
            fields["divides"] = "" if dt else DIVIDES
        fields["ending"] = "".join(ending.substitute(fields) for ending in endings)
        return HEAD.substitute(fields) + FILE.substitute(fields)

    def parameter_values(self) -> tuple[list[str], np.ndarray]:
        """Return the names of parameters in the order of the array, and their values."""
        names = {}
        for (k, field), (array, offset) in self.layout.slots.items():
            if array != "P" or offset in self.record.set_by_integrator:
                continue
            node = self.wiring.nodes[k]
            label = f"{node.name}.{field}"
            if read_as_number(node.system, field):
                label += FIXED
            shape = np.shape(getattr(self.parameters[k], field))
            for j, index in enumerate(np.ndindex(shape)):
                suffix = f"[{','.join(map(str, index))}]" if index else ""
                names[offset + j] = label + suffix
        listed = sorted(names)
        return [names[offset] for offset in listed], self.layout.P[listed]

    def _enum(self, letter: str, labels: list[str]) -> str:
        """Return an enum of names, and of their number."""
        words: list[str] = []
        for label in labels:
            word = base = f"{self.name}_{letter}_{_c_name(label)}"
            while word in words:
                word = f"{base}_{len(words)}"
            words.append(word)
        comments = map(_comment, labels)
        lines = [
            f"    {word},  /* {comment} */\n"
            for word, comment in zip(words, comments, strict=True)
        ]
        count = f"    {self.name}_n{letter} = {len(labels)}\n"
        return f"enum {{\n{''.join(lines)}{count}}};\n"

    def outputs(self) -> Iterator[str]:
        """Yield assignments of outputs from signals and inputs."""
        for k, row in enumerate(self.wiring.outputs):
            terms = []
            for column, gain in row.items():
                signal = f"w[{column}]" if column >= 0 else f"u[{~column}]"
                terms.append(signal if gain == 1.0 else f"{c_number(gain)} * {signal}")
            yield f"y[{k}] = {' + '.join(terms) or '0.0'};"
        yield "(void)u; (void)y;"

    def _intervals(self) -> Iterator[str]:
        """Yield assignments of the current interval of each block."""
        if self.turns:
            yield f"double n = floor(t * {self.rate} + {self._near});"
            yield "counted_(n, 1.0, kept);"
        for j, (k, period) in enumerate(self.periods):
            interval = c_number(float(self.parameters[k].interval))
            if j in self.turns:
                continue
            if period:
                interval = f"floor(t / ({period}) + {ROUNDING})"
            yield f"kept[{j}] = {interval};"
        for k in self.layout.jumps:
            yield f"kept[{self.jump_index[k]}] = 0.0;"

    @property
    def _near(self) -> str:
        """Rounding of a time, as a share of the common period."""
        spacing = "(nextafter(fabs(t), INFINITY) - fabs(t))"
        return f"fmin(0.5, {ROUNDING} + 1.5 * {self.rate} * {spacing})"

    def _counted(self) -> tuple[str, dict[int, str]]:
        """Return the rate of a common period, and how many of it the period of each block has.

        Whole numbers of them tell samples apart where times are rounded to float.
        """
        lengths = {}
        for j, (k, _) in enumerate(self.periods):
            breakpoints = self.wiring.nodes[k].system.breakpoints_function
            is_counted = self.parameters[k].interval < 0.0
            if is_counted and not isinstance(breakpoints.period, str):
                lengths[j] = breakpoints.part * breakpoints.period
        shortest = min(lengths.values(), default=1.0)
        for parts in range(1, MOST_PARTS):
            turns = {j: length / shortest * parts for j, length in lengths.items()}
            if all(abs(n - round(n)) < 1e-9 * n for n in turns.values()):
                rate = parts / shortest
                rate = round(rate) if abs(rate - round(rate)) < 1e-9 * rate else rate
                turns_of = {j: c_number(float(round(n))) for j, n in turns.items()}
                return c_number(float(rate)), turns_of
        return "", {}

    def _period_of(self, k: int) -> str:
        """Return the period of a block's intervals; "" if its interval is fixed."""
        node = self.wiring.nodes[k]
        breakpoints = node.system.breakpoints_function
        if self.parameters[k].interval >= 0.0:
            return ""
        if not isinstance(breakpoints, Each):
            raise Uncompiled(
                f"{node.name} jumps at times that a function of Python says; C knows "
                "multiples of a period, clpt.Sampled or Each"
            )
        if isinstance(breakpoints.period, str):
            slot = self.layout.slots[k, breakpoints.period]
            period = f"p[{self.record.place(slot.offset)}]"
        else:
            period = c_number(float(breakpoints.period))
        if breakpoints.part == 1.0:
            return period
        return f"{c_number(breakpoints.part)} * {period}"

    def jump_tests(self) -> list[str]:
        """Return assignments that test if a block jumps: its interval has changed."""
        levels = [*self.record.levels]
        lines = []
        if levels:
            lines.append(f"double level[{len(levels)}];")
            lines.append("levels_(t + dt, x, u, p, after, level);")
        for k in self.layout.jumps:
            tests = []
            if (j := self.interval_index.get(k)) is not None:
                tests.append(f"after[{j}] != kept[{j}]")
            if k in levels:
                tests.append(f"level[{levels.index(k)}] < 0.0")
            lines.append(f"after[{self.jump_index[k]}] = {' || '.join(tests)};")
        return lines

    def _level_line(self) -> str:
        """Return a line of the head on blocks that jump at a level."""
        names = [self.wiring.nodes[k].name for k in self.record.levels]
        if not names:
            return ""
        listed = _comment(", ".join(names))
        return f" * States of {listed} jump at the end of the step that passes their level.\n"

    def _initial_samples(self) -> Iterator[str]:
        """Yield tests if a sampled block samples at the start of a run."""
        for k in self.layout.jumps:
            block = self.wiring.nodes[k].system
            if block.first_held is not None:
                turns = f"t / {c_number(block.period)}"
                test = f"fabs({turns} - floor({turns} + 0.5)) < {ROUNDING}"
                if turn_count := self.turns.get(self.interval_index[k]):
                    count = f"floor(t * {self.rate} + 0.5)"
                    test = f"fabs(t * {self.rate} - {count}) <= {self._near}"
                    test = f"{test} && fmod({count}, {turn_count}) == 0.0"
                yield f"kept[{self.jump_index[k]}] = {test} ? -1.0 : 0.0;"


def as_lines(lines: Iterable[str], begin: str = "    ") -> str:
    """Return the lines of a function, or of a comment that begin with " * "."""
    return "".join(f"{begin}{line}\n" for line in lines)


def _c_name(text: str) -> str:
    """Return a text as an identifier of C."""
    word = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_")
    return word if word[:1].isalpha() else f"n{word}"


def _comment(text: str) -> str:
    """Return a text that is safe in a comment of C."""
    return " ".join(text.replace("*/", "* /").replace("/*", "/ *").split())


def _numbers(values: Iterable[float]) -> str:
    return ", ".join(map(c_number, values)) or "0.0"
