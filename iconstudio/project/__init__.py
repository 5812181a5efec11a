"""The document: one file that holds the pages of all workflows, and its journal. No Qt."""
