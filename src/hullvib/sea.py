"""Figures of the sea that formulas take by default."""

GRAVITY_M_S2 = 9.81
SEA_WATER_KG_M3 = 1025.0
