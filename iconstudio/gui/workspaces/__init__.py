"""The workspaces of the window: one for each workflow."""
