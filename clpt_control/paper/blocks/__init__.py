"""The paper's diagram, a page for each block, and its laws."""
