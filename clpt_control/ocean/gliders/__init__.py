"""Files of gliders, and the dives in them."""
