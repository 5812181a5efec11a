"""Brings files, drawings and images onto the pages of workflows, however they were given."""
