"""Damaged inputs of every command, made from valid files, and what each is answered.

`python tests/damaged_inputs.py FIRST COUNT` prints a line of JSON for each case.  Case k is the
same everywhere: a use (a command with its files), one of its files or options, and a damage.  A
case is a process of its own, forked where all is imported, with limits of time and memory, so
that a crash or a hang of a library is an answer too.
"""

import gc
import gzip
import io
import json
import os
import re
import resource
import shutil
import signal
import sys
import tempfile
import traceback
from contextlib import chdir, redirect_stderr, redirect_stdout, suppress
from pathlib import Path

import numpy as np
import xarray

HERE = Path(__file__).parent
DATA = HERE / "data"
SECONDS, BYTES = 10, 10**9  # of an answer: time of the processor, and memory
WAIT = 150  # s, after which a command waits for ever
NUMBERS = (
    *("nan", "inf", "-inf", "1e308", "-1e308", "1e-300", "1e15", "-1", "0", "0.5", "1e9"),
    *("99999999999999999999", "9" * 400, "-2147483649", "true", '"word"', "[]", "[[1]]", "{}", ""),
)
VALUES = (np.nan, np.inf, -np.inf, 1e308, -1e308, 1e-300, 1e15, -1.0, 0.0, 9.97e36, 1e9)
OF_NETCDF = (
    "drop rename type value values shape scalar units attribute attributes time dims team equations"
)
WORDS = (
    "",
    "x",
    "null",
    "\u00e9" * 300,
    " " * 4000,
    "9" * 5000,
    "\x1b[31m",
    "a,b",
    "../../x",
    "\t",
)


# --- valid files, and the commands that read them -------------------------------------------------


def make_valid(folder):
    """Write one valid file of each kind that commands read."""
    from made_fields import uniform_field
    from tidal_records import MARACOOS, times, waves

    import clpt_control as clpt
    from clpt_control.gliders import sample_dives, write_dive_table

    short = clpt.paper_scenario().with_values(
        {
            "run.duration": 250,
            "run.output_step": 0.5,
            "reference": {"kind": "waypoints", "dwell": 20, "points": [[3, 0], [0, 3], [1, 1]]},
        }
    )
    clpt.save_scenario(short, folder / "s.toml")
    clpt.save_run(clpt.simulation.run_and_report(short).run, folder / "run.nc")
    team = clpt.Team(members={"a": short, "b": short}, coupling=0.5)
    clpt.save_run(clpt.simulate(team), folder / "team.nc")
    step = clpt.Block(
        "tank",
        update=lambda t, x, u, p: {"h": [p.a @ (u.q[0] - x.h), np.interp(x.h[0], [0, 1], p.a)]},
        inputs={"q": 1},
        states={"h": 2},
        parameters={"a": np.array([0.5, 0.2])},
    )
    clpt.save_run(clpt.simulate(step, np.arange(6.0), 1.0), folder / "diagram.nc")
    (folder / "team.toml").write_text(clpt.load_run(folder / "team.nc").attrs["team"])
    uniform_field(folder / "field.nc", half=40.0, end=500.0)
    text = (folder / "s.toml").read_text()
    theta = text[text.index("parameters", text.index("[flow]")) :].partition("\n")[0]
    (folder / "f.toml").write_text(text.replace(theta, 'field = "field.nc"', 1))
    clpt.run_ensemble(short, "learning.gain=0.2:2", 4, out=folder / "e.zarr", chunk=2, samples=50)
    shutil.copytree(folder / "e.zarr", folder / "begun.zarr")
    (folder / "begun.zarr/done/c/1").unlink()
    write_dive_table(sample_dives()[:4], folder / "dives.csv")
    said = call("replay dives.csv --out watched --json", folder)
    (folder / "replay.json").write_text(said)
    shutil.copy(folder / "watched/replay.nc", folder / "replay.nc")
    when = times(3)
    flow = waves(when)
    rows = (f"{t}Z,{u:.4f},{v:.4f}" for t, u, v in zip(when, *flow, strict=True))
    head = "# latitude: 41.2\n# a comment\ntime,u (m/s),v (m/s)\n"
    (folder / "record.csv").write_text(head + "\n".join(rows) + "\n")
    hours = (when - when[0]) / np.timedelta64(1, "h")
    xarray.Dataset(
        {n: ("time", values, {"units": "m s-1"}) for n, values in zip("uv", flow, strict=True)},
        {"time": ("time", hours, {"units": f"hours since {when[0]}"}), "latitude": 41.2},
    ).to_netcdf(folder / "record.nc")
    shutil.copy(MARACOOS, folder / "grid.nc")
    _forecast(folder / "model.nc")
    call("fit model.nc --rows 2 --columns 2 --width-km 60 --out fit.toml", folder)
    for name in ("basestation", "sg171", "og1", "sea035", "slocum_rosie"):
        shutil.copytree(DATA / "glider" / name, folder / name)
    for path in sorted((folder / "slocum_rosie/sbd").iterdir())[3:]:
        path.unlink()
    packed = gzip.compress((folder / "sea035/SEA035.10.gli.sub.003").read_bytes())
    (folder / "sea035/SEA035.10.gli.sub.004.gz").write_bytes(packed)
    (folder / "in").mkdir()
    shutil.copy(folder / "dives.csv", folder / "in/dives.csv")
    call("replay --follow in --every 0.1 --patience 0.1", folder)


