"""A page to send: whole, safe, of anything that clpt writes, and one sentence for all else."""

import json
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from xml.etree import ElementTree

import control
import matplotlib
import numpy as np
import pytest
import xarray
from error_sentences import says
from html_parser import fetching_nothing
from synthetic_vehicle import fixes_of

import clpt_control as clpt
from clpt_control import ClptError, DataError, report

EVIL = "</title></style><script>alert(1)</script><img src=x onerror='alert(2)'>\"&amp;"
SECTIONS = [
    "achieved",
    "loop",
    "track",
    "clpe",
    "learning",
    "excitation",
    "scenario",
    "versions",
]
VARY = "learning.gain=0.2:2.0"
SHORT = clpt.paper_scenario().with_values(
    {"run.duration": 40, "title": "Two waypoints"}
)


@pytest.fixture(scope="module")
def run():
    return clpt.simulate(SHORT)


@pytest.fixture
def page_of(tmp_path):
    """Return the HTML of a dataset's report."""

    def written(data):
        clpt.report(data, tmp_path / "page.html")
        return (tmp_path / "page.html").read_text("utf-8")

    return written


@pytest.fixture
def words(page_of, undrawn):
    """Return the texts of a report, without its figures: cells of a row are joined by bars."""
    return lambda data: "|".join(map(str.strip, fetching_nothing(page_of(data)).texts))


def checked(text, *said):
    """A page's elements: nothing fetched, one script, identifiers once, headings in order."""
    read = fetching_nothing(text)
    assert [one for one in said if one not in text] == []
    assert [tag for tag, _ in read.tags].count("script") == 1
    assert text.endswith("</script></body></html>\n")
    assert "http" not in text.replace("http-equiv", "")
    own, named = [names["id"] for _, names in read.tags if "id" in names], []
    assert len(own) == len(set(own))
    for tag, names in read.tags:
        assert tag != "svg" or (names["role"] == "img" and names["aria-label"])
        named += re.findall(r"url\(#(.*?)\)", " ".join(filter(None, names.values())))
        named += filter(None, [names.get("href", "")[1:], names.get("aria-labelledby")])
    assert set(named) <= set(own)
    assert re.fullmatch(
        "h1(h2)+", "".join(re.findall(r"h\d", " ".join(t for t, _ in read.tags)))
    )
    assert dict(read.tags)["html"] == {"lang": "en"}
    return read


@pytest.mark.long
def test_a_run_has_its_page(run, page_of):
    page = page_of(run)
    read = checked(page)
    assert [names["id"] for tag, names in read.tags if tag == "h2"] == SECTIONS
    assert [tag for tag, _ in read.tags].count("svg") >= 7
    assert {"adaptation", "gain (1/s)"} <= set(read.texts)  # of figures
    said = "at 10 waypoints, 20 s at each, for 40 s in a flow of 3 functions; law learn.*gain = 0.8"
    assert re.search(f"(?s){said}", " ".join(read.texts))
    assert len(page) < 1_000_000


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_each_figure_of_a_run_has_words_of_its_own(run, page_of):
    figures = [
        names for tag, names in fetching_nothing(page_of(run)).tags if tag == "svg"
    ]
    captions = [names["aria-label"] for names in figures]
    assert [one for one in captions if one.startswith("The prediction error, ")]
    assert len(captions) == len(set(captions))


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_nothing_of_a_run_is_markup(run, page_of):
    scenario = run.attrs["scenario"].replace("Two waypoints", EVIL.replace('"', '\\"'))
    bad = run.assign_attrs(
        title=EVIL, message=EVIL, status=EVIL, software=EVIL, scenario=scenario
    )
    assert sum(EVIL in text for text in checked(page_of(bad)).texts) >= 4


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_a_number_that_is_none_is_refused(run, page_of):
    for name in ("clpe", "feedback_gain", "flow_parameters_estimate"):
        bad = run.assign({name: run[name].where(run.time < 40)})
        says(
            DataError,
            f"run's {name} contains a number that is not finite",
            page_of,
            bad,
        )
    page_of(run.assign(alpha=run.alpha.where(run.time > 30)))  # not shown


@pytest.mark.long
def test_one_sample_is_said_and_two_of_a_vehicle_at_rest_in_still_water_are_drawn(
    run, page_of
):
    text = page_of(run.isel(time=[-1]))
    checked(text, "one sample: nothing can be drawn over time", "Not measured")
    still = {"kind": "waypoints", "points": [[0, 0]], "dwell": 20}
    calm = SHORT.with_values({"flow.parameters": np.zeros((2, 3)), "reference": still})
    still = clpt.simulate(calm)
    assert float(np.abs(still.position).max()) == 0
    checked(page_of(still.isel(time=[0, -1])))


