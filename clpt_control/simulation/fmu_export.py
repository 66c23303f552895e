"""A diagram as a functional mock-up unit (FMU) for Simulink, Modelica and other simulators.

It is the file of C of `export_c`, with the functions of FMI 3.0 for model exchange (`fmi3.c`): the
importer integrates, and stops where parts sample or blocks jump.  The FMU holds the source, and
what this machine's C compiler makes of it.

Source: Modelica Association (2022), Functional Mock-up Interface 3.0.
"""

import hashlib
import io
import os
import platform
import shutil
import subprocess
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from importlib import resources
from pathlib import Path
from string import Template
from typing import Any
from xml.sax.saxutils import quoteattr

import control

from ..base.arguments import public
from ..base.errors import DiagramError
from ..base.files import write_file
from ..base.html import plain
from ..base.progress import note
from ..paper.scenario.experiment import Scenario
from .c_export import FIXED, CFile, as_lines, c_file

FUNCTIONS, DOCUMENTS = (
    (resources.files("clpt_control.data") / f"fmi3.{kind}").read_text("utf-8")
    for kind in ("c", "xml")
)
DESCRIPTION, BUILD = DOCUMENTS.split("<!-- sources/buildDescription.xml -->\n")
FLAGS = ("-std=c99", "-O2", "-shared", "-fPIC", "-fvisibility=hidden")
PROCESSORS = {"AMD64": "x86_64", "arm64": "aarch64"}
ENDINGS = {"Linux": ".so", "Darwin": ".dylib", "Windows": ".dll"}
MOVING = {"variability": "continuous"}
KINDS = {  # of variables, and what is said of them
    "time": {"causality": "independent", **MOVING},
    "state": {"causality": "local", **MOVING, "initial": "exact"},
    "rate": {"causality": "local", **MOVING, "initial": "calculated"},
    "input": {"causality": "input", **MOVING},
    "output": {"causality": "output", **MOVING, "initial": "calculated"},
    "parameter": {
        "causality": "parameter",
        "variability": "tunable",
        "initial": "exact",
    },
    "constant": {"causality": "local", "variability": "constant", "initial": "exact"},
}
STRUCTURE = {  # of modelDescription.xml: which variables are listed
    "Output": ("output",),
    "ContinuousStateDerivative": ("rate",),
    "InitialUnknown": ("output", "rate"),
}
# the time of each file within: the same diagram, the same bytes
LONG_AGO = (1980, 1, 1, 0, 0, 0)


@public
def export_fmu(
    system: Scenario | control.InputOutputSystem,
    path: str | Path,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
) -> None:
    """Write a diagram as an FMU of FMI 3.0, for model exchange.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        A scenario, a diagram, a block or a system of python-control, of continuous time; sampled
        parts are events.
    path : str or Path
        The file, ``"loop.fmu"``.
    initial_state : array_like, optional
        The start of its states, as for `export_c`.
    params : mapping, optional
        Call-time parameters that it has as its own; the importer may change those that no
        function asks for their value.

    Raises
    ------
    DiagramError
        If a function is not read, time is discrete, or a block jumps at times that only a function
        of Python knows.

    Examples
    --------
    >>> import control, pathlib, tempfile, zipfile
    >>> import clpt_control as clpt
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "lag.fmu"
    >>> clpt.export_fmu(control.tf(1, [0.5, 1], name="lag"), file)
    >>> sorted(zipfile.ZipFile(file).namelist())[-2:]
    ['sources/buildDescription.xml', 'sources/lag.c']
    """
    write_file(path, _packed(c_file(system, initial_state, params)))


def _packed(file: CFile) -> bytes:
    """Return the FMU."""
    if file.wiring.dt:
        raise DiagramError(
            f"{file.run.name}: is no FMU for model exchange, whose importer integrates: its "
            "time is discrete; export_c has its step"
        )
    text = file.text
    token = hashlib.sha256(text.encode()).hexdigest()[:32]
    text += _functions(file, token)
    fields = {
        "name": file.name,
        "token": token,
        "title": quoteattr(_name(file.run.name)),
    }
    held: dict[str, str | bytes] = {
        "modelDescription.xml": Template(DESCRIPTION).substitute(
            fields, **_variables(file)
        ),
        "sources/buildDescription.xml": Template(BUILD).substitute(fields),
        f"sources/{file.name}.c": text,
        **_binary(file.name, text),
    }
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as folder:
        for name, content in held.items():
            folder.writestr(
                zipfile.ZipInfo(name, LONG_AGO), content, zipfile.ZIP_DEFLATED
            )
    return packed.getvalue()


