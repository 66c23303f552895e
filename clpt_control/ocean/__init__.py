"""Measured currents: readers, projection, gaps, fits and gridded fields."""
