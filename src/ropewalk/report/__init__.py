"""The student report, claim by claim."""
