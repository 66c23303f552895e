"""The page of a replay: nothing is fetched, nothing of a file is markup, the chart is true."""

import math
import re
from base64 import b64encode
from hashlib import sha256

import pytest
from html_reader import Reader, fetching_nothing
from pyproj import Geod
from synthetic_vehicle import fixes_of, told

from clpt_control.geodesy import near
from clpt_control.replay.replay_page import replay_page
from clpt_control.replay.track_map import grid_label, map_plot

EVIL = "</title></script><script>alert(1)</script><img src=x onerror='alert(2)'>\x00\udc80\"&amp;"


def page_of(count, lat=40.0, lon=8.0, evil=""):
    found = told(fixes_of(count, lat, lon))
    if evil:
        found["skipped"] = [{"dive": None, "why": evil}]
        found["vehicle"] = f"SG {evil}"
        found["each_dive"][0]["dive"] = evil
        found["next_dive"]["place"] = evil
        found["notes"] = [{"dive": 1, "note": evil}]
    return replay_page(found)


def test_nothing_of_a_file_is_markup_and_nothing_is_fetched():
    text = page_of(3, evil=EVIL)
    page = fetching_nothing(text)
    assert [tag for tag, _ in page.tags].count("script") == 1
    shown = EVIL.replace("\x00", "\ufffd").replace("\udc80", "\ufffd")
    assert any(shown in text for text in page.texts)
    assert "//" not in re.sub(r"^// .*$", "", "".join(page.scripts), flags=re.M)
    policy = next(names["content"] for tag, names in page.tags if tag == "meta" and len(names) == 2)
    hashes = [
        f"'sha256-{b64encode(sha256(part.encode()).digest()).decode()}'"
        for part in ("".join(page.styles), "".join(page.scripts))
    ]
    assert policy == f"default-src 'none'; style-src {hashes[0]}; script-src {hashes[1]}"
    charts_have_dates(text)


@pytest.mark.usefixtures("undrawn")
def test_a_page_that_is_written_again_is_loaded_again():
    found = told(fixes_of(3))
    for again in (False, True):
        tags = Reader(replay_page(found, again)).tags
        asked = [names for _, names in tags if names.get("http-equiv") == "refresh"]
        assert asked == [{"http-equiv": "refresh", "content": "60"}] * again
        assert [names["data-again"] for _, names in tags if "data-again" in names] == ["60"] * again


def charts_have_dates(text):
    charts = re.findall(r"<figure>.*?</figure>", text, flags=re.S)
    assert len(charts) == 2
    for chart in charts:
        assert ">surfaced (UTC)<" in chart
        assert len(re.findall(r">\d\d:\d\d<|>[A-Z][a-z]{2}-\d\d<", chart)) in range(2, 12)


def test_sixty_dives_are_small_and_one_is_enough():
    text = page_of(60)
    assert len(text.encode()) < 2_000_000
    tags = Reader(text).tags
    rows = [names["id"] for tag, names in tags if tag == "tr" and "id" in names]
    links = [names["href"] for tag, names in tags if tag == "a"]  # a fix leads to its row
    assert sorted(links) == sorted(f"#{one}" for one in rows) == sorted(set(links))
    assert len(links) == 60
    charts_have_dates(page_of(1))


@pytest.mark.parametrize(("lat", "lon"), [(-43.0, 8.0), (67.0, -179.9), (0.0, 180.0), (89.0, 0.0)])
def test_a_chart_is_true_to_scale_and_angle(lat, lon):
    ax = map_plot(told(fixes_of(4, lat, lon)))
    (low, high), geod = ax.get_ylim(), Geod(ellps="WGS84")
    middle = (low + high) / 2
    # in a degree of longitude
    metres = geod.inv(lon, low, lon, high)[2] / (ax.get_aspect() * (high - low))
    for bearing in (0, 45, 90, 200):
        x, y, _ = geod.fwd(lon, middle, bearing, 100.0)
        away = complex(near(x - lon, 0.0), ax.get_aspect() * (y - middle)) * metres
        assert abs(away) == pytest.approx(100, rel=2e-3)
        turned = math.degrees(math.atan2(away.real, away.imag))
        assert turned % 360 == pytest.approx(bearing, abs=0.5)


@pytest.mark.parametrize("name", ["latitude", "from_latitude"])
def test_a_place_beyond_the_poles_is_not_drawn(name):
    found = told(fixes_of(4))
    found["next_dive"][name] = 1e9
    with pytest.raises(ValueError, match="a latitude is beyond the poles"):
        replay_page(found)


def test_a_far_waypoint_leaves_the_chart_as_it_is():
    *_, last = dives = fixes_of(6)
    found = told(dives)
    sizes = {}
    for bearing, away in ((0.0, 5e5), (90.0, 5e5), (225.0, 5e5), (300.0, 100.0)):
        place = Geod(ellps="WGS84").fwd(last.lon_gpse, last.lat_gpse, bearing, away)
        aimed = found | {"aim": told(dives, (place[1], place[0]))["aim"]}
        page = Reader(replay_page(aimed))
        assert page.texts[page.texts.index("Aim") + 1].startswith("heading ")
        sizes[bearing] = next(names["data-edges"] for tag, names in page.tags if tag == "svg")
    assert len({size for bearing, size in sizes.items() if bearing != 300.0}) == 1


def test_grid_names_its_lines():
    lons = (179 + 55 / 60, 180.0, 180 + 5 / 60)
    names = [grid_label(lon, names="EW", step=5) for lon in lons]
    assert names == ["179°55'E", "180°00'E", "179°55'W"]
    assert grid_label(-0.999999, names="NS", step=0.1) == "1°00.00'S"
    assert grid_label(59.9999 / 60, names="NS", step=1) == "1°00'N"
