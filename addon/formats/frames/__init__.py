"""Where a grid lies, as texts beside it state: .prj files, corners, steps."""
