"""A cable that hangs between two points: what every closed form of its shape answers."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ropewalk.words.annotations import unquoted

Floats = NDArray[np.float64]


@unquoted
@dataclass(frozen=True)
class Cable:
    """A cable of constant weight per unstretched length, hung between two points.

    Seen in the upright plane through its ends: x [m] across gravity from the first end towards the
    second, z [m] upwards. With EA = inf it is the catenary, else Irvine's elastic catenary:

        x(s) = H s/EA + (H/w) [asinh(V/H) - asinh((V - w s)/H)]
        z(s) = -(s/EA) (V - w s/2) - (1/w) [sqrt(H^2 + V^2) - sqrt(H^2 + (V - w s)^2)]

    s the unstretched arc length from the first end. Source: Irvine, Cable Structures (1981),
    sec. 1.4; Irvine and Sinclair, Int. J. Solids Struct. 12 (1976) 309.
    """

    length: float  # unstretched [m]
    across: float  # horizontal distance of the ends [m]
    rise: float  # how much higher the second end is [m]
    weight: float  # per unstretched length [N/m]
    EA: float  # [N]
    horizontal: float  # H [N]
    vertical: float  # V, upward part of the first support's force on the cable [N]

    def position(self, s: ArrayLike) -> Floats:
        """Return x and z at unstretched arc lengths s [m], shape of s + (2,)."""
        s = np.asarray(s, dtype=np.float64)
        H, V, w = self.horizontal, self.vertical, self.weight
        end = V - w * s
        soft = s / self.EA
        if w == 0.0:
            ratio = s / self.length
            return np.stack([ratio * self.across, ratio * self.rise], axis=-1)
        x = H * soft
        if H > 0.0:
            x = x + H / w * asinh_difference(V / H, end / H, w * s / H)
        z = -soft * (V - 0.5 * w * s) - s * (V + end) / _sum(math.hypot(H, V), np.hypot(H, end))
        return np.stack([x, z], axis=-1)

    def tension(self, s: ArrayLike) -> Floats:
        """Return the tension at unstretched arc lengths s [m], (m,) or any shape: in N, of that shape."""
        s = np.asarray(s, dtype=np.float64)
        return np.asarray(np.hypot(self.horizontal, self.vertical - self.weight * s))

    @property
    def start_force(self) -> tuple[float, float]:
        """Force of the first support on the cable, across and up [N]."""
        return -self.horizontal, self.vertical

    @property
    def end_force(self) -> tuple[float, float]:
        """Force of the second support on the cable, across and up [N]."""
        return self.horizontal, self.weight * self.length - self.vertical

    @property
    def lowest(self) -> tuple[float, float, float]:
        """Arc length s, x and z of the lowest point [m]; an end where the cable hangs monotonely."""
        s = self.length / 2.0
        if self.weight > 0.0:
            s = min(max(self.vertical / self.weight, 0.0), self.length)
        elif self.rise != 0.0:
            s = 0.0 if self.rise > 0.0 else self.length
        x, z = self.position(s)
        return float(s), float(x), float(z)

    @property
    def sag(self) -> float:
        """Largest drop below the straight line between the ends [m]; below the lower end if plumb."""
        if self.across == 0.0 or self.weight == 0.0:
            return max(min(self.rise, 0.0) - self.lowest[2], 0.0)
        # Where the cable is parallel to the line: (V - w s)/H = -Y/X.
        s = (self.vertical + self.horizontal * self.rise / self.across) / self.weight
        x, z = self.position(min(max(s, 0.0), self.length))
        return float(x * self.rise / self.across - z)

    @property
    def stretched_length(self) -> float:
        """Length under its tension [m], L + (1/EA) times the integral of T ds."""
        H, V, w, L = self.horizontal, self.vertical, self.weight, self.length
        if math.isinf(self.EA):
            return L
        if w == 0.0:
            return L * (1.0 + _pull(self) / self.EA)
        end = V - w * L
        total = 0.5 * (V * math.hypot(H, V) - end * math.hypot(H, end)) / w
        if H > 0.0:
            total += 0.5 * H * H / w * float(asinh_difference(V / H, end / H, w * L / H))
        return L + total / self.EA

    @property
    def largest_tension(self) -> float:
        """Largest tension [N], at the higher end."""
        return float(self.tension([0.0, self.length]).max())


def _pull(cable: Cable) -> float:
    """Return the tension of a weightless cable [N]."""
    return math.hypot(cable.horizontal, cable.vertical)


def asinh_difference(a: ArrayLike, b: ArrayLike, step: ArrayLike) -> Floats:
    """Return asinh(a) - asinh(b) without loss of digits, given step = a - b >= 0."""
    a, b = np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64)
    p, q = a * np.sqrt(1.0 + b * b), b * np.sqrt(1.0 + a * a)
    same = a * b > 0.0
    safe = np.where(same, p + q, 1.0)
    return np.asarray(np.arcsinh(np.where(same, step * (a + b) / safe, p - q)))


def _sum(a: float, b: Floats) -> Floats:
    total = a + b
    return np.where(total > 0.0, total, 1.0)
