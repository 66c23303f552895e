"""HTML pages without a script: their frame, their style, and figures as SVG in them."""
