"""Waypoints over days: when they are made, and areas that are entered, by drawing the dives."""

import json
import math
from datetime import datetime

import pytest
from synthetic_vehicle import STEADY, vehicle

from clpt_control.errors import DataError
from clpt_control.geodesy import place_from
from clpt_control.replay import map_plot, route
from clpt_control.replay.replay import replay_dives
from clpt_control.replay.wording import route_sentences

STAY, V = 600.0, 0.25  # s, m/s of the made vehicle


@pytest.fixture(autouse=True)
def thirty_draws(monkeypatch):
    monkeypatch.setattr(route, "DRAWS", 30)


@pytest.fixture(scope="module")
def known():
    """A vehicle in a steady current that it knows; it lies where it was at each fix."""
    return replay_dives(vehicle(1, 40, flow="steady"))


def seconds(time):
    return datetime.fromisoformat(time).timestamp()


def box(lat, lon, size=0.02):
    corners = (-size, -size), (-size, size), (size, size), (size, -size)
    return [(lat + a, lon + b) for a, b in corners]


def test_a_known_current_carries_it_there_when_the_triangle_says(known):
    """Across the line the nose makes up for the current; along it the rest of both goes on."""
    far = 40_000.0
    target = place_from(40.0, 8.0, far, 0.0)
    across = box(40.0, 8.0 + (target[1] - 8.0) / 2, 0.05)
    areas = [("across", across), ("beside", box(40.3, 8.2))]
    found = route.arrivals(known, [target], areas, V, 14400.0)
    (one,) = found["waypoints"]
    east = STEADY[0] + math.sqrt(V**2 - STEADY[1] ** 2)
    dives = far / east / 14400
    due = far / east + math.ceil(dives) * STAY
    took = {key: seconds(one[key]) - known.steps[-1].dive.t_gpse for key in route.SHARES}
    assert took["time"] == pytest.approx(due, rel=0.04)
    assert 0.85 * due < took["not_before"] < took["time"] < took["by"] < 1.15 * due
    assert one["made"] == 1
    assert [area["entered"] for area in found["areas"]] == [1, 0]
    assert "cannot be made before" in route_sentences(found)[0]
    assert " draws" not in route_sentences(found)[0]  # it is made in all
    assert route_sentences(found)[1:] == [
        "across: entered in 100 % of the draws",
        "beside: entered in 0 % of the draws",
    ]


def test_who_knows_less_arrives_less_surely(known):
    target = place_from(40.0, 8.0, 10_000.0, 0.0)
    width = []
    for replay in (known, replay_dives(vehicle(1, 1, flow="steady"))):
        (one,) = route.arrivals(replay, [target], [], V, 14400.0)["waypoints"]
        width.append(seconds(one["by"] or one["time"]) - seconds(one["not_before"]))
    assert width[1] > 2 * width[0]


def test_a_waypoint_against_the_current_is_not_made(known, monkeypatch):
    monkeypatch.setattr(route, "DIVES", 5)
    monkeypatch.setattr(route, "MOST_DRAWN", 12)  # of 5 dives each: three of thirty draws
    target = place_from(40.0, 8.0, -30_000.0, 15_000.0)
    found = route.arrivals(known, [target], [], 0.05, 14400.0)
    (one,) = found["waypoints"]
    assert (one["made"], one["time"], one["not_before"]) == (0, None, None)
    assert route_sentences(found)[0].endswith("not there; made within 5 dives in 0 % of 3 draws")


def test_the_same_draws_say_the_same(known):
    target = place_from(40.0, 8.0, 5_000.0, 3_000.0)
    asked = known, [target], [("here", box(40.0, 8.0))], None, None
    first = route.arrivals(*asked)
    assert first == route.arrivals(*asked)
    assert first["areas"][0]["entered"] == 1  # it begins within
    assert len(known.steps) == 40  # it learned nothing of what was drawn


SQUARE = [[8.0, 40.0], [8.1, 40.0], [8.1, 40.1], [8.0, 40.0]]


RING = [[8.0, 40.0 + 1e-6 * k] for k in range(20_001)]
MANY = {
    "type": "GeometryCollection",
    "geometries": [
        {"type": "Polygon", "coordinates": [RING]},
        {"type": "Point", "coordinates": [8.0, 40.0]},
    ],
}


