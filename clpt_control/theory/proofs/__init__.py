"""The theorems, and a law of your own, on the equations that run."""
