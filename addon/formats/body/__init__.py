"""The shape of a body, and distances on it."""
