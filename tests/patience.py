"""How long tests wait for what has to come; what takes longer has failed. Machines can be very slow."""

PATIENCE = 300.0  # [s]
