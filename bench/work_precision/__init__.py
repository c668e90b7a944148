"""Error against computing time, for every method of Ropewalk, numpy and scipy: `make work-precision`."""
