"""The length of rope for a wanted tension, by scipy: a whole generation of designs in one call."""

import numpy as np
from scipy.optimize import differential_evolution

import ropewalk as rw

WANTED = 4.3  # N at most in the rope at rest


def run() -> tuple[float, float]:
    """The length [m] whose largest tension is the wanted one, and that tension [N]."""
    tension = rw.sweep.function("hanging-rope", ["rope.length"], "tension.max", what="rest")

    def miss(lengths: np.ndarray) -> np.ndarray:  # (D, N) as scipy gives them
        return np.abs(tension(lengths.T)[:, 0] - WANTED)

    found = differential_evolution(
        miss, [(10.5, 14.0)], vectorized=True, updating="deferred", rng=1, maxiter=20, popsize=10
    )
    return float(found.x[0]), float(tension(found.x)[0])


def check(found: tuple[float, float]) -> None:
    """The tension is the wanted one, and a longer and a shorter rope have another."""
    tension = rw.sweep.function("hanging-rope", ["rope.length"], "tension.max", what="rest")
    length, here = found
    assert abs(here - WANTED) < 1e-3
    shorter, longer = tension([[length - 0.1], [length + 0.1]])[:, 0]
    assert (shorter - WANTED) * (longer - WANTED) < 0.0


if __name__ == "__main__":
    best = run()
    print(f"{best[0]:.4f} m of rope: {best[1]:.4f} N")
    check(best)