def _forecast(path):
    """Write a current where the dives of the sample are."""
    lat, lon, hours = np.linspace(-44, -42, 4), np.linspace(7, 9.5, 5), np.arange(0.0, 60.0)
    wave = 0.1 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((60, 4, 5))
    dims, units = ("time", "lat", "lon"), {"units": "m s-1"}
    axes = {
        "time": ("time", hours, {"units": "hours since 2016-01-31"}),
        "lat": ("lat", lat, {"units": "degrees_north"}),
        "lon": ("lon", lon, {"units": "degrees_east"}),
    }
    u, v = wave + 0.05 * lat[:, None] / 43, 0.02 * wave + 0.01 * lon / 8
    xarray.Dataset({"u": (dims, u, units), "v": (dims, v, units)}, axes).to_netcdf(path)


RUNS = ("run", "ensemble", "tune", "design", "certify", "excitation s", "excitation t")
VARY = "--members 4 --vary learning.gain=0.2:2 --samples 50 --chunk 2 --threads 1"
FILM = "--seconds 0.2 --fps 5 --width 200"
USES = (  # words, the file to damage (a part of what is copied), all that is copied, how often
    ("run s.toml --out out.nc", "s.toml", "s.toml", 3),
    ("run s.toml --out out.nc --json", "s.toml", "s.toml", 2),
    ("run f.toml --out out.nc --json", "field.nc", "f.toml field.nc", 2),
    ("run f.toml --out out.nc", "f.toml", "f.toml field.nc", 1),
    ("run run.nc --out out.nc --json", "run.nc", "run.nc", 2),
    ("run team.toml --out out.nc", "team.toml", "team.toml", 1),
    ("diagram s.toml", "s.toml", "s.toml", 1),
    ("excitation s.toml --json", "s.toml", "s.toml", 1),
    ("excitation run.nc --json", "run.nc", "run.nc", 4),
    ("excitation team.nc --json", "team.nc", "team.nc", 2),
    ("estimate run.nc --out out.toml --json", "run.nc", "run.nc", 4),
    ("estimate run.nc --method kalman --json", "run.nc", "run.nc", 1),
    ("animate run.nc -o out.gif " + FILM, "run.nc", "run.nc", 3),
    ("report run.nc -o out.html --json", "run.nc", "run.nc", 5),
    ("report team.nc -o out.html --json", "team.nc", "team.nc", 2),
    ("report diagram.nc -o out.html --json", "diagram.nc", "diagram.nc", 3),
    ("run diagram.nc --out out.nc --json", "diagram.nc", "diagram.nc", 4),
    ("report e.zarr -o out.html --json", "e.zarr", "e.zarr", 6),
    ("report replay.nc -o out.html --json", "replay.nc", "replay.nc", 4),
    ("report replay.json -o out.html --json", "replay.json", "replay.json", 4),
    ("ensemble s.toml --out out.zarr --json " + VARY, "s.toml", "s.toml", 1),
    ("ensemble s.toml --out begun.zarr --json " + VARY, "begun.zarr", "s.toml begun.zarr", 5),
    ("certify s.toml --json", "s.toml", "s.toml", 1),
    ("fit grid.nc --rows 2 --columns 2 --out out.toml --json", "grid.nc", "grid.nc", 3),
    ("tides record.nc --constituents M2,K1 --json", "record.nc", "record.nc", 4),
    ("tides record.csv --constituents M2,K1 --json", "record.csv", "record.csv", 4),
    ("replay dives.csv --out out --json", "dives.csv", "dives.csv", 1),
    ("replay dives.csv --json", "dives.csv", "dives.csv", 2),
    ("replay basestation --json", "basestation/p5420306.nc", "basestation", 3),
    ("replay basestation/p5420306.nc --json", "basestation/p5420306.nc", "basestation", 2),
    ("replay sg171 --json", "sg171/p1710101.nc", "sg171", 1),
    ("replay og1/sg015_20040929T140907_delayed.nc --json", "og1/sg015*", "og1", 2),
    ("replay og1/sp028_20230202T1637_R.nc --json", "og1/sp028*", "og1", 2),
    ("replay sea035 --least-duration 60 --json", "sea035/SEA035.10.gli.sub.002", "sea035", 2),
    ("replay sea035 --least-duration 60 --json", "sea035/SEA035.10.gli.sub.004.gz", "sea035", 1),
    ("replay slocum_rosie/sbd --json", "slocum_rosie/sbd/*157.sbd", "slocum_rosie", 2),
    ("replay slocum_rosie/sbd --json", "slocum_rosie/cac/6b016a2e.cac", "slocum_rosie", 3),
    ("replay dives.csv --flow-model model.nc --json", "model.nc", "dives.csv model.nc", 2),
    (
        "replay dives.csv --flow-model fit.toml --json",
        "fit.toml",
        "dives.csv fit.toml fit_field.nc",
        1,
    ),
    ("replay --follow in --every 0.1 --patience 0.1", "in/replay/state/dives.csv.json", "in", 3),
    ("replay --follow in --every 0.1 --patience 0.1", "in/dives.csv", "in", 1),
)
OPTIONS = (  # words, options whose values are damaged
    ("run s.toml --out out.nc", "s.toml", ("--format", "--figures")),
    ("excitation s.toml", "s.toml", ("--window", "--start")),
    ("excitation run.nc", "run.nc", ("--window", "--start")),
    ("certify s.toml", "s.toml", ("--radius", "--error", "--window")),
    (
        "design s.toml --out out.toml --generations 1",
        "s.toml",
        (
            *("--length", "--max-speed", "--count", "--dwell", "--window", "--start", "--level"),
            *("--seed", "--generations"),
        ),
    ),
    (
        "ensemble s.toml --members 3 --vary learning.gain=0.2:2 --samples 50 --out out.zarr",
        "s.toml",
        ("--members", "--vary", "--seed", "--threads", "--chunk", "--samples", "--design"),
    ),
    ("tune s.toml --members 2 --law learned-flow", "s.toml", ("--members", "--prior", "--seed")),
    ("fit grid.nc --out out.toml", "grid.nc", ("--rows", "--columns", "--width-km", "--units")),
    ("tides record.csv --constituents M2", "record.csv", ("--constituents", "--latitude")),
    ("estimate run.nc", "run.nc", ("--every", "--prior", "--noise", "--until")),
    (
        "replay dives.csv --aim 41 -69",
        "dives.csv",
        ("--speed", "--hours", "--least-duration", "--variation", "--width-km", "--flow"),
    ),
    ("animate run.nc -o out.gif " + FILM, "run.nc", ("--start", "--end", "--seconds", "--width")),
)


