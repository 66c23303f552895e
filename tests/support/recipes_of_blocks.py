"""Recipes of CONTRIBUTING on blocks of the package, as data."""

import textwrap

from recipes import FORMULAS, Recipe, Step, row

CONFORMANCE = "tests/support/package_blocks.py"
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
            "KeyError: 'flip'",
            ((CONFORMANCE, FIRST, f'    "flip": [((), {{}})],\n{FIRST}'),),
        ),
        Step(
            "closed form",
            "test_every_part_is_in_a_test",
            (
                (
                    "tests/parts/test_parts_closed_forms.py",
                    "",
                    "\n\ndef test_a_flip():\n"
                    "    assert parts.flip().output(0, [], [3.0]) == [-3.0]\n",
                ),
            ),
        ),
        Step(
            "page of parts",
            "test_every_part_has_a_row_on_the_page",
            (
                (
                    "docs/parts.md",
                    "| `lag(lag, gain)`",
                    "| `flip()` | $y = -u$ | u → y |\n| `lag(lag, gain)`",
                ),
            ),
        ),
        Step(
            "panel",
            "test_the_shelf_has_a_panel_for_each_part",
            (
                (
                    "analysis/shelf.py",
                    "PANELS: tuple[Any, ...] = (",
                    textwrap.dedent(
                        '''
                        def flip():
                            """The negative."""
                            return static(parts.flip(), -RAMP)


                        PANELS: tuple[Any, ...] = (
                            flip,'''
                    ),
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    clpt.check(clpt.parts.flip())
    """,
    (
        "tests/test_documentation.py",
        "tests/engine/conformance/test_conformance.py",
        "tests/parts",
        "tests/analysis/test_closed_forms.py",
        "-k",
        "every_public_name or every_part or flip or shelf_has",
    ),
)
LOOP = "clpt_control/simulation/loop_blocks.py"
SPEED = "    if car.max_speed is not None:\n"
METER = f"""    if car.meter_scale is not None:
        blocks.append(meter.current_meter(car.meter_scale))
{SPEED}"""
BLOCK = Recipe(
    "Add a block",
    (
        Step(
            "equations and maker",
            "cannot import name 'meter'",
            row(
                "paper/blocks/meter.py",
                '''
                """A current meter, which reads the true flow of Eq. (3) with a scale factor."""

                from ...engine.model.block import Block
                from .ports import paper_block


                def metered(t, x, u, p):
                    """m = s F_R, F_R of Eq. (3)."""
                    return p.scale * u.flow_x


                def current_meter(scale: float) -> Block:
                    """Make the current meter."""
                    parameters = {"scale": scale}
                    ports = "flow_x -> flow_meter"
                    return paper_block("current_meter", ports, parameters, output=metered)
                ''',
            ),
        ),
        Step(
            "loop",
            "no meter",
            (
                (LOOP, "    localization,\n", "    localization,\n    meter,\n"),
                (LOOP, SPEED, METER),
            ),
        ),
        Step(
            "port",
            "flow_meter",
            (("clpt_control/paper/blocks/ports.py", "flow_z ", "flow_z flow_meter "),),
        ),
        Step(
            "key",
            "meter_scale",
            (
                (
                    "clpt_control/paper/scenario/tables.py",
                    "    #: # max_speed = 1.5",
                    "    #: # meter_scale = 1.1 # a current meter\n"
                    '    meter_scale: Positive | None = quantity(None, "current_meter.scale")\n'
                    "    #: # max_speed = 1.5",
                ),
            ),
        ),
        Step(
            "example",
            "test_the_pages_are_current",
            (
                (
                    "clpt_control/data/paper.toml",
                    "# max_speed",
                    "# meter_scale = 1.1                           # a current meter\n# max_speed",
                ),
            ),
        ),
        Step(
            "page of scenarios",
            "test_the_pages_are_current",
            (
                (
                    "docs/scenario.md",
                    "`vehicle.max_speed`",
                    "`vehicle.meter_scale` | a current meter\n`vehicle.max_speed`",
                ),
            ),
        ),
        Step(
            "page of blocks",
            "['current_meter'",
            (
                (
                    "docs/blocks.md",
                    "`speed_limit`",
                    "`current_meter` with `vehicle.meter_scale` | m = s F_R, F_R of Eq. (3) "
                    "| `flow_x[2]` | `flow_meter[2]`\n`speed_limit`",
                ),
            ),
        ),
        Step(
            "closed form",
            "test_another_test_has_numbers_of_each_block",
            (
                (
                    FORMULAS,
                    "",
                    textwrap.dedent(
                        """

                        def test_a_meter_scales_the_flow():
                            scenario = PAPER.with_values({"vehicle.meter_scale": 1.5})
                            run = clpt.simulate(clpt.closed_loop(scenario), [0.0, 5.0])
                            np.testing.assert_allclose(run.flow_meter, 1.5 * run.true_flow)
                        """
                    ),
                ),
            ),
        ),
    ),
    """
    import clpt_control as clpt
    scenario = clpt.paper_scenario().with_values({"vehicle.meter_scale": 2.0})
    run = clpt.simulate(clpt.closed_loop(scenario), [0.0, 1.0])
    assert hasattr(run, "flow_meter"), "no meter"
    """,
    (
        "tests/simulation/test_blocks_of_the_loop.py",
        "tests/test_scenario_page.py",
        FORMULAS,
        "-k",
        "blocks_of_the_loop or scenario_page or a_meter",
    ),
)
BLOCKS = {"part": PART, "block": BLOCK}
