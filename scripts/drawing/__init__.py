"""The hull forms of the three ships in bodyplans/, and the drawing of their body plans."""
