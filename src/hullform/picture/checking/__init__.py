"""What does not fit together in a reading, told as doubts."""
