"""Notebook accessor `dataset.clpt` of every xarray.Dataset."""
