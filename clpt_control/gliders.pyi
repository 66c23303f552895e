from .ocean.gliders.dive_files import read_dives as read_dives
from .ocean.gliders.dive_files import sample_dives as sample_dives
from .ocean.gliders.dive_table import write_dive_table as write_dive_table
from .ocean.gliders.dives import Dive as Dive
from .ocean.gliders.dives import make_dive as make_dive