# --- damages --------------------------------------------------------------------------------------


def as_no_file(rng, path):
    """Put something else in its place, or nothing."""
    kind = str(rng.choice(["fifo", "device", "folder", "gone", "loop", "dangling", "socketless"]))
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink()
    if kind == "fifo":
        os.mkfifo(path)
    elif kind == "device":
        path.symlink_to(rng.choice(["/dev/zero", "/dev/null", "/dev/tty"]))
    elif kind == "folder":
        path.mkdir()
    elif kind == "loop":
        path.symlink_to(path.name)
    elif kind == "dangling":
        path.symlink_to("nowhere")
    return kind


def bytes_changed(rng, path):
    """Cut, flip, zero, insert or repeat bytes."""
    raw = bytearray(path.read_bytes())
    kind = str(rng.choice(["cut", "flip one", "flip many", "zeros", "insert", "repeat", "empty"]))
    at = int(rng.integers(0, len(raw) + 1)) if rng.random() < 0.6 else int(rng.integers(0, 200))
    at = min(at, len(raw))
    if kind == "cut":
        del raw[at:]
    elif kind.startswith("flip") and raw:
        for _ in range(1 if kind == "flip one" else 30):
            raw[min(int(rng.integers(0, len(raw))), len(raw) - 1)] ^= 1 << int(rng.integers(8))
    elif kind == "zeros":
        raw[at : at + 200] = bytes(len(raw[at : at + 200]))
    elif kind == "insert":
        raw[at:at] = rng.bytes(int(rng.integers(1, 50)))
    elif kind == "repeat":
        raw[at:at] = raw[at : at + 3000]
    elif kind == "empty":
        raw.clear()
    path.write_bytes(raw)
    return f"{kind} at {at}"


