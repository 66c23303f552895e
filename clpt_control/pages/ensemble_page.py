"""The page of an ensemble: what varied, how many are done, how they ended, percentiles."""

import json
from typing import Any

import numpy as np
from xarray import Dataset

from ..ensemble.drawn_values import Vary, read_vary
from ..ensemble.spread import ensemble_plot, ensemble_summary, unit_of
from ..ensemble.summaries import STATUS
from ..html import Result, folded, listing
from ..units import percent
from .page import Card, Page, Section, again_section, drawn
from .results import Numbers, number

DESIGNS = {"lhs": "Latin hypercube", "grid": "grid", "random": "random draws"}
MOST_KEYS = 4  # in a sentence
MOST_FAILED = 20  # members named
MOST_ROUNDS = 12
Request = dict[str, Any]  # what was asked of `run_ensemble`


def ensemble_page(data: Dataset, title: str | None) -> Page:
    """Return the page of an ensemble, whole or begun."""
    request = json.loads(data.attrs["ensemble"])
    summary = ensemble_summary(data)
    members, status = summary["members"], data["status"].values
    done, finished = int(np.sum(status != 0)), int(np.sum(status == 1))
    warnings = []
    if done < members:
        warnings.append(
            f"The ensemble is not complete: {done} of {members} members are done; figures are of "
            "these. `clpt ensemble` with the same words goes on."
        )
    if finished < done:
        warnings.append(
            f"{done - finished} of {done} runs did not come to their end; what they reached counts."
        )
    text = folded("The scenario that varied, TOML", listing(str(request["scenario"])))
    sections = [
        _spread(data, summary, done),
        _varied(data, request),
        *_failed(data, request, status),
        Section("scenario", "Scenario", more=text),
        _again(data, request),
    ]
    return Page(
        "Ensemble",
        title or str(data.attrs.get("title") or "An ensemble without a title"),
        [_asked(request), *_found(data, summary, done)],
        warnings,
        _cards(data, summary, done, finished),
        sections,
    )


def _asked(request: Request) -> str:
    ways = [_varies(read_vary(one)) for one in request["vary"]]
    varies = "; ".join(ways) if len(ways) <= MOST_KEYS else f"{len(ways)} keys of the scenario vary"
    return (
        f"Asked: how much does the outcome change over {request['members']} runs, in which "
        f"{varies} ({DESIGNS.get(request['design'], request['design'])}, seed {request['seed']})?"
    )


def _varies(vary: Vary) -> str:
    """Return how a key varies, in words."""
    if vary.kind == "uniform":
        return f"{vary.key} varies from {vary.numbers[0]:g} to {vary.numbers[1]:g}"
    if vary.kind == "normal":
        return f"{vary.key} varies normally with a deviation of {vary.numbers[0]:g}"
    if vary.kind == "drawn":
        return f"{vary.key} is drawn from {vary.numbers[0]}"
    return f"{vary.key} has one of {len(vary.numbers)} values"


def _found(data: Dataset, summary: Numbers, done: int) -> list[str]:
    if not done:
        return ["Found: nothing yet, no member is done."]
    unit = data["clpe_rms"].attrs["units"]
    sentences = []
    every = summary["clpe_rms_per_cycle"]
    rounds = [one for one in every if one is not None]  # members that fail reach none that follow
    if (rms := rounds[-1] if rounds else summary["clpe_rms"]) is not None:
        what = "the CLPE over the run, root mean square,"
        if rounds:
            last = "the last" if len(rounds) == len(every) else "the last that any run reached"
            what = f"in round {len(rounds)} of the waypoints, {last}, the CLPE, root mean square,"
        sentences.append(
            f"Found: {what} is {number(rms[2])} {unit} in the median run, and nine in ten runs "
            f"lie between {number(rms[0])} and {number(rms[-1])} {unit}."
        )
    error = summary.get("flow_parameter_error_at_end")
    if error is not None:
        per = unit_of(data["flow_parameter_error"])
        sentences.append(
            f"At the end the largest error of a flow parameter is {number(error[2])} {per} in the "
            f"median run, and at most {number(error[-1])} {per} in 95 of 100."
        )
    return sentences or ["Found: no run came to the end of a round, nor to its own."]


def _cards(data: Dataset, summary: Numbers, done: int, finished: int) -> list[Card]:
    cards = [
        Card("Members done", f"{done} of {summary['members']}", f"{finished} came to their end")
    ]
    for key, variable, what in (
        ("clpe_rms", "clpe_rms_whole", "CLPE rms, whole run, median"),
        ("flow_parameter_error_at_end", "flow_parameter_error", "Flow parameter error, median"),
        ("gain_error_at_end", "gain_error", "Gain error, median"),
    ):
        if (column := summary.get(key)) is not None:
            unit = unit_of(data[variable])
            below = f"5 to 95 %: {number(column[0])} to {number(column[-1])}"
            cards.append(Card(what, f"{number(column[2])} {unit}", below))
    return cards


