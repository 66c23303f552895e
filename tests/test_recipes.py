"""Recipes of CONTRIBUTING: each is done on a copy, and fails if one of its steps is left out."""

import os
import shutil
import subprocess
import sys
import textwrap

import pytest
from paths import ROOT
from recipes import ADDITIONS
from recipes_of_blocks import BLOCKS
from recipes_of_dives import DIVES
from recipes_of_operations import OPERATIONS
from recipes_of_results import RESULTS
from subprocesses import GUARD

pytestmark = pytest.mark.long  # by `make test-long`

RECIPES = ADDITIONS | BLOCKS | OPERATIONS | RESULTS | DIVES
LEFT_OUT = [
    pytest.param(name, k, id=f"{name} without {step.name}")
    for name, recipe in RECIPES.items()
    for k, step in enumerate(recipe.steps)
]


@pytest.fixture(scope="module")
def clone(tmp_path_factory):
    """A copy of the repository."""
    copy = tmp_path_factory.mktemp("recipes") / "clone"
    skipped = shutil.ignore_patterns(".git", ".venv", "build", "glider", "grids")
    return shutil.copytree(ROOT, copy, ignore=skipped)


def result_of(recipe, steps, clone):
    """Do steps in the clone, run what the recipe promises, and undo them: status and output."""
    edits = [edit for step in steps for edit in step.edits]
    before = {
        path: path.read_text("utf-8") if path.exists() else None
        for path in {clone / file for file, *_ in edits}
    }
    try:
        for file, old, new in edits:
            path = clone / file
            text = path.read_text("utf-8") if path.exists() else ""
            path.write_text(text.replace(old, new, 1) if old else text + new, "utf-8")
        code = textwrap.dedent(recipe.promise)
        if recipe.tests:
            words = ["-q", "-p", "no:cacheprovider", *recipe.tests]
            code += f"\nimport pytest, sys; sys.exit(pytest.main({words}))"
        environment = {**os.environ, "PYTHONPATH": str(clone)}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # compile the clone once
        done = subprocess.run(
            [sys.executable, "-c", code],
            cwd=clone,
            env=environment,
            capture_output=True,
            text=True,
            timeout=GUARD,
        )
        return done.returncode, done.stdout + done.stderr
    finally:
        for path, text in before.items():
            if text is None:
                path.unlink(missing_ok=True)
            else:
                path.write_text(text, "utf-8")


@pytest.mark.parametrize("name", RECIPES)
def test_a_recipe_keeps_its_promise(name, clone):
    recipe = RECIPES[name]
    assert f"## {recipe.heading}\n" in (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    status, output = result_of(recipe, recipe.steps, clone)
    assert status == 0, output[-3000:]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "left_out"), LEFT_OUT)
def test_a_step_that_is_left_out_is_named(name, left_out, clone):
    recipe = RECIPES[name]
    steps = [step for k, step in enumerate(recipe.steps) if k != left_out]
    status, output = result_of(recipe, steps, clone)
    assert status != 0
    assert recipe.steps[left_out].without in output, output[-3000:]
