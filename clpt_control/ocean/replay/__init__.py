"""Replay of dives: each forecast before its end is seen."""