def _functions(file: CFile, token: str) -> str:
    """Return the functions that an importer calls."""
    lines = {
        "asked": [
            f"{line} some |= {line.split(' =')[0]} > 0.0;" for line in file.asked()
        ],
        "next": [
            f"at = {period} * (kept[{j}] + 1.0); if (at < next) next = at;"
            for j, (_, period) in enumerate(file.periods)
            if period
        ],
        "outputs": file.outputs(),
    }
    body = {name: as_lines(own) for name, own in lines.items()}
    sizes = {
        "count": file.kept,
        "room": file.room,
        "jumps": int(bool(file.layout.jumps)),
    }
    return Template(FUNCTIONS).substitute(name=file.name, token=token, **sizes, **body)


def _binary(name: str, text: str) -> dict[str, bytes]:
    """Return what this machine's C compiler makes, by its place; nothing where there is none."""
    compiler = shutil.which(os.environ.get("CC", "cc"))
    system = platform.system()
    if compiler is None or system not in ENDINGS:
        note(
            "the FMU holds its source alone: there is no C compiler (cc, or the variable CC)"
        )
        return {}
    machine = PROCESSORS.get(platform.machine(), platform.machine())
    try:
        with tempfile.TemporaryDirectory() as folder:
            source, made = Path(folder) / "model.c", Path(folder) / "made"
            source.write_text(text, "utf-8")
            done = subprocess.run(
                [compiler, *FLAGS, "-o", made, source, "-lm"],
                capture_output=True,
                text=True,
            )
            if not done.returncode:
                place = f"binaries/{machine}-{system.lower()}/{name}{ENDINGS[system]}"
                return {place: made.read_bytes()}
            why = f"{compiler} failed: {done.stderr:.200}"
    except OSError as error:  # of a full disk
        why = f"{compiler} has no folder to work in: {error.strerror or error}"
    note(f"the FMU holds its source alone: {why}")
    return {}


def _variables(file: CFile) -> dict[str, str]:
    """Return what modelDescription.xml says of variables, and which of them depend on others."""
    lines, kinds, taken = list[str](), list[str](), set[str]()
    for place, (kind, name, own) in enumerate(_rows(file)):
        name = _name(name)
        while name in taken:
            name += "_"
        taken.add(name)
        kinds.append(kind)
        attributes = {"name": name, "valueReference": f"{place}", **KINDS[kind], **own}
        pairs = " ".join(
            f"{key}={quoteattr(value)}" for key, value in attributes.items()
        )
        lines.append(f"    <Float64 {pairs}/>")
    structure = [
        f'    <{tag} valueReference="{place}"/>'
        for tag, listed in STRUCTURE.items()
        for place, kind in enumerate(kinds)
        if kind in listed
    ]
    return {"variables": "\n".join(lines), "structure": "\n".join(structure)}


def _rows(file: CFile) -> Iterator[tuple[str, str, dict[str, str]]]:
    """Yield kind, name and own attributes of each variable, in the order of value references."""
    x, u, y = (file.labels[letter] for letter in "xuy")
    yield "time", "time", {}
    for label, start in zip(x, file.start, strict=True):
        yield "state", f"state.{label}", {"start": repr(float(start))}
    for k, label in enumerate(x):
        yield "rate", f"der(state.{label})", {"derivative": f"{1 + k}"}
    for label in u:
        yield "input", label, {"start": "0.0"}
    for label in y:
        yield "output", label, {}
    for label, value in zip(*file.parameters(), strict=True):
        kind = "constant" if FIXED in label else "parameter"
        start = repr(float(value)).replace("inf", "INF")  # as XML says it
        yield kind, label.replace(FIXED, ""), {"start": start}


def _name(text: str) -> str:
    """Return a name in one line, of letters that XML may hold."""
    return " ".join(plain(text).split())
