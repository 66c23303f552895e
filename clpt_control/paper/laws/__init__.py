"""The adaptive laws by family, and the table of them.

`law` says what a row of the `table` is and adapts K and Gamma for every law.  A family holds its
laws' rates, whose docstrings are their pages, their V and their rows, `LAWS`.
"""
