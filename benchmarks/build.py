"""Compile the C programs of `benchmarks/c` into the build folder.

The coefficients of the Runge-Kutta method are scipy's own: they are written as
sums over their non-zero entries into a header when the programs are built.
"""

import hashlib
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

SOURCES = Path(__file__).parent / "c"
FOLDER = Path(__file__).parent.parent / "build" / "benchmarks"
FLAGS = (
    "-std=gnu11",
    "-O3",
    "-march=native",
    "-fno-math-errno",
    "-fPIC",
    "-shared",
    "-Wall",
)


def compiler() -> str | None:
    """Return a C compiler; None where there is none."""
    return next(
        (found for name in ("gcc", "cc", "clang") if (found := shutil.which(name))),
        None,
    )


def weighted(weights: np.ndarray) -> str:
    """Return the sum of the stages with the weights that are not zero."""
    terms = [f"{w!r} * k[{s}][i]" for s, w in enumerate(weights.tolist()) if w]
    return " + ".join(terms)


def coefficients() -> str:
    """Return the header of DOP853 coefficients."""
    from scipy.integrate._ivp import dop853_coefficients as dop

    lines = ["/* Written by benchmarks/build.py from scipy's DOP853. */"]
    for s in range(1, dop.N_STAGES):
        lines += [f"#define DP_C_{s} {float(dop.C[s])!r}"]
        lines += [f"#define DP_STAGE_{s}(i) {weighted(dop.A[s, :s])}"]
    for name, weights in (("B", dop.B), ("E3", dop.E3), ("E5", dop.E5)):
        if np.any(weights[dop.N_STAGES :]):
            raise ValueError(
                f"{name} weighs the new derivative; the C program does not"
            )
        lines += [f"#define DP_{name}(i) {weighted(weights[: dop.N_STAGES])}"]
    return "\n".join(lines) + "\n"


def library(source: str, *options: str) -> Path:
    """Return a source compiled to a shared library, made unless it is there already.

    Its name holds a hash of sources and flags, such as ``"-DN=3"``.
    """
    cc = compiler()
    if cc is None:
        raise RuntimeError("no C compiler")
    header, text = (
        coefficients(),
        "".join(p.read_text() for p in sorted(SOURCES.iterdir())),
    )
    key = hashlib.sha256(
        "\n".join((cc, header, text, *FLAGS, *options)).encode()
    ).hexdigest()
    folder = FOLDER / key[:12]
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{source}.so"
    if path.exists():
        return path
    with tempfile.TemporaryDirectory(
        dir=folder
    ) as own:  # others may be compiling it too
        (Path(own) / "coefficients.h").write_text(header)
        made = Path(own) / path.name
        command = [cc, *FLAGS, *options, f"-I{own}", str(SOURCES / f"{source}.c")]
        done = subprocess.run(
            [*command, "-o", str(made), "-lm"],
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode:
            raise RuntimeError(f"{source}.c does not compile: {done.stderr.strip()}")
        made.replace(path)
    return path
