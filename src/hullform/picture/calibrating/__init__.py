"""Pixels to metres: the long straight lines of the drawing, its grid, its scale."""
