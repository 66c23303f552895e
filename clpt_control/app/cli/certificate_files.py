"""Files of the certificates of `clpt prove`, and of the proofs that have none."""

import json
from pathlib import Path
from typing import Any

from ...base.files import make_folder, write_file
from .printing import say

NAMES = {  # of proofs: title, file
    "theorems": ("Theorem {}", "theorem_{}"),
    "limited_speed": ("Limited speed, {}", "limited_speed_{}"),
    "laws": ("Law {}", "law_{}"),
    "team": ("A team that learns one flow", "team"),
}
CHECKER = "python -m clpt_control.data.check_certificate"


def write_certificates(outcomes: dict[Any, Any], folder: Path, quiet: bool) -> None:
    """Write the certificate of each proof that has one; print the reason of one that has none."""
    make_folder(folder)
    lines, count = [], 0
    for statement, proof in outcomes.items():
        if statement.room not in NAMES:
            continue
        title, file = (text.format(statement.name) for text in NAMES[statement.room])
        if proof.certificate is None:
            reason = proof.why_no_certificate or "the statement is not about one V'"
            lines.append(f"{title}: has no certificate, as {reason}.")
            continue
        name = file.replace(".", "_").replace(" ", "_")
        write_file(folder / f"{name}.json", json.dumps(proof.certificate, indent=1))
        count += 1
    files = f"{count} certificate{'s' * (count != 1)}"
    lines.append(f"Wrote {files} to {folder}. Check with: {CHECKER} {folder}/*.json\n")
    for line in lines if not quiet else ():
        say(line)
