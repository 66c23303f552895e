"""No wrong law of a hundred is proved, no right law of sixty refuted; most right ones are shown."""

import pytest
from many_laws import RIGHT, WRONG

from clpt_control.errors import ClptError
from clpt_control.theory.proving.own_law import prove

POINTS = 100
SHOWN = ("proved", "bounded", "proved between jumps", "proved as long as s exist")
SAMPLE = slice(4, None, 15)


def status(name, laws):
    make, more = laws[name]
    try:
        return prove(make(), points=POINTS, **more).status
    except ClptError:
        return "refused"


@pytest.mark.parametrize("name", list(WRONG)[SAMPLE])
def test_a_wrong_law_is_not_proved(name):
    assert status(name, WRONG) not in ("proved", "bounded")


@pytest.mark.parametrize("name", list(RIGHT)[SAMPLE])
def test_a_right_law_is_not_refuted(name):
    assert not status(name, RIGHT).startswith("refuted")


@pytest.mark.slow
def test_no_wrong_law_of_a_hundred_is_proved():
    assert len(WRONG) >= 100
    assert [name for name in WRONG if status(name, WRONG) in ("proved", "bounded")] == []


@pytest.mark.slow
def test_no_right_law_of_sixty_is_refuted():
    found = {name: status(name, RIGHT) for name in RIGHT}
    assert len(found) >= 60
    assert [name for name, own in found.items() if own.startswith("refuted")] == []
    assert sum(own in SHOWN for own in found.values()) >= 50
