"""Every public name is documented, with parameters, result and example; studies use no others."""

import ast
import functools
import inspect
import re
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
from test_layout import trees

import clpt_control
from clpt_control import figures
from clpt_control.blocks.laws.table import LAWS
from clpt_control.scenario.tidal_periods import SPEEDS

EQUATION = ["t", "x", "u", "p"]
REFERENCE = Path(__file__).parent.parent / "docs" / "reference"


def is_code(value):
    return inspect.isfunction(value) or inspect.isclass(value)


def rooms():
    yield clpt_control
    for name in clpt_control.__all__:
        if inspect.ismodule(value := getattr(clpt_control, name)):
            yield value


def public_objects():
    """What `clpt.` and the rooms name in `__all__`, once: the public API."""
    seen = set()
    for room in rooms():
        for name in room.__all__:
            value = getattr(room, name)
            if is_code(value) and value not in seen:
                seen.add(value)
                yield f"{room.__name__}.{name}", value


def methods(cls):
    for name, value in vars(cls).items():
        if name.startswith(("_", "model_")):  # pydantic's own
            continue
        if inspect.isfunction(value) or isinstance(value, property):
            yield name, value


def summary(text):
    return text.strip().splitlines()[0]


@functools.cache
def all_docstrings():
    """Each function and class of the package: its file and name, what it stands in, itself."""
    found = []
    for name, tree in trees().items():
        inner = {n: top for top in tree.body for n in ast.walk(top)}
        found += [
            (f"{name}.{node.name}", inner[node], node, ast.get_docstring(node) or "")
            for node in inner
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)
        ]
    return found


def test_every_file_says_what_it_is():
    empty = ("data", "")
    bare = [name for name, tree in trees().items() if not ast.get_docstring(tree)]
    assert [name for name in bare if name not in empty] == []


def test_every_name_says_what_it_is():
    for name, top, node, text in all_docstrings():
        if node is top and not node.name.startswith("_"):
            assert text, f"{name} has no docstring"
            if [a.arg for a in getattr(node, "args", ast.arguments(args=[])).args][:4] == EQUATION:
                source = r"Eqs?\.|section|from the grid|outputs are the states"
                assert re.search(source, text), f"{name} has no source"


def test_docstrings_say_what_is_done():
    words = ("Give", "Gives", "Tell", "Tells", "Say", "Says", "Ask", "Asks", "Let", "Lets")
    assert [name for name, *_, text in all_docstrings() if text.split(" ", 1)[0] in words] == []


def test_only_public_names_have_sections():
    """Of all others one good line is enough."""
    values = [value for _, value in public_objects()]
    public = {one.__name__ for value in values for one in getattr(value, "__mro__", [value])}
    sections = re.compile(r"^(Parameters|Returns|Raises|Yields)\n---", re.M)
    found = [
        name
        for name, top, _, text in all_docstrings()
        if getattr(top, "name", "") not in public and sections.search(text)
    ]
    assert found == []


@pytest.mark.parametrize("value", [pytest.param(v, id=name) for name, v in public_objects()])
def test_documented(value):
    text = inspect.getdoc(value)
    assert text, "no docstring"
    assert len(summary(text)) < 64, f"summary has {len(summary(text))} characters"
    if inspect.isclass(value):
        for name, method in methods(value):
            said = inspect.getdoc(method)
            assert said, f"{name} has no docstring"
            assert len(summary(said)) < 64, f"{name}: {summary(said)}"
        if issubclass(value, Exception):
            return
    else:
        signature = inspect.signature(value)
        names = [name for name in signature.parameters if not name.startswith("_")]
        if names:
            assert "Parameters\n---" in text
            section = text.split("Parameters\n", 1)[1].split("\n\n")[0]
            missing = [name for name in names if not re.search(rf"\b{name}\b", section)]
            assert not missing, f"undocumented parameters {missing}"
        assert "Returns\n----" in text or signature.return_annotation in (None, "None")
    assert ">>>" in text, "no example"


