"""The workspaces of the window: one for each workflow of section 4."""
