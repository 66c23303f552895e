"""The command line: figures within 1e-6 of independent numbers, and what it leaves."""

import json
import os
import re
import shlex
import shutil
import sys
import unicodedata
import zipfile
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray
from command_outputs import COMMANDS, FOLLOW, seldom, write, write_each
from paths import ROOT, TESTS
from responses import states_of
from subprocesses import (
    CLPT,
    CODE,
    await_line,
    interrupt,
    ran,
    started,
    without_progress,
)

import clpt_control

HERE = TESTS
HEARD = CODE.replace(
    "; main()", "; import clpt_control.base.progress as p; p.PATIENCE = 0.0; main()"
)
NAMES = sorted(path.stem for path in (HERE / "reference").glob("*.toml"))


def assert_matches(found, run, numbers):
    for key in ("clpe_rms_per_cycle", "max_flow_parameter_error", "max_gain_error"):
        if key in numbers:
            # the reference takes plain means of samples, which differ from means over time
            off = 2e-6 if key.startswith("clpe_rms") else 1e-6
            assert found[key] == pytest.approx(numbers[key], abs=off), key
    found = states_of(run.sel(time=[float(t) for t in numbers["states"]]))
    np.testing.assert_allclose(found, [*numbers["states"].values()], rtol=0, atol=1e-6)


def test_paper_matches_the_independent_numbers(printed, reference):
    found = printed("paper", "--out", "out")
    assert_matches(found, clpt_control.load_run("out/run.nc"), reference["paper"])
    verdicts = [claim["verdict"] for claim in found["claims"]]
    assert [one.split()[0] for one in verdicts] == ["holds"] * 3
    assert "not in one cycle" in verdicts[1]
    names = sorted(path.name for path in Path("out").iterdir())
    assert names == [*(f"figure{k}.png" for k in (1, 2, 3, 4)), "run.nc"]


@pytest.mark.parametrize("name", [name for name in NAMES if name != "paper"])
def test_run_matches_the_independent_numbers(printed, reference, name):
    found = printed("run", HERE / "reference" / f"{name}.toml", "--out", "run.nc")
    assert_matches(found, clpt_control.load_run("run.nc"), reference[name])


@pytest.mark.long
def test_init_writes_examples_and_never_over_a_file(clpt, refused_for):
    assert clpt("init").status == 0
    text = Path("paper.toml").read_text()
    assert clpt_control.load_scenario("paper.toml") == clpt_control.paper_scenario()
    keys = [line for line in text.splitlines() if " = " in line or line.startswith("[")]
    assert all("#" in line for line in keys if "title" not in line and line != "[run]")
    refused_for(["already exists"], "init")
    refused_for(["must end in .nc"], "run", "paper.toml", "--out", "paper.toml")
    assert Path("paper.toml").read_text() == text
    assert clpt("init", "--example", "currents").status == 0
    fitted = clpt(
        "fit", "currents.nc", "--rows", "2", "--columns", "2", "--out", "mine.toml"
    )
    assert re.search(
        r"(?s)track radius\W+[\d.]+ km .*residual rms\W+[\d.]+ km h-1 ", fitted.out
    )
    said = "--example current: must be one of paper, team, currents"
    refused_for([said], "init", "--example", "current")


def test_a_run_names_the_direction_that_its_track_hardly_shows(printed):
    """The Gramian of gaussian kernels hardly has the second function."""
    write({"basis.kernel": "gaussian", "run.duration": 400}, "g.toml")
    said = printed("run", "g.toml", "--out", "g.nc")["not_learnable"]
    assert re.search(r"off\. .* direction theta_[12]\[2\] \+1\.00, ", said)
    fall, own = re.search(r"within (\d+) s, the run has (\d+) s", said).groups()
    assert int(fall) > int(own) == 400


def test_a_run_is_exported_as_a_map_of_its_flow(printed, clpt):
    write({"origin": [41.2, -69.5], "run.duration": 40}, "p.toml")
    printed("run", "p.toml", "--out", "p.nc")
    assert clpt("export", "p.nc", "-o", "map.nc").status == 0
    with xarray.open_dataset("map.nc") as flow:
        assert {"u", "v", "true_u", "error"} <= {*flow}
        assert "latitude" in flow.dims