def text_changed(rng, path):
    """Change numbers, words, lines or the encoding of a text."""
    text = path.read_text("utf-8", "replace")
    kind = str(
        rng.choice(["number", "number", "number", "word", "line", "long", "encoding", "spaces"])
    )
    if kind == "number" and (found := list(re.finditer(r"-?\d+(\.\d+)?(e[-+]?\d+)?", text))):
        one, value = found[rng.integers(len(found))], str(rng.choice(NUMBERS))
        text = text[: one.start()] + value + text[one.end() :]
        kind = f"{one[0]} at {one.start()} is {value[:20]}"
    elif kind == "word" and (found := list(re.finditer(r"[A-Za-z_]+", text))):
        one, value = found[rng.integers(len(found))], str(rng.choice(WORDS))
        text = text[: one.start()] + value + text[one.end() :]
        kind = f"{one[0]} at {one.start()} is {value[:20]!r}"
    elif kind == "line":
        lines = text.splitlines(True) or [""]
        k, j = rng.integers(len(lines), size=2)
        how = int(rng.integers(3))
        if how == 0:
            del lines[k]
        elif how == 1:
            lines.insert(k, lines[j])
        else:
            lines[k], lines[j] = lines[j], lines[k]
        text, kind = "".join(lines), f"line {k}, {j}, {how}"
    elif kind in ("long", "spaces"):
        lines = text.splitlines(True) or [""]
        k = 0 if rng.random() < 0.5 else int(rng.integers(len(lines)))
        more = str(rng.choice(["#" + "x" * 10**5, " " * 10**5, "# " + "a = " * 30000, "(" * 5000]))
        more = "\t" * 4000 if kind == "spaces" else more
        at = int(rng.integers(0, len(lines[k]) + 1))
        lines[k] = lines[k][:at] + more + lines[k][at:]
        text, kind = "".join(lines), f"{kind} in line {k}: {more[:4]}"
    elif kind == "encoding":
        name = str(rng.choice(["utf-16", "utf-32", "utf-8-sig", "cp037"]))
        path.write_bytes(text.encode(name, "replace"))
        return f"encoding {name}"
    path.write_text(text, "utf-8")
    return kind


