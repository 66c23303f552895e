"""Shared libraries of C text, made by the C compiler `cc`, or that of the variable CC."""

import os
import platform
import shutil
import subprocess
import tempfile
from pathlib import Path

from ...base.errors import DiagramError

ENDINGS = {"Linux": ".so", "Darwin": ".dylib", "Windows": ".dll"}
FLAGS = ("-std=c99", "-shared", "-fPIC", "-Werror=implicit-function-declaration")


def compiler() -> str:
    """Return the path of the C compiler, "" without one."""
    program = shutil.which(os.environ.get("CC", "cc"))
    return program if program and platform.system() in ENDINGS else ""


def compiled(text: str, *flags: str) -> bytes:
    """Return the shared library of C text, or raise `DiagramError` with the reason."""
    program = compiler()
    if not program:
        raise DiagramError("there is no C compiler (cc, or the variable CC)")
    try:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "model.c").write_text(text, "utf-8")
            command = [program, *FLAGS, *flags, "-o", "library", "model.c", "-lm"]
            result = subprocess.run(command, capture_output=True, text=True, cwd=folder)
            if not result.returncode:
                return (Path(folder) / "library").read_bytes()
    except OSError as error:  # such as a full disk
        reason = error.strerror or error
        raise DiagramError(f"{program} has no folder to work in: {reason}") from None
    raise DiagramError(f"{program} failed: {result.stderr:.200}")
