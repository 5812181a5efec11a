"""Line styles by example (*Curve Analogies*)."""
