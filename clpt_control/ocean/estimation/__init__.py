"""Estimates of the flow parameters theta from data.

From samples of a flow (`least_squares.least_squares`), or from fix to fix of a vehicle that
sees itself at surfacings only (`FixModel`, `make_estimator`).
"""
