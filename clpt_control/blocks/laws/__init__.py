"""The adaptive laws, a page for each, and the table of them.

`law` says what a row of the `table` is and adapts K and Gamma for every law.  A page holds
a law's equations, its parameters, its V and its row, `LAW`.
"""
