from .ocean.gliders.dive_files import read_dives, sample_dives
from .ocean.gliders.dive_table import write_dive_table
from .ocean.gliders.dives import Dive, make_dive

__all__ = ["Dive", "make_dive", "read_dives", "sample_dives", "write_dive_table"]
