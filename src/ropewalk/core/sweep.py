"""The solution of a saddle-point system whose band is empty, from both ends of the chain at once.

A node and the tension of the segment before it are eliminated together; what they leave to the next node
and segment is a tuple (A, p, q, s, g, f): the node's block, column, row and pivot of the tension, and right
sides. `symmetric` and `leaning` hold the formulas for the two kinds of blocks. The two ends do not depend on
each other until they meet at the middle node: what is done to both is done to a `Twin`, two numbers in one
register.
"""

from __future__ import annotations

from types import ModuleType
from typing import Any

from ropewalk.core import leaning, symmetric
from ropewalk.core.jit import deferred, part
from ropewalk.core.twin import first, second, twin


def _to_the_middle(form: ModuleType) -> Any:
    """Return the part that goes from both ends to the middle with the pieces of a form."""
    nothing, row, rows, keep, keep_both = (
        form.nothing,
        form.row,
        form.rows,
        form.keep,
        form.keep_both,
    )
    add_node, respond, pass_on = form.add_node, form.respond, form.pass_on
    own, owns = form.own, form.owns
    firsts, seconds = form.firsts, form.seconds

    @part
    def _both_ends(saddle, middle):
        free, e = saddle.free, saddle.compliance
        across, along, misfit = saddle.across, saddle.along, saddle.misfit
        d0, d1, d2 = saddle.direction[0], saddle.direction[1], saddle.direction[2]
        r0, r1, r2 = saddle.force[0], saddle.force[1], saddle.force[2]
        z0, z1, z2 = saddle.moved[0], saddle.moved[1], saddle.moved[2]
        tension, factor = saddle.pulled, saddle.factor
        n = free.shape[0]
        both = nothing(twin(0.0, 0.0), twin(1.0, 1.0))
        for i in range(n - 1 - middle):
            h, j = n - 1 - i, n - 2 - i
            t = (twin(d0[i], -d0[j]), twin(d1[i], -d1[j]), twin(d2[i], -d2[j]))
            stiff = twin(across[i], across[j])
            bend = twin(along[i], along[j]) - stiff
            f = (twin(r0[i], r0[h]), twin(r1[i], r1[h]), twin(r2[i], r2[h]))
            both = add_node(both, owns(saddle, i, h), f, t, stiff, bend)
            m, w, y, pull = respond(both, twin(free[i], free[h]))
            keep_both(factor, i, h, m, w)
            z0[i], z1[i], z2[i] = first(y[0]), first(y[1]), first(y[2])
            z0[h], z1[h], z2[h] = second(y[0]), second(y[1]), second(y[2])
            if i > 0:
                tension[i - 1], tension[h] = first(pull), second(pull)
            gap = twin(misfit[i], misfit[j])
            both = pass_on(m, y, t, stiff, bend, twin(e[i], e[j]), rows(saddle, i, j, t), gap)
        one, other = firsts(both), seconds(both)
        for i in range(n - 1 - middle, middle):  # of an even number of nodes one is left
            t = (d0[i], d1[i], d2[i])
            bend = along[i] - across[i]
            one = add_node(one, own(saddle, i), (r0[i], r1[i], r2[i]), t, across[i], bend)
            m, w, y, pull = respond(one, free[i])
            keep(factor, i, m, w)
            z0[i], z1[i], z2[i] = y
            if i > 0:
                tension[i - 1] = pull
            one = pass_on(m, y, t, across[i], bend, e[i], row(saddle, i, t), misfit[i])
        return one, other

    return _both_ends


