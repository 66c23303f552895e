"""Tables and a figure from the results of the benchmarks."""

from pathlib import Path

HEAD = """# Performance

Measured by `make bench`, in turn, each on one thread. Compare ratios.

Machine: {machine}.
"""
QUICK = "\nThis is a quick run: few rounds, short; its figures are rough.\n"
LEFT_OUT = "\nLeft out: {lines}.\n"
PAPER = """
## The paper's run

Section IV, t = 0 to 2000, {rounds} rounds at most, rtol 1e-8, atol 1e-10. Error: max |state -
reference|; the reference is an independent simulation, `tests/reference/paper.json`.

"""
BASIS = """
## Growth with the number of basis functions

N = 3 is the paper's flow; else N random exponential functions of the same strength; t = 0 to
{end:g}. Median time in ms, ratio to C, largest error against C at 1e-12 (N = 3: `paper.json`).

"""
ENSEMBLE = """
## Ensembles

1024 runs differ in parameters and initial states; t = 0 to 200. Error: 64 final states against C
at 1e-12.

"""
MODELS = """
## Small models

rtol 1e-8, atol 1e-10 (the long orbit 1e-15), median time of a run in ms and error at the end.
Series: the machine code of `method="taylor"` with arrays that are ready, as heyoka's; `prepare`
takes 30 us more.

"""
PARTICLES = """
## Passive particles in a gridded current

RK4, 2000 steps of 300 s, 101 x 101 points hourly for a week. Difference: relative, of eight end
positions to those of C.

"""


def _number(value, pattern: str) -> str:
    """Return a number as 12,150 in place of 1.215e+04."""
    text = "" if value is None else format(value, pattern)
    return f"{float(text):,.0f}" if "e+" in text else text


def _table(header: list[str], rows: list[list[str]]) -> str:
    def line(cells: list[str]) -> str:
        return "| " + " | ".join(cells) + " |\n"

    return line(header) + "|---" * len(header) + "|\n" + "".join(map(line, rows))


def _paper(rows: list[dict]) -> str:
    notes = [row["note"] for row in rows if row["note"]]
    cells = [
        [
            row["title"]
            + (f" [{notes.index(row['note']) + 1}]" if row["note"] else ""),
            _number(1e3 * row["median"], ".3g"),
            _number(row.get("ratio"), ".3g"),
            f"{row['error']:.1e}",
        ]
        for row in rows
    ]
    header = ["engine", "median, ms", "ratio to C", "error"]
    text = PAPER.format(rounds=max(row["rounds"] for row in rows)) + _table(
        header, cells
    )
    return text + "".join(f"\n[{k}] {note}.\n" for k, note in enumerate(notes, 1))


def _basis(results: dict) -> str:
    def cell(row: dict) -> str:
        beside = f" ({_number(row['ratio'], '.3g')})" if row.get("ratio") else ""
        return f"{_number(1e3 * row['median'], '.3g')}{beside}, {row['error']:.0e}"

    sizes = results["basis"]
    found = {(row["title"], N): cell(row) for N, rows in sizes.items() for row in rows}
    rows = [
        [title, *(found.get((title, N), "") for N in sizes)]
        for title in dict.fromkeys(title for title, _ in found)
    ]
    header = ["engine", *(f"N = {N}" for N in sizes)]
    return BASIS.format(end=results["basis_duration"]) + _table(header, rows)


def _ensemble(rows: list[dict]) -> str:
    patterns = {"rate": ".4g", "ratio": ".3g", "error": ".1e", "peak_mb": ".0f"}
    header = ["engine", "runs/s", "ratio to C", "error", "peak, MB"]
    return ENSEMBLE + _table(header, [_cells(row, patterns) for row in rows])