def _spread(data: Dataset, summary: Numbers, done: int) -> Section:
    """Return percentiles, drawn and as a table."""
    heading = "How the runs differ"
    if not done:
        result = Result(sentences=["No member is done: nothing to draw"])
        return Section("spread", heading, result)
    caption = (
        "Above, the CLPE in each round of the waypoints; below, the largest error of what was "
        "learned: the median run, half of all runs, and nine in ten."
    )
    result = ensemble_result(data, summary, "Percentiles over the members", MOST_ROUNDS)
    figure = drawn("ensemble", 5.4, caption, ensemble_plot, data)
    return Section("spread", heading, result, [figure])


def ensemble_result(data: Dataset, summary: Numbers, name: str, most: int) -> Result:
    """Return percentiles over the members; of more cycles than `most`, the first and the last."""
    length, time = data["clpe_rms"].attrs["units"], data["mark"].attrs["units"]
    rows, cycles = [], summary["clpe_rms_per_cycle"]
    for k, column in enumerate(cycles, 1):
        if k < most or k == len(cycles):
            rows.append([f"CLPE rms, cycle {k} ({length})", *_cells(column)])
    rows.append([f"CLPE rms, whole run ({length})", *_cells(summary["clpe_rms"])])
    end = f"t = {float(data['mark'][-1]):g} {time}"
    for key, what in (("flow_parameter_error", "flow parameter"), ("gain_error", "gain")):
        if f"{key}_at_end" in summary:
            row = f"largest {what} error ({unit_of(data[key])}), {end}"
            rows.append([row, *_cells(summary[f"{key}_at_end"])])
    ended = ", ".join(f"{n} {how.replace('_', ' ')}" for how, n in summary["ended"].items())
    sentences = []
    if "faster_flow" in summary and summary["faster_flow"]["members"]:
        faster = summary["faster_flow"]
        sentences.append(
            f"in {faster['members']} members the flow was faster than the vehicle, for at most "
            f"{percent(faster['largest_share'])} of the time and {faster['longest']:.3g} {time} "
            "in a stretch"
        )
    if summary["first_failed"] is not None:
        sentences.append(f"the first member that did not finish is {summary['first_failed']}")
    columns = ["percentile", *(f"{p} %" for p in summary["percents"])]
    return Result(f"{name}: {ended}", columns, rows, sentences)


def _cells(column: list[float] | None) -> list[str]:
    return ["-"] * 5 if column is None else [f"{value:.4g}" for value in column]


def _varied(data: Dataset, request: Request) -> Section:
    rows = []
    for key, text in zip(request["keys"], request["vary"], strict=True):
        values = data[key].values.reshape(request["members"], -1)
        count = values.shape[1]
        low, middle, high = np.percentile(values, (0, 50, 100))
        of = f"{count} numbers" if count > 1 else "one number"
        rows.append([key, text.removeprefix(key), of, number(low), number(middle), number(high)])
    columns = ["key", "asked for", "each member has", "least", "median", "most"]
    return Section("varied", "What varied", Result("Values of all members", columns, rows))


def _failed(data: Dataset, request: Request, status: np.ndarray) -> list[Section]:
    """Return the members that did not come to their end."""
    failed = np.flatnonzero(status > 1)
    if not len(failed):
        return []
    keys = [key for key in request["keys"] if data[key].ndim == 1]
    rows = []
    for k in failed[:MOST_FAILED]:
        values = [f"{float(data[key][k]):.6g}" for key in keys]
        end = f"{float(data['end'][k]):.6g}"
        rows.append([str(k), STATUS[status[k]].replace("_", " "), end, *values])
    columns = ["member", "ended by", f"at t ({data['end'].attrs['units']})", *keys]
    more = len(failed) - MOST_FAILED
    sentence = f"{len(failed)} runs did not come to their end"
    sentence += f"; the first {MOST_FAILED} are listed" if more > 0 else ""
    listed = Result("Runs that did not come to their end", columns, rows, [sentence])
    return [Section("failed", "Runs that failed", listed)]


def _again(data: Dataset, request: Request) -> Section:
    words = [f"--vary '{one}'" for one in request["vary"]]
    begin = f"clpt ensemble scenario.toml --members {request['members']}"
    end = f"--design {request['design']} --seed {request['seed']}"
    command = " ".join([begin, *words, end, "--out ensemble.zarr"])
    how = "Save the scenario above as <code>scenario.toml</code>, and type:"
    commands = [command, "clpt report ensemble.zarr -o report.html"]
    if request.get("law"):
        how = "The runs had a law given in Python, which no file holds:"
        commands = [f"# {request['law']}"]
    return again_section(how, commands, data.attrs)