@pytest.mark.slow
def test_many_samples_stay_small(run, page_of):
    long = run.interp(time=np.linspace(0, 40, 60_001)).assign(
        flow_parameters=run.flow_parameters
    )
    text = page_of(long)
    checked(text, "Drawn from 1 in 11 of 60001 samples")
    assert len(text) < 2_000_000


@pytest.mark.long
def test_what_the_scenario_does_not_hold_is_said(run, words):
    steered = clpt.closed_loop(SHORT, external=("zc",))
    times, start = np.linspace(0, 40, 41), clpt.initial_state(SHORT)
    steps = clpt.simulate(steered, times, inputs=[3, 0], initial_state=start)
    assert "Eigenvalues" not in words(steps)
    for data, said in (
        (steps, "may be others than drawn"),
        (
            run.assign_attrs(own_law="mine"),
            "does not hold: a law given in Python, mine",
        ),
        (
            run.assign_attrs(parameters_changed='{"a.b": 1}'),
            "hold: parameters given at call time",
        ),
        (
            run.assign_attrs(status="stopped", message="it left"),
            "The run ended early: it left.",
        ),
    ):
        assert said in words(data)


@pytest.mark.long
def test_a_truth_that_is_not_known_is_left_out(run, words):
    last = run.flow_parameters_estimate.values[-1, 0, 0]
    named = f"|theta_1[1] (m/s)|{last:.4g}|"
    true = run.flow_parameters.values[0, 0]
    assert f"{named}{true:.4g}|theta_1[2]" in words(run)
    assert f"{named}theta_1[2]" in words(run.drop_vars("flow_parameters"))


@pytest.mark.long
def test_a_changed_loop_has_not_the_papers_title(tmp_path, undrawn):
    scenario = clpt.paper_scenario().with_values({"run.duration": 40})
    lag = control.tf(1, [0.5, 1], name="lag")
    loop = clpt.closed_loop(scenario, insert={("v_x", "vehicle"): lag})
    page = tmp_path / "page.html"
    changed = clpt.report(clpt.simulate(loop), page)["title"]
    assert changed == "The paper's loop with parts given in Python, v_x to vehicle: lag"
    assert "section IV" in clpt.report(clpt.simulate(scenario), page)["title"]
    other = scenario.with_values({"learning.gain": 2.0, "vehicle.max_speed": 3.0})
    changed = clpt.report(clpt.simulate(other), tmp_path / "other.html")["title"]
    assert changed == "The paper's loop with other vehicle.max_speed, learning.gain"
    text = page.read_text("utf-8")
    wide = text.count('class="wide"')
    assert text.count("Scroll sideways to see all of it.") == wide > 0


def test_rounding_is_printed_as_0_with_its_tolerance(words):
    size = control.nlsys(
        lambda t, x, u, p: [0.0],
        lambda t, x, u, p: [x[0], 1e-15 * np.cos(t) + 3.0 * t],
        inputs=0,
        outputs=["small", "far"],
        states=1,
        name="size",
    )
    text = words(clpt.simulate(size, [0.0, 1.0], initial_state=[1e-15]))
    assert "small|1e-15|1e-15|1e-15|1e-15" in text  # as large as this signal is
    assert "far|0|3|0|3" in text
    assert "0 stands for less than 1e-12 of the signal's largest value." in text


@pytest.fixture
def found(printed, tmp_path):
    """The figures that `clpt run` prints of a run, and the run."""
    clpt.save_scenario(SHORT, tmp_path / "s.toml")
    summary = printed("run", tmp_path / "s.toml", "--out", tmp_path / "run.nc")
    return summary, clpt.load_run(tmp_path / "run.nc")


@pytest.mark.long
def test_figures_of_clpt_run_are_those_of_the_page(found, words):
    summary, run = found
    text = words(run)
    assert f"CLPE rms, whole run (m)|{summary['clpe_rms']:.3g}|" in text
    assert f"|solver steps|{run.attrs['solver_steps']}|" in text
    assert f"|software|{run.attrs['software']}|" in text
    assert "of the file" not in text
    assert "samples of the file" in words(run.isel(time=slice(10)))


def with_figures(run, **changed):
    """Return a run that carries changed figures."""
    figures = json.loads(run.attrs["summary"]) | changed
    return run.assign_attrs(summary=json.dumps(figures))


@pytest.mark.long
def test_a_share_of_a_current_near_all_of_it_is_not_all(found, words):
    """0.9996 of it is 99.96 %."""
    shares = {"track": 0.9996, "box": -0.5, "window": [30.0, 40.0]}
    text = words(with_figures(found[1], explained_variance=shares))
    assert "share of the flow's variance learned, track|99.96 %|" in text
    assert "|-50 %; negative: worse than the mean current|" in text


