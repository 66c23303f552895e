"""How exciting a track is: the joint Gramian and what follows from it."""
