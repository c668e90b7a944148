"""What can be said about a scene before and after its run: stability, statics, checks, diagnosis."""
