"""GeoTIFF: tags, keys, and samples decoded natively."""
