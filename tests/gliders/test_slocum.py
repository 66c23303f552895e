"""A Slocum and a SeaExplorer: real files against plain arithmetic; files in all their forms."""

import csv
import gzip
import shutil
import struct

import numpy as np
import pytest

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, slocum_file, usable
from clpt_control.gliders.dives import files_before
from clpt_control.gliders.slocum_file import read_segment, uncompressed
from clpt_control.replay.follow import Follower


def test_rosie_agrees_with_its_own_current(facts):
    dives, skipped = read_dives(facts / "glider/slocum_rosie/sbd")
    assert skipped == []
    assert [d.number for d in dives] == [970157, 970159, 970161, 980000, 980002, 980003]
    off = [
        np.hypot(d.miss_east / d.duration - d.dac_east, d.miss_north / d.duration - d.dac_north)
        for d in dives
    ]
    assert np.median(off) < 6e-3
    assert sorted(off)[-2] < 1e-2
    (noted,) = [d for d in dives if d.notes]
    assert noted.number == 970161  # its last ten minutes are after its last logged place
    assert all(16.5 < d.magvar < 18.0 for d in dives)  # a SeaExplorer there says 17
    used, left_out = usable(dives)
    assert (len(used), left_out) == (6, [])
    assert not any("missing" in note for dive in used for note in dive.notes)


def test_the_folder_of_lists_can_be_named(facts, tmp_path, monkeypatch):
    shutil.copy(facts / "glider/slocum_rosie/sbd/rosie_713-2019-170-0-2.sbd", tmp_path)
    with pytest.raises(DataError, match=r"6b016a2e\.cac was not found .* CLPT_CAC"):
        read_dives(tmp_path)
    monkeypatch.setenv("CLPT_CAC", str(facts / "glider/slocum_rosie/cac"))
    assert len(read_dives(tmp_path)[0]) == 1


HEADER = "Timestamp;NavState;Heading;Declination;Pitch;Depth;Lat;Lon;\n"


def test_the_first_dive_is_that_of_the_table(facts):
    ((dive,), skipped) = read_dives(facts / "glider/sea035")
    assert skipped == []
    with (facts / "glider/sea035m10_dives.csv").open() as file:
        row = next(csv.DictReader(line for line in file if not line.startswith("#")))
    for name in ("t_gps2", "lat_gps2", "lon_gps2", "t_gpse", "lat_gpse", "lon_gpse"):
        assert getattr(dive, name) == pytest.approx(float(row[name]), abs=1e-6), name
    reckoned = float(row["dr_east_m"]), float(row["dr_north_m"])
    assert (dive.dr_east, dive.dr_north) == pytest.approx(reckoned, abs=0.5)
    assert dive.depth_max == pytest.approx(float(row["depth_max"]), abs=0.5)
    assert (dive.magvar, dive.kind) == (17.0, "SeaExplorer")


@pytest.mark.parametrize(("heading", "declination"), [(0.0, 0.0), (73.0, 17.0), (350.0, -20.0)])
def test_a_v_of_constant_slope_is_depth_over_tangent(tmp_path, heading, declination):
    """Down to 100 m and up at 20 degrees: 2 * 100 m/tan(20 deg) along heading + declination."""
    text = HEADER + "09/04/2024 11:59:00;116;0;0;0;0;4500.000;-3000.100;\n"
    for k in range(203):
        depth, down = (k - 1, True) if k <= 101 else (201 - k, False)
        surface = k == 0 or k == 202
        text += (
            f"09/04/2024 12:{k * 10 // 60:02d}:{k * 10 % 60:02d};{116 if surface else 100};"
            f"{heading};{declination};{-20 if down else 20};{0 if surface else depth};"
            f"4500.{'200' if k == 202 else '000'};-3000.000;\n"
        )
    (tmp_path / "sea001.1.gli.sub.1").write_text(text)
    ((dive,), _) = read_dives(tmp_path)
    length = 2 * 100 / np.tan(np.radians(20.0))
    true = np.radians(heading + declination)
    there = length * np.sin(true), length * np.cos(true)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(there, abs=0.02 * length)
    assert dive.duration == 2020.0


