"""Measured currents: gridded fields (`read_currents`), fits to them, tides.

`fit_current` makes a scenario in a gridded current, `tidal_basis` the theta of tides that UTide
fitted to a record at one place.
"""
