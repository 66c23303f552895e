"""With what a page was written, and how what it shows is made again."""

import platform
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from ..html.text import listing, table
from .page import Section

PACKAGES = ("clpt-control", "control", "numpy", "scipy", "llvmlite", "xarray", "matplotlib")


def again_section(said: str, commands: list[str], ran_with: str, facts: dict[str, str]) -> Section:
    """Return how to make a page again, with what it was made, and facts of the run."""
    here = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    rows = [
        ["run with", ran_with or "not recorded"],
        ["page made with", f"Python {platform.python_version()}, {here}"],
        *([what, value] for what, value in facts.items()),
    ]
    parts = [f"<p>{said}</p>"]
    if commands:
        parts.append(listing("\n".join(commands)))
    return Section("again", "Make it again", [*parts, table("Versions", ["", ""], rows)])


def solver_facts(attributes: Mapping[Any, Any]) -> dict[str, str]:
    """Return how a run ended, and the numbers of its solver."""
    counts = [
        f"{value} {str(name).removeprefix('solver_')}"
        for name, value in attributes.items()
        if str(name).startswith("solver_")
    ]
    return {
        "engine": str(attributes.get("engine", "not recorded")),
        "ended": str(attributes.get("message", "not recorded")),
        "solver": ", ".join(counts) or "not recorded",
    }