def netcdf_changed(rng, path):
    """Change shapes, types, numbers, names or attributes of a NetCDF file."""
    with xarray.open_dataset(path, decode_cf=False, engine="netcdf4") as found:
        data = found.load()
    names = list(data.variables)
    name = str(names[rng.integers(len(names))])
    one = data[name]
    kind = str(rng.choice(OF_NETCDF.split()))
    said = f"{kind} of {name}"
    plain = xarray.Variable(one.dims, one.values, one.attrs)
    if kind == "drop":
        data = data.drop_vars(name)
    elif kind == "rename":
        data = data.rename({name: f"{name}_"})
    elif kind == "type":
        made = rng.choice(["i1", "S1", "U3", "f4", "i8", "u1"])
        with np.errstate(all="ignore"), suppress(ValueError, TypeError):
            plain.values = plain.values.astype(made)
        data = data.drop_vars(name).assign({name: plain})
    elif kind in ("value", "values", "time"):
        if kind == "time":
            times = [n for n in names if "time" in str(n).lower()] or names
            name = str(times[rng.integers(len(times))])
            plain = data[name].variable.to_base_variable()
        values = np.array(plain.values)
        if values.dtype.kind in "iuf" and values.size:
            value = rng.choice(VALUES)
            if values.dtype.kind != "f" and rng.random() < 0.7:
                values = values.astype(float)
            with np.errstate(all="ignore"), suppress(OverflowError, ValueError):
                if kind == "time" and rng.random() < 0.5:
                    values = values + values.dtype.type(1e15)
                elif kind == "values":
                    values[...] = value
                else:
                    values.ravel()[rng.integers(values.size)] = value
            said += f" {value}"
        plain = xarray.Variable(plain.dims, values, plain.attrs)
        data = data.drop_vars(name).assign({name: plain})
    elif kind == "shape" and one.dims:
        dim = one.dims[rng.integers(one.ndim)]
        k = int(rng.integers(0, 3))
        data = data.isel({dim: slice(0, k)})
        said += f": {dim} of {k}"
    elif kind == "scalar":
        with suppress(ValueError):
            data = data.drop_vars(name).assign({name: ((), np.resize(plain.values, 1)[0])})
    elif kind == "dims" and one.dims:
        changed = [f"{dim}_" if rng.random() < 0.5 else dim for dim in one.dims]
        changed = changed[::-1] if rng.random() < 0.5 else changed
        values = plain.values.T if changed[::-1] == list(one.dims) else plain.values
        with suppress(ValueError):
            data = data.drop_vars(name).assign({name: (changed, values, one.attrs)})
    elif kind == "units":
        data[name].attrs["units"] = str(rng.choice(WORDS))
    elif kind in ("attribute", "team"):
        known = list(data.attrs) or ["title"]
        key = "team" if kind == "team" else str(known[rng.integers(len(known))])
        value = [str(rng.choice(WORDS)), 3.5, np.array([1, 2]), -1][rng.integers(4)]
        if isinstance(data.attrs.get(key), str) and rng.random() < 0.4:
            value = data.attrs[key].replace("0", "9" * 30, 1)
        if key == "team" and rng.random() < 0.5:
            value = data.attrs.get("scenario", "")
        data.attrs[key] = value
        said = f"attribute {key} is {str(value)[:30]!r}"
    elif kind == "attributes":
        data.attrs = {}
    elif kind == "equations" and kind in data.attrs:
        plain = json.loads(data.attrs[kind])
        said = f"equations: {json_changed(rng, plain)}"
        data.attrs[kind] = json.dumps(plain)
    return said if _rewritten(data, path) else "of other variables"


def _rewritten(data, path):
    path.unlink()
    written = {n: {"_FillValue": None} for n in data.variables if "_FillValue" not in data[n].attrs}
    try:
        data.to_netcdf(path, engine="netcdf4", encoding=written)
        return True
    except Exception:  # what NetCDF cannot hold
        path.unlink(missing_ok=True)
        xarray.Dataset({"a": ("n", np.zeros(3))}).to_netcdf(path)
        return False


