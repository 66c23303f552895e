"""Each kind of disturbance does what its row states, and the row alone adds a kind."""

import re
import sys
import textwrap

import numpy as np
import pytest
from error_sentences import says
from paths import ROOT
from subprocesses import ran

import clpt_control as clpt
from clpt_control.paper.blocks import disturbance
from clpt_control.paper.blocks.disturbance import KINDS, DisturbanceKind
from clpt_control.paper.scenario.file import paper_text

PAPER = clpt.paper_scenario()
AMPLITUDE, PERIOD, PERIODS = np.array([0.5, 0.3]), 0.5, 440


def with_kind(kind, **keys):
    """The paper's scenario with a disturbance of this kind."""
    table = {"kind": kind, "amplitude": AMPLITUDE.tolist(), **keys}
    return PAPER.with_values({"flow.disturbance": table})


def delta(kind, points=40, periods=PERIODS, **keys):
    """Delta at some points of each of whole periods, shape (time, 2)."""
    allowed = {"period": PERIOD, "seed": 3} | keys
    table = {key: value for key, value in allowed.items() if key in KINDS[kind].keys}
    loop = clpt.closed_loop(with_kind(kind, **table))
    samples = (np.arange(points * periods) + 0.5) * PERIOD / points
    return clpt.simulate(loop, [0.0, *samples]).delta.values[1:]


@pytest.mark.parametrize("kind", KINDS)
def test_bound_and_rms_of_the_row_are_those_of_delta(kind):
    row = KINDS[kind]
    # of any wave the midpoint rule errs by about 1/points^2
    values = delta(kind) if row.random else delta(kind, 20_000, 1)
    assert (np.abs(values) <= AMPLITUDE).all() == row.bounded
    settled = values[40 * 40 :] if row.random else values  # 400 periods, after 40
    rms = np.sqrt(np.mean(settled**2, axis=0)) / AMPLITUDE
    # of 400 independent normal numbers within 4 standard errors, 1/sqrt(800)
    np.testing.assert_allclose(rms, row.rms, atol=4 / 800**0.5 if row.random else 1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_random_kinds_and_no_others_depend_on_the_seed(kind):
    row = KINDS[kind]
    assert row.random == ("seed" in row.keys)
    if row.random:
        assert (delta(kind, seed=4) != delta(kind)).all()


@pytest.mark.parametrize("kind", KINDS)
def test_a_scenario_has_the_keys_of_the_row(kind):
    required = {key: 1 for key, needed in KINDS[kind].keys.items() if needed}
    assert with_kind(kind, **required).flow.disturbance.kind == kind
    for key in required:
        said = f'flow.disturbance.{key}: is required for kind = "{kind}"'
        says(clpt.ScenarioError, said, with_kind, kind, **required | {key: None})
    for key in {"period", "seed"} - KINDS[kind].keys.keys():
        said = f'{key} = 1: kind = "{kind}" has no {key}. Leave it out'
        says(
            clpt.ScenarioError, re.escape(said), with_kind, kind, **required | {key: 1}
        )


@pytest.mark.parametrize("field", DisturbanceKind._fields)
def test_a_kind_without_a_field_does_not_construct(field):
    fields = {k: v for k, v in KINDS["noise"]._asdict().items() if k != field}
    says(
        TypeError,
        f"missing 1 required positional argument: '{field}'",
        DisturbanceKind,
        **fields,
    )


def test_the_docstring_and_the_example_name_each_kind():
    assert re.findall(r"(?m)^    (\w+) +Delta = ", disturbance.__doc__) == [*KINDS]
    (comment,) = re.findall(r'# kind = "square" +# (.*)', paper_text())
    assert comment == f"one of: {', '.join(KINDS)}"


NEW_KIND = """
    import sys

    sys.path.append("tests/support")
    import numpy as np
    from clpt_control.base.random_numbers import normal
    from clpt_control.engine.model.declaration import Each
    from clpt_control.paper.blocks.disturbance import AXES, KINDS, DisturbanceKind

    LAGS = np.arange(40.0)

    def drifting(t, x, u, p):
        past = normal(p.seed, p.interval - LAGS + LAGS[-1], AXES[:, np.newaxis])
        return p.amplitude * (past @ (0.6 * 0.8**LAGS))

    KINDS["drifting"] = DisturbanceKind(
        drifting, Each("period"), {"period": True, "seed": False},
        bounded=False, random=True, rms=0.5,
    )

    import clpt_control as clpt
    from clpt_control.ensemble.candidates import unknown_of
    from drawn_scenarios import NUMBERS, drawn
    from promises_along_runs import CONDITIONS

    def disturbed(kind, law="learned-flow"):
        table = {"kind": kind, "amplitude": [0.003, 0.004], "period": 1.8}
        values = {"flow.disturbance": table, "learning.law": law}
        return clpt.paper_scenario().with_values(values)

    scenario = disturbed("drifting")
    try:
        clpt.certify(scenario, 0.05)
    except clpt.ScenarioError as error:
        print(error)
    noise, drifting, sine = (
        {name for name, holds in CONDITIONS.items() if name != "within"
         and holds(disturbed(kind, "dead-zone"))}
        for kind in ("noise", "drifting", "sine")
    )
    assert noise == drifting and sine - drifting == {"bounded", "small"}, (noise, drifting, sine)
    points = np.random.default_rng(0).random((200, NUMBERS))
    tried = {s.flow.disturbance.kind for s in (drawn("learned-flow", p) for p in points)
             if s.flow.disturbance}
    assert tried == set(KINDS), tried
    unknown = unknown_of(scenario, None, None, 4)
    assert list(unknown.varies["flow.disturbance.seed"]) == [0, 1, 2, 3]
    assert abs(unknown.unmodelled - 0.5 * 0.005) < 1e-15
    short = scenario.with_values({"run.duration": 20})
    runs = clpt.run_ensemble(short, {"flow.disturbance.seed": [1, 2]})
    assert len(set(runs.clpe_rms_whole.values.tolist())) == 2
"""


@pytest.mark.long
def test_an_unbounded_kind_that_is_a_row_alone_is_treated_as_noise():
    done = ran(sys.executable, "-c", textwrap.dedent(NEW_KIND), cwd=ROOT)
    assert done.stdout.startswith(
        'no certificate: flow.disturbance.kind = "drifting" has no bound on |Delta|'
    )
