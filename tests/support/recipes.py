"""Recipes of CONTRIBUTING on rows as data: steps, what is promised, and tests that then pass."""

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
            "line of the docstring",
            "disturbance.__doc__",
            (
                (
                    "clpt_control/paper/blocks/disturbance.py",
                    "\n\na is the amplitude",
                    "\n    half       Delta = a/2\n\na is the amplitude",
                ),
            ),
        ),
        Step(
            "page of scenarios",
            "test_the_pages_are_current",
            (
                ("docs/scenario.md", "square, noise", "square, noise, half"),
                (
                    "clpt_control/data/paper.toml",
                    "square, noise",
                    "square, noise, half",
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
        "test_the_docstring_and_the_example_name_each_kind",
        "tests/test_scenario_page.py",
    ),
)
FORMULAS = "tests/paper/blocks/test_blocks_closed_forms.py"
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

                KERNELS["rational"] = Kernel(
                    rational, "1/(1 + d^2/s^2)", lambda s: s, 0.375 * np.sqrt(3)
                )
                ''',
            ),
        ),
        Step(
            "formula",
            "KeyError: 'rational'",
            (
                (
                    FORMULAS,
                    "FORMULAS = {",
                    'FORMULAS = {\n    "rational": lambda d: 1 / (1 + d * d / 9),',
                ),
            ),
        ),
        Step(
            "page of scenarios",
            "test_the_pages_are_current",
            (
                (
                    "docs/scenario.md",
                    "exp(-d²/s)",
                    "exp(-d²/s); rational: 1/(1 + d²/s²)",
                ),
                (
                    "clpt_control/data/paper.toml",
                    "exp(-d^2/s)",
                    "exp(-d^2/s); rational: 1/(1 + d^2/s^2)",
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    scenario = clpt.paper_scenario().with_values({"basis.kernel": "rational"})
    clpt.check(scenario.basis_block())
    assert clpt.simulate(scenario, [0.0, 20.0]).attrs["engine"] == "native"
    """,
    (
        FORMULAS,
        "tests/test_scenario_page.py",
        "-k",
        "each_kernel or many_places or functions_ or of_a_kernel or pages_are",
    ),
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
                    """The rates of Eqs. (21)-(23) with 2 e. Source: section III."""
                    return driven_by(2 * u.e, u, p)

                def twice(t, x, u, p):
                    """V of Eq. (24) with |e|^2 in place of |e|^2/2."""
                    V = lyapunov.level(u.e, u, p) + lyapunov.flow_level(u, p)
                    return {"V": V + u.e @ u.e / 2}

                from .paper import LEARNED_FLOW
                COPIED = LEARNED_FLOW._replace(name="copied", rates=copied, candidate=twice)
                ''',
            ),
        ),
        Step(
            "table", "'copied'", row("paper/laws/robust.py", "LAWS = (*LAWS, COPIED)\n")
        ),
        Step(
            "own V",
            "test_V_is_zero_at_the_truth_and_e_squared_over_2_beside_it[copied]",
            (
                (
                    "tests/paper/blocks/test_table_of_laws.py",
                    "OWN_V = {",
                    'OWN_V = {\n    "copied": lambda e, p: np.dot(e, e),',
                ),
            ),
        ),
        Step(
            "page of laws",
            "'copied'",
            (("docs/laws.md", "", "\n`copied`: twice the rates.\n"),),
        ),
        Step(
            "page of Coq",
            "test_every_law_has_a_file_or_a_reason",
            (("docs/machine_checked.md", "every $N$).\n", "every $N$), `copied`.\n"),),
        ),
    ),
    """
    import clpt_control as clpt
    law = clpt.laws()["copied"]
    assert clpt.prove(law.of(2, gain=0.5), points=200).status == "proved"
    assert clpt.check(law.of(2, gain=0.5)) is not False
    """,
    (
        "tests/test_documentation.py::test_the_page_of_laws_names_each",
        "tests/theory/test_coq.py::test_every_law_has_a_file_or_a_reason",
        "tests/paper/blocks/test_table_of_laws.py",
    ),
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
ADDITIONS = {"kind": KIND, "kernel": KERNEL, "law": LAW, "command": COMMAND}
