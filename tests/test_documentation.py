"""Every public name is documented, with parameters, result and example; studies use no others."""

import ast
import functools
import inspect
import re
import runpy
from importlib import import_module
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
from command_line import command
from paths import ROOT
from test_layout import trees

import clpt_control

EQUATION = ["t", "x", "u", "p"]
# an equation or a section of the paper, or an author and a year
SOURCE = re.compile(r"\bEqs?\.|\b[Ss]ection\b|\b[A-Z]\w+ (19|20)\d\d\b")
REFERENCE = Path(__file__).parent.parent / "docs" / "reference"


def is_code(value):
    return inspect.isfunction(value) or inspect.isclass(value)


TOP = {name: getattr(clpt_control, name) for name in clpt_control.__all__}
ROOMS = [value for value in TOP.values() if inspect.ismodule(value)]
EVERY = [clpt_control, *ROOMS]


def public_objects():
    """What `clpt.` and the rooms name in `__all__`, once: the public API."""
    every = [
        (room, name, getattr(room, name)) for room in EVERY for name in room.__all__
    ]
    first = {
        one: f"{room.__name__}.{name}"
        for room, name, one in reversed(every)
        if is_code(one)
    }
    return [(name, one) for one, name in reversed(first.items())]


# classes that public functions return, and that are not made by hand
RESULTS = [
    function.__annotations__["return"]
    for function in (
        clpt_control.connect,
        clpt_control.equations,
        clpt_control.prove,
        clpt_control.fit_parameters,
        clpt_control.currents.fit_current,
        clpt_control.currents.tidal_basis,
        clpt_control.gramian,
    )
]
LAWS = clpt_control.laws()


def methods(cls):
    for name, value in vars(cls).items():
        of_pydantic = name.startswith(("_", "model_"))
        if (
            inspect.isfunction(value) or isinstance(value, property)
        ) and not of_pydantic:
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
            and "overload" not in map(ast.unparse, node.decorator_list)
        ]
    return found


def test_every_file_says_what_it_is():
    assert {name for name, tree in trees().items() if not ast.get_docstring(tree)} <= {
        "data",
        "",
    }


def test_every_name_says_what_it_is():
    for name, top, node, text in all_docstrings():
        if node is top and not node.name.startswith("_"):
            assert text, f"{name} has no docstring"
            arguments = getattr(node, "args", ast.arguments(args=[])).args[:4]
            if [argument.arg for argument in arguments] == EQUATION:
                assert SOURCE.search(text), f"{name} has no source"


def test_docstrings_say_what_is_done():
    words = (
        "Give",
        "Gives",
        "Tell",
        "Tells",
        "Say",
        "Says",
        "Ask",
        "Asks",
        "Let",
        "Lets",
    )
    assert [
        name for name, *_, text in all_docstrings() if text.split(" ", 1)[0] in words
    ] == []


CLAUSES = ["What", "Whether", "How", "Where", "Of", "Which", "When", "Why"]
FENCED = re.compile(r"(?ms)^(`{3,}|:{3,}).*?^\1$")


def test_no_heading_begins_as_a_clause():
    house = REFERENCE.parent.parent
    for path in [*house.glob("*.md"), *house.glob("docs/**/*.md")]:
        for title in re.findall(r"(?m)^#+ (.*)$", FENCED.sub("", path.read_text())):
            assert title.split()[0] not in CLAUSES, f"{path.name}: {title}"


def test_no_help_text_begins_as_a_clause():
    for name, one in command().commands.items():
        for text in [one.help, *(param.help for param in one.params)]:
            assert (text or "-").split()[0] not in CLAUSES, f"{name}: {text}"


def test_no_docstring_begins_as_a_clause():
    for module, tree in trees().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
                first = (ast.get_docstring(node) or "-").split()[0]
                assert first not in CLAUSES, f"{module}: {ast.get_docstring(node)}"


def test_only_public_names_have_sections():
    """Of all others one good line is enough."""
    values = [value for _, value in public_objects()]
    public = {
        one.__name__ for value in values for one in getattr(value, "__mro__", [value])
    } | {type.__name__ for type in RESULTS}
    for value in filter(inspect.isclass, values):  # methods with files of their own
        public |= {
            method.__name__
            for name, method in methods(value)
            if getattr(method, "__qualname__", "") == name
        }
    sections = re.compile(r"^(Parameters|Returns|Raises|Yields)\n---", re.M)
    found = [
        name
        for name, top, _, text in all_docstrings()
        if getattr(top, "name", "") not in public and sections.search(text)
    ]
    assert found == []


