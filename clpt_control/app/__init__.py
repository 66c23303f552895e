"""Command line, HTML pages and notebook display."""
