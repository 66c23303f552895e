"""Files of Coq: fixed ones, and ones with the record of a law that runs.

The files of this folder are complete but for two kinds of lines:

    (* record of LAW *)     equations of the law's closed loop, by `printing`
    (* text of FILE *)      lines that several laws share
"""

import re
from functools import cache
from pathlib import Path

from ...base.errors import DiagramError
from ...engine.record.unread import Unread
from ...paper.laws.table import LAWS
from .printing import text_of
from .running import equations_of, loop_of_law

FOLDER = Path(__file__).parent
PROJECT = "_CoqProject"  # options of coqc, and the files in the order of compilation
RECORD = re.compile(r"\(\* record of (\S+) \*\)")
SHARED = re.compile(r"\(\* text of (\S+) \*\)")


def record_of(law: str) -> str:
    """Return the equations of a law's closed loop as text of Coq."""
    if LAWS[law].jump is not None:
        raise DiagramError(f"{law}: its states jump. A file of Coq has rates alone")
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


def coq_files() -> dict[str, str]:
    """Return name -> text of all files, in the order of compilation."""
    return {
        name: RECORD.sub(lambda line: record_of(line[1]), text)
        for name, text in templates().items()
    }


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
