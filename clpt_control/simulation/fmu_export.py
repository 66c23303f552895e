"""Functional mock-up unit (FMU) of a diagram, for Simulink, Modelica and other simulators.

The FMU has the C file of `c_file` with the functions of FMI 3.0 for model exchange (`fmi3.c`):
the importer integrates, and stops at samples and jumps.  If this machine has a C compiler, the FMU
also has the compiled library.  Variables have the units that blocks declare, and the ends that the
rules of parts set; an importer without settings of its own integrates to the tolerance `ACCURATE`.

Source: Modelica Association (2022), Functional Mock-up Interface 3.0.
"""

import hashlib
import io
import platform
import zipfile
from collections.abc import Iterator
from string import Template
from xml.sax.saxutils import quoteattr

from ..base.errors import BlockError, DiagramError
from ..base.html import asset, plain
from ..base.progress import note
from ..engine.codegen.c_library import ENDINGS, compiled
from ..engine.diagram.wiring import state_units
from ..engine.model.declaration import powers
from .c_export import FIXED, CFile, as_lines, refuse_levels
from .diagram_runs import signal_units

FUNCTIONS = asset("fmi3.c")
DESCRIPTION, BUILD = asset("fmi3.xml").split("<!-- sources/buildDescription.xml -->\n")
FLAGS = ("-O2", "-fvisibility=hidden")
PROCESSORS = {"AMD64": "x86_64", "arm64": "aarch64"}
CONTINUOUS = {"variability": "continuous"}
KINDS = {  # attributes of each kind of variable
    "time": {"causality": "independent", **CONTINUOUS},
    "state": {"causality": "local", **CONTINUOUS, "initial": "exact"},
    "rate": {"causality": "local", **CONTINUOUS, "initial": "calculated"},
    "input": {"causality": "input", **CONTINUOUS},
    "output": {"causality": "output", **CONTINUOUS, "initial": "calculated"},
    "parameter": {
        "causality": "parameter",
        "variability": "tunable",
        "initial": "exact",
    },
    "constant": {"causality": "local", "variability": "constant", "initial": "exact"},
}
STRUCTURE = {  # elements of ModelStructure, and the kinds that they list
    "Output": ("output",),
    "ContinuousStateDerivative": ("rate",),
    "InitialUnknown": ("output", "rate"),
}
ACCURATE = "1e-10"  # importers' integrators lose three digits of a swing at 1e-8
BASE_UNITS = {"kg", "m", "s", "A", "K", "mol", "cd"}
# time stamp of the files: equal diagrams give equal bytes
TIME_STAMP = (1980, 1, 1, 0, 0, 0)


def fmu(file: CFile) -> bytes:
    """Return a diagram as an FMU of FMI 3.0 for model exchange: the bytes of a ZIP archive.

    >>> import control
    >>> from clpt_control.simulation.c_export import c_file
    >>> archive = fmu(c_file(control.tf(1, [0.5, 1], name="lag"), None, None))
    >>> sorted(zipfile.ZipFile(io.BytesIO(archive)).namelist())[-2:]
    ['sources/buildDescription.xml', 'sources/lag.c']
    """
    if file.wiring.dt:
        raise DiagramError(
            f"{file.run.name}: is no FMU for model exchange, whose importer integrates: its "
            "time is discrete; clpt.export to C has its step"
        )
    refuse_levels(file.run)
    text = file.text
    token = hashlib.sha256(text.encode()).hexdigest()[:32]
    text += _fmi_functions(file, token)
    title = quoteattr(_xml_name(file.run.name))
    fields = {"name": file.name, "token": token, "title": title, "tolerance": ACCURATE}
    description = Template(DESCRIPTION).substitute(fields, **_variables(file))
    contents: dict[str, str | bytes] = {
        "modelDescription.xml": description,
        "sources/buildDescription.xml": Template(BUILD).substitute(fields),
        f"sources/{file.name}.c": text,
        **_binary(file.name, text),
    }
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as folder:
        for name, content in contents.items():
            entry = zipfile.ZipInfo(name, TIME_STAMP)
            folder.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return archive.getvalue()


def _fmi_functions(file: CFile, token: str) -> str:
    """Return the functions that an importer calls."""
    jump_tests = [
        f"{line} some |= {line.split(' =')[0]} > 0.0;" for line in file.jump_tests()
    ]
    next_times = [
        f"at = {period} * (kept[{j}] + 1.0); if (at < next) next = at;"
        for j, (_, period) in enumerate(file.periods)
        if period
    ]
    return Template(FUNCTIONS).substitute(
        name=file.name,
        token=token,
        count=file.memory_size,
        room=file.work_size,
        jumps=int(bool(file.layout.jumps)),
        asked=as_lines(jump_tests),
        next=as_lines(next_times),
        outputs=as_lines(file.outputs()),
    )


