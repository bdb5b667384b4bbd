"""Heights in text: USGS DEM and Esri ASCII."""
