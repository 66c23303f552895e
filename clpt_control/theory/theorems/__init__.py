"""The paper's theorems line by line, misprints, counterexamples, and all verdicts together."""