def test_a_place_that_is_repeated_behind_a_row_without_one_is_no_new_fix(tmp_path):
    """At 13:21 the vehicle is up with the place that it left; the first new fix is of 13:25."""
    rows = [(0, 116, 0, "4500.000"), (1, 116, 0, "4500.100"), (2, 110, 9, "4500.100")]
    rows += [(k, 110 if k < 40 else 117, 9, "4500.100") for k in range(3, 80)]
    rows += [(80, 116, 0, ""), (81, 116, 0, "4500.100"), (85, 116, 0, "4500.900")]
    text = HEADER + "".join(
        f"09/04/2024 {12 + k // 60}:{k % 60:02d}:00;{state};0;0;{-20 if k < 40 else 20};{depth};"
        f"{lat};-3000.000;\n"
        for k, state, depth, lat in rows
    )
    (tmp_path / "sea001.1.gli.sub.1").write_text(text)
    ((dive,), _) = read_dives(tmp_path)
    assert (dive.duration, dive.lat_gpse) == (84 * 60.0, pytest.approx(45 + 0.9 / 60))


def test_a_dive_of_two_files_comes_with_the_second(facts, tmp_path):
    names = ["SEA035.10.gli.sub.002", "SEA035.10.gli.sub.003"]
    source = facts / "glider/sea035"
    for order in (names, names[::-1]):
        inbox = tmp_path / order[0]
        inbox.mkdir()
        follower = Follower(inbox, tmp_path / f"{order[0]}.state")
        for name in order:
            (inbox / f"{name}.gz").write_bytes(gzip.compress((source / name).read_bytes()))
            follower.look()
        assert follower.dives() == read_dives(source)
    other = tmp_path / "other"
    other.mkdir()
    (other / "sea036.10.gli.sub.002").write_text("")
    shutil.copy(source / names[1], other)
    assert files_before(other / names[1]) == []


@pytest.mark.parametrize(("steered", "course"), [(("301", "312.5"), 312.5), (("", ""), None)])
def test_a_seaexplorer_steers_its_last_desired_heading(tmp_path, facts, steered, course):
    for path in sorted((facts / "glider/sea035").iterdir()):
        head, *lines = path.read_text().splitlines()
        early, late = steered
        rows = [f"{line}{early if k < len(lines) / 2 else late};" for k, line in enumerate(lines)]
        (tmp_path / path.name).write_text("\n".join([f"{head}DesiredH;", *rows]) + "\n")
    ((dive,), _) = read_dives(tmp_path)
    assert dive.next_course == course


TIME = "m_present_time"
LZ4 = pytest.importorskip("numcodecs").LZ4


def compressed(raw):
    """Return bytes as a glider compresses them: blocks of 32 kB, each behind its size."""
    blocks = [LZ4().encode(raw[k : k + 2**15])[4:] for k in range(0, len(raw), 2**15)]
    return b"".join(struct.pack(">H", len(block)) + block for block in blocks)


def as_text(path, name, ext):
    """Return a segment as dbd2asc writes it."""
    of = read_segment(path).of
    sensors = [TIME, *of]
    tags = {
        "dbd_label": "DBD_ASC(dinkum_binary_data_ascii)file",
        "encoding_ver": 2,
        "num_ascii_tags": 14,
        "all_sensors": 0,
        "filename": name,
        "the8x3_filename": "00970157",
        "filename_extension": ext,
        "filename_label": f"{name}-{ext}(00970157)",
        "mission_name": "MADE.MI",
        "fileopen_time": "Thu_Sep__5_02:46:15_2013",
        "sensors_per_cycle": len(sensors),
        "num_label_lines": 3,
        "num_segments": 1,
        "segment_filename_0": name,
    }
    lines = [f"{tag}: {value}" for tag, value in tags.items()]
    lines += [" ".join(line) for line in (sensors, ["x"] * len(sensors), ["8"] * len(sensors))]
    first = np.full(len(sensors), np.nan)
    lines += [" ".join(f"{v:.15g}" for v in row) for row in (first, *of.reset_index().to_numpy())]
    return "\n".join(lines) + "\n"


@pytest.fixture
def rosie(facts, tmp_path):
    shutil.copytree(facts / "glider/slocum_rosie", tmp_path, dirs_exist_ok=True)
    return tmp_path


def test_compressed_files_are_read_as_plain_ones(rosie):
    plain = read_dives(rosie / "sbd")
    for path in list((rosie / "sbd").iterdir()):
        packed = compressed(path.read_bytes())
        assert uncompressed(packed) == (path.read_bytes(), True)
        path.with_suffix(".scd").write_bytes(packed)
        path.unlink()
    for path in list((rosie / "cac").iterdir()):
        path.with_suffix(".ccc").write_bytes(compressed(path.read_bytes()))
        path.unlink()
    assert read_dives(rosie / "sbd") == plain
    assert len(files_before(sorted((rosie / "sbd").iterdir())[3])) == 3


