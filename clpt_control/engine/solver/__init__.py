"""Solver: integration of compiled or Python diagrams between events of time and of state."""
