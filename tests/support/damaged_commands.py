"""Valid files of each kind, and the commands that read them.

A use is a command's words, of which the first that names a valid file is damaged; after `|` stands
what is damaged in its place.
"""

import gzip
import io
import shutil
from contextlib import chdir, redirect_stderr, redirect_stdout

import numpy as np
from paths import DATA

from clpt_control.simulation.summary import run_and_report

SAMPLE = "2016-01-31"  # the day of the sample's dives
RUNS = ("run", "ensemble", "tune", "excitation s", "excitation t")
VARY = "--members 4 --vary learning.gain=0.2:2 --chunk 2 --threads 1"
FILM = "--seconds 0.2 --fps 5 --width 200"
WATCH = "watch in --every 0.1 --patience 0.1"
USES = (
    "run s.toml --out out.nc",
    "run f.toml --out out.nc",
    "run f.toml --out out.nc --json | field.nc",
    "run run.nc --out out.nc --json",
    "run diagram.nc --out out.nc --json",
    "run team.toml --out out.nc",
    "export s.toml --drawing",
    "excitation s.toml --json",
    "excitation run.nc --json",
    "excitation team.nc --json",
    "estimate run.nc --out out.toml --json",
    "estimate run.nc --method kalman --json",
    f"report run.nc --film -o out.gif {FILM}",
    "report run.nc -o out.html --json",
    "report team.nc -o out.html --json",
    "report diagram.nc -o out.html --json",
    "report e.zarr -o out.html --json",
    "report replay.nc -o out.html --json",
    f"ensemble s.toml --out out.zarr --json {VARY}",
    f"ensemble s.toml --out begun.zarr --json {VARY} | begun.zarr",
    "excitation s.toml --bounds --json",
    "verify s.toml --always t<9 --until 0.01 --json",
    "fit grid.nc --rows 2 --columns 2 --out out.toml --json",
    "replay dives.csv --out out --json",
    "replay dives.csv --flow-model model.nc --json | model.nc",
    "replay dives.csv --flow-model fit.toml --json | fit.toml",
    "replay basestation --json | basestation/p5420306.nc",
    "replay basestation/p5420306.nc --json | basestation/p5420306.nc",
    "replay sg171 --json | sg171/p1710101.nc",
    "replay og1/sg015_20040929T140907_delayed.nc --json | og1/sg015*",
    "replay og1/sp028_20230202T1637_R.nc --json | og1/sp028*",
    "replay sea035 --least-duration 60 --json | sea035/SEA035.10.gli.sub.002",
    "replay sea035 --least-duration 60 --json | sea035/SEA035.10.gli.sub.004.gz",
    "replay slocum_rosie/sbd --json | slocum_rosie/sbd/*157.sbd",
    "replay slocum_rosie/sbd --json | slocum_rosie/cac/6b016a2e.cac",
    f"{WATCH} | in/dives.csv",
)
# what a file names is copied, too
BESIDE = {"f.toml": "field.nc", "fit.toml": "fit_field.nc"}
OPTIONS = (  # words, options whose values are damaged
    ("run s.toml --out out.nc", "--format --figures"),
    ("excitation s.toml", "--window --start"),
    ("excitation run.nc", "--window --start"),
    ("excitation s.toml --bounds", "--radius --error --window"),
    (
        "tune s.toml --waypoints --out out.toml",
        "--length --max-speed --window --start --seed",
    ),
    (
        "ensemble s.toml --members 3 --vary learning.gain=0.2:2 --out out.zarr",
        "--members --vary --seed --threads --chunk --design",
    ),
    ("tune s.toml --members 2 --law learned-flow", "--members --prior --seed"),
    (
        "fit grid.nc --out out.toml",
        "--rows --columns --width-km --units --constituents --depth",
    ),
    ("estimate run.nc", "--every --prior --noise --until"),
    (
        "replay dives.csv --aim 41 -69",
        "--speed --hours --least-duration --variation --flow",
    ),
    (f"report run.nc --film -o out.gif {FILM}", "--start --end --seconds --width"),
)


