"""Timing in turn, and one engine alone in a process of its own."""

import json
import os
import platform
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).parent.parent
FAILURES: list[str] = []  # what `alone` could not run, a sentence each


def peak_memory() -> float:
    """Return the most memory this process ever held, megabytes.

    On Linux the figure is the kernel's for this program alone: `ru_maxrss` begins
    with what the parent held when it started the process.
    """
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text().splitlines():
            if line.startswith("VmHWM:"):
                return float(line.split()[1]) / 2**10
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (2**20 if sys.platform == "darwin" else 2**10)


def interleave(
    runs: dict[str, Callable[[], float]],
    rounds: int,
    budget: float,
    say: Callable[[str], None] = lambda text: None,
) -> dict[str, dict]:
    """Time the engines in turn, round after round, each for at most `budget` seconds.

    A run returns its seconds; return the median, the minimum and the rounds of each.
    """
    seconds: dict[str, list[float]] = {name: [] for name in runs}
    spent = dict.fromkeys(runs, 0.0)
    for turn in range(rounds):
        say(f"round {turn + 1} of {rounds}")
        for name, run in runs.items():
            if spent[name] > budget:
                continue
            begin = time.perf_counter()
            seconds[name].append(run())
            spent[name] += time.perf_counter() - begin
    return {
        name: {"median": statistics.median(s), "minimum": min(s), "rounds": len(s)}
        for name, s in seconds.items()
    }


def alone(module: str, *arguments, timeout: float = 1800) -> dict | None:
    """Run `python -m MODULE ARGUMENTS` and read the JSON it prints; None if it failed.

    The child has one thread, so that engines are compared per core.
    """
    one = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
    xla = "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"
    try:
        done = subprocess.run(
            [sys.executable, "-m", module, *map(str, arguments)],
            cwd=ROOT,
            env={**os.environ, **one, "XLA_FLAGS": xla},
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
        )
    except subprocess.TimeoutExpired:
        FAILURES.append(f"{arguments[0]}: {module} took more than {timeout:g} s")
        return None
    if done.returncode:
        last = done.stderr.strip().splitlines()[-1:] or ["no message"]
        FAILURES.append(f"{arguments[0]}: {last[0]}")
        return None
    return json.loads(done.stdout.strip().splitlines()[-1])


def in_turn(
    module: str,
    titles: dict[str, str],
    count: int,
    rounds: int,
    say: Callable[[str], None],
) -> list[dict]:
    """Run engines in turn, each time in a process of its own.

    Return what the processes print, with median rates and their ratio to C.
    """
    turns: dict[str, list[dict]] = {name: [] for name in titles}
    for turn in range(rounds):
        for name, done in turns.items():
            if turn == 0 or done:
                say(f"{module}, {count}, round {turn + 1}: {titles[name]}")
                found = alone(module, name, count)
                done += [found] if found else []
    rows = []
    for name, done in turns.items():
        if done:
            rates = [d["rate"] for d in done]
            rate = {"rate": statistics.median(rates), "fastest": max(rates)}
            rows.append({**done[0], "title": titles[name], **rate})
    base = next((row["rate"] for row in rows if row["engine"] == "c"), None)
    for row in rows:
        row["ratio"] = row["rate"] / base if base else None
    return rows


def machine() -> str:
    """Describe the machine and the versions in one line."""
    from importlib.metadata import PackageNotFoundError, version

    from .build import FLAGS, compiler

    model = platform.processor() or platform.machine()
    path = Path("/proc/cpuinfo")
    if path.exists():
        lines = path.read_text().splitlines()
        found = [
            line.split(":", 1)[1].strip()
            for line in lines
            if line.startswith("model name")
        ]
        model = found[0] if found else model
        if any("avx512f" in line for line in lines):
            model += " (AVX-512)"
    parts = [
        f"{os.cpu_count()} cores of {model}",
        f"Python {platform.python_version()}",
    ]
    for name in ("numpy", "scipy", "numba", "control", "diffrax", "heyoka", "parcels"):
        try:
            parts.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            continue
    cc = compiler()
    if cc is not None:
        text = subprocess.run(
            [cc, "-dumpfullversion"], capture_output=True, text=True, check=False
        )
        flags = " ".join(f for f in FLAGS if f.startswith(("-O", "-m", "-fno")))
        parts.append(f"C compiler {Path(cc).name} {text.stdout.strip()} {flags}")
    return ", ".join(parts)
