"""SG171 carried an ADCP, which the replay never reads: it says what the replay learned."""

import pytest

from analysis.against_adcp import compared, read_adcp
from clpt_control.gliders import read_dives, usable


def test_learned_speed_and_current_are_those_of_the_adcp(facts):
    dives, skipped = usable(read_dives(facts / "glider" / "sg171_dives.csv")[0])
    found = compared(dives, read_adcp(facts / "glider" / "sg171_adcp.csv"))
    assert (len(dives), skipped) == (10, [])
    assert 1.3 < found.measured < 1.6
    assert abs(found.learned - found.measured) < found.standard_error < 0.15
    assert found.learned == pytest.approx(1.48, abs=0.11)
    assert found.current < 0.012 < 0.03 < found.in_file
