"""What is drawn in one half, before anybody says which curve it is: pieces of curve, deck edge, side."""
