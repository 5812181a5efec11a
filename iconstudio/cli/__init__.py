"""The command line. Nothing here knows Qt."""
