"""Facts about expressions: zero or not, their signs, slopes and sums of squares."""
