"""What a person says of a half: more ink or less, and constraints of the tracing."""
