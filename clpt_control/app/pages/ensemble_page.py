"""The page of an ensemble: what varied, how many are done, how they ended, percentiles.

The page of a diagram's ensemble has a figure for each output over time.
"""

import json
from typing import Any

import numpy as np
from xarray import Dataset

from ...base.html import Result, folded, listing
from ...base.units import percent
from ...ensemble.ensemble_statistics import (
    by_member,
    ensemble_plot,
    ensemble_summary,
    is_of_diagram,
    rms_of,
    signals_over_time,
    unit_of,
)
from ...simulation.comparison import MAX_PORTS
from .page import Page, Section, drawn, versions_section
from .results import Summary

MOST_ROUNDS = 8
MOST_PORTS = 12  # outputs of a diagram, a figure each
SPREAD = "Spread of the runs"
NOT_BEGUN = Result(sentences=["No member is done: nothing to draw"])
Request = dict[str, Any]  # what was asked of `run_ensemble`


def ensemble_page(data: Dataset, title: str | None) -> Page:
    """Return the page of an ensemble, whole or begun."""
    request = json.loads(data.attrs["ensemble"])
    of_diagram = is_of_diagram(data)
    if of_diagram:
        data = by_member(data)
    summary = ensemble_summary(data)
    members, status = summary["members"], data["status"].values
    completed, finished = int(np.sum(status != 0)), int(np.sum(status == 1))
    warnings = []
    if completed < members:
        warnings.append(
            f"The ensemble is not complete: {completed} of {members} members are done; "
            f"figures are of these. {'run_ensemble' if of_diagram else '`clpt ensemble`'} with the "
            "same words goes on."
        )
    if finished < completed:
        warnings.append(
            f"{completed - finished} of {completed} runs ended early; figures are of "
            "the part that they completed."
        )
    if request.get("law"):
        warnings.append(
            f"The runs had a law given in Python, which no file holds: {request['law']}"
        )
    sections = [_varied(data, request), versions_section(data.attrs)]
    if of_diagram:
        spread = _diagram_spread(data, summary, completed)
    else:
        spread = _spread(data, summary, completed)
        text = folded("The scenario that varied, TOML", listing(request["scenario"]))
        sections.insert(1, Section("scenario", "Scenario", more=text))
    return Page(
        "Ensemble",
        title or str(data.attrs.get("title") or "An ensemble without a title"),
        [
            f"{members} runs of a {'diagram' if of_diagram else 'scenario'} with values that vary."
        ],
        warnings,
        [spread, *sections],
    )


def _spread(data: Dataset, summary: Summary, completed: int) -> Section:
    """Return percentiles, drawn and as a table."""
    if not completed:
        return Section("spread", SPREAD, NOT_BEGUN)
    caption = (
        "Above, the CLPE in each round of the waypoints; below, the largest error of what was "
        "learned: the median run, half of all runs, and nine in ten."
    )
    result = ensemble_result(data, summary, "Percentiles over the members")
    figure = drawn("ensemble", 5.4, caption, ensemble_plot, data)
    return Section("spread", SPREAD, result, [figure])


def ensemble_result(data: Dataset, summary: Summary, name: str) -> Result:
    """Return percentiles over the members; of many cycles the first and the last."""
    length, time = data["clpe_rms"].attrs["units"], data["mark"].attrs["units"]
    rows, cycles = [], summary["clpe_rms_per_cycle"]
    for k, column in enumerate(cycles, 1):
        if k < MOST_ROUNDS or k == len(cycles):
            rows.append([f"CLPE rms, cycle {k} ({length})", *_cells(column)])
    rows.append([f"CLPE rms, whole run ({length})", *_cells(summary["clpe_rms"])])
    if "flow_error" in summary:
        row = f"rms error of the learned flow along the track ({unit_of(data.flow_error)})"
        rows.append([row, *_cells(summary["flow_error"])])
    end = f"t = {float(data['mark'][-1]):g} {time}"
    for key, quantity in (
        ("flow_parameter_error", "flow parameter"),
        ("gain_error", "gain"),
    ):
        if f"{key}_at_end" in summary:
            row = f"largest {quantity} error ({unit_of(data[key])}), {end}"
            rows.append([row, *_cells(summary[f"{key}_at_end"])])
    sentences = []
    if "faster_flow" in summary and summary["faster_flow"]["members"]:
        faster = summary["faster_flow"]
        sentences.append(
            f"in {faster['members']} members the flow was faster than the vehicle, for at most "
            f"{percent(faster['largest_share'])} of the time"
        )
    return _percentile_table(summary, name, rows, sentences)


def _percentile_table(
    summary: Summary, name: str, rows: list[list[str]], sentences: list[str]
) -> Result:
    """Return rows of percentiles under their heading, which tells how the members ended."""
    ended = ", ".join(
        f"{n} {how.replace('_', ' ')}" for how, n in summary["ended"].items()
    )
    if summary["first_failed"] is not None:
        sentences.append(
            f"the first member that did not finish is {summary['first_failed']}"
        )
    columns = ["percentile", *(f"{p} %" for p in summary["percents"])]
    return Result(f"{name}: {ended}", columns, rows, sentences)


def _diagram_spread(data: Dataset, summary: Summary, completed: int) -> Section:
    """Return percentiles of a diagram's outputs over time, drawn, and of its summaries."""
    if not completed:
        return Section("spread", SPREAD, NOT_BEGUN)
    rows = [[name, *_cells(column)] for name, column in summary["summaries"].items()]
    signals = signals_over_time(data)
    sentences, figures = [], []
    for k, (label, signal) in enumerate([*signals.items()][:MOST_PORTS]):
        caption = f"{label} over time: the median run, half of all runs, nine in ten."
        one = signal.to_dataset(name=label).assign_attrs(data.attrs)
        figures.append(drawn(f"output-{k}", 2.8, caption, ensemble_plot, one))
    if hidden := len(signals) - len(figures):
        sentences.append(f"{hidden} more outputs are not drawn")
    if not signals and len(rms_of(data)) <= MAX_PORTS:
        caption = "rms of each output over the first number that varies."
        figures = [drawn("rms", 4.2, caption, ensemble_plot, data)]
    if not signals:
        sentences.append(
            "`run_ensemble(..., trajectories=True)` stores outputs over time"
        )
    name = "Percentiles over the members"
    result = _percentile_table(summary, name, rows, sentences)
    return Section("spread", SPREAD, result, figures)


def _cells(column: list[float] | None) -> list[str]:
    return ["-"] * 5 if column is None else [f"{value:.4g}" for value in column]


def _varied(data: Dataset, request: Request) -> Section:
    rows = []
    for key, text in zip(request["keys"], request["vary"], strict=True):
        cells = [f"{number:.4g}" for number in np.percentile(data[key], (0, 50, 100))]
        rows.append([key, text.removeprefix(key), *cells])
    columns = ["key", "asked for", "least", "median", "most"]
    return Section(
        "varied", "Varied parameters", Result("Values of all members", columns, rows)
    )
