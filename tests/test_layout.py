"""Imports run downhill: from each row of subpackages to rows below it."""

import ast
import shutil
import subprocess
import sys
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import clpt_control

PACKAGE = Path(clpt_control.__file__).parent
PUBLIC_MODULES = sorted({path.stem for path in PACKAGE.glob("*.pyi")} - {"__init__"})
PUBLIC_PACKAGES = {path.parent.name for path in PACKAGE.glob("*/__init__.pyi")}
# subpackages; a subpackage of one of two parts, such as ocean, has rows of its own
ROWS = [
    ("app.cli",),
    ("app.notebook",),
    ("app.pages",),
    ("ocean.forecast", "ensemble", "theory.coq", "theory.theorems"),
    ("theory.design",),
    ("theory.excitation",),
    ("theory.laws",),
    ("theory.proofs",),
    ("theory.algebra",),
    ("ocean.estimation", "simulation"),
    ("ocean.gliders",),
    ("paper.currents",),
    ("paper.scenario", "plots"),
    ("parts", "paper.blocks", "paper.laws"),
    ("engine",),
    ("base", "data"),
]
DIVIDED = ("app", "ocean", "paper", "theory")
ENGINE_AND_HELPERS = {room for row in ROWS[-2:] for room in row}
ROW = {room: k for k, row in enumerate(ROWS) for room in row}
DOORS = ("__init__", "__main__")  # may import all subpackages


def room_of(name):
    """The subpackage of a module, of a divided one its part."""
    parts = name.split(".")
    return ".".join(parts[:2]) if parts[0] in DIVIDED else parts[0]


def module_of(path):
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" and parts[1:] else parts)


FILES = {module_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}


def imports(name, path, tree):
    """Yield modules of the package that a module imports, also inside functions."""
    package = [
        "clpt_control",
        *name.split(".")[: None if path.name == "__init__.py" else -1],
    ]
    for node in ast.walk(tree):
        base = ""
        if isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*above, node.module or ""]).strip(".")
        # a module of a subpackage, or a name in a module
        for alias in (
            node.names if isinstance(node, ast.Import | ast.ImportFrom) else ()
        ):
            candidates = f"{base}.{alias.name}".strip("."), base
            modules = (
                m.removeprefix("clpt_control.")
                for m in candidates
                if "clpt_control" in m
            )
            yield from [
                module for module in modules if module in FILES and module != name
            ][:1]


@cache
def trees():
    """Syntax tree of each module."""
    return {name: ast.parse(path.read_text("utf-8")) for name, path in FILES.items()}


@cache
def edges():
    """Pairs of a module and a module that it imports."""
    return sorted(
        {
            (n, used)
            for n, tree in trees().items()
            for used in imports(n, FILES[n], tree)
        }
    )


@pytest.mark.parametrize("module", PUBLIC_MODULES)
def test_names_of_public_modules_leave_the_modules_in_place(module):
    before = getattr(clpt_control, module)
    assert all(hasattr(before, name) for name in dir(before))
    assert getattr(clpt_control, module) is before
    assert [getattr(clpt_control, name).__name__ for name in PUBLIC_MODULES] == [
        f"clpt_control.{name}" for name in PUBLIC_MODULES
    ]


def test_every_module_has_a_room():
    rooms = {room_of(name) for name in FILES} - {*DOORS, *DIVIDED} - {*PUBLIC_MODULES}
    assert rooms == set(ROW)


def test_the_engine_imports_only_itself_and_helpers():
    above = [
        f"{name} imports {used}"
        for name, used in edges()
        if room_of(name) == "engine" and room_of(used) not in ENGINE_AND_HELPERS
    ]
    assert above == []


@pytest.mark.parametrize(
    ("part", "above"),
    [("record", {"trace", "model", "codegen", "solver"}), ("codegen", {"solver"})],
)
def test_parts_of_the_engine_import_no_part_above(part, above):
    back = [
        f"{name} imports {used}"
        for name, used in edges()
        if name.startswith(f"engine.{part}.")
        and used.startswith(tuple(f"engine.{name}." for name in above))
    ]
    assert back == []


