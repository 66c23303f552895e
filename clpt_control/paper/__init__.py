"""The paper's diagram: blocks, adaptive laws and scenarios."""