@pytest.mark.long
def test_a_run_and_an_ensemble_are_exported_as_tables(printed, clpt):
    write({"run.duration": 40}, "p.toml")
    printed("run", "p.toml", "--out", "p.nc")
    vary = ("--vary", "learning.gain=[0.5,0.8]")
    printed("ensemble", "p.toml", *vary, "--out", "p.zarr")
    for name, first, rows in (("p.nc", "time (s)", None), ("p.zarr", "member", 2)):
        assert clpt("export", name, "-o", "t.csv").out == "Wrote t.csv\n"
        head, *lines = Path("t.csv").read_text().splitlines()
        assert head.startswith(first + ",")
        if rows is None:
            with xarray.open_dataset(name) as run:
                rows = run.sizes["time"]
        assert len(lines) == rows


@pytest.mark.long
def test_a_loop_is_drawn_and_exported(clpt, refused_for):
    write({}, "p.toml")
    before = Path("p.toml").read_text()
    assert re.match(
        "(?s)flowchart.*learning_controller", clpt("export", "p.toml", "--drawing").out
    )
    refused_for([".svg"], "export", "p.toml", "--drawing", "-o", "p.docx")
    refused_for(["a run's name must end in .nc"], "run", "p.toml", "--out", "r.txt")
    refused_for(
        ["a program or map's name must end in .c, .h, .fmu, .csv, .kml, .geojson"],
        "export",
        "p.toml",
        "-o",
        "p.toml",
    )
    assert Path("p.toml").read_text() == before
    for name, *words in (("p.svg", "--drawing"), ("p.c",), ("p.fmu",)):
        assert clpt("export", "p.toml", *words, "-o", name).out == f"Wrote {name}\n"
    assert "adaptation" in Path("p.svg").read_text()
    assert "void closed_loop_step(" in Path("p.c").read_text()
    words = "export", "p.toml", "--part", "learner", "--single", "-o", "own.c"
    assert clpt(*words).out == "Wrote own.c\n"
    assert "void own_step(float t" in Path("own.c").read_text()
    assert clpt("export", *words[1:], "--watch").out == "Wrote own.c\n"
    assert "own_y_factor_x1," in Path("own.c").read_text()
    refused_for(
        ["watch: is of part='learner'"], "export", "p.toml", "--watch", "-o", "q.c"
    )
    refused_for(
        ["part = 'law': must be 'learner'"],
        "export",
        "p.toml",
        "--part",
        "law",
        "-o",
        "l.c",
    )
    assert "sources/closed_loop.c" in zipfile.ZipFile("p.fmu").namelist()


@pytest.mark.long
def test_interrupt_ends_cleanly():
    write({"run.duration": 2e7, "run.output_step": 1e4})
    with started(
        [sys.executable, "-c", HEARD, "run", "s.toml", "--out", "run.nc"]
    ) as process:
        await_line(process, process.stderr, "running s.toml")  # its progress
        assert interrupt(process) == (
            "",
            "clpt: interrupted; nothing half-written was left\n",
        )
    assert (process.returncode, [*Path().iterdir()]) == (130, [Path("s.toml")])


