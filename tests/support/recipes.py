"""Recipes of CONTRIBUTING as data: steps, what is promised, and tests that then pass."""

import textwrap
from typing import NamedTuple


class Step(NamedTuple):
    """A step of a recipe: texts of files that change, and words of the failure without it."""

    name: str
    without: str
    edits: tuple[tuple[str, str, str], ...]  # file, old text, new; no old: at the end


class Recipe(NamedTuple):
    """A recipe: its heading in CONTRIBUTING, Python that then runs, and tests that then pass."""

    heading: str
    steps: tuple[Step, ...]
    promise: str
    tests: tuple[str, ...]


def row(file, text):
    """Return the edit that adds a text to the end of a file of the package."""
    return ((f"clpt_control/{file}", "", textwrap.dedent(text)),)


KIND = Recipe(
    "Add a kind of disturbance",
    (
        Step(
            "row",
            "'half'",
            row(
                "paper/blocks/disturbance.py",
                '''
                def half(t, x, u, p):
                    """Delta = a/2, Eq. (32)."""
                    return 0.5 * p.amplitude

                KINDS["half"] = DisturbanceKind(
                    half, None, {"period": False}, bounded=True, random=False, rms=0.5
                )
                ''',
            ),
        ),
        Step(
            "page of scenarios",
            "docs/scenario.md",
            (
                (
                    "docs/scenario.md",
                    "`noise`; `amplitude`",
                    "`noise`, `half`; `amplitude`",
                ),
            ),
        ),
        Step(
            "example",
            "data/paper.toml",
            (
                (
                    "clpt_control/data/paper.toml",
                    "square or noise",
                    "square, noise or half",
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    table = {"kind": "half", "amplitude": [0.2, 0.4]}
    loop = clpt.closed_loop(clpt.paper_scenario().with_values({"flow.disturbance": table}))
    assert clpt.simulate(loop, [0.0, 1.0]).delta.values.tolist() == [[0.1, 0.2]] * 2
    """,
    (
        "tests/paper/blocks/test_disturbance_kinds.py::"
        "test_documentation_and_the_example_name_each_kind",
    ),
)
KERNEL = Recipe(
    "Add a flow",
    (
        Step(
            "kernel",
            "basis.kernel = 'rational'",
            row(
                "paper/blocks/flow.py",
                '''
                def rational(t, x, u, p):
                    """phi_i = 1/(1 + d^2/s^2) tide, Eq. (5)."""
                    return tide(t, p) / (1.0 + squared_distance(u, p) / p.widths**2)

                KERNELS["rational"] = rational
                ''',
            ),
        ),
    ),
    """
    import clpt_control as clpt
    scenario = clpt.paper_scenario().with_values({"basis.kernel": "rational"})
    clpt.check(scenario.basis_block())
    assert clpt.simulate(scenario, [0.0, 20.0]).attrs["engine"] == "native"
    """,
    (),
)
LAW = Recipe(
    "Add a law",
    (
        Step(
            "rates and row",
            "COPIED",
            row(
                "paper/laws/robust.py",
                '''
                def copied(t, x, u, p):
                    """The rates of Eqs. (21)-(23). Source: section III."""
                    return learned_flow(t, x, u, p)

                from .paper import LEARNED_FLOW
                COPIED = LEARNED_FLOW._replace(name="copied", rates=copied)
                ''',
            ),
        ),
        Step(
            "table", "'copied'", row("paper/laws/robust.py", "LAWS = (*LAWS, COPIED)\n")
        ),
        Step(
            "page of laws", "'copied'", (("docs/laws.md", "", "\n`copied`: a copy.\n"),)
        ),
    ),
    """
    import clpt_control as clpt
    law = clpt.laws()["copied"]
    assert clpt.prove(law.of(2, gain=0.5), points=200).status == "proved"
    assert clpt.check(law.of(2, gain=0.5)) is not False
    """,
    ("tests/test_documentation.py::test_the_page_of_laws_names_each",),
)
COMMANDS = "clpt_control/app/cli/__init__.py"
COMMAND = Recipe(
    "Add a command or an option",
    (
        Step(
            "function",
            "place",
            row(
                "app/cli/tracks.py",
                '''
                def place(as_json: Json = False) -> None:
                    """Print where the paper's vehicle starts.

                    Example:
                        clpt place --json
                    """
                    position = [*clpt.paper_scenario().vehicle.position]
                    sentences = [f"It starts at {position}."]
                    finish([Result(sentences=sentences)], {"position": position}, as_json)
                ''',
            ),
        ),
        Step(
            "group",
            "place",
            (
                (COMMANDS, "import excitation", "import excitation, place"),
                (COMMANDS, "excitation, tune)", "excitation, tune, place)"),
            ),
        ),
        Step(
            "tests",
            "'place'",
            (
                (
                    "tests/support/command_outputs.py",
                    "FOLLOW: None,",
                    'FOLLOW: None, ("place",): (),',
                ),
            ),
        ),
        Step(
            "cheat sheet",
            "test_the_cheat_sheet_has_every_command",
            (("docs/cheatsheet.md", "`clpt laws`,", "`clpt laws`, `clpt place`,"),),
        ),
    ),
    """
    import json, subprocess, sys
    words = [sys.executable, "-m", "clpt_control", "place", "--json"]
    done = subprocess.run(words, capture_output=True, text=True)
    assert json.loads(done.stdout or "{}") == {"position": [0.0, 0.0]}, done
    """,
    ("tests/app/cli/test_cli.py", "-k", "page_lists or cheat or (help_is and place)"),
)
ROW = "        np.cbrt,\n"


def part(name, without, text):
    """Return the step that adds a field to the row of an operation."""
    edit = "clpt_control/engine/record/operations.py", ROW, f"{ROW}        {text},\n"
    return Step(name, without, (edit,))


OPERATION = Recipe(
    "Add an operation",
    (
        Step(
            "row and NumPy function",
            "no cbrt in C",
            (
                (
                    "clpt_control/engine/record/operations.py",
                    '    "log10": _libm(',
                    f'    "cbrt": Row(\n{ROW}    ),\n    "log10": _libm(',
                ),
            ),
        ),
        part(
            "slopes",
            "the derivative of `cbrt`",
            "slopes=(lambda a, f: 1.0 / (3.0 * f * f),)",
        ),
        part(
            "SymPy",
            "the backend 'symbolic'",
            "sympy=lambda s, a: s.sign(a) * s.Abs(a) ** s.Rational(1, 3)",
        ),
        part("machine code", "cbrt: has no machine code", 'llvm="libm"'),
        part("C", "missing 1 required keyword-only argument: 'c'", 'c="cbrt"'),
    ),
    """
    import numpy as np, warnings
    import clpt_control as clpt

    def root(t, x, u, p):
        return np.cbrt(u[0])

    block = clpt.Block("root", output=root, inputs={"u": 1}, outputs={"y": 1})
    warnings.simplefilter("error")
    clpt.check(block)
    assert clpt.simulate(block, [0.0, 1.0], 8.0).y.values.tolist() == [2.0, 2.0]
    assert "cbrt(" in clpt.export(block), "no cbrt in C"
    slope = clpt.linearize(block, [], [8.0]).D[0, 0]
    assert abs(slope - 1 / 12) < 1e-12, f"slope {slope}"
    """,
    ("tests/engine/codegen/test_operations_in_c.py",),
)
FUNCTION = Recipe(
    "Add an operation",
    (
        Step(
            "row",
            "np.real_if_close",
            (
                (
                    "clpt_control/engine/trace/numpy_functions.py",
                    "OF_AN_ARRAY: dict[Any, Callable] = {",
                    "OF_AN_ARRAY: dict[Any, Callable] = {\n"
                    "    np.real_if_close: lambda a, tol=100: a,",
                ),
            ),
        ),
    ),
    """
    import numpy as np, warnings
    import clpt_control as clpt

    def real(t, x, u, p):
        return np.real_if_close(u.u)

    block = clpt.Block("real", output=real, inputs={"u": 2}, outputs={"y": 2})
    warnings.simplefilter("error")
    clpt.check(block)
    run = clpt.simulate(block, [0.0, 1.0], [1.0, 3.0])
    assert (run.attrs["engine"], run.y.values[0].tolist()) == ("native", [1.0, 3.0])
    """,
    (),
)
FIRST = '    "backlash": ['
PART = Recipe(
    "Add a block",
    (
        Step(
            "equations and maker",
            "flip",
            row(
                "parts/flip.py",
                '''
                """Sign change: y = -u. Source: section II."""

                from ..base.arguments import public
                from ..engine.model.block import Block


                def flipped(t, x, u, p):
                    """y = -u, section II."""
                    return -u.u


                @public
                def flip() -> Block:
                    """Return the negative of a signal.

                    Returns
                    -------
                    Block
                        With the input u[1] and the output y[1].

                    Examples
                    --------
                    >>> flip().output(0, [], [2.0]).tolist()
                    [-2.0]
                    """
                    return Block("flip", output=flipped, inputs={"u": 1}, outputs={"y": 1})
                ''',
            ),
        ),
        Step(
            "stub",
            "flip",
            (
                (
                    "clpt_control/parts/__init__.pyi",
                    "from .lags import delay",
                    "from .flip import flip as flip\nfrom .lags import delay",
                ),
            ),
        ),
        Step(
            "conformance",
            "'flip'",
            (
                (
                    "tests/support/package_blocks.py",
                    FIRST,
                    f'    "flip": [((), {{}})],\n{FIRST}',
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    clpt.check(clpt.parts.flip())
    """,
    (
        "tests/test_documentation.py::test_every_public_name_stands_in_the_reference",
        "tests/engine/conformance/test_conformance.py",
        "-k",
        "reference or every_part or flip or docstrings_name",
    ),
)
RECIPES = {"kind": KIND, "kernel": KERNEL, "law": LAW, "command": COMMAND}
RECIPES |= {"operation": OPERATION, "function": FUNCTION, "part": PART}
