"""The picture as ink: files of every kind, the paper taken away, pixels mapped and counted."""
