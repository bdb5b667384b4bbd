"""What is plugged in, for people; the servo's own devices are native code."""
