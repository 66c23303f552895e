"""Simulation of the paper's closed loop, of teams, and of any diagram of blocks.

`loops` wires the loop, and `integrate` returns a run as an `xarray.Dataset`.  Further modules
summarise, plot and save runs, compute sensitivities, fit parameters, and export C and FMUs.
"""
