"""Which of the rarer laws act: all but springs, their friction, weight and anchors.

Every method is compiled in two variants. `System.rare` is None where none of these laws acts, and by its
type all that asks here is left out of the kernels when they are compiled; else it is 1, and the tables
tell. Both give the same bits, but where long ropes have windows, see `methods.window`: those with none of
these laws alone.
"""

from __future__ import annotations

from ropewalk.core.arrays import BENDING
from ropewalk.core.jit import part


@part
def has_bending(system):
    """Tell whether any rope has bending stiffness."""
    return system.rare is not None and system.flags[BENDING] == 1


@part
def has_elastic_laws(system):
    """Tell whether the tension of any segment is no straight line of its strain."""
    return system.rare is not None and system.elastic.time.shape[0] > 0


@part
def has_inner(system, state):
    """Tell whether any segment remembers anything."""
    return system.rare is not None and state.inner.shape[1] > 0


@part
def limits(system):
    """Tell whether the stretch is bounded."""
    return system.rare is not None and system.limiter.active == 1


@part
def winds(system, state):
    """Tell whether there is any winch."""
    return system.rare is not None and state.winch_exit.shape[0] > 0


@part
def has_clamps(system, state):
    """Tell whether any anchor holds the direction of a rope, too."""
    return system.rare is not None and state.moment.shape[0] > 0


@part
def are_tied(system):
    """Tell whether there is any joint."""
    return system.rare is not None and system.joints.member.shape[0] > 0


@part
def acts(system, k):
    """Tell whether law `k` of nodes acts."""
    return system.rare is not None and system.acts[k] == 1


@part
def any_acts(system):
    """Tell whether a law of nodes acts."""
    acting = 0
    if system.rare is not None:
        for k in range(system.acts.shape[0]):
            acting += system.acts[k]
    return acting > 0


@part
def parts(system):
    """Tell whether any rope can part."""
    return system.rare is not None and system.node.parting.strength.shape[0] > 0


@part
def acts_after(extras):
    """Tell whether winches or a limiter act on the end of a step; None: there is neither, as of `rare`."""
    return extras is not None and extras == 1
