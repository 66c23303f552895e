"""The proof of a team, and its pooled Gramian, against closed forms and sums."""

import numpy as np
import pytest
from strait import DIFFERENT, ROW, team, vehicle

import clpt_control as clpt
from clpt_control.blocks import consensus as blocks
from clpt_control.theory.excitation import regressor
from clpt_control.theory.proving.all_proofs import team_steps


def test_a_sum_in_place_of_the_difference_is_not_proved(monkeypatch):
    def together(t, x, u, p):
        """pull = -kappa sum_j (alpha + alpha_j), section III with a wrong sign."""
        own = (u.alpha + getattr(u, f"alpha_{j}") for j in range(p.neighbours))
        return {"pull": -p.coupling * sum(own)}

    monkeypatch.setattr(blocks, "consensus", together)
    step = next(team_steps())
    assert not step.holds
    assert "left over" in step.detail


def test_a_one_sided_graph_is_not_proved(monkeypatch):
    """One hears the other, who does not hear back: V' is not that of the edge."""
    monkeypatch.setattr(clpt.Team, "neighbours", lambda self, name: ["b"] if name == "a" else [])
    assert not next(team_steps()).holds


@pytest.mark.parametrize("rough", [regressor.ROUGH, 1e6])  # then each has its own pieces
def test_the_pooled_gramian_is_the_sum_with_gains_of_their_own(rough, monkeypatch):
    monkeypatch.setattr(regressor, "ROUGH", rough)
    of = team(0.0, ROW, **DIFFERENT)  # uncoupled, each as its own scenario runs
    N, window, start = 3, 6.0, 2.0
    found = clpt.theory.gramian(of, window, start)
    assert found.names["x1"][N:] == [f"{g}_1 of {v}" for v in "abc" for g in ("K", "Gamma")]
    for axis in ("x1", "x2"):
        whole = np.zeros((N + 6, N + 6))
        for k, scenario in enumerate(of.members.values()):
            own = clpt.theory.gramian(scenario, window, start).gramians[axis]
            at = [*range(N), N + 2 * k, N + 2 * k + 1]
            whole[np.ix_(at, at)] += own
        np.testing.assert_allclose(found.gramians[axis], whole, rtol=0, atol=1e-6)
    run = clpt.simulate(of, np.arange(0.0, 12.01, 0.05))
    read = clpt.theory.gramian(run, window, start)
    assert read.smallest == pytest.approx(found.smallest, rel=1e-2)
    for name, one in read.vehicles.items():
        assert one.smallest == pytest.approx(found.vehicles[name].smallest, rel=1e-2)


@pytest.mark.parametrize(
    ("source", "arguments", "said"),
    [
        (3, (), "must be a Scenario, a Team, an xarray.Dataset or a Regressor"),
        (team(a=vehicle(), b=vehicle()), (50.0,), "window 50 from 0: must be positive and lie"),
        (team(a=vehicle(), b=vehicle()), (-1.0, 0.0), "window -1 from 0: must be positive"),
    ],
    ids=["number", "too long", "negative"],
)
def test_what_has_no_pooled_gramian(source, arguments, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.theory.gramian(source, *arguments)


def test_the_certificate_of_one_vehicle_takes_no_team():
    of = team(a=vehicle(), b=vehicle())
    with pytest.raises(clpt.ArgumentError, match="a Team: must be a Scenario"):
        clpt.theory.certificate(of)
    with pytest.raises(clpt.DataError, match="gramian measures a team"):
        clpt.theory.certificate(clpt.simulate(of, [0.0, 1.0, 2.0]))
