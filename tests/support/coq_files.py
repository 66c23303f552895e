"""Files of Coq in tests: compiled by coqc, and the axioms on which their last theorem rests."""

import re
import shutil
import subprocess

import pytest

REALS = {"sig_forall_dec", "sig_not_dec", "functional_extensionality_dep", "classic"}


def compiled(folder, text):
    """Return whether coqc accepts a file, and the axioms of its last theorem."""
    if not shutil.which("coqc"):
        pytest.skip("coqc is not installed")
    (folder / "mine.v").write_text(text)
    command = ["coqc", "-q", "-w", "none", "mine.v"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    axioms = re.findall(r"^([\w.']+)(?= :|\n  :)", done.stdout, re.MULTILINE)
    return done.returncode == 0, {axiom.rpartition(".")[2] for axiom in axioms}
