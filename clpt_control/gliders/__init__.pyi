from .dive_files import read_dives, sample_dives
from .dive_table import write_dive_table
from .dives import Dive, make_dive
from .usable_dives import usable

__all__ = [
    "Dive",
    "make_dive",
    "read_dives",
    "sample_dives",
    "usable",
    "write_dive_table",
]
