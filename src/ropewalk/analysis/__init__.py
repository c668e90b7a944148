"""What can be said about a scene before and after its run."""
