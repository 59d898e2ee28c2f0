"""The acceleration of free fall."""

GRAVITY_M_S2 = 9.81