def _at_the_middle(form: ModuleType) -> Any:
    """Return the part that solves for the middle node and the tensions beside it."""
    join, respond, meet, own = form.join, form.respond, form.meet, form.own

    @part
    def _middle_node(saddle, i, one, other):
        force, tension, z = saddle.force, saddle.pulled, saddle.moved
        f = (force[0, i], force[1, i], force[2, i])
        m, w, y, pull = respond(join(one, other, own(saddle, i), f), saddle.free[i])
        if i < saddle.free.shape[0] - 1:  # the tension of the segment that comes from the other end
            against, moved = meet(m, y, other)
            p = other[1]
            tension[i] = against
            y = (y[0] - against * moved[0], y[1] - against * moved[1], y[2] - against * moved[2])
            pull -= against * (w[0] * p[0] + w[1] * p[1] + w[2] * p[2])
        z[0, i], z[1, i], z[2, i] = y
        if i > 0:
            tension[i - 1] = pull

    return _middle_node


def _to_the_ends(form: ModuleType) -> Any:
    """Return the part that puts each node's solution into the next one outward."""
    kept, kept_both, come_back = form.kept, form.kept_both, form.come_back

    @part
    def _go_back(saddle, middle):
        across, along = saddle.across, saddle.along
        d0, d1, d2 = saddle.direction[0], saddle.direction[1], saddle.direction[2]
        z0, z1, z2 = saddle.moved[0], saddle.moved[1], saddle.moved[2]
        tension, factor = saddle.pulled, saddle.factor
        n = across.shape[0] + 1
        x, y, z = z0[middle], z1[middle], z2[middle]
        Z = (twin(x, x), twin(y, y), twin(z, z))
        for i in range(middle - 1, 2 * middle - n, -1):
            h, j = 2 * middle - i, 2 * middle - i - 1
            t = (twin(d0[i], -d0[j]), twin(d1[i], -d1[j]), twin(d2[i], -d2[j]))
            stiff = twin(across[i], across[j])
            bend = twin(along[i], along[j]) - stiff
            pulled = twin(tension[i], tension[j])
            change, pull = come_back(kept_both(factor, i, h), Z, pulled, t, stiff, bend)
            Z = (
                twin(z0[i], z0[h]) + change[0],
                twin(z1[i], z1[h]) + change[1],
                twin(z2[i], z2[h]) + change[2],
            )
            z0[i], z1[i], z2[i] = first(Z[0]), first(Z[1]), first(Z[2])
            z0[h], z1[h], z2[h] = second(Z[0]), second(Z[1]), second(Z[2])
            if i > 0:
                tension[i - 1] += first(pull)
            if h < n - 1:
                tension[h] += second(pull)
        z = (first(Z[0]), first(Z[1]), first(Z[2]))
        for i in range(2 * middle - n, -1, -1):  # of an even number of nodes one is left
            t = (d0[i], d1[i], d2[i])
            bend = along[i] - across[i]
            change, pull = come_back(kept(factor, i), z, tension[i], t, across[i], bend)
            z0[i], z1[i], z2[i] = z0[i] + change[0], z1[i] + change[1], z2[i] + change[2]
            if i > 0:
                tension[i - 1] += pull

    return _go_back


_both_ends, _middle_node, _go_back = (
    make(symmetric) for make in (_to_the_middle, _at_the_middle, _to_the_ends)
)
_both_leaning, _middle_leaning, _go_back_leaning = (
    make(leaning) for make in (_to_the_middle, _at_the_middle, _to_the_ends)
)


@deferred()
def sweep(saddle):
    """Solve the equations; the solution is in `moved` and `pulled`, not finite where there is none."""
    middle = saddle.free.shape[0] // 2
    one, other = _both_ends(saddle, middle)
    _middle_node(saddle, middle, one, other)
    _go_back(saddle, middle)


@deferred()
def leaning_sweep(saddle):
    """As `sweep`, with `lean` and the blocks on the band's diagonal."""
    middle = saddle.free.shape[0] // 2
    one, other = _both_leaning(saddle, middle)
    _middle_leaning(saddle, middle, one, other)
    _go_back_leaning(saddle, middle)
    tension, z, lean = saddle.pulled, saddle.moved, saddle.lean
    for k in range(3):
        row, zk = lean[k], z[k]
        for j in range(tension.shape[0]):
            tension[j] -= row[j] * (zk[j + 1] - zk[j])
