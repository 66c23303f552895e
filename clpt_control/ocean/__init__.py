"""Ocean currents, gliders, flow estimation and forecasts of surfacings."""