def _binary(name: str, text: str) -> dict[str, bytes]:
    """Return the compiled library by its path; nothing if there is no C compiler."""
    system = platform.system()
    machine = PROCESSORS.get(platform.machine(), platform.machine())
    try:
        library = compiled(text, *FLAGS)
    except DiagramError as reason:
        note(f"the FMU holds its source alone: {reason}")
        return {}
    return {f"binaries/{machine}-{system.lower()}/{name}{ENDINGS[system]}": library}


def _variables(file: CFile) -> dict[str, str]:
    """Return the variables and the structure in modelDescription.xml."""
    lines = []
    kinds = []
    names = set()
    units = {}
    for reference, (kind, label, extra) in enumerate(_rows(file)):
        name = _xml_name(label)
        while name in names:
            name += "_"
        names.add(name)
        kinds.append(kind)
        attributes = {"name": name, "valueReference": str(reference), **KINDS[kind]}
        attributes |= {key: text for key, text in extra.items() if text}
        if unit := attributes.get("unit"):
            units[unit] = _unit_definition(unit)
        pairs = [f"{key}={quoteattr(value)}" for key, value in attributes.items()]
        lines.append(f"    <Float64 {' '.join(pairs)}/>")
    structure = [
        f'    <{tag} valueReference="{reference}"/>'
        for tag, listed_kinds in STRUCTURE.items()
        for reference, kind in enumerate(kinds)
        if kind in listed_kinds
    ]
    definitions = "".join(units.values())
    if units:
        definitions = f"  <UnitDefinitions>\n{definitions}  </UnitDefinitions>\n"
    return {
        "units": definitions,
        "variables": "\n".join(lines),
        "structure": "\n".join(structure),
    }


def _unit_definition(unit: str) -> str:
    """Return the element of a unit, with its powers of base units where it is a product of them."""
    try:
        base = powers(unit)
    except BlockError:
        base = {"": 1}
    pairs = "".join(f' {symbol}="{power}"' for symbol, power in base.items())
    is_known = base.keys() <= BASE_UNITS and "rad" not in unit
    content = f"<BaseUnit{pairs}/>" if is_known else ""
    return f"    <Unit name={quoteattr(unit)}>{content}</Unit>\n"


def _rows(file: CFile) -> Iterator[tuple[str, str, dict[str, str]]]:
    """Yield kind, name and further attributes of each variable, by value reference."""
    states = zip(file.labels["x"], file.start, state_units(file.wiring), strict=True)
    signals = signal_units(file.wiring)
    count = len(file.labels["y"])
    yield "time", "time", {}
    for label, start, unit in states:
        yield "state", f"state.{label}", {"start": repr(float(start)), "unit": unit}
    for k, label in enumerate(file.labels["x"]):
        yield "rate", f"der(state.{label})", {"derivative": f"{1 + k}"}
    for label, unit in zip(file.labels["u"], signals[count:], strict=True):
        yield "input", label, {"start": "0.0", "unit": unit}
    for label, unit in zip(file.labels["y"], signals[:count], strict=True):
        yield "output", label, {"unit": unit}
    declared = _declared_of_parameters(file)
    for label, value in zip(*file.parameter_values(), strict=True):
        kind = "constant" if FIXED in label else "parameter"
        name = label.replace(FIXED, "")
        start = repr(float(value)).replace("inf", "INF")  # XML's infinity
        yield kind, name, {"start": start, **declared[name.partition("[")[0]]}


def _declared_of_parameters(file: CFile) -> dict[str, dict[str, str]]:
    """Return the unit and the least value, where there is one, of "block.parameter"."""
    declared = {}
    for node in file.wiring.nodes:
        least = {
            name: repr(end)
            for rule in getattr(node.system, "rules", ())
            for name, end in getattr(rule, "least", {}).items()
        }
        for name in node.system.parameters._fields:
            unit = node.system.units.get(name, "")
            attributes = {"unit": unit, "min": least.get(name, "")}
            declared[f"{node.name}.{name}"] = attributes
    return declared


def _xml_name(text: str) -> str:
    """Return a text in one line of characters that XML allows."""
    return " ".join(plain(text).split())
