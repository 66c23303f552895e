"""The blocks of the paper's diagram, one file for each."""
