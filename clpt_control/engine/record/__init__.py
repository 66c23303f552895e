"""Record: a typed SSA graph of array operations; derivative and SymPy's expressions of it."""
