"""The commands of `clpt`, one file each; they import what they need when run."""
