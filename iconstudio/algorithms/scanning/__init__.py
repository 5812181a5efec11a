"""From a photo of a pen drawing to black and white."""