@pytest.mark.parametrize(
    "value", [pytest.param(v, id=name) for name, v in public_objects()]
)
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
        section = re.search(r"(?s)Parameters\n---.*?(\n\n|$)", text)
        words = set(re.findall(r"\w+", section[0])) if section else set()
        missing = {name for name in signature.parameters if name[0] != "_"} - words
        assert not missing, f"undocumented parameters {missing}"
        assert "Returns\n----" in text or signature.return_annotation in (None, "None")
    assert ">>>" in text, "no example"


def test_every_public_name_stands_in_the_reference():
    """Once, on the page of its room: in a block ```{names} ROOM of docs/reference."""
    block = re.compile(r"^```\{names\} (\S+)\n(.*?)^```", re.M | re.S)
    text = "\n".join(page.read_text("utf-8") for page in REFERENCE.glob("*.md"))
    shown = [
        f"{room}.{name}"
        for room, names in block.findall(text)
        for name in names.split() or import_module(room).__all__
    ]
    public = {f"{room.__name__}.{name}" for room in ROOMS for name in room.__all__}
    known = {name.rsplit(".", 1)[1] for name in public} | {
        room.__name__[13:] for room in ROOMS
    }
    public |= {f"clpt_control.{name}" for name in TOP if name not in known}
    results = {f"{cls.__module__}.{cls.__qualname__}" for cls in RESULTS}
    assert sorted(shown) == sorted(public | results)


PRINTERS = [
    path
    for path in sorted((ROOT / "tools").glob("print_*.py"))
    if "def page()" in path.read_text("utf-8")
]


@pytest.mark.parametrize("path", PRINTERS, ids=lambda path: path.stem)
def test_a_printed_page_is_current(path):
    tool = runpy.run_path(str(path))
    assert tool["PAGE"].read_text("utf-8") == tool["page"]()


def test_every_key_of_a_scenario_and_every_tide_stands_on_its_page():
    page = (REFERENCE.parent / "scenario.md").read_text("utf-8")
    example = (ROOT / "clpt_control/data/paper.toml").read_text("utf-8")
    tables = {
        "flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0.2]},
        "localization": {"noise": 0.1, "noise_period": 1.0},
    }
    scenario = clpt_control.paper_scenario().with_values(tables)
    of_laws = {f"learning.{law.table}" for law in LAWS.values()}
    keys = {
        key.split(".")[-1] for key, *_ in scenario.every_key() if key not in of_laws
    }
    unknown = {"basis.periods": None, "basis.constituents": ["M2", "K1", "none"]}
    with pytest.raises(clpt_control.ScenarioError, match="steady or one of") as caught:
        scenario.with_values(unknown)
    tides = str(caught.value).rpartition(" one of ")[2].split(", ")
    assert keys | {*tides} <= {*re.findall(r"[\w-]+", page)}
    assert keys <= {*re.findall(r"[\w-]+", example)}


def test_equations_are_found_by_their_numbers():
    text = "".join(
        p.read_text() for p in Path(clpt_control.__file__).parent.rglob("*.py")
    )
    assert [n for n in range(1, 36) if f"Eq. ({n})" not in text] == []


def test_links_of_the_engines_page_exist_and_reach_each_of_its_folders():
    page = REFERENCE.parent / "engine.md"
    links = {
        page.parent / name for name in re.findall(r"\]\((\S+?)\)", page.read_text())
    }
    assert all(link.exists() for link in links)
    engine = REFERENCE.parents[1] / "clpt_control" / "engine"
    folders = {path.parent for path in engine.glob("*/*.py")}
    assert folders <= {link.resolve().parent for link in links}


ROOT = Path(__file__).parent.parent
FILES = [
    path
    for room in ("examples", "analysis")
    for path in sorted((ROOT / room).glob("*.py"))
]


def is_public(name):
    """Whether `clpt.` or one of its rooms lists a name, such as "replay.aims"."""
    room, _, own = name.rpartition(".")
    held = TOP.get(room) if room else clpt_control
    return inspect.ismodule(held) and own in held.__all__


