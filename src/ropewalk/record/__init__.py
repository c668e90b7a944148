"""What a run leaves: results in memory, run folders, tables."""
