"""Icons to look at and to pick from: the grid of results, lists, details."""
