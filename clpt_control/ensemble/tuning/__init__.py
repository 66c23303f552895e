"""Which law, with which gains and filter, for a scenario whose flow nobody knows."""