@pytest.mark.long
def test_part_of_a_run_has_no_first_round(words):
    """From t = 150 of rounds of 200 on: the first, which was the worst, is not among them."""
    run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 600}))
    part = run.sel(time=slice(150, 500))
    text = words(part)
    rms = ((part.position - part.predicted_position) ** 2).sum("axis").mean() ** 0.5
    assert "CLPE rms per cycle" not in text
    assert f"CLPE rms, whole run (m)|{float(rms):.3g}|" in text
    said = "The page shows t = 7 to 7 s of the run..*over the 1 samples of the file"
    assert re.search(f"(?s){said}", words(run.isel(time=[7])))


@pytest.mark.long
def test_damaged_figures_of_a_run_are_not_believed(found, words):
    _, run = found
    right = json.loads(run.attrs["summary"])
    for summary in (
        *({"end": right["end"]}, right | {"clpe_rms": None}),
        *(right | {"clpe_rms_per_cycle": "0.1"}, right | {"explained_variance": [0.5]}),
        right | {"max_flow_parameter_error": {"40": float("nan")}},
    ):
        assert "samples of the file" in words(
            run.assign_attrs(summary=json.dumps(summary))
        )


@pytest.mark.long
def test_an_ensemble_has_its_page_and_figures(printed, tmp_path):
    out, page, folder = tmp_path / "e.zarr", tmp_path / "r.html", tmp_path / "f"
    clpt.run_ensemble(SHORT, VARY, 6, out=out)
    found = printed("report", out, "-o", page, "--figures", folder)
    checked(page.read_text("utf-8"), "6 finished", "=0.2:2.0")
    assert found["bytes"] == page.stat().st_size
    names = [str(folder / f"ensemble.{kind}") for kind in ("pdf", "svg")]
    assert sorted(found["figures"]) == sorted(map(str, folder.iterdir())) == names


def test_an_ensemble_that_failed_has_its_page(words):
    long = SHORT.with_values({"run.duration": 250})
    text = words(clpt.run_ensemble(long, "vehicle.position=[[1e200,0],[1e201,0]]", 2))
    said = "2 of 2 runs ended early.*2 step too small.*did not finish is 0"
    assert re.search(f"(?s){said}", text)


@pytest.mark.sampled
@pytest.mark.parametrize("done", [0, 1])
def test_an_ensemble_under_way_says_how_far_it_is(tmp_path, done):
    """Chunks that a killed process has not written have no files."""
    clpt.run_ensemble(SHORT, VARY, 6, out=tmp_path / "e.zarr", chunk=2, threads=1)
    for name in ("done", "status"):
        for chunk in range(done, 3):
            (tmp_path / "e.zarr" / name / "c" / str(chunk)).unlink()
    said = clpt.report(tmp_path / "e.zarr", tmp_path / "e.html")["sentences"]
    told = f"not complete: {2 * done} of 6 members are done"
    assert told in said[1]  # where the command ran
    checked((tmp_path / "e.html").read_text("utf-8"), told)


@pytest.mark.long
def test_a_team_has_its_page_and_a_replay_that_of_the_watch(tmp_path):
    page, team = (
        tmp_path / "t.html",
        clpt.Team(members={"a": SHORT, "b": SHORT}, coupling=0.5),
    )
    clpt.save_run(clpt.simulate(team), tmp_path / "team.nc")
    assert (
        clpt.report(tmp_path / "team.nc", page, title="Two")["kind"] == "Run of a team"
    )
    checked(page.read_text("utf-8"))
    made = clpt.report(clpt.replay.replay_dives(fixes_of(4)), page)
    assert made["sentences"][0].startswith("next surfacing ")
    assert "glider: next surfacing" in page.read_text("utf-8")


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_command_looks_at_what_a_file_is_and_figures_have_their_formats(
    run, clpt, tmp_path
):
    twice = ("--format", "svg", "--format", "pdf", "--format", "svg")
    out, again = tmp_path / "replay", tmp_path / "again.html"
    assert clpt("replay", "--sample", "--out", out, *twice).status == 0
    drawn = {
        path.name for path in out.iterdir() if path.suffix in (".svg", ".pdf", ".png")
    }
    assert drawn == {f"replay.{k}" for k in ("svg", "pdf")}
    words = ("--figures", tmp_path / "charts", "--format", "svg")
    assert clpt("report", out / "replay.nc", "-o", again, *words).status == 0
    assert again.read_bytes() == (out / "replay.html").read_bytes()
    charts = {path.name for path in (tmp_path / "charts").iterdir()}
    assert charts == {"clpe.svg", "learned.svg"}
    own = {"figures": tmp_path, "formats": ["gif"]}
    said = "format 'gif': must be one of png, pdf, svg"
    says(ClptError, said, report, run, tmp_path / "r.html", **own)


