"""What the user's files say: one module a format, all JSON."""
