"""What a measured sag says of a rope's length: a posterior by emcee, all walkers of a step in one call."""

import emcee
import numpy as np

import ropewalk as rw

SAG, ERROR = 3.8, 0.02  # m, measured and its standard deviation
LOW, HIGH = 10.0, 15.0  # m, what the length may be


def run(steps: int = 150) -> np.ndarray:
    """Draw lengths [m] from the posterior: a flat prior, a measured sag with a normal error."""
    sag = rw.sweep.function("hanging-rope", ["rope.length"], "sag[-1]", what="rest")

    def log_probability(lengths: np.ndarray) -> np.ndarray:
        inside = (lengths[:, 0] > LOW) & (lengths[:, 0] < HIGH)
        found = np.full(len(lengths), -np.inf)
        found[inside] = -0.5 * ((sag(lengths[inside])[:, 0] - SAG) / ERROR) ** 2
        return np.nan_to_num(found, nan=-np.inf)  # a run that broke

    sampler = emcee.EnsembleSampler(8, 1, log_probability, vectorize=True)
    dice = np.random.default_rng(1)
    sampler.random_state = np.random.RandomState(1).get_state()
    sampler.run_mcmc(dice.uniform(11.5, 13.0, (8, 1)), steps)
    return np.asarray(sampler.get_chain(discard=steps // 3, flat=True)[:, 0])


def check(lengths: np.ndarray) -> None:
    """The mean of the posterior hangs as deep as was measured, its spread is the error over the slope."""
    sag = rw.sweep.function("hanging-rope", ["rope.length"], "sag[-1]", what="rest")
    middle = float(lengths.mean())
    below, here, above = sag([[middle - 0.01], [middle], [middle + 0.01]])[:, 0]
    assert abs(here - SAG) < 3.0 * ERROR
    assert 0.5 < lengths.std() / (ERROR * 0.02 / (above - below)) < 2.0


if __name__ == "__main__":
    drawn = run()
    print(f"length {drawn.mean():.4f} m, standard deviation {drawn.std():.4f} m")
    check(drawn)
