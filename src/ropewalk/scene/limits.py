"""How large the numbers of a scene may be, how many its parts, and how many faults are told."""

#: Largest magnitude of any quantity; beyond it squares and products leave float64.
HUGE = 1e15
#: Smallest value of a quantity that must be positive; below it reciprocals leave float64.
TINY = 1e-12
#: Most segments a scene may have.
MOST_SEGMENTS = 10_000_000
#: Most segments that wait on a winch's drum.
MOST_ON_DRUM = 1_000_000
#: Faults told one by one; a scene with more of them is something else.
MOST_TOLD = 200
