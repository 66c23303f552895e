"""Where Eqs. (16) and (33) and the argument of Theorem 3.3 fail."""
