"""Blocks wired by python-control: `connect`, what is wired to what, pictures."""