STREAMS = {  # what a shell does with streams -> status, what is said on standard error
    ">&-": (2, "clpt: standard output: is closed. Give it a file or a terminal\n"),
    ">/dev/full": (
        2,
        "clpt: standard output: no space left. Give it a place with more\n",
    ),
    "2>&-": (0, ""),
    "2>/dev/full": (0, ""),
    "<&-": (0, ""),
    ">&- 2>&- <&-": (2, ""),
    "| head -1": (0, ""),
    "2>&1 >/dev/null | true": (0, ""),  # nobody reads what is told
}
STREAMED = ("--help", "laws", "run", "report", "prove", "replay")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
@pytest.mark.parametrize("stream", STREAMS)
@pytest.mark.parametrize(
    "words", seldom([c for c in COMMANDS if c[0] in STREAMED and c != FOLLOW])
)
def test_streams_that_are_closed_full_or_not_read(words, stream):
    if words != ("--help",):
        write_each(Path(), 40)
    before = {*Path().iterdir()}
    line = f'"$0" -c "$1" {shlex.join(words)} {stream}; exit ${{PIPESTATUS[0]}}'
    status, said = STREAMS[stream]
    done = ran("bash", "-c", line, sys.executable, HEARD, status=status)
    assert without_progress(done.stderr) == said
    new = {*Path().iterdir()} - before
    assert bool(new) == (bool(COMMANDS[words]) and not stream.startswith(">&-"))
    assert all(path.stat().st_size for path in new)


@pytest.mark.skipif(os.name != "posix", reason="limits of a shell")
def test_an_output_at_the_limit_of_its_size_is_named():
    # else Python itself forgets the rest of a write
    buffered = "unset PYTHONUNBUFFERED"
    line = f'ulimit -f 1; {buffered}; "$0" -c "$1" --help > help.txt'
    done = ran("bash", "-c", line, sys.executable, CODE, status=2)
    said = "clpt: standard output: may not become larger; allow more (ulimit -f)\n"
    assert done.stderr == said


WATCHED = """
import sys
asked = ("socket.connect", "socket.bind", "socket.getaddrinfo", "pickle.find_class")
own = ("_operator", "dask.delayed")  # Dask names its operators by pickling them itself
seen = []

def hear(event, given):
    if event in asked and given[0] not in own:
        seen.append(event)

sys.addaudithook(hear)
from clpt_control.app.cli import main
for line in sys.argv[1:]:
    sys.argv = ["clpt", *line.split()]
    try:
        main()
    except SystemExit as ended:
        assert not ended.code, line
    assert not line.startswith("run") or "distributed" not in sys.modules  # to save a run
assert seen == []
import pickle, socket
pickle.loads(pickle.dumps(main))
socket.create_server(("127.0.0.1", 0)).close()
assert seen == ["pickle.find_class", "socket.bind"]  # they are heard
"""


@pytest.mark.long
def test_no_connection_is_opened_and_nothing_is_unpickled():
    write({"run.duration": 20})
    vary = "--members 4 --vary learning.gain=1:2 --out e.zarr"
    lines = ["run s.toml --out r.nc", f"ensemble s.toml {vary}", "report e.zarr"]
    lines += ["replay --sample --json"]
    assert without_progress(ran(sys.executable, "-c", WATCHED, *lines).stderr) == ""


HOSTILE = "\x1b]0;owned\x07\x1b[2J\r\x9b31m\u202e\u2066\x7f\b"


def steers(text):
    """Letters that steer a terminal."""
    return {one for one in text if unicodedata.category(one) in ("Cc", "Cf")} - {
        "\n",
        "\t",
    }


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_nothing_that_is_printed_steers_the_terminal(clpt, refused, monkeypatch):
    seconds = SimpleNamespace(monotonic=count(step=20.0).__next__)  # all work is slow
    monkeypatch.setattr("clpt_control.base.progress.time", seconds)
    title, file, run = f"title {HOSTILE}", f"s {HOSTILE}.toml", f"r {HOSTILE}.nc"
    write({"run.duration": 20, "title": title})
    Path("s.toml").rename(file)
    key = json.dumps(f"key {HOSTILE}")
    Path("k.toml").write_text(
        Path(file).read_text() + f"\n[run.{key}]\n{key} = {key}\n"
    )
    vary = ("--members", "2", "--vary", "learning.gain=1:2", "--out", f"e {HOSTILE}")
    for words in (
        *(
            ("run", file, "--out", run),
            ("excitation", file),
            ("export", file, "--drawing"),
        ),
        ("run", run, "--out", f"{HOSTILE}.nc", "--figures", f"f {HOSTILE}"),
        *(("report", run, "-o", f"p {HOSTILE}.html"), ("ensemble", file, *vary)),
        ("report", f"e {HOSTILE}", "-o", "e.html"),
    ):
        status, *said = clpt(*words)
        assert (status, steers("".join(said))) == (0, set()), words
    for words in (
        *(
            ("run", "k.toml", "--out", run),
            ("run", file, "--out", f"no {HOSTILE}/run.nc"),
        ),
        *(
            (f"run{HOSTILE}",),
            ("laws", HOSTILE),
            ("ensemble", file, *vary, "--seed", "1"),
        ),
        ("ensemble", file, "--members", "2", "--vary", f"{HOSTILE}=1:2", "--out", "e"),
        *(("replay", f"{HOSTILE}.nc"), ("fit", f"{HOSTILE}.nc", "--out", "x.toml")),
    ):
        said = refused(*words)
        assert (steers(said), r"\x1b" in said) == (set(), True), words
    as_json = clpt("run", file, "--out", run, "--json").out
    assert (steers(as_json), json.loads(as_json)["title"]) == (set(), title)