def _models(rows: list[dict]) -> str:
    def cell(row: dict) -> str:
        error = f", {row['error']:.0e}" if "error" in row else ""
        return f"{_number(1e3 * row['median'], '.3g')}{error}"

    found = {(row["model"], row["engine"]): cell(row) for row in rows}
    engines = {
        "native": "compiled diagram",
        "taylor": "series",
        "simulate": "`simulate`, `run_ensemble`",
        "heyoka": "heyoka",
        "diffrax": "diffrax",
    }
    table = [
        [model, *(found.get((model, engine), "") for engine in engines)]
        for model in dict.fromkeys(model for model, _ in found)
    ]
    notes = {row["note"]: "" for row in rows if "note" in row}
    text = MODELS + _table(["model", *engines.values()], table)
    return text + "".join(f"\n{note}\n" for note in notes)


def _particles(rows: list[dict]) -> str:
    patterns = {"rate": ".3g", "ratio": ".3g", "difference": ".0e", "peak_mb": ".0f"}
    header = ["engine", "particle-steps/s", "ratio to C", "difference", "peak, MB"]
    return PARTICLES + _table(header, [_cells(row, patterns) for row in rows])


def _cells(row: dict, patterns: dict[str, str]) -> list[str]:
    return [
        row["title"],
        *(_number(row.get(key), form) for key, form in patterns.items()),
    ]


def markdown(results: dict) -> str:
    """Return the results, as `bench` keeps them, as Markdown: a table for each section."""
    text = HEAD.format(machine=results["machine"])
    text += QUICK if results["quick"] else ""
    if results["left_out"]:
        text += LEFT_OUT.format(lines="; ".join(results["left_out"]))
    text += "".join(f"\n{remark}\n" for remark in results.get("remarks", []))
    if results.get("paper"):
        text += _paper(results["paper"])
    if any(results.get("basis", {}).values()):
        text += _basis(results)
    for name, write in (
        ("ensemble", _ensemble),
        ("models", _models),
        ("particles", _particles),
    ):
        if results.get(name):
            text += write(results[name])
    return (
        text
        + "\n![Times, growth with N and with the members of an ensemble](performance.png)\n"
    )


OURS = "#0072B2"
GREYS = ("0.25", "0.45", "0.6", "#D55E00", "#009E73", "#E69F00", "#CC79A7")


def figure(results: dict, path: Path) -> None:
    """Draw times, growth with N and growth with members into a PNG file."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    drawing = Figure(figsize=(13, 5.6), layout="constrained")
    FigureCanvasAgg(drawing)
    bars, basis, members = drawing.subplots(1, 3)
    rows = sorted(results.get("paper", []), key=lambda row: -row["median"])
    shades = [OURS if row["title"].startswith("clpt") else "0.5" for row in rows]
    # as points: a bar has no length on this axis
    times = [1e3 * row["median"] for row in rows]
    bars.scatter(times, [row["title"] for row in rows], color=shades, zorder=3)
    bars.set(xscale="log", xlabel="time of a run (ms)", title="The paper's run")
    bars.grid(alpha=0.3)
    bars.tick_params(axis="y", labelsize=7)
    lines: dict[str, list] = {}
    for N, found in results.get("basis", {}).items():
        for row in found:
            lines.setdefault(row["title"], []).append((int(N), 1e3 * row["median"]))
    _lines(basis, lines, "basis functions N", "time of a run (ms)", "One run")
    lines = {}
    for row in results.get("growth", []):
        lines.setdefault(row["title"], []).append((row["members"], row["rate"]))
    _lines(members, lines, "members", "runs per second", "Ensembles, one thread")
    drawing.savefig(path, dpi=110)


def _lines(axes, lines: dict[str, list], xlabel: str, ylabel: str, title: str) -> None:
    for number, (name, points) in enumerate(lines.items()):
        ours = name.startswith("clpt")
        axes.plot(
            *zip(*points, strict=True),
            marker="os^vDPX*<>"[number % 10],
            markersize=4,
            color=OURS if ours else GREYS[number % len(GREYS)],
            zorder=3 if ours else 2,
            linewidth=2.2 if ours else 1.0,
            label=name,
            linestyle=("-", "--", "-.", ":")[number // 3 % 4],
        )
    axes.set(xscale="log", yscale="log", xlabel=xlabel, ylabel=ylabel, title=title)
    axes.grid(alpha=0.3)
    if lines:
        axes.legend(fontsize=6, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncol=2)
