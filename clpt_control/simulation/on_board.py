"""C99 source of the learner alone, for the computer on board of a vehicle.

The learner is the adaptive law with all blocks of the closed loop that it reads: model, controller,
basis functions, waypoints.  Positions, fixes and velocities come from outside.  Samples and jumps
happen at the beginning of a step, with the inputs of that time.  A law at fixes jumps when the
caller says so: its interval is fixed, and its input `taken` is 1.
"""

import re
from collections.abc import Iterator, Sequence
from importlib import resources
from string import Template
from typing import Any

import numpy as np

from ..base.errors import ClptError, DiagramError
from ..base.html import asset
from ..base.units import at_least
from ..engine.diagram.interconnection import Diagram, connect
from ..engine.diagram.wiring import input_ports, output_ports
from ..engine.model.ports import counts_of
from ..paper.blocks.ports import POWERS, paper_block
from ..paper.laws.fix_bound import largest_gain
from ..paper.scenario.experiment import Scenario
from .c_export import FILE, RUNGE_KUTTA, CFile, as_lines, c_file
from .dataset import unit_of
from .loop_blocks import changed_blocks
from .loops import ClosedLoop

HEAD, FIXES, MIDDLE, SAMPLES, FIX = map(Template, asset("learner.c").split("//\n"))
THEOREMS = resources.files("clpt_control") / "theory" / "coq"
INPUTS = {  # of learners, and their meaning
    "x": "measured position",
    "fix": "position of the fix, read when it arrives",
    "v_x": "velocity through the water, as flown",
    "v_c": "velocity through the water, as commanded",
    "flow_x": "true flow at the vehicle",
    "zc": "desired position",  # if it is an external port of the loop
}


def learner_file(
    system: Any, name: str, initial_state: Any, params: Any, watch: Sequence[Any]
) -> CFile:
    """Return the C file of the learner of a scenario or of a closed loop."""
    loop = getattr(system, "origin", None)
    if isinstance(system, Scenario):
        loop = ClosedLoop(system)
    if loop is None:
        raise DiagramError(
            f"{system.name}: has no learner. Give a scenario, or a closed_loop of one"
        )
    scenario = loop.scenario
    diagram = learner(loop, name, watch)
    # the loop's numbers of blocks that the learner has
    diagram.params |= {
        key: value
        for key, value in getattr(system, "params", {}).items()
        if key.partition(".")[0] in diagram.params
    }
    if watch and (params or any("." in key for key in diagram.params)):
        raise ClptError(
            "watch: has the numbers of its gramian, not those of params. Give them in the scenario"
        )
    if scenario.learning.row.at_fixes:
        if scenario.localization.latency > 0:
            raise DiagramError(
                "localization.latency: no learner on board jumps twice for a fix. Set it to 0, "
                "and see docs/on_board.md for late fixes"
            )
        params = {**(params or {}), "adaptation.interval": 0.0}
    return c_file(diagram, initial_state, params, LearnerFile)


def received(t, x, u, p):
    """taken = 1: a fix of x of Eq. (1) arrives when the caller says so."""
    return {"taken": 1.0}


def learner(loop: ClosedLoop, name: str, watch: Sequence[Any]) -> Diagram:
    """Wire the law, blocks that watch it, and all that they read, up to the ports from outside."""
    blocks = [*changed_blocks(loop.scenario, loop.changes, loop.external), *watch]
    outside = {*INPUTS, *loop.external} - ({"zc"} - {*loop.external})
    makers = {port: block for block in blocks for port in output_ports(block)}
    makers["taken"] = paper_block("received", "-> taken", output=received)
    parts = [makers["alpha"], *watch]
    read: set[str] = set()
    for block in parts:
        ports = input_ports(block).keys()
        read |= ports
        if unknown := ports - outside - makers.keys():
            raise ClptError(
                f"watch: no block makes {', '.join(sorted(unknown))}. Give all of `watch` of the "
                "gramian of this learner"
            )
        parts += [makers[port] for port in ports - outside if makers[port] not in parts]
    inputs = dict.fromkeys([*INPUTS, *loop.external])
    external = [port for port in inputs if port in read & outside]
    in_order = [block for block in [*blocks, makers["taken"]] if block in parts]
    diagram = connect(in_order, external, name)
    diagram.origin = loop
    return diagram


