"""Examples and studies use public names only, and the package's style of figures."""

import ast
import inspect
from pathlib import Path

import matplotlib.pyplot as plt
import pytest

import clpt_control as clpt
from clpt_control import figures

ROOT = Path(__file__).parent.parent
FILES = [path for room in ("examples", "analysis") for path in sorted((ROOT / room).glob("*.py"))]


def is_public(name):
    """Whether `clpt.` or one of its rooms lists a name, such as "replay.aims"."""
    room, _, own = name.rpartition(".")
    if not room:
        return own in clpt.__all__
    held = getattr(clpt, room, None) if room in clpt.__all__ else None
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
                    if inspect.ismodule(getattr(clpt, room, None)):
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
