"""From coloured drawings to pictograms of one tone."""
