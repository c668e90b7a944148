"""What acts on a simulation from outside while it runs: hands on anchors, and the drums of winches."""
