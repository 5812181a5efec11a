"""What words mean, and which icons they may find."""
