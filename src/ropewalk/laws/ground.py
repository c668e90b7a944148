"""Ground as in NeHe's lesson 40, for any direction of up.

Only for nodes strictly below the height: slide friction -c_s v_t (viscous, whatever the load), absorption
-c_a v_n only while sinking, repulsion k_g times the depth upward. Conservative part: U = k_g depth^2 / 2,
counted in the work of the ground, not in the elastic energy.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel


@kernel
def ground_forces(x, v, ground, force):
    """Write the force of the ground on every node [N], (3, n)."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    for i in range(x.shape[1]):
        depth = ground.height - (x[0, i] * ux + x[1, i] * uy + x[2, i] * uz)
        touching = 1.0 if depth > 0.0 else 0.0
        rise = v[0, i] * ux + v[1, i] * uy + v[2, i] * uz
        sinking = rise if rise < 0.0 else 0.0
        slide = touching * ground.friction
        push = touching * (ground.repulsion * depth - ground.absorption * sinking)
        force[0, i] = push * ux - slide * (v[0, i] - rise * ux)
        force[1, i] = push * uy - slide * (v[1, i] - rise * uy)
        force[2, i] = push * uz - slide * (v[2, i] - rise * uz)
