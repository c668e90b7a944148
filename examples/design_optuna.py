"""The best place of an anchor, by Optuna: asked for a batch of places, then told what their runs gave."""

import optuna

import ropewalk as rw

WANTED = 3.0  # m of sag: the farther away the second anchor, the less of it
PATH = "rope.shape.end[0]"


def run(rounds: int = 8, places: int = 8) -> tuple[float, float]:
    """How far off the second anchor is [m] where the rope sags by what is wanted, and its miss [m]."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    sag = rw.sweep.function("hanging-rope", [PATH], "sag[-1]", what="rest")
    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=1))
    for _ in range(rounds):
        asked = [study.ask() for _ in range(places)]
        distances = [[trial.suggest_float(PATH, 6.0, 11.0)] for trial in asked]
        for trial, found in zip(asked, sag(distances)[:, 0], strict=True):
            study.tell(trial, abs(float(found) - WANTED))
    return float(study.best_params[PATH]), float(study.best_value)


def check(found: tuple[float, float]) -> None:
    """The best place is a good one, and is one: at the ends of the range the rope sags otherwise."""
    sag = rw.sweep.function("hanging-rope", [PATH], "sag[-1]", what="rest")
    distance, miss = found
    assert abs(float(sag([distance])[0]) - WANTED) == miss < 0.1
    assert all(abs(float(value) - WANTED) > 2.0 * miss for value in sag([[6.0], [11.0]])[:, 0])


if __name__ == "__main__":
    best = run()
    print(f"second anchor at {best[0]:.3f} m: sag {WANTED} m, off by {1e3 * best[1]:.1f} mm")
    check(best)
