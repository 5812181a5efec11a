"""Hybrids (section 4.3): icons are mixed at random."""
