"""A run as a wide table: one column a signal, units in its header; as CSV and for MATLAB.

Nothing of pandas is needed.  MATLAB gets a matrix for each port, whose columns are its signals.
"""

import csv
import io
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import DataError
from ..files import beside, check_writable, write_text
from ..html import facts, fragment
from ..simulation.plots import STATES, named, signals_of

if TYPE_CHECKING:
    import xarray

LONGEST = 63  # letters of a name in MATLAB
WORDS = {  # that name nothing in MATLAB
    *("break", "case", "catch", "classdef", "continue", "else", "elseif", "end", "for"),
    *("function", "global", "if", "otherwise", "parfor", "persistent", "return", "spmd"),
    *("switch", "try", "while"),
}
SHOWN = 5  # rows that a notebook is shown


class SignalTable:
    """A run as a table: `columns` are the names with units, `values` the numbers (times, columns).

    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 5}))
    >>> found = run[["clpe"]].clpt.table()
    >>> found.columns, found.values.shape
    (['time (s)', 'clpe axis 1 (m)', 'clpe axis 2 (m)'], (6, 3))
    """

    def __init__(self, run: "xarray.Dataset"):
        ports = [one for n, one in run.data_vars.items() if "time" in one.dims and n != STATES]
        if "time" not in run.dims or not ports:
            raise DataError("the dataset has no signal along time, of which a table could be made")
        self._title = str(run.attrs.get("title", ""))
        self._ports = [(run.time, {"time": run.time.values})]
        self._ports += [(one, signals_of(one)) for one in ports]
        self.columns = [
            named(name, one.attrs.get("units")) for one, own in self._ports for name in own
        ]
        self.values = np.column_stack([v for _, own in self._ports for v in own.values()])

    def __repr__(self) -> str:
        times, count = self.values.shape
        return f"<SignalTable of {times} times and {count} columns: {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        rows = [[f"{one:.6g}" for one in row] for row in self.values[:SHOWN]]
        more = len(self.values) - SHOWN
        rows += [[f"... {more} more", *[""] * (len(self.columns) - 1)]] if more > 0 else []
        return fragment("Table", self._title, facts(rows, self.columns))

    def to_csv(self, path: str | Path) -> None:
        """Write a CSV file: a header with units, then a row for each time, every digit kept."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self.columns)
        writer.writerows(self.values.tolist())
        write_text(path, text.getvalue())

    def to_mat(self, path: str | Path) -> None:
        """Write a file for MATLAB: ``time``, a matrix for each port, ``units`` and ``signals``.

        Names are those of the ports, where MATLAB allows them.
        """
        from scipy.io import savemat

        found: dict[str, Any] = {"title": self._title, "units": {}, "signals": {}}
        for port, own in self._ports:
            name = _valid(str(port.name), found)
            found[name] = np.column_stack([*own.values()])
            found["units"][name] = str(port.attrs.get("units", ""))
            found["signals"][name] = np.array([*own], dtype=object)
        check_writable(path)
        with beside(path) as made:
            savemat(made, found, appendmat=False, long_field_names=True)

    def write(self, path: str | Path) -> None:
        """Write the table as the ending of the file says, ``.csv`` or ``.mat``."""
        ways = {".csv": self.to_csv, ".mat": self.to_mat}
        if (suffix := Path(path).suffix.lower()) not in ways:
            raise DataError(f"{path}: a table is written as {' or '.join(ways)}")
        ways[suffix](path)


def _valid(name: str, taken: Any) -> str:
    """Return a name that MATLAB allows, and that is not taken.

    >>> _valid("K", []), _valid("2nd flow", []), _valid("end", []), _valid("e", ["e", "e_2"])
    ('K', 'x_2nd_flow', 'x_end', 'e_3')
    """
    found = re.sub(r"[^A-Za-z0-9_]", "_", name)
    found = found if found[:1].isalpha() and found not in WORDS else f"x_{found}"
    first, k = found[:LONGEST], 2
    found = first
    while found in taken:
        found, k = f"{first[: LONGEST - len(str(k)) - 1]}_{k}", k + 1
    return found
