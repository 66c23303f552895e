"""Guaranteed runs: the record of a diagram, computed on sets of numbers."""
