"""Pictures of pixels from outside: photos to trace over, drawings to make icons of."""
