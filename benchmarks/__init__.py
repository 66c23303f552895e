"""Benchmarks: one interleaved run of several engines; see docs/performance.md."""
