"""Measured currents: gridded fields and records, fits to them, tides.

Currents on a grid (`read_currents`, `fit_scenario`), tides of a record (`read_record`,
`fit_tides`).
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