class LearnerFile(CFile):
    """A C file of a learner, whose samples and jumps are at the beginning of a step."""

    def filled(self, fields: dict[str, Any]) -> str:
        """Return the file from the fields of its templates."""
        loop = self.run.loop
        assert loop is not None
        scenario = loop.scenario
        sampled = [k for k in self.layout.jumps if self._period_of(k)]
        fields |= {
            "length": scenario.units.length,
            "time": scenario.units.time,
            "inputs": as_lines(self._inputs(scenario), " * "),
            "advice": f"{0.1 / np.max(scenario.vehicle.feedback):.2g}",
            "proved": as_lines(proved(loop), " * "),
            "fixes": "",
            "inputs_count": self.wiring.ninputs,
            "next": "const double *u_next, ",
            "u_middle": "middle",
            "u_end": "u_next",
            "begin": as_lines(self._first_jumps(sampled)),
        }
        fields["ending"] = RUNGE_KUTTA.substitute(fields)
        fields["samples"] = MIDDLE.substitute(fields)
        if sampled:
            fields["samples"] += SAMPLES.substitute(fields)
        for k in self.layout.jumps.keys() - sampled:  # the law at fixes
            fields["jump"] = self.jump_index[k]
            fields["fixes"] = FIXES.substitute(fields)
            fields["ending"] += FIX.substitute(fields)
        return HEAD.substitute(fields) + FILE.substitute(fields)

    def _inputs(self, scenario: Scenario) -> Iterator[str]:
        """Yield a line for each input: its name, size, meaning and unit."""
        for port, size in counts_of(self.labels["u"]).items():
            meaning = INPUTS.get(port, "as in the scenario")
            unit = unit_of(scenario.units, *POWERS.get(port, (0, 0)))
            yield f"    {port}[{size}]: {meaning}, {unit}".rstrip(", ")

    def _first_jumps(self, sampled: list[int]) -> Iterator[str]:
        """Yield tests for the start of a run: a sampled block takes its inputs, none jumps."""
        for k in sampled:
            samples = self.wiring.nodes[k].system.first_held is not None
            statement = f"after[{self.jump_index[k]}] = {-1.0 * samples};"
            yield f"if (kept[{self.interval_index[k]}] < 0.0) {statement}"


def proved(loop: ClosedLoop) -> list[str]:
    """Return lines on the proofs of the equations of a learner."""
    learning = loop.scenario.learning
    name = learning.row.name
    if loop.changes.components or learning.sample is not None:
        return [f"Proofs of law {name} do not cover samples and parts of your own."]
    lines = [
        f"Proved by `clpt prove {name}`, with its conditions, in continuous time:",
        "not of steps, inputs between measurements and rounding.",
    ]
    fixes = loop.scenario.localization
    N = loop.scenario.basis.N
    if learning.row.at_fixes and fixes is not None:
        lines += [
            f"For a fix each {fixes.interval:g} {loop.scenario.units.time}: a bound lasts only "
            "where the shear of the",
            f"flow times the interval is below {at_least(largest_gain(N), 3)}, `clpt excitation "
            "--bounds`.",
        ]
    is_paper = loop.scenario.vehicle.max_speed is None and learning.used_gains.shared
    if is_paper and (theorems := theorems_of(name)):
        coq = "Checked by Coq for every N, docs/machine_checked.md: theorems"
        lines += [coq, f"{theorems}."]
    return lines


def theorems_of(law: str) -> str:
    """Return the names of the theorems in Coq on a law, and their file; "" if there are none."""
    for file in THEOREMS.iterdir():
        text = file.read_text("utf-8") if file.name.endswith(".v") else ""
        if f"(* record of {law} *)" in text:
            names = re.findall(r"^Theorem (\w+)", text, re.MULTILINE)
            return f"{', '.join(names)} ({file.name})"
    return ""
