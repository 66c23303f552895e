"""Compilation of files of Coq by `coqc`, and the theorems whose axioms the files print."""

import re
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from ...base.errors import SimulationError
from ...base.files import make_folder, write_together
from ...base.progress.interrupt import check
from .files import FOLDER, PROJECT, coq_files, laws_without_file

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


def write_proofs(folder: Path, report: Callable[[float], None]) -> Proofs:
    """Write the theorems as files of Coq; compile them in order if `coqc` is installed.

    A file that Coq refuses is an error, and an axiom that is none of the real numbers.
    """
    texts, not_written = coq_files(), laws_without_file()
    folder = make_folder(folder)
    project = {PROJECT: (FOLDER / PROJECT).read_text("utf-8")}
    write_together({folder / name: text for name, text in {**texts, **project}.items()})
    theorems: list[Theorem] = []
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
