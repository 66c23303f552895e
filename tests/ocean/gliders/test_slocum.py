"""A Slocum and a SeaExplorer: real files against plain arithmetic; all forms; made missions."""

import csv
import shutil
import struct
from functools import partial
from itertools import permutations

import numpy as np
import pytest
from glider_files import error_of, used_numbers
from pyproj import Geod
from refusals import refuses
from slocum_writer import (
    FIX,
    FLAG,
    LASTS,
    OWN,
    PLACES,
    SENSORS,
    STEP,
    VARIATION,
    Mission,
    ddmm,
    segment,
)
from watched_folder import watched

from clpt_control.gliders import read_dives
from clpt_control.ocean.gliders.slocum_file import read_segment, uncompressed

LZ4 = pytest.importorskip("numcodecs").LZ4


def test_rosie_agrees_with_its_own_current(facts):
    dives, skipped = read_dives(facts / "glider/slocum_rosie/sbd", usable=False)
    assert skipped == []
    assert [d.number for d in dives] == [970157, 970159, 970161, 980000, 980002, 980003]
    off = sorted(error_of(dive)[1] for dive in dives)
    assert np.median(off) < 6e-3
    assert off[-2] < 1e-2
    # the last ten minutes of one are after its last logged place
    assert [d.number for d in dives if d.notes] == [970161]
    assert all(16.5 < d.magvar < 18.0 for d in dives)  # a SeaExplorer there says 17
    used, left_out = read_dives(facts / "glider/slocum_rosie/sbd")
    assert (len(used), left_out) == (6, [])
    assert not any("missing" in note for dive in used for note in dive.notes)


def test_the_folder_of_lists_can_be_named(facts, tmp_path, monkeypatch):
    shutil.copy(facts / "glider/slocum_rosie/sbd/rosie_713-2019-170-0-2.sbd", tmp_path)
    refuses(r"6b016a2e\.cac was not found .* CLPT_CAC", read_dives, tmp_path)
    monkeypatch.setenv("CLPT_CAC", str(facts / "glider/slocum_rosie/cac"))
    assert len(read_dives(tmp_path, usable=False)[0]) == 1


def test_the_first_dive_is_that_of_the_table(facts):
    ((dive,), skipped) = read_dives(facts / "glider/sea035", usable=False)
    assert skipped == []
    with (facts / "glider/sea035m10_dives.csv").open() as file:
        row = next(csv.DictReader(line for line in file if not line.startswith("#")))
    for name in ("t_gps2", "lat_gps2", "lon_gps2", "t_gpse", "lat_gpse", "lon_gpse"):
        assert getattr(dive, name) == pytest.approx(float(row[name]), abs=1e-6), name
    reckoned = [float(row[name]) for name in ("dr_east_m", "dr_north_m", "depth_max")]
    assert [dive.dr_east, dive.dr_north, dive.depth_max] == pytest.approx(
        reckoned, abs=0.5
    )
    assert (dive.magvar, dive.kind) == (17.0, "SeaExplorer")


