"""The hull forms of the ships in bodyplans/, and the drawing of their body plans."""
