"""From pieces to whole curves: one flow for all curves of a half, then smoothed and finished."""