RUN_OF_THE_ENGINE = """
import sys

# an editable install of the whole package must not serve the deleted modules
sys.meta_path = [finder for finder in sys.meta_path if "editable" not in repr(finder).lower()]

import numpy as np
import clpt_control
from clpt_control.engine.model.block import Block
from clpt_control.engine.solver.native_diagram import NativeDiagram

block = Block("decay", update=lambda t, x, u, p: -x, states={"x": 1})
times = np.linspace(0.0, 5.0, 11)
solution = NativeDiagram(block).run([1.0], times, rtol=1e-10, atol=1e-12)
assert np.max(np.abs(solution.x[:, 0] - np.exp(-times))) < 1e-9
modules = [name for name in sys.modules if name.startswith("clpt_control.")]
print(clpt_control.__file__, *modules)
"""


@pytest.mark.long
def test_the_engine_runs_without_the_paper(tmp_path):
    above = {room.partition(".")[0] for row in ROWS[:-2] for room in row}
    copy = tmp_path / PACKAGE.name
    ignored = shutil.ignore_patterns(*above, "__pycache__")
    # names of subpackages are deleted at the top only
    shutil.copytree(
        PACKAGE,
        copy,
        ignore=lambda folder, names: (
            ignored(folder, names) if folder == str(PACKAGE) else ()
        ),
    )
    assert not any((copy / room).exists() for room in above)

    arguments = [sys.executable, "-c", RUN_OF_THE_ENGINE]
    run = subprocess.run(arguments, cwd=tmp_path, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    file, *modules = run.stdout.split()
    assert Path(file).parent == copy
    assert {name.split(".")[1] for name in modules} <= ENGINE_AND_HELPERS | set(
        PUBLIC_MODULES
    )


def test_imports_run_downhill():
    uphill = [
        f"{name} imports {used}"
        for name, used in edges()
        if name not in (*DOORS, *DIVIDED)
        and ROW[room_of(name)] > ROW.get(room_of(used), -1)
    ]
    assert uphill == []


@pytest.mark.parametrize("level", ["files", "rooms"])
def test_there_are_no_circles(level):
    short = (lambda m: m) if level == "files" else room_of
    below = {}
    for name, used in edges():
        if name not in DOORS and short(name) != short(used):
            below.setdefault(short(name), set()).add(short(used))
    TopologicalSorter(below).prepare()  # else an error that names the circle


TESTS = Path(__file__).parent
OF_TUPLES = {"_asdict", "_fields", "_replace"}  # of a `NamedTuple`


def inner_names(path):
    """Return the inner modules that a test imports, and the private names that it reads."""
    modules, private = set(), set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            name = node.module.removeprefix("clpt_control.")
            candidates = {name, *(f"{name}.{alias.name}" for alias in node.names)}
            if node.module.startswith("clpt_control."):
                modules |= candidates & FILES.keys() - {*PUBLIC_PACKAGES}
        if isinstance(node, ast.Attribute) and node.attr[0] == "_" != node.attr[1]:
            of_test = ast.unparse(node.value) in ("self", "super()")
            if not (of_test or node.attr.startswith("_repr_")):
                private |= {node.attr} - OF_TUPLES
    return modules, private


@pytest.mark.long
def test_tests_use_public_names():
    found = {path.name: inner_names(path) for path in TESTS.rglob("test_*.py")}
    assert {name: private for name, (_, private) in found.items() if private} == {}
    assert len([name for name, (modules, _) in found.items() if modules]) <= 30


def test_files_of_tests_have_names_of_their_own():
    names = [path.name for path in TESTS.rglob("test_*.py")]
    assert sorted(names) == sorted(set(names))  # pytest imports them by name alone