WORSE = "the flow learned is worse than the mean current"
RISES = "CLPE does not fall: its last cycle is above the first"
REMEDY = r"Try another law \(`clpt tune`\), .*see docs/laws\.md"
ADVICE = [  # CLPE of each cycle, shares learned on the track and in the box, advice
    ([0.2, 0.1], 0.9, 0.4, ""),
    ([0.2, 0.2], 0.0, None, ""),
    ([0.2], 0.9, 0.4, ""),
    ([0.2, 0.1], -0.1, 0.4, WORSE),
    ([0.2, 0.1], 0.9, -0.4, WORSE),
    ([0.1, 0.05, 0.2], 0.9, 0.4, RISES),
    ([0.1, 0.2], -0.1, 0.4, f"{RISES}; {WORSE}"),
    ([0.1, 0.2], 0.997, 0.4, ""),  # the floor that the unmodelled field sets
]


@pytest.mark.long
def test_faults_of_learning_have_a_sentence_and_a_remedy(found, words):
    for rms, track, box, said in ADVICE:
        shares = {"track": track, "box": box, "window": [10.0, 20.0]}
        changed = {"clpe_rms_per_cycle": rms, "explained_variance": shares}
        text = words(with_figures(found[1], **changed))
        advice = re.findall(rf"\|([^|]*)\. {REMEDY}", text)
        assert advice == ([said] if said else [])


NO_SUMMARY = {  # of a replay's NetCDF
    "deep.nc": ("[" * 10**5, "is a replay's NetCDF without its summary"),
    "list.nc": ("[1]", "earlier version"),
    "old.nc": ('{"each_dive": [{"dive": 1}], "next_dive": {}}', "earlier version"),
    "none.nc": (
        '{"each_dive": [], "hindsight": {}, "next_dive": null}',
        "without a dive",
    ),
    "bad.nc": (
        '{"each_dive": [{}], "hindsight": {}, "next_dive": {}}',
        "is damaged or of another",
    ),
}


def test_what_cannot_be_read_is_one_sentence(run, refused_for, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    clpt.save_run(run, "run.nc")
    whole = Path("run.nc").read_bytes()
    Path("folder").mkdir()
    Path("folder/run.nc").write_bytes(whole)
    for name, (summary, _) in NO_SUMMARY.items():
        held = {"summary": ((), summary), "clpe_adaptive": ("dive", [1.0])}
        xarray.Dataset(held, attrs={"estimator": "gaussian-process"}).to_netcdf(name)
    half = whole[: len(whole) // 2]
    no_page = {"empty.nc": b"", "bytes.nc": bytes(range(256)) * 9, "b.nc": half}
    for name, content in no_page.items():
        Path(name).write_bytes(content)
    clpt.save_scenario(clpt.paper_scenario(), "a.toml")
    for name, said in {
        **{name: said for name, (_, said) in NO_SUMMARY.items()},
        "a.toml": "a.toml: is a scenario. Make a run of it: clpt run a.toml --out run.nc",
        **dict.fromkeys(no_page, "cannot be read as NetCDF"),
        **{"folder": "Give ", "nowhere.nc": "no such file"},
    }.items():
        refused_for([said], "report", name, "-o", "r.html")
    for target in ("r.txt", "no/r.html", "folder"):
        refused_for([], "report", "run.nc", "-o", target)


@pytest.mark.filterwarnings("ignore:Glyph")
def test_a_text_that_no_page_may_hold_is_drawn_without_its_controls(page_of):
    lag = control.ss(-1, 1, 1, 0, name="lag", outputs="level")
    run = clpt.simulate(lag, [0, 1, 2], 1.0)
    run.level.attrs["units"] = "\x1b[31m"
    text = page_of(run)
    figures = re.findall("(?s)<svg.*?</svg>", text)
    assert [one for one in figures if "level (\ufffd[31m)" in one]
    for one in figures:
        ElementTree.fromstring(one)
    checked(text)


@pytest.mark.long
def test_threads_write_the_same_page_and_leave_matplotlibs_settings(tmp_path):
    run = clpt.simulate(SHORT)
    clpt.report(run, tmp_path / "alone.html")
    before = dict(matplotlib.rcParams)
    pages = [tmp_path / f"{k}.html" for k in range(2)]
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(clpt.report, [run] * 2, pages))
    alone = (tmp_path / "alone.html").read_bytes()
    assert [page.read_bytes() == alone for page in pages] == [True] * 2
    assert dict(matplotlib.rcParams) == before
