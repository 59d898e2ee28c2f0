"""From the picture of a body plan to its traced stations.

`reading.read_picture` and `overlay.draw_overlay` are the doors; nothing outside knows how they work.
"""
