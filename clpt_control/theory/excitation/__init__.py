"""Excitation of the joint regressor: Gramians and certificates of decay."""
