"""Serialization of diagrams and runs: plain data in the types of JSON, without code.

Blocks are stored as records of array operations (`records`, `blocks`), a diagram as its blocks and
wires (`diagrams`), a run as its diagram with inputs, initial state and solver options
(`run_record`).
"""
