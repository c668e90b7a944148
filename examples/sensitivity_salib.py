"""Which of the unknowns moves the tension? Sobol indices by SALib, from `rw.sweep.function`."""

from SALib.analyze import sobol as analyse
from SALib.sample import sobol as sample

import ropewalk as rw

PROBLEM = {
    "num_vars": 3,
    "names": ["rope.length", "rope.made_of.mass_per_length", "rope.made_of.EA"],
    "bounds": [[11.8, 12.2], [0.057, 0.069], [9.0e3, 1.1e4]],
}


def run() -> dict[str, float]:
    """The total index of each unknown, of the largest tension of a rope at rest."""
    tension = rw.sweep.function("hanging-rope", PROBLEM["names"], "tension.max", what="rest")
    points = sample.sample(PROBLEM, 32, calc_second_order=False, seed=1)
    found = analyse.analyze(PROBLEM, tension(points)[:, 0], calc_second_order=False, seed=1)
    return dict(zip(PROBLEM["names"], map(float, found["ST"]), strict=True))


def check(total: dict[str, float]) -> None:
    """The tension follows the mass most, by far: it is in proportion to it. The indices are whole."""
    assert total["rope.made_of.mass_per_length"] > 0.9
    assert total["rope.made_of.mass_per_length"] > 5.0 * total["rope.made_of.EA"]
    assert 0.9 < sum(total.values()) < 1.1, "next to no interaction"


if __name__ == "__main__":
    indices = run()
    for name, value in indices.items():
        print(f"{name:32} total index {value:.3f}")
    check(indices)
