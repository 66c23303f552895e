from .dive_files import read_dives
from .dive_table import sample_dives, write_dive_table
from .dives import Dive, make_dive
from .og1_writer import write_og1
from .usable_dives import usable

__all__ = [
    "Dive",
    "make_dive",
    "read_dives",
    "sample_dives",
    "usable",
    "write_dive_table",
    "write_og1",
]
