"""The paper's techniques, one a file. Arrays in, arrays out: no files, no processes, no Qt."""
