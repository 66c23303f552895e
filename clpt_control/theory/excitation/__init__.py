"""Excitation of the joint regressor: Gramians and certificates of decay.

`regressor` computes w of Eq. (31), `gramian` Definition 3.1, `certificates` the decay of V over
one window and `certify` bounds for every start of the learner.
"""
