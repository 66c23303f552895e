"""A Slocum's files in all their forms: compressed, as text, as a dockserver keeps them."""

import shutil
import struct

import numpy as np
import pytest

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, slocum_file
from clpt_control.gliders.dives import files_before
from clpt_control.gliders.slocum_file import read_segment, uncompressed

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


def test_files_that_are_skipped_alike_are_one_line(rosie):
    for path in (rosie / "cac").iterdir():
        path.unlink()
    with pytest.raises(DataError, match=r"11 files: no dive; .*6b016a2e.* \(one of \d+ files\)"):
        read_dives(rosie / "sbd")


def test_dives_of_one_file_are_told_apart(rosie):
    texts = [
        as_text(rosie / "sbd" / f"rosie_713-2019-166-0-{k}.sbd", "rosie", "sbd") for k in (157, 159)
    ]
    path = rosie / "both.asc"
    path.write_text(texts[0] + "".join(texts[1].splitlines(keepends=True)[17:]))
    dives, _ = read_dives(path)
    assert len(dives) == 2
    assert [dive.notes[0] for dive in dives] == [f"dive {k} of 2 in both.asc" for k in (1, 2)]
