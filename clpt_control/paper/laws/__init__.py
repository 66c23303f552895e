"""The adaptive laws by family, and the table of laws.

`law` defines a row of the table and the rates of K and Gamma.  Each family (`paper`, `robust`,
`least_squares`, `memory_laws`) has the rates of its laws, whose docstrings are the laws' pages,
their V, and their rows, `LAWS`.
"""
