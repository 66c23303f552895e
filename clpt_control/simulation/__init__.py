"""Simulation of the paper's closed loop, of teams, and of any diagram of blocks.

`closed_loop` wires the loop, and `simulate` returns a run as an `xarray.Dataset`.  Further modules
summarise, plot and save runs, compute sensitivities, fit parameters, and export C and FMUs.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