def names_of(tree, internals=False):
    """Public names that a file uses; with `internals` it may import files by their path too."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and f"{node.module}.".startswith(
            "clpt_control."
        ):
            room = node.module.partition(".")[2]
            if "." not in room or not internals:
                yield from (f"{room}.{one.name}".lstrip(".") for one in node.names)
        elif isinstance(node, ast.Import):
            own = (one.name.partition("clpt_control.") for one in node.names)
            yield from (name for before, _, name in own if name and not before)
        elif isinstance(node, ast.Attribute) and not node.attr.startswith("__"):
            match node:
                case ast.Attribute(ast.Name("clpt"), name):
                    yield name
                case ast.Attribute(ast.Attribute(ast.Name("clpt"), room), name):
                    if inspect.ismodule(getattr(clpt_control, room, None)):
                        yield f"{room}.{name}"


@pytest.mark.parametrize(
    "path", FILES, ids=lambda path: f"{path.parent.name}/{path.name}"
)
def test_only_public_names_are_used(path):
    private = {
        one
        for one in names_of(
            ast.parse(path.read_text("utf-8")), path.parent.name == "analysis"
        )
        if not is_public(one)
    }
    assert private == set()


def test_the_style_is_that_of_the_packages_own_figures():
    with plt.style.context("clpt_control.data.house"):
        colours = plt.rcParams["axes.prop_cycle"].by_key()["color"]
        run = clpt_control.simulate(clpt_control.parts.lag(1.0), [0, 1], [0, 1])
        runs = {"a": run, "b": run}
        (own, *_) = clpt_control.compare(runs)
        assert [*dict.fromkeys(line.get_color() for line in own.lines)] == colours[:2]
        both = plt.figure().subplots(), own
    for ax in both:
        assert [ax.spines[side].get_visible() for side in ("top", "right", "left")] == [
            0,
            0,
            1,
        ]
    lines = [ax.xaxis.get_gridlines()[0] for ax in both]
    assert (
        len(
            {(one.get_visible(), one.get_linewidth(), one.get_alpha()) for one in lines}
        )
        == 1
    )


# --- docs/each_law.md ----------------------------------------------------------------------------

SECTIONS = ROOT / "docs" / "_extensions" / "law_sections.py"


def test_the_page_of_laws_names_each():
    page = (REFERENCE.parent / "laws.md").read_text("utf-8")
    assert [name for name in LAWS if f"`{name}`" not in page] == []


def test_the_page_of_each_law_has_a_section_for_each():
    text = runpy.run_path(str(SECTIONS))["sections"]()
    heads = "".join(re.findall(r"(?m)^## .*", text))
    assert [name for name in LAWS if f"`{name}`" not in heads] == []
    assert text.count(" promises: ") == len(LAWS)
    assert r"\alpha' &= - \gamma e \phi ( x )^{\top}" in text  # Eq. (21)
    page = ["# Each law"]
    runpy.run_path(str(SECTIONS))["append_sections"](None, "each_law", page)
    assert page[0].endswith(text)


@pytest.mark.parametrize("name", LAWS)
def test_the_command_prints_a_laws_page(clpt, printed, name):
    law, out = LAWS[name], clpt("laws", name).out
    [(listed, told)] = printed("laws", name)["laws"].items()
    assert (listed, told["page"], [*told["settings"]]) == (
        name,
        law.page,
        [*law.settings],
    )
    assert len(told["promises"]) == len(law.promises)
    assert [
        one for one in (law.page.splitlines()[0], *told["promises"]) if one not in out
    ] == []


def test_the_command_lists_all_and_refuses_others(clpt, printed, refused):
    assert list(printed("laws")["laws"]) == list(LAWS)
    assert all(name in clpt("laws").out for name in LAWS)
    assert (
        refused("laws", "sgma")
        == "clpt: laws: there is no sgma. Did you mean 'sigma'?\n"
    )


def test_the_paper_has_the_journals_sections_and_length():
    """Those of the Journal of Open Source Software: 750 to 1750 words; citations exist."""
    text = (ROOT / "paper.md").read_text("utf-8").split("---\n", 2)[2]
    headings = re.findall(r"^# (.*)$", text, re.M)
    needed = ["Summary", "Statement of need", "State of the field", "Software design"]
    assert headings[:4] == needed
    assert headings[4] == "Research impact statement"
    assert headings[-1] == "References"
    assert 750 <= len(text.split()) <= 1750
    cited = set(re.findall(r"@(\w+)", text))
    known = re.findall(r"^@\w+\{(\w+),", (ROOT / "paper.bib").read_text("utf-8"), re.M)
    assert cited == {*known}


def test_notebooks_leave_out_tests_and_links_to_pages():
    """`make notebooks`; what it needs is installed by `make docs`."""
    pytest.importorskip("myst_nb")
    pytest.importorskip("nbclient")
    tool = runpy.run_path(str(ROOT / "tools" / "write_notebooks.py"))
    cells = tool["notebook_of"](
        "---\nfile_format: mystnb\nkernelspec:\n  name: python3\n---\n\n"
        "[Here](a.md#b), [there](https://a.org)\n\n"
        "```{code-cell} ipython3\nx = 1\n```\n\n"
        "```{code-cell} ipython3\n:tags: [remove-cell]\n\nassert x == 1\n```\n"
    ).cells
    assert [(cell.cell_type, cell.source) for cell in cells] == [
        ("markdown", "Here, [there](https://a.org)"),
        ("code", "x = 1"),
    ]
