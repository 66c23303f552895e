"""What a notebook has of clpt: `dataset.clpt`, on every xarray.Dataset."""
