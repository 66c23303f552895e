"""What is published agrees with itself: version, date, dependencies, licence, entry point."""

import json
import os
import re
import sys
import tomllib
from pathlib import Path

import pytest
import yaml
from packaging.requirements import Requirement
from subprocesses import ran

import clpt_control

HOUSE = Path(__file__).parent.parent
CONDA = {"matplotlib": "matplotlib-base"}  # without a window's toolkit
WHOLE = tomllib.loads((HOUSE / "pyproject.toml").read_text())
PROJECT, TOOLS = WHOLE["project"], WHOLE["tool"]
EXTRAS = PROJECT["optional-dependencies"]
RECIPE = yaml.safe_load((HOUSE / "conda-recipe" / "recipe.yaml").read_text())
CITATION = yaml.safe_load((HOUSE / "CITATION.cff").read_text())


def bounds(requirements):
    """Return name -> bound, named as conda-forge names them."""
    made = [Requirement(text) for text in requirements]
    return {
        CONDA.get(r.name, r.name.lower()): str(r.specifier) for r in made if r.specifier
    }


def conda_bounds(requirements):
    return dict(
        text.rsplit(" ", 1) for text in requirements if not text.startswith("python ")
    )


VERSION, DATE = re.search(
    r"(?m)^## (\S+), (.+)$", (HOUSE / "CHANGELOG.md").read_text()
).groups()
LOWEST, ABOUT = RECIPE["context"]["python_min"], RECIPE["about"]
NAMED = re.findall(r"Python :: (3\.\d+)", "\n".join(PROJECT["classifiers"]))
SAME = [
    (
        VERSION,
        clpt_control.__version__,
        CITATION["version"],
        RECIPE["context"]["version"],
    ),
    (["version"], PROJECT["dynamic"]),
    ({"attr": "clpt_control.__version__"}, TOOLS["setuptools"]["dynamic"]["version"]),
    (DATE, str(CITATION.get("date-released", "not yet released"))),
    (ABOUT["summary"], PROJECT["description"]),
    (ABOUT["license"], PROJECT["license"], CITATION["license"]),
    ([ABOUT["license_file"]], PROJECT["license-files"]),
    (LOWEST, NAMED[0], TOOLS["mypy"]["python_version"]),
    (f">={LOWEST}", PROJECT["requires-python"]),
    (f"py{LOWEST.replace('.', '')}", TOOLS["ruff"]["target-version"]),
]


@pytest.mark.parametrize("said", SAME, ids=lambda said: str(said[0]))
def test_what_several_files_say_is_the_same(said):
    assert all(one == said[0] for one in said)
    assert (HOUSE / ABOUT["license_file"]).is_file()


def test_the_conda_recipe_takes_what_pip_takes():
    needs = RECIPE["requirements"]
    assert conda_bounds(needs["run"]) == bounds(PROJECT["dependencies"])
    assert conda_bounds(needs["run_constraints"]) == bounds(
        EXTRAS["sea"] + EXTRAS["ensemble"]
    )
    builds = bounds(WHOLE["build-system"]["requires"])
    assert (
        builds.items()
        <= dict(t.split(" ", 1) for t in needs["host"] if " " in t).items()
    )
    [(name, target)] = PROJECT["scripts"].items()
    assert RECIPE["build"]["python"]["entry_points"] == [f"{name} = {target}"]


def test_pinned_versions_are_allowed():
    pins = dict(
        line.split("==") for line in (HOUSE / "constraints.txt").read_text().split()
    )
    pins = {name.lower().replace("_", "-"): version for name, version in pins.items()}
    for needed in map(Requirement, sum(EXTRAS.values(), PROJECT["dependencies"])):
        pinned = pins.get(needed.name.lower().replace("_", "-"), "")
        assert not needed.specifier or needed.specifier.contains(pinned), (
            f"{needed}: {pinned}"
        )


# --- SECURITY.md ---------------------------------------------------------------------------------


def test_each_line_has_its_tests():
    rows = re.findall(
        r"(?m)^\| .*(?<!\| tests \|)$", (HOUSE / "SECURITY.md").read_text("utf-8")
    )
    texts = [path.read_text("utf-8") for path in (HOUSE / "tests").rglob("test_*.py")]
    there = {
        name for text in texts for name in re.findall(r"^def (test_\w+)\(", text, re.M)
    }
    assert len(rows) > 12
    for row in rows:
        named = re.findall(r"`(test_\w+)`", row.rsplit("|", 2)[1])
        assert named, row
        assert set(named) <= there, row