def test_every_public_name_stands_in_the_reference():
    """Once, on the page of its room: in a block ```{names} ROOM of docs/reference."""
    block = re.compile(r"^```\{names\} (\S+)\n(.*?)^```", re.M | re.S)
    shown = [
        f"{room}.{name}"
        for page in REFERENCE.glob("*.md")
        for room, names in block.findall(page.read_text("utf-8"))
        for name in names.split()
    ]
    top, *below = rooms()
    public = {f"{room.__name__}.{name}" for room in below for name in room.__all__}
    known = {name.rsplit(".", 1)[1] for name in public} | {room.__name__[13:] for room in below}
    public |= {f"{top.__name__}.{name}" for name in top.__all__ if name not in known}
    assert sorted(shown) == sorted(public)


def test_the_reference_begins_with_what_clpt_reaches():
    page = (REFERENCE / "index.md").read_text("utf-8")
    values = {name: getattr(clpt_control, name) for name in clpt_control.__all__}
    wanted = [n for n, v in values.items() if is_code(v) and not is_error(v)]
    assert [name for name in wanted if f"`clpt.{name}`" not in page] == []


def is_error(value):
    return inspect.isclass(value) and issubclass(value, clpt_control.ClptError)


def test_every_key_of_a_scenario_and_every_tide_stands_on_its_page():
    words = set(re.findall(r"[\w-]+", (REFERENCE.parent / "scenario.md").read_text("utf-8")))
    of_laws = {f"learning.{law.table}" for law in LAWS.values()}
    keys = {key for key, _, _ in clpt_control.paper_scenario().every_key()} - of_laws
    assert {key.split(".")[-1] for key in keys} | {*SPEEDS} <= words


def test_equations_are_found_by_their_numbers():
    text = "".join(p.read_text() for p in Path(clpt_control.__file__).parent.rglob("*.py"))
    missing = [
        n
        for n in (1, 2, 3, 4, 5, 6, 7, 10, 13, 14, 15, 17, 20, 21, 22, 23, 24, 27, 28, 32)
        if f"Eq. ({n})" not in text
    ]
    assert missing == []


def test_every_file_of_the_engine_is_on_its_page():
    page = REFERENCE.parent / "engine.md"
    links = {page.parent / name for name in re.findall(r"\]\((\S+?)\)", page.read_text())}
    assert all(link.exists() for link in links)
    files = {path.resolve() for path in links}
    engine = (REFERENCE.parents[1] / "clpt_control/native").glob("*.py")
    assert {path for path in engine if path.stem != "__init__"} <= files


ROOT = Path(__file__).parent.parent
FILES = [path for room in ("examples", "analysis") for path in sorted((ROOT / room).glob("*.py"))]


def is_public(name):
    """Whether `clpt.` or one of its rooms lists a name, such as "replay.aims"."""
    room, _, own = name.rpartition(".")
    if not room:
        return own in clpt_control.__all__
    held = getattr(clpt_control, room, None) if room in clpt_control.__all__ else None
    return inspect.ismodule(held) and own in held.__all__


def names_of(tree):
    """Names of the package that a file imports, or asks of `clpt.`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and f"{node.module}.".startswith("clpt_control."):
            room = node.module.partition(".")[2]
            yield from (f"{room}.{one.name}".lstrip(".") for one in node.names)
        elif isinstance(node, ast.Import):
            yield from (
                one.name.partition(".")[2]
                for one in node.names
                if one.name.startswith("clpt_control.")
            )
        elif isinstance(node, ast.Attribute) and not node.attr.startswith("__"):
            match node:
                case ast.Attribute(ast.Name("clpt"), name):
                    yield name
                case ast.Attribute(ast.Attribute(ast.Name("clpt"), room), name):
                    if inspect.ismodule(getattr(clpt_control, room, None)):
                        yield f"{room}.{name}"


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_only_public_names_are_used(path):
    private = {one for one in names_of(ast.parse(path.read_text("utf-8"))) if not is_public(one)}
    assert private == set()


def test_the_style_is_that_of_the_packages_own_figures():
    with plt.style.context("clpt_control.data.house"):
        assert plt.rcParams["axes.prop_cycle"].by_key()["color"] == list(figures.COLOURS)
        ours = plt.figure().subplots()
    _, theirs = figures.new_figure()
    for ax in (ours, theirs):
        assert [ax.spines[side].get_visible() for side in ("top", "right", "left")] == [0, 0, 1]
    lines = [ax.xaxis.get_gridlines()[0] for ax in (ours, theirs)]
    assert len({(one.get_visible(), one.get_linewidth(), one.get_alpha()) for one in lines}) == 1
