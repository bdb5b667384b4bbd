"""Sub-panels of the tab, one file for each topic."""
