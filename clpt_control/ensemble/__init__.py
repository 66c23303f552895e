"""Ensembles: many runs with sampled parameters, on threads or a cluster, stored in Zarr."""
