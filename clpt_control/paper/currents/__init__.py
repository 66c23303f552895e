"""Measured currents: gridded fields and records, fits to them, tides.

Currents on a grid (`read_currents`, `fit_current`), tides of a record (`read_record`,
`fit_tides`).
"""
