"""Measured currents and gliders: readers, fits, tides and replay."""
