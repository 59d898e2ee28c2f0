"""Which curve is which station: marks, labels, order and spacing."""
