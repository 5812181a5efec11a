"""What the pointer does on the canvas: a tool is an object that lives through one use of it."""
