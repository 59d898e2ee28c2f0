"""The offline report: one HTML file and its figures, out of a finished run."""
