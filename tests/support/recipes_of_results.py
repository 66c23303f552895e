"""Recipes of CONTRIBUTING on methods, options, figures and messages, as data."""

from paths import TESTS
from recipes import Recipe, Step, row

TABLE = "clpt_control/engine/methods/__init__.py"
INTEGRATOR = Recipe(
    "Add an integrator",
    (
        Step(
            "tableau and formulas",
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
                    "ROWS = (DOP853,",
                    'TSIT5 = Method("Tsit5", 7, 5, ".tsit5")\nROWS = (DOP853, TSIT5,',
                ),
            ),
        ),
        Step(
            "page of scenarios",
            "test_the_pages_are_current",
            (
                (
                    "docs/scenario.md",
                    "order 8), ",
                    "order 8), tsit5 (explicit, order 5), ",
                ),
                (
                    "clpt_control/data/paper.toml",
                    "order 8), ",
                    "order 8), tsit5 (explicit, order 5), ",
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
    (
        "tests/engine/solver/test_methods.py",
        "tests/test_scenario_page.py",
        "-k",
        "a_row or scenario_page",
    ),
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
RUN_PAGE = "clpt_control/app/pages/run_page.py"
FIGURE = Recipe(
    "Add to results",
    (
        Step(
            "plot",
            "norm_plot",
            row(
                "simulation/run_plots.py",
                '''
                def norm_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
                    """Draw the error of the flow parameters over time."""
                    ax = axes_for(ax, 6.4, 3.0)
                    errors = run.flow_parameters_estimate - run.flow_parameters
                    ax.plot(run.time, (errors**2).sum(("axis", "basis")))
                    return ax
                ''',
            ),
        ),
        Step(
            "section",
            "no figure of the error",
            (
                (
                    RUN_PAGE,
                    "    figures = []\n    for axis,",
                    "    from ...simulation.run_plots import norm_plot\n"
                    '    clpe.append(figure("norm", 3.0, "Of the error.", norm_plot))\n'
                    "    figures = []\n    for axis,",
                ),
            ),
        ),
        Step(
            "condition",
            "has no attribute 'flow_parameters'",
            (
                (
                    RUN_PAGE,
                    '    clpe.append(figure("norm"',
                    '    if "flow_parameters" in run:\n'
                    '        clpe.append(figure("norm"',
                ),
            ),
        ),
        Step(
            "accessor",
            "plot 'norm': the run has no such signal",
            (
                (
                    "clpt_control/app/notebook/accessor.py",
                    '        "clpe": "simulation.run_plots:clpe_plot",\n',
                    '        "clpe": "simulation.run_plots:clpe_plot",\n'
                    '        "norm": "simulation.run_plots:norm_plot",\n',
                ),
            ),
        ),
    ),
    """
    import pathlib
    import clpt_control as clpt
    scenario = clpt.paper_scenario().with_values({"run.duration": 20.0})
    run = clpt.simulate(scenario)
    clpt.report(run, "build-recipe.html")
    text = pathlib.Path("build-recipe.html").read_text("utf-8")
    assert "Of the error." in text, "no figure of the error"
    run.clpt.plot("norm")
    clpt.report(run.drop_vars("flow_parameters"), "build-recipe.html")
    """,
    ("tests/app/pages/test_html_reports.py", "-k", "run_has_its_page"),
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
    "figure": FIGURE,
    "message": MESSAGE,
}
