"""General helpers: arguments, errors, files, progress, figures, HTML, units, random numbers."""
