"""Tracing: a function runs on tracer arrays, which record array operations."""
