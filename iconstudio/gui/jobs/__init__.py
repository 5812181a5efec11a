"""What takes long: threads, what runs in them, and when it runs again."""
