"""Workflows (section 4): generators that yield progress and finished results."""
