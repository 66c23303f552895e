"""Many runs of one scenario: designed, run on threads or a cluster, kept in Zarr."""
