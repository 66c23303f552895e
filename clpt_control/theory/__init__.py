"""The paper's section III as checks on the equations that run."""