# --- the core alone ------------------------------------------------------------------------------

MODULES = {
    Requirement(one).name for extra in ("sea", "ensemble") for one in EXTRAS[extra]
}
BLOCKED = f"""
import os, sys
from importlib.machinery import PathFinder

class Lacking(PathFinder):
    @classmethod
    def find_spec(cls, name, path=None, target=None):
        absent = name.partition(".")[0] in {MODULES - {"pandas"}}  # xarray brings pandas
        return None if absent else super().find_spec(name, path, target)

sys.meta_path[sys.meta_path.index(PathFinder)] = Lacking
os.environ["MPLBACKEND"] = "agg"
"""
CORE = """
import clpt_control as clpt
from law_blocks import papers_law

law = papers_law()
assert clpt.prove(law, points=100).status == "proved"
short = scenario.with_values({"run.duration": 40})
own = clpt.simulate(clpt.closed_loop(short, law=law))
assert own.clpt.kind == "run"
clpt.report(own.isel(time=[-1]), "page.html")
clpt.save_run(own, "own.nc")
clpt.save_run(clpt.simulate(short), "run.nc")
assert clpt.load_run("own.nc").alpha.equals(own.alpha)
assert clpt.load_scenario("run.nc") == short
"""


def test_the_core_is_at_most_ten_packages():
    assert len(PROJECT["dependencies"]) <= 10
    reasons = (HOUSE / "CONTRIBUTING.md").read_text().replace("-", "_")
    for one in PROJECT["dependencies"]:
        assert re.search(
            rf"^\|.*\b{Requirement(one).name.replace('-', '_')}\b", reasons, re.M
        )


COMMANDS = {
    "replay --sample": "pyproj",
    "ensemble mine.toml --vary learning.gain=0.2:2.0 --members 3 --out e.zarr": "zarr",
    "fit current.nc --out fit.toml": "netCDF4",
}
TOLD = f"""
import contextlib, io, json
from clpt_control.app.cli import main
told = {{}}
for words in {["init mine.toml", "laws", *COMMANDS]}:
    sys.argv = ["clpt", *words.split()]
    with contextlib.redirect_stderr(io.StringIO()) as complaint:
        try:
            status = main()
        except SystemExit as ended:
            status = ended.code
    told[words] = [status or 0, " ".join(complaint.getvalue().split())]
open("told.json", "w").write(json.dumps(told))
"""


@pytest.fixture(scope="module")
def said(tmp_path_factory):
    """The status and complaint of commands, in a process that runs ten lines and a law first."""
    folder = tmp_path_factory.mktemp("core")
    (folder / "current.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
    readme = (HOUSE / "README.md").read_text()
    [lines] = re.findall(r"## The paper.*?```python\n(.*?)```", readme, re.S)
    (folder / "mine.py").write_text(BLOCKED + "import xarray\n" + lines + CORE + TOLD)
    places = [str(HOUSE / "tests/support"), os.environ.get("PYTHONPATH", "")]
    env = os.environ | {"PYTHONPATH": os.pathsep.join(places)}
    ran(sys.executable, "mine.py", cwd=folder, env=env)
    assert (folder / "page.html").stat().st_size > 10_000
    return json.loads((folder / "told.json").read_text())


@pytest.mark.long
def test_the_ten_lines_a_proof_a_law_a_page_and_commands_need_no_extra(said):
    assert said["init mine.toml"][0] == said["laws"][0] == 0


@pytest.mark.long
@pytest.mark.parametrize("words", COMMANDS)
def test_what_is_missing_is_said_by_name_with_the_command(said, words):
    package, (status, complaint) = COMMANDS[words], said[words]
    extra = "ensemble" if package == "zarr" else "sea"
    wanted = sorted({Requirement(one).name for one in EXTRAS[extra]} - {"pandas"})
    sentence = f"{package} is not installed. Install it with: pip install "
    assert (status, sentence + " ".join(wanted) in complaint) == (2, True)
