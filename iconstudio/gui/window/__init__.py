"""The main window: its switch, menus, messages and preferences."""
