"""Line styles by example: *Curve Analogies* (Hertzmann et al. 2002)."""
