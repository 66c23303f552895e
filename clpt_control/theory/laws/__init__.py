"""Laws on the paper's loop: their V, V', relations, and promises."""
