"""What the scripts for pipelines share: arguments, exit codes, summaries, scenes."""
