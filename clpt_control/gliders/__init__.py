"""Files of gliders and the dives in them: `read_dives`, `usable`."""

from typing import TYPE_CHECKING

from ..lazy import lazily

_NAMES = {
    "Dive": "dives",
    "make_dive": "dives",
    "usable": "usable_dives",
    "read_dives": "dive_files",
    "sample_dives": "dive_table",
    "write_dive_table": "dive_table",
    "write_og1": "og1_writer",
}

__all__ = list(_NAMES)

if TYPE_CHECKING:
    from .dive_files import read_dives
    from .dive_table import sample_dives, write_dive_table
    from .dives import Dive, make_dive
    from .og1_writer import write_og1
    from .usable_dives import usable

__getattr__, __dir__ = lazily(__name__, _NAMES)
