"""The doors beside the picture: a table of offsets, a mesh, or the main particulars alone, each to a BodyPlan."""
