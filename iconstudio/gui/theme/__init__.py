"""How the window looks: its colours, its style sheet and its own small icons."""
