"""A scenario file of the paper's with some keys changed, and the command that runs it."""

import tomllib
from pathlib import Path

from clpt_control.scenario.file import paper_text, toml

RUN = ("run", "s.toml", "--out", "run.nc")


def write(changes, path="s.toml"):
    tables = tomllib.loads(paper_text())
    for key, value in changes.items():
        *place, last = key.split(".")
        table = tables
        for name in place:
            table = table.setdefault(name, {})
        if value is None:
            del table[last]
        else:
            table[last] = value
    Path(path).write_text(toml(tables))