def test_routes_are_read(tmp_path):
    path = tmp_path / "route"
    path.write_text("# two\n-42.8 8.4\n\n-42.7, 8.3  # the second\n")
    assert route.read_route(path) == ([(-42.8, 8.4), (-42.7, 8.3)], [])
    shapes = [
        {"type": "Point", "coordinates": [8.4, -42.8, 0.0]},
        {"type": "Polygon", "coordinates": [SQUARE, SQUARE]},
        {"type": "LineString", "coordinates": [[8.3, -42.7], [8.2, -42.6]]},
        {"type": "GeometryCollection", "geometries": [
            {"type": "MultiPolygon", "coordinates": [[SQUARE], [SQUARE]]}
        ]},
    ]  # fmt: skip
    names = [{"name": "P"}, {"name": "ground"}, None, {}]
    features = [
        {"type": "Feature", "geometry": shape, "properties": name}
        for shape, name in zip(shapes, names, strict=True)
    ]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    targets, areas = route.read_route(path)
    assert targets == [(-42.8, 8.4), (-42.7, 8.3), (-42.6, 8.2)]
    assert [name for name, _ in areas] == ["ground", "area", "area"]
    assert areas[0][1] == [(lat, lon) for lon, lat in SQUARE]
    parts = [[[8.4, -42.8], [8.3, -42.7]], [[8.2, -42.6], [8.1, -42.5]]]  # as QGIS saves lines
    path.write_text(json.dumps({"type": "MultiLineString", "coordinates": parts}))
    places = [(-42.8, 8.4), (-42.7, 8.3), (-42.6, 8.2), (-42.5, 8.1)]
    assert route.read_route(path)[0] == places


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "has no waypoint"),
        ("-42.8 8.4 7\n", "is neither GeoJSON nor a latitude"),
        ("8.4 -942.8\n", "latitude 8.4, longitude -942.8 is no place"),
        ('{"type": "Circle"}', "has no waypoint"),
        (json.dumps({"type": "Polygon", "coordinates": [SQUARE]}), "has no waypoint"),
        ("{" * 10**5, "is neither GeoJSON"),
        ('{"type": "LineString", "coordinates": [[[8.0, 40.0]]]}', "places are pairs"),
        (f'{{"type": "Point", "coordinates": [{10**400}, 1]}}', "is neither GeoJSON"),
        (json.dumps({"type": "Polygon", "coordinates": [SQUARE[:2]]}), "at least three corners"),
        ("-42.8 8.4\n" * 101, "has 101 waypoints, and areas of 0 places; at most 100,"),
        (json.dumps(MANY), "and areas of 20001 places; at most 100,"),
        (" " * 10**7 + "1", "is larger than 10 MB"),
    ],
)
def test_what_is_no_route_is_one_sentence(text, says, tmp_path):
    (tmp_path / "route").write_text(text)
    with pytest.raises(DataError, match="route: ") as caught:
        route.read_route(tmp_path / "route")
    assert says in str(caught.value)


@pytest.mark.usefixtures("undrawn")
def test_the_command_draws_the_way(command, tmp_path):
    line = {"type": "LineString", "coordinates": [[8.47, -42.93], [8.47, -42.92]]}
    ring = [[8.46, -42.94], [8.48, -42.94], [8.48, -42.92], [8.46, -42.94]]
    both = {
        "type": "GeometryCollection",
        "geometries": [line, {"type": "Polygon", "coordinates": [ring]}],
    }
    (tmp_path / "route.json").write_text(json.dumps(both))
    words = ("--sample", "--route", tmp_path / "route.json", "--json")
    done = command(*words, "--out", tmp_path / "out")
    found = json.loads(done.stdout)
    assert found["aim"][0]["latitude"] == -42.93
    assert found["route"]["waypoints"][0]["made"] > 0.5
    page = (tmp_path / "out" / "replay.html").read_text("utf-8")
    assert "route to 42 55.80 S" in page
    (area,) = map_plot(found).patches
    assert len(area.get_xy()) == 4
    assert found["paste"]["file"] == "targets"
