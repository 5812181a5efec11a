"""Line styles by example in the window (*Curve Analogies*)."""