def test_a_file_larger_than_a_block_and_every_cut_of_one(rosie):
    raw = (rosie / "sbd" / "rosie_713-2019-166-0-157.sbd").read_bytes() * 20
    packed = compressed(raw)
    assert uncompressed(packed) == (raw, True)
    for cut in range(1, 3000, 37):
        part, whole = uncompressed(packed[:cut])
        assert not whole
        assert raw.startswith(part)


@pytest.mark.parametrize("seed", range(3))
def test_random_bytes_end_soon(tmp_path, seed, monkeypatch):
    rng = np.random.default_rng(seed)
    body = rng.integers(0, 256, 300_000, dtype=np.uint8).tobytes()
    path = tmp_path / "unit-2024-100-7-1.dcd"
    path.write_bytes(b"\xff\xff\xf0dbd_label: x" + body)
    runs, length = [], slocum_file._length
    monkeypatch.setattr(slocum_file, "_length", lambda *of: runs.append(of) or length(*of))
    with pytest.raises(DataError, match="damaged or cut short"):
        read_dives(path)
    assert 0 < len(runs) < 100  # of new bytes and of copies


def test_text_of_dbd2asc_gives_the_same_dives(rosie):
    plain, _ = read_dives(rosie / "sbd")
    source = rosie / "sbd" / "rosie_713-2019-166-0-157.sbd"
    text = as_text(source, source.stem, "sbd")
    (rosie / "text").mkdir()
    for name in (f"{source.stem}.sba", "rosie.asc"):
        path = rosie / "text" / name
        path.write_text(text)
        ((dive,), skipped) = read_dives(path)
        assert skipped == []
        assert dive.number == plain[0].number
        for key in ("t_gps2", "t_gpse", "dr_east", "dr_north", "dac_east", "dac_north"):
            assert getattr(dive, key) == pytest.approx(getattr(plain[0], key), abs=1e-4)
        path.write_text(text[: len(text) // 2])
        assert read_segment(path).of.m_depth.count() > 50
        path.unlink()


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("sensors_per_cycle: ", "sensors_per_cycle: -", "sensors_per_cycle"),
        ("num_label_lines: 3", "num_label_lines: many", "num_label_lines"),
        ("encoding_ver: 2", "encoding_ver: 5", "encoding '5'"),
        ("num_ascii_tags: 14", "num_ascii_tags: 140", "too few lines"),
        ("m_present_time", "m_past_time", "no m_present_time"),
    ],
)
def test_a_text_that_is_none_is_one_sentence(rosie, old, new, said):
    source = rosie / "sbd" / "rosie_713-2019-166-0-157.sbd"
    path = rosie / "one.asc"
    path.write_text(as_text(source, source.stem, "sbd").replace(old, new))
    with pytest.raises(DataError, match=said) as caught:
        read_dives(path)
    assert "\n" not in str(caught.value)


def test_a_dockservers_folder_is_read_as_it_is(rosie):
    plain = read_dives(rosie / "sbd")
    glider = rosie / "default" / "gliders" / "rosie_713"
    for name in ("to-glider", "logs", "configuration"):
        (glider / name).mkdir(parents=True)
        (glider / name / "x.log").write_text("x")
    (rosie / "sbd").rename(glider / "from-glider")
    (glider / "from-glider" / "rosie_713-2019-166-0-157.tbd").write_bytes(b"dbd_label: x")
    (rosie / "cac").rename(rosie / "default" / "cache")
    dives, skipped = read_dives(glider)
    assert (dives, skipped) == plain


def test_dives_of_one_file_are_told_apart(rosie):
    texts = [
        as_text(rosie / "sbd" / f"rosie_713-2019-166-0-{k}.sbd", "rosie", "sbd") for k in (157, 159)
    ]
    path = rosie / "both.asc"
    path.write_text(texts[0] + "".join(texts[1].splitlines(keepends=True)[17:]))
    dives, _ = read_dives(path)
    assert len(dives) == 2
    assert [dive.notes[0] for dive in dives] == [f"dive {k} of 2 in both.asc" for k in (1, 2)]
