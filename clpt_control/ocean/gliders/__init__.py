"""Files of gliders and the dives in them: `read_dives`."""
