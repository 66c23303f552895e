"""Recipes of CONTRIBUTING on dives: columns, formats, levels and estimators, as data."""

from recipes import Recipe, Step, row

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
DIVES_FILE = "clpt_control/ocean/gliders/dives.py"
SAMPLES = "clpt_control/ocean/gliders/samples.py"
FIELD = Recipe(
    "Add to results",
    (
        Step(
            "field",
            "Dive: pressure= is not an argument",
            (
                (
                    DIVES_FILE,
                    '    magvar: OrNaN | None = optional("degrees", limits=VARIATIONS)\n',
                    '    magvar: OrNaN | None = optional("degrees", limits=VARIATIONS)\n'
                    '    pressure: OrNaN | None = optional("dbar")\n',
                ),
            ),
        ),
        Step(
            "docstring",
            "Dive: no pressure",
            (
                (
                    DIVES_FILE,
                    "    turned : float or None\n",
                    "    pressure : float or None\n"
                    "        Pressure at the surface, dbar.\n"
                    "    turned : float or None\n",
                ),
            ),
        ),
        Step(
            "page",
            "docs/gliders.md: no pressure",
            (("docs/gliders.md", "`dac_qc`;", "`dac_qc`; `pressure` (dbar);"),),
        ),
        Step(
            "names in files",
            "KeyError: 'pressure'",
            (
                (
                    SAMPLES,
                    "QUANTITIES = {  # of a measurement: what files call it, and how it is read\n",
                    "QUANTITIES = {\n"
                    '    "pressure": (("SURFACE_PRESSURE",), values),\n',
                ),
            ),
        ),
        Step(
            "reader",
            "no pressure of the file",
            (
                (
                    "clpt_control/ocean/gliders/seaglider.py",
                    "        magvar=_variation(data),\n",
                    "        magvar=_variation(data),\n"
                    '        pressure=_number_of(data, "pressure"),\n',
                ),
            ),
        ),
    ),
    """
    import sys
    sys.path.insert(0, "tests/support")
    from glider_files import basestation
    import clpt_control as clpt
    from clpt_control import gliders
    file = basestation("build-recipe.nc", surface_pressure=((), 10.25, {}))
    dives = gliders.read_dives(file)[0]
    assert getattr(dives[0], "pressure", 10.25) == 10.25, "no pressure of the file"
    gliders.write_dive_table(dives, "build-recipe.csv")
    (dive,), _ = gliders.read_dives("build-recipe.csv")
    replay = clpt.replay.replay_dives([dive])
    assert replay.summary()["each_dive"][0]["pressure"] == 10.25
    data = replay.dataset()
    assert (data.pressure.item(), data.pressure.units) == (10.25, "dbar")
    """,
    ("tests/ocean/gliders/test_dive_table.py", "-k", "field_of_a_dive"),
)
TABLE = (
    "    return _dives_and_skipped(table_dives(text, path, every_row), name, None)\n"
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
                    TABLE,
                    "    if toy.is_known(text):\n"
                    '        return _dives_and_skipped(toy.dives_of(text, path), name, "Toy")\n'
                    + TABLE,
                ),
            ),
        ),
        Step(
            "damaged inputs",
            "AssertionError: toy",
            (
                (
                    "tests/support/damaged_commands.py",
                    "USES = (\n",
                    'USES = (\n    "replay toy --json | toy/toy.csv",\n',
                ),
            ),
        ),
        Step(
            "origin",
            "README",
            (("tests/data/README.md", "", "\n`glider/toy`: of nobody.\n"),),
        ),
    ),
    """
    import pathlib
    from clpt_control import gliders
    folder = pathlib.Path("tests/data/glider/toy")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "toy.csv").write_text("toy\\n9000 500\\n")
    (dive,), _ = gliders.read_dives(folder)
    assert (dive.kind, dive.duration, dive.dr_east) == ("Toy", 9000.0, 500.0)
    """,
    ("tests/app/cli/test_damaged_inputs.py", "-k", "are_damaged"),
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
    done = subprocess.run([*words, "--json"], capture_output=True, text=True)
    level = json.loads(done.stdout)["level"]
    assert level == 0.8, f"the level is {level}"
    plain = subprocess.run(words, capture_output=True, text=True).stdout
    assert "80 % ellipse" in plain and "90 %" not in plain, plain
    """,
    (
        *(f"tests/ocean/forecast/test_{n}.py" for n in LEVELLED),
        *("--doctest-modules", "clpt_control/ocean/forecast", "-k"),
        "long_run or say_the_same or ring_is or 180_degrees or test_the_command or keeps_what "
        "or cf_trajectory or clpt_control",
    ),
)
DIVES = {
    "column": COLUMN,
    "field of a dive": FIELD,
    "format": FORMAT,
    "forecast": FORECAST,
}
