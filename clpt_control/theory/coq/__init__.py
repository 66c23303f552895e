"""The theorems of section III in Coq: fixed files, and the records of the blocks that run."""
