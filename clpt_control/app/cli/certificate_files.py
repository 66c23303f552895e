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
    names = []
    for statement, proof in outcomes.items():
        if statement.room not in NAMES:
            continue
        title, file = (text.format(statement.name) for text in NAMES[statement.room])
        if proof.certificate is None:
            reason = proof.why_no_certificate or "it is about no single V'"
            quiet or say(f"{title} has no certificate: {reason}.")
            continue
        names.append(file.replace(".", "_").replace(" ", "_") + ".json")
        write_file(folder / names[-1], json.dumps(proof.certificate, indent=1) + "\n")
    quiet or say(
        f"Wrote {len(names)} certificates to {folder}. Check them with: "
        f"{CHECKER} {folder}/*.json\n"
    )
