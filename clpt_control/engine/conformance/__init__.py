"""Conformance: every backend of a block or diagram compared with Python."""
