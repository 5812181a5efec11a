"""The workspace of workflows that have none of their own."""