def zarr_changed(rng, path):
    """Change one file of a folder, or what its JSON says, or put an array of another beside."""
    files = sorted(file for file in path.rglob("*") if file.is_file())
    listed = [file for file in files if file.name == "zarr.json"]
    kind = str(rng.choice(["no file", "bytes", "json", "json", "json", "foreign", "moved", "gone"]))
    one = files[rng.integers(len(files))]
    where = one.relative_to(path)
    if kind == "no file":
        return f"{where}: {as_no_file(rng, one)}"
    if kind == "bytes":
        return f"{where}: {bytes_changed(rng, one)}"
    if kind == "foreign":
        import zarr

        shape = [(3,), (4, 7), (), (0,), (2, 2, 2, 2)][rng.integers(5)]
        dims = [f"d{k}" if rng.random() < 0.5 else "member" for k in range(len(shape))]
        group = zarr.open_group(path, mode="r+")
        group.create_array("foreign", shape=shape, dtype="f8", dimension_names=dims)
        return f"foreign {shape} {dims}"
    if kind == "moved":
        shutil.rmtree(one.parent)
        if len(where.parts) == 1:
            path.mkdir()
        return f"{where.parent} is gone"
    if kind == "gone":
        one.unlink()
        return f"{where} is gone"
    one = listed[rng.integers(len(listed))]
    made = json.loads(one.read_text())
    said = json_changed(rng, made)
    one.write_text(json.dumps(made))
    return f"{one.relative_to(path)}: {said}"


def json_changed(rng, made):
    """Change one place of what JSON says."""
    at, key = made, None
    while isinstance(at, dict | list) and at and (key is None or rng.random() < 0.8):
        inner, key = (
            at,
            [*at][rng.integers(len(at))] if isinstance(at, dict) else int(rng.integers(len(at))),
        )
        at = inner[key]
    values = (None, 0, -1, 10**9, 10**30, 1.5, "", "x", [], {}, [1], True, "NaN", "9" * 400)
    value = values[rng.integers(len(values))]
    if isinstance(at, str) and at.startswith("{") and rng.random() < 0.9:
        inside = json.loads(at)
        name = [*inside][rng.integers(len(inside))]
        inside[name] = value
        value, key = json.dumps(inside), f"{key}.{name}"
        inner[key.split(".")[0]] = value
    elif rng.random() < 0.2:
        del inner[key]
        value = "gone"
    else:
        inner[key] = value
    return f"{key} is {str(value)[-30:]}"


def damaged(rng, path):
    """Damage a file or a folder; return in words how."""
    if path.is_dir():
        return as_no_file(rng, path) if rng.random() < 0.05 else zarr_changed(rng, path)
    chance = rng.random()
    if chance < 0.06:
        return as_no_file(rng, path)
    if chance < 0.3 or path.suffix == ".gz":
        return bytes_changed(rng, path)
    if path.suffix == ".nc":
        return netcdf_changed(rng, path)
    return text_changed(rng, path)


# --- cases and answers ----------------------------------------------------------------------------


def case(k, valid, folder):
    """Make case k in a folder; return its words and what is damaged."""
    rng = np.random.default_rng([7, k])
    if rng.random() < 0.12:
        words, file, options = OPTIONS[rng.integers(len(OPTIONS))]
        shutil.copy(valid / file, folder / file)
        name, value = str(rng.choice(options)), str(rng.choice(NUMBERS))
        return f"{words} {name}={value}", f"{name}={value[:30]}"
    weights = np.array([use[3] for use in USES], float)
    words, target, copied, _ = USES[rng.choice(len(USES), p=weights / weights.sum())]
    put(valid, folder, copied)
    path = next(iter(sorted(folder.glob(target))))
    return words, f"{path.relative_to(folder)}: {damaged(rng, path)}"


def put(valid, folder, copied):
    """Copy valid files and folders."""
    for name in copied.split():
        source = valid / name
        if source.is_dir():
            shutil.copytree(source, folder / name)
        else:
            shutil.copy(source, folder / name)
    for state in folder.rglob("state/*.json"):  # names the folder that is watched
        state.write_text(state.read_text().replace(str(valid), str(folder)))


def call(words, folder):
    """Run a command here, which must do its work; return what it prints."""
    from clpt_control.cli import application

    said = io.StringIO()
    with redirect_stdout(said), redirect_stderr(io.StringIO()), chdir(folder):
        assert not application()(args=words.split(), standalone_mode=False), words
    return said.getvalue()


