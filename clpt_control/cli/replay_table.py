"""The table of a replay: a row for each dive, as many columns as the terminal is wide.

Columns join in the order of their rank while they fit; those of rank 0 always stand.
"""

from typing import TYPE_CHECKING, Any

from .printing import print_table, terminal_width

if TYPE_CHECKING:
    from ..replay.columns import Column

EDGES, EDGE = 3, 1  # letters around a cell, and of the table's own edge
ROWS = {
    "clpe_rms": "after the first dive",
    "clpe_rms_all": "all, the first with no flow",
    "clpe_rms_after_3": "after the third dive",
}
NAMES = {
    "no_flow": "no flow",
    "previous_dive": "previous",
    "adaptive": "adaptive",
    "flow_model": "model",
}


def fitting(table: "list[Column]", cells: list[list[str]], width: int) -> list[int]:
    """Return which columns of a table fit into a width, in letters; `cells` are its rows."""
    size = [
        EDGES + max(len(column.title), *(len(row[k]) for row in cells))
        for k, column in enumerate(table)
    ]
    chosen: list[int] = []
    for k in sorted(range(len(table)), key=lambda k: table[k].rank):
        if table[k].rank == 0 or EDGE + size[k] + sum(size[j] for j in chosen) <= width:
            chosen.append(k)
    return sorted(chosen)


def show_tables(summary: dict[str, Any], width: int | None = None) -> None:
    """Print a row per dive, then the rms of misses, into a width; by default the terminal's."""
    from ..replay.columns import ahead_cell, columns, metres

    width = terminal_width() if width is None else width
    each = summary["each_dive"]
    table = columns(each[0])
    cells = [[column.cell(row) for column in table] for row in each]
    if summary.get("next_dive"):
        cells.append([ahead_cell(column.title, summary["next_dive"]) for column in table])
    chosen = fitting(table, cells, width)
    print_table(
        "Miss (CLPE, m) one dive ahead; currents in m/s",
        [table[k].title for k in chosen],
        [[row[k] for k in chosen] for row in cells],
        width,
    )
    means = {name: summary[key] for key, name in ROWS.items()}
    if "flow_model" in summary and 0 < summary["flow_model"]["covered"] < summary["used"]:
        means["covered, after the first dive"] = summary["flow_model"]["clpe_rms"]
    models = [NAMES[key] for key in each[0]["clpe"]]
    rows = [[name, *map(metres, rms.values())] for name, rms in means.items()]
    print_table("Miss, rms (m)", ["over", *models], rows, width)
