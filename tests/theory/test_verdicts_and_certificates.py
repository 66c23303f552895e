"""Each proved verdict has a conclusion, and exceeds its certificate by named steps alone."""

import pytest
from judged_loops import RIGHT, WRONG
from lyapunov_cases import CASES
from small_scenarios import paper_of
from test_ends import BROKEN, HELD
from text_systems import written
from user_laws import FOR_TWO
from user_laws import RIGHT as OWN_LAWS

import clpt_control as clpt

pytestmark = pytest.mark.long  # by `make test-long`

CARRIED = {  # conclusions that a certificate may show -> what steps must add to them
    "asymptotically stable": {
        "goes to zero": {"limit", "rest", "all"},
        "square-integrable": {"limit", "rest", "all", "exists"},
        "V does not increase": {"limit", "rest", "all", "exists"},
        "stable": {"limit", "rest"},
    },
    "comes to rest": {
        "goes to zero": {"still", "isolated"},
        "square-integrable": {"still", "isolated", "exists"},
        "V does not increase": {"still", "isolated", "exists"},
    },
    "all rates go to zero": {
        "goes to zero": {"still"},
        "square-integrable": {"still", "exists"},
        "V does not increase": {"still", "exists"},
    },
    "goes to zero": {
        "square-integrable": {"limit", "exists"},
        "V does not increase": {"loses", "limit", "exists"},
        "stable": {"limit"},
    },
    "square-integrable": {"V does not increase": {"loses"}, "stable": {"loses"}},
    "stable": {"V does not increase": {"all", "exists"}},
}
# V' is no polynomial, or no sum of squares is known
WITHOUT_CERTIFICATE = {"times sin^2 + cos^2", "x - z and exp(c)", "composite"}


def compared(verdict):
    """Compare a proved verdict with its certificate; False if it has none."""
    if verdict.status != "proved":
        return False
    assert verdict.conclusion
    data = verdict.certificate()
    if data is None:
        assert verdict.why_no_certificate()
        return False
    steps = verdict.beyond_certificate()
    assert all(step.holds for step in steps)
    by_steps = {name for step in steps for name in step.shows.split()}
    said, shown = verdict.conclusion, data["conclusion"]
    if said != shown and shown in CARRIED.get(said, {}):
        assert CARRIED[said][shown] <= by_steps
    elif said != shown:  # the certificate says as much, or more
        assert said in CARRIED.get(shown, {}), (said, shown)
    return True


def texts():
    """The written systems of the tests of ends."""
    for rows in (*BROKEN.values(), *HELD.values()):
        yield from (row[0] for row in rows)


def test_verdicts_on_systems():
    cases = [(c.plant, c.V, c.more) for c in CASES.values() if c.status == "proved"]
    cases += [
        (c.plant, c.V, c.more) for c in (*RIGHT.values(), *WRONG.values()) if c.true
    ]
    for text in texts():
        plant, V, *rest = written(text)
        cases.append((plant, V, dict(*rest)))
    compared_cases = 0
    for plant, V, more in cases:
        compared_cases += compared(clpt.lyapunov(plant, V, **more | {"points": 5}))
    assert compared_cases > 60


@pytest.mark.parametrize("name", [*OWN_LAWS, *FOR_TWO])
def test_verdicts_on_own_laws(name):
    verdict = clpt.prove({**OWN_LAWS, **FOR_TWO}[name](), points=50)
    assert compared(verdict) == (name not in WITHOUT_CERTIFICATE)


@pytest.mark.slow
@pytest.mark.parametrize("name", clpt.laws())
def test_verdicts_on_laws(name):
    compared(clpt.prove(clpt.closed_loop(paper_of(1, name)), points=50))
