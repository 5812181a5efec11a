"""The window's document: the pages of all workspaces in one file, and their journal."""