def make_valid(folder):
    """Write one valid file of each kind that commands read."""
    from gridded_currents import gridded_current, uniform_field

    import clpt_control as clpt
    from clpt_control.gliders import sample_dives, write_dive_table

    way = {"kind": "waypoints", "dwell": 20, "points": [[3, 0], [0, 3], [1, 1]]}
    values = {"run.duration": 250, "run.output_step": 0.5, "reference": way}
    short = clpt.paper_scenario().with_values(values)
    clpt.save_scenario(short, folder / "s.toml")
    clpt.save_run(run_and_report(short).run, folder / "run.nc")
    team = clpt.Team(members={"a": short, "b": short}, coupling=0.5)
    clpt.save_run(clpt.simulate(team), folder / "team.nc")
    (folder / "team.toml").write_text(clpt.load_run(folder / "team.nc").attrs["team"])
    tank = clpt.Block(
        "tank",
        update=lambda t, x, u, p: {
            "h": [p.a @ (u.q[0] - x.h), np.interp(x.h[0], [0, 1], p.a)]
        },
        inputs={"q": 1},
        states={"h": 2},
        parameters={"a": np.array([0.5, 0.2])},
    )
    clpt.save_run(clpt.simulate(tank, np.arange(6.0), 1.0), folder / "diagram.nc")
    uniform_field(folder / "field.nc", half=40.0, end=500.0)
    flow = {"flow.parameters": None, "flow.field": str(folder / "field.nc")}
    clpt.save_scenario(short.with_values(flow), folder / "f.toml")
    clpt.run_ensemble(short, "learning.gain=0.2:2", 4, out=folder / "e.zarr", chunk=2)
    shutil.copytree(folder / "e.zarr", folder / "begun.zarr")
    (folder / "begun.zarr/done/c/1").unlink()
    shutil.copy(clpt.currents.sample_currents(), folder / "grid.nc")
    lat, lon, hours = (
        np.linspace(-44, -42, 4),
        np.linspace(7, 9.5, 5),
        np.arange(0.0, 60.0),
    )
    wave = 0.1 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((60, 4, 5))
    model = gridded_current(
        wave + 0.05 * lat[:, None] / 43, wave, lat, lon, hours, since=SAMPLE
    )
    model.to_netcdf(folder / "model.nc")
    call("fit model.nc --rows 2 --columns 2 --width-km 60 --out fit.toml", folder)
    for source in (DATA / "glider").iterdir():
        if source.is_dir():
            shutil.copytree(source, folder / source.name)
    for path in sorted((folder / "slocum_rosie/sbd").iterdir())[3:]:
        path.unlink()
    packed = gzip.compress((folder / "sea035/SEA035.10.gli.sub.003").read_bytes())
    (folder / "sea035/SEA035.10.gli.sub.004.gz").write_bytes(packed)
    (folder / "in").mkdir()
    for name in ("dives.csv", "in/dives.csv"):
        write_dive_table(sample_dives()[:4], folder / name)
    said = call("replay dives.csv --out watched --json", folder)
    (folder / "replay.json").write_text(said)
    shutil.copy(folder / "watched/replay.nc", folder / "replay.nc")
    call("watch in --every 0.1 --patience 0.1", folder)


def put(valid, folder, words):
    """Copy the valid files and folders that words name; return the first."""
    named = [
        name
        for word in words.split()
        if (valid / (name := word.split("/")[0])).exists()
    ]
    for name in (*named, *(BESIDE[name] for name in named if name in BESIDE)):
        source = valid / name
        (shutil.copytree if source.is_dir() else shutil.copy)(source, folder / name)
    return named[0]


def call(words, folder):
    """Run a command here, which must do its work; return what it prints."""
    from clpt_control.app.cli import application

    said = io.StringIO()
    with redirect_stdout(said), redirect_stderr(io.StringIO()), chdir(folder):
        assert not application()(args=words.split(), standalone_mode=False), words
    return said.getvalue()
