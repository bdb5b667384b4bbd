"""Sizes in bytes, for people."""


def in_bytes(size: int) -> str:
    """Write a size out in the largest unit that it fills."""
    for unit, bytes_ in (("GB", 10**9), ("MB", 10**6), ("kB", 10**3)):
        if size >= bytes_:
            return f"{size / bytes_:,.1f} {unit}"
    return f"{size} bytes"