def held(folder):
    """Return what lies in a folder, without what says that somebody works there."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.name != ".clpt-lock":
            plain = path.is_file() and not path.is_symlink()
            found[str(path)] = hash(path.read_bytes()) if plain else None
    return found


def answer(folder, words):
    """Run a command in a process of its own; return status, outputs, time and memory."""
    out, err = folder.parent / "out.txt", folder.parent / "err.txt"
    child = os.fork()
    if child == 0:
        _run(folder, words, out, err)
    _, status, used = os.wait4(child, 0)
    return {
        "status": os.waitstatus_to_exitcode(status),
        "out": out.read_text("utf-8", "replace"),
        "err": err.read_text("utf-8", "replace"),
        "seconds": used.ru_utime + used.ru_stime,
        "bytes": 1024 * used.ru_maxrss,
    }


def _run(folder, words, out, err):
    status = 70
    try:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(WAIT)
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
        resource.setrlimit(resource.RLIMIT_FSIZE, (BYTES, BYTES))
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        most = pages * resource.getpagesize() + 3 * BYTES // 2
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        os.chdir(folder)
        for place, number in ((out, 1), (err, 2)):
            os.dup2(os.open(place, os.O_CREAT | os.O_TRUNC | os.O_WRONLY), number)
        sys.stdout, sys.stderr = (os.fdopen(number, "w", closefd=False) for number in (1, 2))
        sys.argv = ["clpt", *words.split(" ")]
        from clpt_control import progress
        from clpt_control.cli import main

        progress.PATIENCE = float("inf")  # no lines that only a slow machine shows
        try:
            main()
        except SystemExit as ended:
            status = ended.code or 0
        sys.stdout.flush()
        sys.stderr.flush()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def fault(words, found, before, after):
    """Return what is wrong with an answer, or ''."""
    status, err = found["status"], found["err"]
    lines = err.splitlines()
    if status < 0:
        return f"ended by signal {-status}"
    if status not in (0, 1, 2):
        return f"status {status}"
    if "fault in clpt" in err or "Traceback" in err:
        return "a fault"
    if found["seconds"] > SECONDS or found["bytes"] > BYTES:
        return "too long or too large"
    if status == 0:
        if "--json" in words:
            try:
                json.loads(found["out"], parse_constant=lambda name: 1 / 0)
            except (ValueError, ZeroDivisionError):
                return "its output is no JSON"
        return ""
    said = [line for line in lines if line.startswith("clpt: ")]
    if len(said) != 1 or lines[-1] != said[0]:
        return "not one sentence"
    if status == 1 and not words.startswith(RUNS):
        return "status 1"
    if found["out"]:
        return "output beside an error"
    return "" if before == after else "something was written"


def draw_nothing():
    """Let figures be made and not drawn, which takes most of the time."""
    from matplotlib.figure import Figure

    from clpt_control import figures  # before pages take it

    figures.inline_svg = lambda *_: ""
    Figure.savefig = lambda self, file, **_: Path(file).write_bytes(b"drawn")


def main(first, count, drawn=1):
    """Print the answers of some cases."""
    sys.path.insert(0, str(HERE))
    if not drawn:
        draw_nothing()
    with tempfile.TemporaryDirectory() as base:
        valid = Path(base, "valid")
        valid.mkdir()
        import matplotlib.pyplot  # noqa: F401
        import typer
        from PIL import Image  # noqa: F401

        from clpt_control import cli

        made = typer.main.get_command(cli.application())
        cli.application = lambda: made
        make_valid(valid)
        kinds = {use[0].split()[0]: use for use in USES}
        for words, _, copied, _ in kinds.values():  # now most is imported and compiled
            folder = Path(base, "warm")
            folder.mkdir()
            put(valid, folder, copied)
            call(words, folder)
            shutil.rmtree(folder)
        gc.collect()
        gc.freeze()  # so that a fork copies less
        for k in range(first, first + count):
            folder = Path(base, "case", "work")
            folder.mkdir(parents=True)
            words, how = case(k, valid, folder)
            before = held(folder)
            found = answer(folder, words)
            wrong = fault(words, found, before, held(folder))
            found |= {"case": k, "words": words[:200], "how": how, "wrong": wrong}
            found |= {"out": found["out"][-300:], "err": found["err"][-500:]}
            print(json.dumps(found), flush=True)
            shutil.rmtree(folder.parent)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
