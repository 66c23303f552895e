"""Laws on the paper's loop: their V, V', relations, promises, and runs that break these."""
