"""What is published agrees with itself: version, date, dependencies, licence, entry point."""

import re
import tomllib
from pathlib import Path

import yaml
from packaging.requirements import Requirement

import clpt_control

HOUSE = Path(__file__).parent.parent
CONDA = {"matplotlib": "matplotlib-base"}  # without a window's toolkit
PROJECT = tomllib.loads((HOUSE / "pyproject.toml").read_text())
RECIPE = yaml.safe_load((HOUSE / "conda-recipe" / "recipe.yaml").read_text())
CITATION = yaml.safe_load((HOUSE / "CITATION.cff").read_text())


def bounds(requirements):
    """Return name -> bound, named as conda-forge names them."""
    made = [Requirement(text) for text in requirements]
    return {CONDA.get(r.name, r.name.lower()): str(r.specifier) for r in made if r.specifier}


def conda_bounds(requirements):
    return dict(text.rsplit(" ", 1) for text in requirements if not text.startswith("python "))


def test_one_version_and_one_date():
    said = re.search(r"^## (\S+), (.+)$", (HOUSE / "CHANGELOG.md").read_text(), re.M)
    version, date = said.groups()
    assert PROJECT["project"]["dynamic"] == ["version"]
    dynamic = PROJECT["tool"]["setuptools"]["dynamic"]["version"]
    assert dynamic == {"attr": "clpt_control.__version__"}
    assert version == clpt_control.__version__ == CITATION["version"]
    assert RECIPE["context"]["version"] == version
    assert str(CITATION.get("date-released", "not yet released")) == date


def test_the_conda_recipe_takes_what_pip_takes():
    extras = PROJECT["project"]["optional-dependencies"]
    needs = RECIPE["requirements"]
    assert conda_bounds(needs["run"]) == bounds(PROJECT["project"]["dependencies"])
    assert conda_bounds(needs["run_constraints"]) == bounds(extras["sea"] + extras["ensemble"])
    builds = bounds(PROJECT["build-system"]["requires"])
    assert builds.items() <= dict(t.split(" ", 1) for t in needs["host"] if " " in t).items()
    [(name, target)] = PROJECT["project"]["scripts"].items()
    assert RECIPE["build"]["python"]["entry_points"] == [f"{name} = {target}"]


def test_one_description_and_one_licence():
    about, project = RECIPE["about"], PROJECT["project"]
    assert about["summary"] == project["description"]
    assert about["license"] == project["license"] == CITATION["license"]
    assert [about["license_file"]] == project["license-files"]
    assert (HOUSE / about["license_file"]).is_file()


def test_one_lowest_python():
    lowest = RECIPE["context"]["python_min"]
    named = re.findall(r"Python :: (3\.\d+)", "\n".join(PROJECT["project"]["classifiers"]))
    assert (PROJECT["project"]["requires-python"], named[0]) == (f">={lowest}", lowest)
    assert PROJECT["tool"]["mypy"]["python_version"] == lowest
    assert PROJECT["tool"]["ruff"]["target-version"] == f"py{lowest.replace('.', '')}"


def test_pinned_versions_are_allowed():
    pins = dict(line.split("==") for line in (HOUSE / "constraints.txt").read_text().split())
    pins = {name.lower().replace("_", "-"): version for name, version in pins.items()}
    extras = PROJECT["project"]["optional-dependencies"].values()
    for needed in map(Requirement, sum(extras, PROJECT["project"]["dependencies"])):
        pinned = pins.get(needed.name.lower().replace("_", "-"), "")
        assert not needed.specifier or needed.specifier.contains(pinned), f"{needed}: {pinned}"
