"""What only rasterio reads, where the person has it."""
