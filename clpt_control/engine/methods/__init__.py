"""Integration methods: a row of facts for each, its tableau and its formulas."""
