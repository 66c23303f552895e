"""The paper's closed loop and its runs: `simulate`, data, report, pictures."""
