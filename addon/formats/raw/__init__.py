"""Raw samples with a small header beside them, or none: EHdr, GridFloat, ENVI, SRTM, GTOPO30."""
