"""Diagrams: blocks wired by python-control, their merged record, linearization and equations."""
