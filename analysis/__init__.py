"""Studies: each asks one question and leaves one table and one figure."""
