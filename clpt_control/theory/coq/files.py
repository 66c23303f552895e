"""Files of Coq: fixed ones, and ones with the record of a law that runs; compiled by `coqc`.

The files of this folder are complete but for two kinds of lines:

    (* record of LAW *)     equations of the law's closed loop, by `printing`
    (* text of FILE *)      lines that several laws share

The files print the axioms of their theorems.
"""

import re
import shutil
import subprocess
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import NamedTuple

from ...base.errors import DiagramError, SimulationError
from ...base.files import make_folder, write_together
from ...base.progress.interrupt import check
from ...engine.record.unread import Unread
from ...paper.laws.table import LAWS
from .printing import text_of
from .running import equations_of, loop_of_law

FOLDER = Path(__file__).parent
PROJECT = "_CoqProject"  # options of coqc, and the files in the order of compilation
RECORD = re.compile(r"\(\* record of (\S+) \*\)")
REQUIRED = re.compile(r"^From Clpt Require Import ([^.]*)\.", re.MULTILINE)
SHARED = re.compile(r"\(\* text of (\S+) \*\)")
COQC = ("coqc", "-q", "-w", "none", "-Q", ".", "Clpt")
PACKAGES = "coq libcoq-coquelicot"  # of Debian
# axioms of the real numbers of Coq's library
CLASSICAL = (
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
)
PRINTED = re.compile(r"^Print Assumptions (\w+)\.$", re.MULTILINE)
ASSUMED = re.compile(r"^(?:Axioms:|Closed under the global context)$", re.MULTILINE)
AXIOM = re.compile(r"^([\w.']+)(?= :|\n  :)", re.MULTILINE)


def record_of(law: str) -> str:
    """Return the equations of a law's closed loop as text of Coq."""
    if LAWS[law].jump is not None and not LAWS[law].at_fixes:
        raise DiagramError(f"{law}: its states jump, and not at fixes")
    try:
        return text_of(equations_of(loop_of_law(law)))
    except (DiagramError, Unread) as error:
        raise DiagramError(f"{law}: {error}") from None


@cache
def templates() -> dict[str, str]:
    """Return name -> text of all files, without records, in the order of compilation."""

    def read(name: str) -> str:
        return (FOLDER / name).read_text("utf-8")

    files = read(PROJECT).split("\n")[1:-1]
    return {name: SHARED.sub(lambda line: read(line[1]), read(name)) for name in files}


def coq_files(law: str | None = None) -> dict[str, str]:
    """Return name -> text of all files, or of one law's with those that it needs, in order."""
    files = templates()
    if law is not None:
        files = {name: text for name, text in files.items() if name in files_of(law)}
    return {
        name: RECORD.sub(lambda line: record_of(line[1]), text)
        for name, text in files.items()
    }


def files_of(law: str) -> list[str]:
    """Return the names of the files with a law's record, and of those that they require."""
    texts = templates()
    found = [name for name, text in texts.items() if law in RECORD.findall(text)]
    if not found:
        raise DiagramError(laws_without_file()[law])
    for name in found:
        for names in REQUIRED.findall(texts[name]):
            files = (f"{word}.v" for word in names.split())
            found += [file for file in files if file not in found]
    return found


def laws_without_file() -> dict[str, str]:
    """Return the laws that have no file, each with the reason."""
    reasons = {}
    for law in sorted(LAWS.keys() - RECORD.findall("".join(templates().values()))):
        reasons[law] = f"{law}: no theorem on its V' is written"
        try:
            record_of(law)
        except DiagramError as error:
            reasons[law] = str(error)
    return reasons


# --- compilation ------------------------------------------------------------------------------


class Theorem(NamedTuple):
    """A theorem that Coq accepted."""

    name: str
    file: str
    seconds: float  # to compile the file
    axioms: list[str]


class Proofs(NamedTuple):
    """Files of Coq in a folder, and their theorems if `coqc` checked them."""

    files: list[str]
    theorems: list[Theorem] | None
    not_written: dict[str, str]  # law -> reason


def write_proofs(
    folder: Path, report: Callable[[float], None], law: str | None
) -> Proofs:
    """Write the theorems, or a law's, as files of Coq; compile them if `coqc` is installed.

    A file that Coq refuses is an error, and an axiom that is none of the real numbers.
    """
    texts = coq_files(law)
    not_written = laws_without_file() if law is None else {}
    folder = make_folder(folder)
    options = (FOLDER / PROJECT).read_text("utf-8").split("\n")[0]
    project = {PROJECT: "\n".join([options, *texts, ""])}
    write_together({folder / name: text for name, text in {**texts, **project}.items()})
    theorems = []
    if not shutil.which("coqc"):
        return Proofs([*texts], None, not_written)
    for count, (file, text) in enumerate(texts.items()):
        report(count / len(texts))
        theorems += compile_file(folder, file, text)
    return Proofs([*texts], theorems, not_written)


def compile_file(folder: Path, file: str, text: str) -> list[Theorem]:
    """Compile a file of a folder, and return the theorems whose axioms it prints."""
    started = time.monotonic()
    done = subprocess.run([*COQC, file], cwd=folder, capture_output=True, text=True)
    check()
    if done.returncode:
        reason = " ".join(done.stderr.split())
        raise SimulationError(
            f"{file}: coqc refuses it ({reason:.300}). Its packages on Debian: {PACKAGES}"
        )
    seconds = time.monotonic() - started
    theorems = []
    assumed = ASSUMED.split(done.stdout)[1:]
    for name, block in zip(PRINTED.findall(text), assumed, strict=True):
        axioms = AXIOM.findall(block)
        for axiom in set(axioms) - set(CLASSICAL):
            raise SimulationError(
                f"{name}: assumes {axiom}, which is no axiom of the real numbers"
            )
        theorems.append(Theorem(name, file, seconds, axioms))
    return theorems