@pytest.mark.processes
def test_without_a_home_and_a_cache_the_work_goes_on(tmp_path):
    """A folder inside a file can be made by nobody."""
    Path("file").write_text("")
    write({"run.duration": 20})
    nowhere = str(tmp_path / "file" / "folder")
    env = {**os.environ, "HOME": nowhere, "CLPT_CONTROL_CACHE": nowhere}
    for name in ("MPLCONFIGDIR", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"):
        env.pop(name, None)
    done = ran(*CLPT, "run", "s.toml", "--out", "r.nc", "--figures", ".", env=env)
    assert re.fullmatch(
        "(.*there is no folder to keep it in.*\n)?", without_progress(done.stderr)
    )
    assert Path("figure1.png").exists()


BROKEN = """
import sys

class Broken:
    def find_spec(self, name, *_):
        if name == "control":
            try:
                raise {}
            except KeyboardInterrupt as error:
                raise ImportError("initialization failed") from error

sys.meta_path.insert(0, Broken())
sys.argv = ["clpt", "laws"]
"""
FAILED_IMPORTS = {  # raised at an import -> status, what is said
    "KeyboardInterrupt": (130, "clpt: interrupted; nothing half-written was left\n"),
    "OSError(24, 'Too many open files', 'a.ttf')": (
        1,
        "clpt: too many files are open at once; allow more (ulimit -n)\n",
    ),
}


@pytest.mark.long
def test_a_backend_that_matplotlib_does_not_have_is_a_mistake():
    done = ran(*CLPT, "laws", status=2, env={**os.environ, "MPLBACKEND": "nonsense"})
    sentence = "clpt: MPLBACKEND = 'nonsense': is not a backend of matplotlib. "
    assert done.stderr == f"{sentence}Unset it, or set it to agg\n"


@pytest.mark.parametrize("error", FAILED_IMPORTS)
def test_a_failed_import_is_one_sentence(error):
    status, said = FAILED_IMPORTS[error]
    code = BROKEN.format(error) + CODE
    assert ran(sys.executable, "-c", code, status=status).stderr == said


def test_brackets_in_tables_are_as_they_are(clpt):
    title = "x[b].csv [/] [bold]1[/bold] :smile:"
    write({"run.duration": 5, "title": title})
    assert title in clpt("run", "s.toml", "--out", "run.nc").out


@pytest.mark.filterwarnings("ignore:overflow")
def test_figures_that_json_cannot_hold_are_said(clpt):
    """The square of the distance is no number of 64 bits."""
    changes = {"run.duration": 5, "vehicle.position": [1e155, 0.0]}
    changes |= {"vehicle.feedback": [1e-3, 1e-3], "learning.adapt_gains": False}
    changes |= {"learning.law": "known-flow", "learning.parameters": None}
    changes |= {"learning.theta_estimate": [[0.0] * 3] * 2}
    scenario = clpt_control.paper_scenario().with_values(changes)
    clpt_control.save_scenario(scenario, "s.toml")
    status, out, err = clpt("run", "s.toml", "--out", "run.nc", "--json")
    said = "clpt: --json: a number is not finite, so JSON cannot represent it."
    assert (status, out, err.startswith(said)) == (1, "", True), err


@pytest.mark.long  # 5 s of CPU: boxes of the loop from its start
def test_verify_judges_all_runs_of_a_scenario(clpt, printed):
    clpt_control.save_scenario(clpt_control.paper_scenario(), "s.toml")
    far = "hypot(e[0], e[1]) < 3"
    found = printed(
        "verify", "s.toml", "--always", far, "--flow", "0.01", "--until", "1"
    )
    assert (found["status"], found["conclusion"]) == ("proved", "holds on every run")
    near = "0.5: hypot(e[0], e[1]) < 0.05"
    status, out, err = clpt("verify", "s.toml", "--by", near, "--until", "1", "--json")
    found = json.loads(out)
    assert (found["status"], found["margin"] < 0.0) == ("refuted", True)
    assert (status, err) == (1, "clpt: the specification is refuted\n")


# --- manners -------------------------------------------------------------------------------------

CALLED = sorted({words[0] for words in COMMANDS} - {"--help"})
TYPES = re.compile(
    r"<|\b(TEXT|FLOAT|INTEGER|PATH|None|inf|float|str|int|list|bool)\b|\.\.\.$"
)


@pytest.mark.parametrize("words", [(), ("--help",), ("-h",)])
def test_the_page_lists_every_command_in_one_line(clpt, words):
    status, out, err = clpt(*words)
    assert (status, err) == (0, "")
    for name in CALLED:
        (line,) = re.findall(rf"^  {name} +[A-Z].*", out, re.M)
        assert line.endswith("."), line  # not cut, not broken
    groups = out.partition("Simulation:\n")[2]
    assert sorted(re.findall(r"^  (\w+) +[A-Z]", groups, re.M)) == CALLED
    assert "  clpt init mine.toml" in out


def test_the_cheat_sheet_has_every_command():
    page = (ROOT / "docs" / "cheatsheet.md").read_text("utf-8")
    assert set(re.findall(r"`clpt (\w+)", page)) == set(CALLED)


@pytest.mark.parametrize("name", ["", *CALLED])
def test_help_is_of_shell_words_80_columns_and_an_example(clpt, name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    text = clpt(*([name] if name else []), "--help").out
    assert max(map(len, text.splitlines())) <= 80
    entries = re.findall(r"^  (?:-|[A-Z])(?:\S| (?! ))*", text, re.M)
    assert entries
    assert [entry for entry in entries if TYPES.search(entry)] == []
    assert not re.search(r"\x1b|\[default: inf\]", text)
    if not name:
        return
    example = (
        text.split("\n  Example:\n")[1].split("\n\n")[0].replace("\\\n", " ").split()
    )
    assert example[:2] == ["clpt", name]
    options = re.findall(r"^  (-\S+?)[ ,]", text, re.M) + re.findall(
        r" (--[\w-]+)", text
    )
    assert {word for word in example if re.match("--?[a-z]", word)} - set(
        options
    ) == set()


def test_the_version_is_that_of_the_package(clpt):
    status, out, _ = clpt("--version")
    first, python, *others = out.splitlines()
    assert (status, first) == (0, f"clpt-control {clpt_control.__version__}")
    assert python.split()[:2] == ["Python", ".".join(map(str, sys.version_info[:3]))]
    assert {"control", "llvmlite"} <= {line.split()[0] for line in others}


MISSPELT = r"""
    rnu -> ; did you mean .*run.*\?
    run x.toml --figure f -> ; did you mean .*--figures.*\?
    --versoin -> ; did you mean .*--version.*\?
    run -> (?i)scenario.*; `clpt run --help` shows what it takes
    run x.toml --out -> --out.*; `clpt run --help` shows what it takes
    nothing-like-it -> nothing-like-it.*; `clpt --help` shows what it takes
    replay --aim 3 -> --aim.*; `clpt replay --help` shows what it takes
    prove sigma --search 20 -> --search; `clpt prove --help` shows what it takes
    estimate - -> FlowEstimator in Python
    run x.toml --out r.nc --format svg -> --format: is of the figures. Give --figures FOLDER
    export run.nc -o x.fmu --single -> --single: is of C, not of x.fmu. Leave it out
"""


@pytest.mark.parametrize("line", MISSPELT.strip().splitlines())
def test_what_is_misspelt_or_lacks_is_said(refused, line):
    words, said = line.split(" -> ")
    assert re.search(rf"{said}\n$", refused(*words.split()))


def test_the_module_is_the_command(clpt):
    done = ran(sys.executable, "-m", "clpt_control", "run", "--help")
    assert done.stdout == clpt("run", "--help").out


# --- completion ----------------------------------------------------------------------------------


IN_BASH = r"""
eval "$(_CLPT_COMPLETE=source_bash clpt)"
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_clpt_completion clpt; printf "%s\n" "${COMPREPLY[@]}"
"""


OFFERED = [(["re"], ["report", "replay"]), (["run", "--fi"], ["--figures"])]
OFFERED += [(["run", "mine"], [])]  # files, by bash itself
OFFERED += [(["prove", "sig"], ["sigma"]), (["tune", "--law", "sig"], ["sigma"])]
OFFERED += [(["ensemble", "none.toml", "--vary", "basis.wi"], ["basis.widths="])]


@pytest.mark.skipif(not shutil.which("bash"), reason="no bash")
@pytest.mark.parametrize(("words", "offered"), OFFERED)
def test_bash_completes(tmp_path, words, offered):
    """By bash's own completion function, of the last word."""
    command = tmp_path / "clpt"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m clpt_control "$@"\n')
    command.chmod(0o755)
    env = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    env["PYTHONPATH"] = str(Path(clpt_control.__file__).parents[1])
    done = ran("bash", "--norc", "-c", IN_BASH, "bash", "clpt", *words, env=env)
    assert (done.stdout.split(), done.stderr) == (offered, "")


def test_each_shell_has_its_script_and_fish_is_told_of_words_or_files(
    clpt, monkeypatch
):
    for shell in ("bash", "zsh", "fish"):
        monkeypatch.setenv("_CLPT_COMPLETE", f"source_{shell}")
        status, out, err = clpt()
        assert (status, err, f"complete_{shell}" in out) == (0, "", True)
    monkeypatch.setenv("_CLPT_COMPLETE", "complete_fish")
    monkeypatch.setenv("_TYPER_COMPLETE_FISH_ACTION", "is-args")
    for words, status in (("clpt r", 0), ("clpt run mine", 1)):
        monkeypatch.setenv("_TYPER_COMPLETE_ARGS", words)
        assert clpt().status == status


COMPLETING = {
    "_CLPT_COMPLETE": "complete_bash",
    "COMP_CWORD": "1",
    "COMP_WORDS": "clpt repl",
}
COMMAND = "sys.argv = {}; os.environ.update({}); from clpt_control.app.cli import main; main()"
LIGHT = {  # code, and what it says
    "the package": ("import clpt_control", ""),
    "help": (COMMAND.format(["clpt", "--help"], {}), "clpt init mine.toml"),
    "completion": (COMMAND.format(["clpt"], COMPLETING), "replay\n"),
}


@pytest.mark.parametrize("name", LIGHT)
def test_nothing_heavy_is_imported_for(name):
    code, said = LIGHT[name]
    heavy = {"control", "numpy", "sympy", "matplotlib", "xarray", "pandas", "scipy"}
    heavy |= {"pydantic"} if name != "completion" else set()  # Typer brings it
    code = f"import os, sys\ntry: {code}\nexcept SystemExit: pass\n"
    code += f"print(sorted({heavy} & set(sys.modules)), file=sys.stderr)"
    done = ran(sys.executable, "-c", code)
    assert (said in done.stdout, done.stderr.strip()) == (True, "[]")
