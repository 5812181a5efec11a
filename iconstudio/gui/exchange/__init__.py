"""What comes into the window and what goes out: files, the clipboard, drags."""
