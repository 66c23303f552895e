"""The engine: one pass over a diagram, and integration to every breakpoint."""
