"""Tides of a current record: constants, ellipses, what can be told apart."""
