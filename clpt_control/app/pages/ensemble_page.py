"""The page of an ensemble: what varied, how many are done, how they ended, percentiles.

The page of a diagram's ensemble has a figure for each output over time.
"""

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from xarray import Dataset

from ...base.html import Result, folded, listing
from ...base.page import Page, Section, drawn, versions_section
from ...ensemble.ensemble_plots import ensemble_plot
from ...ensemble.ensemble_statistics import (
    by_member,
    curves_of,
    ensemble_summary,
    is_of_diagram,
    rms_of,
)
from ...simulation.comparison import MAX_PORTS
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
    data = by_member(data)
    summary = ensemble_summary(data)
    members = summary["members"]
    status = data["status"].values
    completed = int(np.sum(status != 0))
    finished = int(np.sum(status == 1))
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
    if not of_diagram:
        text = folded("The scenario that varied, TOML", listing(request["scenario"]))
        sections.insert(1, Section("scenario", "Scenario", more=text))
    return Page(
        "Ensemble",
        title or str(data.attrs.get("title") or "An ensemble without a title"),
        [
            f"{members} runs of a {'diagram' if of_diagram else 'scenario'} with values that vary."
        ],
        warnings,
        [_spread(data, summary, completed), *sections],
    )


def _spread(data: Dataset, summary: Summary, completed: int) -> Section:
    """Return percentiles: of a scenario in one figure, of a diagram's outputs a figure each."""
    if not completed:
        return Section("spread", SPREAD, NOT_BEGUN)
    curves = curves_of(data)
    sentences = []
    figures = []
    if not is_of_diagram(data):
        caption = (
            "Above, the CLPE in each round of the waypoints; below, the largest error of what was "
            "learned: the median run, half of all runs, and nine in ten."
        )
        figures = [drawn("ensemble", 5.4, caption, ensemble_plot, data)]
    elif curves:
        for k, (label, signal) in enumerate([*curves.items()][:MOST_PORTS]):
            caption = (
                f"{label} over time: the median run, half of all runs, nine in ten."
            )
            spread = signal.to_dataset(name=label).assign_attrs(data.attrs)
            figures.append(drawn(f"output-{k}", 2.8, caption, ensemble_plot, spread))
        if hidden := len(curves) - len(figures):
            sentences.append(f"{hidden} more outputs are not drawn")
    else:
        if len(rms_of(data)) <= MAX_PORTS:
            caption = "rms of each output over the numbers that vary."
            figures = [drawn("rms", 4.2, caption, ensemble_plot, data)]
        sentences.append(
            "`run_ensemble(..., trajectories=True)` stores outputs over time"
        )
    result = percentile_table(summary, "Percentiles over the members", sentences)
    return Section("spread", SPREAD, result, figures)


def percentile_table(
    summary: Summary, name: str, sentences: Sequence[str] = ()
) -> Result:
    """Return percentiles of all summaries; of many cycles the first and the last."""
    labels = [*summary["summaries"]]
    cycles = [label for label in labels if " cycle " in label]
    hidden = {*cycles[MOST_ROUNDS - 1 : -1]}
    rows = []
    for label, column in summary["summaries"].items():
        if label not in hidden:
            cells = ["-"] * 5 if column is None else [f"{x:.4g}" for x in column]
            rows.append([label, *cells])
    ended = ", ".join(
        f"{n} {how.replace('_', ' ')}" for how, n in summary["ended"].items()
    )
    if hidden:
        left_out = f"left out: cycles from {MOST_ROUNDS} to the last but one"
        sentences = [*sentences, left_out]
    failed = summary["first_failed"]
    if failed is not None:
        sentences = [*sentences, f"the first member that did not finish is {failed}"]
    columns = ["percentile", *(f"{p} %" for p in summary["percents"])]
    return Result(f"{name}: {ended}", columns, rows, [*sentences])


def _varied(data: Dataset, request: Request) -> Section:
    rows = []
    for key, text in zip(request["keys"], request["vary"], strict=True):
        if data[key].dtype.kind == "f":
            marks = np.percentile(data[key], (0, 50, 100))
            cells = [f"{number:.4g}" for number in marks]
        else:
            cells = [""] * 3
        rows.append([key, text.removeprefix(key), *cells])
    columns = ["key", "asked for", "least", "median", "most"]
    return Section(
        "varied", "Varied parameters", Result("Values of all members", columns, rows)
    )