def navigated(folder, rows, cut=""):
    """Return the dive of rows: s, NavState, heading, declination, pitch, depth, lat, lon.

    A last one may be cut short.
    """
    text = "Timestamp;NavState;Heading;Declination;Pitch;Depth;Lat;Lon;\n"
    for s, *cells in rows:
        hours, minutes = divmod(s // 60, 60)
        time = f"09/04/2024 {12 + hours}:{minutes:02d}:{s % 60:02d}"
        text += ";".join(map(str, [time, *cells, "\n"]))
    (folder / "sea001.1.gli.sub.1").write_text(text + cut)
    return read_dives(folder, usable=False)[0][0]


@pytest.mark.parametrize(
    ("heading", "declination"), [(0.0, 1.0), (73.0, 17.0), (350.0, -20.0)]
)
def test_a_v_of_constant_slope_is_depth_over_tangent(tmp_path, heading, declination):
    """Down to 100 m and up at 20 degrees: 2 * 100 m/tan(20 deg) along heading + declination."""
    way, west = (heading, declination), "-3000.000"
    rows = [(-60, 116, 0, 0, 0, 0, "4500.000", "-3000.100")]
    rows += [(0, 116, *way, -20, 0, "4500.000", west)]
    rows += [(10 * k, 100, *way, -20, k - 1, "4500.000", west) for k in range(1, 102)]
    rows += [
        (10 * k, 100, *way, 20, 201 - k, "4500.000", west) for k in range(102, 202)
    ]
    dive = navigated(tmp_path, [*rows, (2020, 116, *way, 20, 0, "4500.200", west)])
    length = 2 * 100 / np.tan(np.radians(20.0))
    true = np.radians(heading + declination)
    there = length * np.sin(true), length * np.cos(true)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(there, abs=0.02 * length)
    assert dive.duration == 2020.0


@pytest.mark.parametrize("column", [2, 3, 4])
def test_angles_that_are_none_are_gaps(tmp_path, column):
    rows = [(-60, 116, 0, 0, 0, 0, "4500.000", "-3000.100")]
    rows += [(0, 116, 90, 0, -20, 0, "4500.000", "-3000.000")]
    rows += [
        (10 * k, 100, 90, 0, -20 if k < 101 else 20, min(k, 201 - k) - 1, "", "")
        for k in range(1, 201)
    ]
    rows += [(2020, 116, 90, 0, 20, 0, "4500.200", "-3000.000")]
    right = navigated(tmp_path, rows)
    bad = [
        (*row[:column], -999, *row[column + 1 :]) if k % 7 == 3 else row
        for k, row in enumerate(rows)
    ]
    dive = navigated(tmp_path, bad)
    assert dive.dr_east == pytest.approx(right.dr_east, rel=0.02)
    assert dive.dr_north == pytest.approx(right.dr_north, abs=20.0)
    assert "numbers of Heading, Declination, Pitch, DesiredH are no" in dive.notes[0]


def test_a_place_that_is_repeated_behind_a_row_without_one_is_no_new_fix(tmp_path):
    """At 13:21 the vehicle is up with the place that it left; the first new fix is of 13:25."""
    rows = [(0, 116, 0, "4500.000"), (1, 116, 0, "4500.100"), (2, 110, 9, "4500.100")]
    rows += [(k, 110 if k < 40 else 117, 9, "4500.100") for k in range(3, 80)]
    rows += [(80, 116, 0, ""), (81, 116, 0, "4500.100"), (85, 116, 0, "4500.900")]
    rows = [
        (60 * k, s, 0, 0, -20 if k < 40 else 20, d, n, "-3000.000")
        for k, s, d, n in rows
    ]
    dive = navigated(tmp_path, rows)
    assert (dive.duration, dive.lat_gpse) == (84 * 60.0, pytest.approx(45 + 0.9 / 60))
    cut = "09/04/2024 13:25:00;116;0;0;20;0;4500.900;-3"  # of -3000.000
    refuses("no dives", navigated, tmp_path, rows[:-1], cut)


def test_the_fix_of_the_start_is_none_at_the_end_though_places_moved_between(tmp_path):
    rows = [(0, 116, 0, "4500.000"), (1, 116, 0, "4500.100")]
    rows += [(k, 110 if k < 40 else 117, 9, f"4500.{100 + k}") for k in range(2, 80)]
    rows += [(80, 116, 0, "4500.100"), (81, 116, 0, ""), (85, 116, 0, "4500.900")]
    rows = [
        (60 * k, s, 0, 0, -20 if k < 40 else 20, d, n, "-3000.000")
        for k, s, d, n in rows
    ]
    dive = navigated(tmp_path, rows)
    assert (dive.duration, dive.lat_gpse) == (84 * 60.0, pytest.approx(45 + 0.9 / 60))


@pytest.mark.parametrize(
    ("steered", "course"), [(("301", "312.5"), 312.5), (("", ""), None)]
)
def test_a_seaexplorer_steers_its_last_desired_heading(
    tmp_path, facts, steered, course
):
    for path in sorted((facts / "glider/sea035").iterdir()):
        head, *lines = path.read_text().splitlines()
        rows = [
            f"{line}{steered[2 * k >= len(lines)]};" for k, line in enumerate(lines)
        ]
        (tmp_path / path.name).write_text("\n".join([f"{head}DesiredH;", *rows]) + "\n")
    ((dive,), _) = read_dives(tmp_path, usable=False)
    assert dive.next_course == course


def compressed(raw):
    """Return bytes as a glider compresses them: blocks of 32 kB, each behind its size."""
    blocks = [LZ4().encode(raw[k : k + 2**15])[4:] for k in range(0, len(raw), 2**15)]
    return b"".join(struct.pack(">H", len(block)) + block for block in blocks)


TEXT = (  # lines, here between |
    "dbd_label: DBD_ASC(dinkum_binary_data_ascii)file|encoding_ver: 2|num_ascii_tags: 14|"
    "all_sensors: 0|filename: {name}|the8x3_filename: 00970157|filename_extension: sbd|"
    "filename_label: {name}-sbd(00970157)|mission_name: MADE.MI|"
    "fileopen_time: Thu_Sep__5_02:46:15_2013|sensors_per_cycle: {n}|num_label_lines: 3|"
    "num_segments: 1|segment_filename_0: {name}"
)


def as_text(path, name):
    """Return a segment as dbd2asc writes it."""
    log = read_segment(path).of.reset_index()
    n = len(log.columns)
    lines = [
        *TEXT.format(name=name, n=n).split("|"),
        *map(" ".join, (log, "x" * n, "8" * n)),
    ]
    rows = np.vstack([np.full(n, np.nan), log])
    return (
        "\n".join([*lines, *(" ".join(f"{v:.15g}" for v in row) for row in rows)])
        + "\n"
    )


@pytest.fixture
def rosie(facts, tmp_path):
    return shutil.copytree(facts / "glider/slocum_rosie", tmp_path, dirs_exist_ok=True)


@pytest.fixture
def one(rosie):
    """One of its segments."""
    return rosie / "sbd" / "rosie_713-2019-166-0-157.sbd"


def test_compressed_files_are_read_as_plain_ones(rosie):
    plain = read_dives(rosie / "sbd", usable=False)
    for path in [*(rosie / "sbd").iterdir(), *(rosie / "cac").iterdir()]:
        packed = compressed(path.read_bytes())
        assert uncompressed(packed) == (path.read_bytes(), True)
        path.with_suffix({".sbd": ".scd", ".cac": ".ccc"}[path.suffix]).write_bytes(
            packed
        )
        path.unlink()
    assert read_dives(rosie / "sbd", usable=False) == plain


def test_a_file_larger_than_a_block_and_every_cut_of_one(one):
    raw = one.read_bytes() * 20
    packed = compressed(raw)
    assert uncompressed(packed) == (raw, True)
    for cut in range(1, 3000, 37):
        part, whole = uncompressed(packed[:cut])
        assert not whole
        assert raw.startswith(part)


@pytest.mark.parametrize("seed", range(3))
def test_random_bytes_end(tmp_path, seed):
    rng = np.random.default_rng(seed)
    path = tmp_path / "unit-2024-100-7-1.dcd"
    path.write_bytes(b"\xff\xff\xf0dbd_label: x" + rng.bytes(300_000))
    refuses("damaged or cut short", read_dives, path)


def test_text_of_dbd2asc_gives_the_same_dives(rosie, one):
    plain, text = read_dives(rosie / "sbd", usable=False)[0][0], as_text(one, one.stem)
    (rosie / "text").mkdir()
    for name in (f"{one.stem}.sba", "rosie.asc"):
        path = rosie / "text" / name
        path.write_text(text)
        ((dive,), skipped) = read_dives(path, usable=False)
        assert skipped == []
        for key in (
            "number",
            "t_gps2",
            "t_gpse",
            "dr_east",
            "dr_north",
            "dac_east",
            "dac_north",
        ):
            assert getattr(dive, key) == pytest.approx(getattr(plain, key), abs=1e-4)
        path.write_text(text[: len(text) // 2])
        assert read_segment(path).of.m_depth.count() > 50
        path.unlink()


def test_a_text_that_is_none_is_one_sentence(rosie, one):
    for old, new, said in (
        ("sensors_per_cycle: ", "sensors_per_cycle: -", "sensors_per_cycle"),
        ("num_label_lines: 3", "num_label_lines: many", "num_label_lines"),
        ("encoding_ver: 2", "encoding_ver: 5", "encoding '5'"),
        ("num_ascii_tags: 14", "num_ascii_tags: 140", "too few lines"),
        ("m_present_time", "m_past_time", "no m_present_time"),
    ):
        (rosie / "one.asc").write_text(as_text(one, one.stem).replace(old, new))
        refuses(said, read_dives, rosie / "one.asc")


def test_a_dockservers_folder_is_read_as_it_is(rosie):
    plain = read_dives(rosie / "sbd", usable=False)
    glider = rosie / "default" / "gliders" / "rosie_713"
    for name in ("to-glider", "logs", "configuration"):
        (glider / name).mkdir(parents=True)
        (glider / name / "x.log").write_text("x")
    (rosie / "sbd").rename(glider / "from-glider")
    (glider / "from-glider" / "rosie_713-2019-166-0-157.tbd").write_bytes(
        b"dbd_label: x"
    )
    (rosie / "cac").rename(rosie / "default" / "cache")
    assert read_dives(glider, usable=False) == plain


def test_dives_of_one_file_are_told_apart(rosie, one):
    other = as_text(one.with_stem("rosie_713-2019-166-0-159"), "rosie").splitlines(
        keepends=True
    )
    (rosie / "both.asc").write_text(as_text(one, "rosie") + "".join(other[17:]))
    dives, _ = read_dives(rosie / "both.asc", usable=False)
    assert [dive.notes[0] for dive in dives] == [
        f"dive {k} of 2 in both.asc" for k in (1, 2)
    ]


# --- made missions --------------------------------------------------------------------------------


DIVES = 5  # in 1, 2, 3, 4 files and in 1


def flown(folder, without=(), late=False, wrong=0.0, **how):
    """Return the true currents and dives of a mission of segments of 1 to 4 files."""
    mission = Mission(folder, tuple(n for n in SENSORS if n not in without), **how)
    for k in range(DIVES):
        mission.dive(k, 1 + k % 4, wrong, late)
    dives, skipped = read_dives(folder, usable=False)
    assert skipped == []
    return mission.truth, sorted(dives, key=lambda dive: dive.t_gpse)


def largest_error(truth, dives):
    """Return how far a dive's miss over its duration is from the truth at most, mm/s."""
    found = [
        (dive.miss_east / dive.duration, dive.miss_north / dive.duration)
        for dive in dives
    ]
    return 1e3 * np.hypot(*(np.array(found) - truth).T).max()


MISSIONS = [
    {},
    {"end": b""},
    {"without": PLACES},  # on magnetic axes
    {"every": 15},  # each ten minutes
    {"without": FLAG},
    {"late": True},
    {"added": 0.0},
    {"added": 0.0, "without": FLAG},
    {"added": 0.0, "late": True},
]


@pytest.mark.parametrize("how", MISSIONS, ids=str)
def test_each_dive_of_a_mission_has_the_current_of_its_sea(tmp_path, how):
    truth, dives = flown(tmp_path / "sbd", **how)
    assert [d.number for d in dives] == [70000, 70002, 70005, 70009, 70010]
    # what is added goes on along the heading from the last place on
    assert largest_error(truth, dives) < (12 if "every" in how else 5)
    for dive, sea in zip(dives, truth, strict=True):
        note = " ".join(dive.notes)
        added = how.get("added", 1.0) == 1.0
        assert ("taken off" in note or "that current is" in note) == added
        assert not any("cut short" in note for note in dive.notes)
        own = (None, None) if "late" in how else tuple(sea)
        assert (dive.dac_east, dive.dac_north) == pytest.approx(own)
        assert dive.magvar == pytest.approx(VARIATION)


class Stale(Mission):
    """A mission whose receiver repeats its first fix after the first dive."""

    fixes = 0

    def fixed(self):
        cycle = super().fixed()
        self.fixes += 1
        if self.fixes == 3:  # before the mission, before the dive, after it
            cycle |= dict(zip(FIX[:2], ddmm(self.started), strict=True))
        else:
            self.started = self.at
        return cycle


def test_a_dive_whose_end_fix_is_its_start_fix_goes_on_to_the_next(tmp_path):
    dives = []
    for kind in (Mission, Stale):
        mission = kind(tmp_path / kind.__name__, added=0.0)
        mission.dive(0)
        mission.dive(1)
        found = read_dives(tmp_path / kind.__name__, usable=False)[0]
        dives.append(sorted(found, key=lambda dive: dive.t_gpse))
    (first, right), (longer, used) = dives
    assert (longer.t_gps2, longer.t_gpse) == (first.t_gps2, right.t_gps2)
    assert longer.through_water == pytest.approx(first.through_water, abs=1.0)
    assert used.t_gpse == right.t_gpse
    assert (used.gps_north, used.dr_north) == pytest.approx(
        (right.gps_north, right.dr_north), abs=1.0
    )


class Descending(Mission):
    """A mission that logs m_depth in the first half of a dive, and up at the surface."""

    deep = 0

    def says(self, **new):
        if new.get("m_depth"):
            self.deep += 1
            if self.deep > LASTS / STEP / 2:
                del new["m_depth"]
        return super().says(**new)


def test_a_dive_with_depths_on_the_descent_alone_is_read(tmp_path):
    found = []
    for kind in (Mission, Descending):
        kind(tmp_path / kind.__name__, added=0.0).dive(0)
        found += read_dives(tmp_path / kind.__name__)[0]
    right, half = found
    assert (half.dr_east, half.dr_north) == pytest.approx(
        (right.dr_east, right.dr_north), abs=1.0
    )
    assert "no m_depth after 60 m, but places: taken as under water" in half.notes


def test_a_file_without_depths_says_what_to_give(tmp_path):
    sensors = tuple(name for name in SENSORS if name != "m_depth")
    Mission(tmp_path / "sbd", sensors).dive(0)
    said = "has fixes and no m_depth, by which dives are found. Give files with m_depth"
    refuses(said, read_dives, tmp_path / "sbd")


@pytest.mark.long
@pytest.mark.parametrize(("share", "used"), [(0.2, 5), (1.0, 0)])
def test_a_heading_of_999_is_a_gap(tmp_path, monkeypatch, share, used):
    chance = np.random.default_rng(3)
    says = Mission.says

    def broken(self, **new):
        if "m_heading" in new and chance.random() < share:
            new["m_heading"] = -999.0
        return says(self, **new)

    monkeypatch.setattr(Mission, "says", broken)
    truth, dives = flown(tmp_path / "sbd", OWN, added=0.0, every=25)
    found, skipped = read_dives(tmp_path / "sbd")
    assert len(found) == used
    if found:
        assert largest_error(truth, dives) < 5
    else:
        assert "m_heading is not in radians" in skipped[0].why


def test_dead_reckoning_that_contradicts_the_own_current_is_not_used(tmp_path):
    truth, dives = flown(tmp_path / "sbd", wrong=np.array([0.1, -0.3]))
    assert largest_error(truth, dives) < 5
    assert all(
        d.track is None and "not used, that current is" in d.notes[-1] for d in dives
    )
    assert len(used_numbers(dives)) == DIVES


@pytest.mark.long
def test_a_dive_that_may_hold_a_current_is_not_used(tmp_path):
    for without in (OWN, FLAG):
        flown(tmp_path / without[0], without, late=True)
        used, skipped = read_dives(tmp_path / without[0])
        assert (used, len(skipped)) == ([], DIVES)
        assert all("holds a current" in s.why for s in skipped)
    _, dives = flown(tmp_path / "neither", (*OWN, *FLAG))
    assert all("no file says whether" in d.notes[0] for d in dives)


@pytest.fixture(scope="module")
def in_three_files(tmp_path_factory):
    """A folder of a dive in three files and their list, and what is read of it."""
    folder = tmp_path_factory.mktemp("source") / "sbd"
    Mission(folder).dive(0, 3)
    return folder, read_dives(folder, usable=False)


def test_a_dive_over_several_files_is_one(in_three_files, tmp_path):
    source, ((dive,), _) = in_three_files
    Mission(tmp_path / "whole").dive(0)
    (whole,) = read_dives(tmp_path / "whole", usable=False)[0]
    assert (dive.dr_east, dive.dr_north) == pytest.approx(
        (whole.dr_east, whole.dr_north), abs=1e-6
    )
    paths = [source / f"unit-2024-100-7-{k}.sbd" for k in range(3)]
    part = shutil.copytree(source, tmp_path / "part")
    (part / paths[1].name).unlink()
    (dive,) = read_dives(part, usable=False)[0]
    assert np.isnan(dive.dr_east)  # a third of it is missing
    assert any("no samples for" in note for note in dive.notes)


@pytest.mark.parametrize("order", list(permutations(range(4)))[::5])
def test_watched_files_come_in_any_order(
    in_three_files, tmp_path, order, clpt, monkeypatch
):
    (source, wanted), inbox = in_three_files, tmp_path / "inbox"
    inbox.mkdir()
    things = [*sorted(source.glob("*.sbd")), source / "cac"]

    def arrive(k):
        copy = shutil.copytree if things[k].is_dir() else shutil.copy
        copy(things[k], inbox / things[k].name)

    changes = [partial(arrive, k) for k in order]
    words = "--format", "svg", "--out", tmp_path / "out"
    found, _ = watched(clpt, monkeypatch, inbox, changes, *words)
    used = found["each_dive"]
    assert [row["dive"] for row in used] == [dive.number for dive in wanted[0]]
    assert read_dives(inbox, usable=False) == wanted


def test_a_file_that_holds_its_own_list_needs_none_beside_it(tmp_path):
    mission, written = Mission(tmp_path / "sbd"), []
    mission.write = lambda cycles, first: written.append(
        (cycles, {n: first[n] for n in SENSORS})
    )
    mission.dive(0)
    ((cycles, first),) = written
    shutil.rmtree(tmp_path / "sbd" / "cac")
    path = tmp_path / "sbd" / "unit-2024-100-7-0.sbd"
    raw = segment(cycles, SENSORS, "00070000", path.stem, 0, first)
    path.write_bytes(raw)
    Mission(tmp_path / "beside").dive(0)
    assert read_dives(path, usable=False) == read_dives(
        tmp_path / "beside", usable=False
    )
    path.write_bytes(raw[: raw.index(b"m_depth")])
    refuses(r"is not a list of \d+ sensors", read_dives, path)


@pytest.mark.parametrize("said", ["a waypoint", "a heading", "nothing"])
def test_the_plan_of_the_next_dive(tmp_path, said):
    """To the waypoint, else along the heading from magnetic north."""
    plan, there = {"c_heading": 1.0} if said != "nothing" else {}, (51.9, -127.7)
    if said == "a waypoint":
        plan |= dict(zip(("c_wpt_lat", "c_wpt_lon"), ddmm(there), strict=True))
    mission = Mission(tmp_path / "sbd", (*SENSORS, *plan))
    mission.says(**plan)
    mission.dive(0)
    dive = read_dives(tmp_path / "sbd", usable=False)[0][-1]
    bearing = Geod(ellps="WGS84").inv(dive.lon_gpse, dive.lat_gpse, *there[::-1])[0]
    wanted = {
        "a waypoint": bearing % 360,
        "a heading": np.degrees(1.0) + VARIATION,
    }.get(said)
    assert dive.next_course == (wanted and pytest.approx(wanted, abs=0.05))


@pytest.mark.parametrize("name", ["{}.asc", "{}_sbd.asc", "made_{}.dba"])
def test_text_is_in_the_order_of_its_headers(tmp_path, name):
    """A dive over three files, whose names say nothing of the vehicle."""
    Mission(tmp_path / "source").dive(0, 3)
    (right,) = read_dives(tmp_path / "source", usable=False)[0]
    folder = tmp_path / "text"
    folder.mkdir()
    for k, other in enumerate((2, 0, 1)):
        own = f"unit-2024-100-7-{k}"
        text = as_text(tmp_path / "source" / f"{own}.sbd", own)
        (folder / name.format(other)).write_text(text)
    (dive,) = read_dives(folder, usable=False)[0]
    assert dive.vehicle == "unit"
    assert dive.through_water == pytest.approx(right.through_water, abs=1.0)
    assert (dive.t_gps2, dive.t_gpse) == (right.t_gps2, right.t_gpse)


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize(
    ("share", "said"),
    [(0.5, "no place for the last"), (0.88, "s under water are of the heading")],
)
def test_places_that_end_early_or_are_held_are_told(tmp_path, share, said, held):
    """Of an hour under water without a place the first half's speed tells nothing."""
    Mission(tmp_path / "source").dive(0)
    ((path,),) = [(tmp_path / "source").glob("*.sbd")]
    head, *rows = as_text(path, path.stem).splitlines()
    names = rows[13].split()
    lost = [names.index(name) for name in PLACES]
    first = int(share * len(rows))
    last = [rows[first - 1].split()[j] for j in lost]
    for k in range(first, len(rows)):
        cells = rows[k].split()
        for j, cell in zip(lost, last, strict=True):
            cells[j] = cell if held else "NaN"
        rows[k] = " ".join(cells)
    (tmp_path / "part.asc").write_text("\n".join([head, *rows]) + "\n")
    (dive,) = read_dives(tmp_path / "part.asc", usable=False)[0]
    assert np.isnan(dive.dr_east) == ("no place" in said)
    assert any(said in note for note in dive.notes)
