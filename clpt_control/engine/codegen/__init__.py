"""Code generation: machine code (LLVM) and C of a diagram's record."""
