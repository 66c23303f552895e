"""The C program of the benchmarks agrees with the reference; the harness leaves its table."""

import json
import math
import sys

import numpy as np
import pytest
from image_checks import inked
from paths import ROOT
from subprocesses import ran

import clpt_control as clpt

sys.path.insert(0, str(ROOT))  # benchmarks/ is no installed package

from benchmarks import build, cases, models, report, traced
from benchmarks.c_engine import Program

pytestmark = pytest.mark.skipif(
    build.compiler() is None, reason="there is no C compiler here"
)


@pytest.mark.sampled
@pytest.mark.parametrize("options", [(), ("-DBASIS_LANES",)])
def test_c_agrees_with_the_reference(options):
    times, reference = cases.reference_states()
    program, case = Program(3, "scalar", *options), cases.paper()
    states = program.run(case)[0][np.searchsorted(case.times, times[1:])]
    early = program.run(cases.paper(10.0))[0][-1]
    np.testing.assert_allclose([early, *states], reference, rtol=0, atol=1e-7)


@pytest.mark.slow
def test_simd_agrees_with_one_function_and_one_run_after_the_other():
    case = cases.many(21, 40.0)  # two blocks of eight, five left
    ours, expected = (
        Program(21, *how).run(case)[0] for how in (("scalar", "-DBASIS_LANES"), ())
    )
    np.testing.assert_allclose(ours, expected, rtol=0, atol=1e-9)
    scenario = cases.paper(60.0).scenario
    parameters, states = cases.members(scenario, 0, 21)
    expected, _ = Program(3).members(scenario, parameters, states)
    for way in (1, -1):  # lanes, in any order
        ours, _ = Program(3, "lanes").members(
            scenario, parameters[::way], states[::way]
        )
        np.testing.assert_allclose(ours[::way], expected, rtol=0, atol=1e-9)


def test_traced_equations_are_the_diagram():
    loop, x = clpt.closed_loop(clpt.paper_scenario()), np.linspace(-1.0, 2.0, 14)
    found = traced.rates(loop, 3.0, list(x), vars(math), {"reference": [3.0, 0.0]})
    np.testing.assert_allclose(found, loop.dynamics(3.0, x, []), rtol=1e-13, atol=1e-14)


@pytest.mark.slow
def test_the_quick_run_leaves_its_tables(tmp_path):
    words = ["--quick", "--engines", "c", "--sections", "paper,particles", "--out"]
    ran(sys.executable, "-m", "benchmarks.bench", *words, tmp_path, cwd=ROOT)
    assert (
        json.loads((tmp_path / "performance.json").read_text())["paper"][0]["error"]
        < 1e-7
    )
    text = (tmp_path / "performance.md").read_text()
    assert all(words in text for words in ("## The paper's run", "| C [1] |"))
    assert inked(tmp_path / "performance.png") > 0.01


@pytest.mark.long
def test_small_models_end_where_scipy_does(monkeypatch):
    few = models.SMALL[:2]
    monkeypatch.setattr(models, "SMALL", few)
    monkeypatch.setattr(models, "MODELS", (*few, models.LARGE))
    rows = models.measure(["native", "simulate"], 1, 1.0, lambda text: None)
    found = {(row["model"], row["engine"]) for row in rows}
    assert len(found) == len(rows) == 13
    assert max(row["error"] for row in rows) < 1e-6


def test_the_page_is_made_of_the_figures_beside_it():
    results = json.loads((ROOT / "docs" / "performance.json").read_text())
    assert (ROOT / "docs" / "performance.md").read_text() == report.markdown(results)
    times = {
        one["engine"]: f"{1000 * one['median']:.1f} ms" for one in results["paper"]
    }
    lines = (ROOT / "docs" / "index.md").read_text().splitlines()
    assert [times["native"] in line for line in lines if "2000 s" in line] == [True]


@pytest.mark.slow
def test_the_drifter_block_moves_as_the_c_program():
    from benchmarks import advection
    from benchmarks.drifter import advect

    steps = advection.STEP, advection.STEPS
    found, _ = advect(*advection.current(), *advection.starts(9), *steps)
    np.testing.assert_allclose(found, advection.run_c(9)[0], rtol=1e-12)
