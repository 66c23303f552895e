"""Estimates of the flow parameters theta from data.

Samples of a flow: `least_squares`.  Fixes of a run: `theta_from_fixes`.  Surfacings of a glider,
which has no position between them: `fix_model` and the estimators.
"""
