"""Recipes of CONTRIBUTING on methods, options, results and messages, as data."""

from paths import TESTS
from recipes import Recipe, Step, row

TABLE = "clpt_control/engine/methods/table.py"
INTEGRATOR = Recipe(
    "Add an integrator",
    (
        Step(
            "tableau, formulas and row",
            "engine.methods.tsit5",
            (
                (
                    "clpt_control/engine/methods/tsit5.py",
                    "",
                    (TESTS / "support" / "tsit5.py").read_text("utf-8"),
                ),
            ),
        ),
        Step(
            "table",
            "run.method = 'tsit5': must be",
            (
                (
                    TABLE,
                    "import RODAS5P\n",
                    "import RODAS5P\nfrom .tsit5 import TSIT5\n",
                ),
                (TABLE, "ROWS = (DOP853,", "ROWS = (DOP853, TSIT5,"),
            ),
        ),
        Step(
            "page of scenarios",
            "test_a_row_is_named_where_users_look[Tsit5]",
            (("docs/scenario.md", "`rodas5p`, for", "`tsit5`, `rodas5p`, for"),),
        ),
        Step(
            "docstring",
            "test_a_row_is_named_where_users_look[Tsit5]",
            (
                (
                    "clpt_control/simulation/integrate.py",
                    '``"rodas5p"``, for',
                    '``"tsit5"``, ``"rodas5p"``, for',
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    values = {"run.method": "tsit5", "run.duration": 5.0}
    run = clpt.simulate(clpt.paper_scenario().with_values(values))
    assert run.attrs["method"] == "Tsit5"
    """,
    ("tests/engine/solver/test_methods.py", "-k", "a_row"),
)
TRACKS = "clpt_control/app/cli/tracks.py"
OPTION = Recipe(
    "Add a command or an option",
    (
        Step(
            "argument",
            "No such option: --rounds",
            (
                (
                    TRACKS,
                    "    radius: float | None = opt(",
                    '    rounds: bool = flag("Also print 1 round.", "--rounds"),\n'
                    "    radius: float | None = opt(",
                ),
            ),
        ),
        Step(
            "use",
            "no 1 round",
            (
                (
                    TRACKS,
                    "    excitation = clpt.gramian(source, window, start)\n",
                    "    excitation = clpt.gramian(source, window, start)\n"
                    "    if rounds:\n"
                    '        print("1 round")\n',
                ),
            ),
        ),
    ),
    """
    import subprocess, sys
    import clpt_control as clpt
    clpt.save_scenario(clpt.paper_scenario(), "build-recipe.toml")
    words = [sys.executable, "-m", "clpt_control", "excitation", "build-recipe.toml"]
    done = subprocess.run([*words, "--rounds"], capture_output=True, text=True)
    assert "1 round" in done.stdout, f"no 1 round: {done.stdout[-200:]} {done.stderr}"
    """,
    (),
)
COLUMN = Recipe(
    "Add to results",
    (
        Step(
            "column",
            "no deepest",
            (
                (
                    "clpt_control/ocean/forecast/table_rows.py",
                    "    PERCENT: (0, in_words),\n",
                    '    "deepest (m)": (10, lambda row: metres(row["depth_max"])),\n'
                    "    PERCENT: (0, in_words),\n",
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    replay = clpt.replay.replay_dives(clpt.gliders.sample_dives()[:3])
    assert "deepest (m)" in replay._repr_html_(), "no deepest"
    """,
    (),
)
RUN_PAGE = "clpt_control/app/pages/run_page.py"
FIGURE = Recipe(
    "Add to results",
    (
        Step(
            "plot",
            "speed_plot",
            row(
                "simulation/run_plots.py",
                '''
                def speed_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
                    """Draw the size of CLPE over time."""
                    ax = axes_for(ax, 6.4, 3.0)
                    ax.plot(run.time, np.hypot(*run.clpe.values.T))
                    return ax
                ''',
            ),
        ),
        Step(
            "section",
            "no figure of the speed",
            (
                (
                    RUN_PAGE,
                    "    figures = []\n",
                    "    from ...simulation.run_plots import speed_plot\n"
                    '    clpe.append(figure("speed", 3.0, "Of the speed.", speed_plot))\n'
                    "    figures = []\n",
                ),
            ),
        ),
    ),
    """
    import pathlib
    import clpt_control as clpt
    scenario = clpt.paper_scenario().with_values({"run.duration": 20.0})
    clpt.report(clpt.simulate(scenario), "build-recipe.html")
    text = pathlib.Path("build-recipe.html").read_text("utf-8")
    assert "Of the speed." in text, "no figure of the speed"
    """,
    (),
)
DIVE_FILES = "clpt_control/ocean/gliders/dive_files.py"
FORMAT = Recipe(
    "Add a glider file format",
    (
        Step(
            "reader",
            "cannot import name 'toy'",
            row(
                "ocean/gliders/toy.py",
                '''
                """Toy glider: a line `toy`, then duration (s) and way east (m) of a dive."""

                from .dives import ThroughWater, dive_between


                def is_known(text):
                    """Return whether a text is of a toy glider."""
                    return text.startswith("toy")


                def dives_of(text, path):
                    """Return the dives of a text."""
                    rows = [line.split() for line in text.splitlines()[1:]]
                    fixes = None, (1e9, 40.0, 8.0), (1e9 + float(rows[0][0]), 40.0, 8.02)
                    return [dive_between(1, fixes, ThroughWater((float(rows[0][1]), 0.0)))]
                ''',
            ),
        ),
        Step(
            "call",
            "no column dive",
            (
                (DIVE_FILES, "slocum, usable_dives", "slocum, toy, usable_dives"),
                (
                    DIVE_FILES,
                    "    return _dives_and_skipped(table_dives(text, path), name, None)\n",
                    "    if toy.is_known(text):\n"
                    '        return _dives_and_skipped(toy.dives_of(text, path), name, "Toy")\n'
                    "    return _dives_and_skipped(table_dives(text, path), name, None)\n",
                ),
            ),
        ),
    ),
    """
    import pathlib
    from clpt_control import gliders
    pathlib.Path("build-recipe.csv").write_text("toy\\n9000 500\\n")
    (dive,), _ = gliders.read_dives("build-recipe.csv")
    assert (dive.kind, dive.duration, dive.dr_east) == ("Toy", 9000.0, 500.0)
    """,
    (),
)
LEVELLED = "surfacing", "replay", "replay_command", "replay_page"
FORECAST = Recipe(
    "Add to results",
    (
        Step(
            "level",
            "the level is 0.9",
            (
                (
                    "clpt_control/ocean/estimation/fix_model.py",
                    "LEVEL = 0.9 ",
                    "LEVEL = 0.8 ",
                ),
            ),
        ),
    ),
    """
    import json, subprocess, sys
    words = [sys.executable, "-m", "clpt_control", "replay", "--sample"]
    words += ["--route", "build-recipe.txt"]
    open("build-recipe.txt", "w").write("-42.8 8.4")
    done = subprocess.run([*words, "--json"], capture_output=True, text=True)
    level = json.loads(done.stdout)["level"]
    assert level == 0.8, f"the level is {level}"
    plain = subprocess.run(words, capture_output=True, text=True).stdout
    assert "80 % ellipse" in plain and "(80 %)" in plain and "90 %" not in plain, plain
    """,
    (
        *(f"tests/ocean/forecast/test_{n}.py" for n in LEVELLED),
        *("--doctest-modules", "clpt_control/ocean/forecast", "-k"),
        "long_run or say_the_same or ring_is or 180_degrees or test_the_command or keeps_what "
        "or cf_trajectory or clpt_control",
    ),
)
MESSAGE = Recipe(
    "Add to results",
    (
        Step(
            "error",
            "no error",
            (
                (
                    "clpt_control/parts/lags.py",
                    "@public\ndef lag(\n",
                    "def refuse_zero(name: str, value: float) -> None:\n"
                    '    """Refuse a value of 0."""\n'
                    "    if value == 0:\n"
                    '        raise BlockError(f"{name}: is 0. Give another number")\n'
                    "\n\n@public\ndef lag(\n",
                ),
            ),
        ),
        Step(
            "list",
            "test_the_list_of_messages_is_current",
            (
                (
                    "tests/messages.md",
                    "## parts/lags.py\n",
                    "## parts/lags.py\n- {name}: is 0. Give another number\n",
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    from clpt_control.parts import lags
    assert hasattr(lags, "refuse_zero"), "no error"
    """,
    ("tests/test_messages.py",),
)
RESULTS = {
    "integrator": INTEGRATOR,
    "option": OPTION,
    "column": COLUMN,
    "figure": FIGURE,
    "format": FORMAT,
    "forecast": FORECAST,
    "message": MESSAGE,
}
