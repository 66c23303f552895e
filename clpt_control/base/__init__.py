"""Helpers without a subject of the field: public names, random numbers."""
