"""Estimates of the flow parameters theta from data."""
