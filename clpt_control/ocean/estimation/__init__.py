"""Estimates of the flow parameters theta from fixes.

Fixes of a run: `theta_from_fixes`.  Legs of a vehicle, recorded or live: `flow_estimator`.
Surfacings of a glider, which has no position between them: `fix_model` and `estimators`.
"""
