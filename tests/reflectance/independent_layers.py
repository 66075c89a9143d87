"""A BRDF below a coat or below another BRDF, as `coat alpha=0.3 over diffuse kd=0.8`, for independent_values.py.

The layer transmits t(u) t(v) to the base, such that the albedo of this part is 1 - E(u) times that of the base, where E is
the albedo of the layer (renderer/MODELS.md). t is solved for at Gauss' places by fixed-point iteration, and follows at any
other angle from the same equation. All BRDFs have to be isotropic, and none has a mirror part. Nothing here is taken from
renderer/reflectance, which has a table of t by samples; what it interpolates differs by about a hundredth.
"""
import functools
from math import asin, cos, pi, sin, sqrt

from independent_basics import Direction, gauss_legendre
from independent_models import Instance, arguments, to_float, value_of

PLACES = 8
AZIMUTHS = 32


def azimuths():
    """Angles from the mirror direction and weights: the grid is the denser the nearer to it."""
    for k in range(AZIMUTHS):
        place = 2 * pi * (k + 0.5) / AZIMUTHS - pi
        yield (place - 0.9 * sin(place)) * 180 / pi, (1 - 0.9 * cos(place)) * 2 * pi / AZIMUTHS


def angles(edges):
    """Angles from the normal in degrees, with weights that make an integral over the solid angle with the cosine."""
    for low, high in zip(edges, edges[1:]):
        for place, weight in gauss_legendre(PLACES):
            theta = (low + high) / 2 + place * (high - low) / 2
            yield theta, weight * (high - low) / 2 * pi / 180 * sin(theta * pi / 180) * cos(theta * pi / 180)


class Layered:
    def __init__(self, text):
        top, _, base = text.partition(' over ')
        self.keyword, _, rest = top.partition(' ')
        self.base, self.tint, self.ior = Instance(base), (1, 1, 1), 1.5
        if self.keyword == 'coat':
            values = {'ior': '1.5', 'alpha': '0.1', 'tint': '1', **arguments(rest)}
            self.top = Instance(f"ggx alpha={values['alpha']} nreal={values['ior']}")
            tint, self.ior = value_of(values['tint']), to_float(values['ior'])
            self.tint = tint if isinstance(tint, tuple) else (tint,) * 3
        else:
            self.top = Instance(top)
        self.places = list(angles((0, 30, 60, 90)))
        self.known = functools.lru_cache(maxsize=None)(self.transmitted_from)
        self.solved = None

    def scattered(self, instance, theta, edges=None):
        """By place of the light, what is reflected from an angle to all azimuths, with the weight of the place."""
        u = Direction(theta, 0)
        for angle, weight in self.places if edges is None else angles(edges):
            total = [0.0, 0.0, 0.0]
            for turn, share in azimuths():
                value = instance.value(u, Direction(angle, 180 + turn))
                total = [a + share * b for a, b in zip(total, value)]
            yield [weight * part for part in total]

    def transmitted_from(self, theta):
        """By channel, 1 - E times the albedo of the base, and by place what the base reflects there."""
        edges = (0, theta, 90) if 0 < theta < 90 else (0, 45, 90)
        above = [sum(parts) for parts in zip(*self.scattered(self.top, theta, edges))]
        exact = [sum(parts) for parts in zip(*self.scattered(self.base, theta, edges))]
        row = list(self.scattered(self.base, theta))
        return [(1 - a) * b for a, b in zip(above, exact)], row

    def solve(self):
        rows = [self.known(theta) for theta, _ in self.places]
        self.solved = [[1.0] * 3 for _ in rows]
        for _ in range(60):
            reached = [[sum(t[k] * part[k] for t, part in zip(self.solved, row)) for k in range(3)] for _, row in rows]
            self.solved = [[sqrt(t[k] * wanted[k] / reach[k]) if reach[k] > 0 else 0.0 for k in range(3)]
                           for t, (wanted, _), reach in zip(self.solved, rows, reached)]

    def transmitted(self, theta):
        if self.solved is None:
            self.solve()
        wanted, row = self.known(round(theta * 180 / pi, 9))
        reached = [sum(t[k] * part[k] for t, part in zip(self.solved, row)) for k in range(3)]
        return [wanted[k] / reached[k] if reached[k] > 0 else 0.0 for k in range(3)]

    def clear(self, theta):
        inside = asin(sin(theta) / self.ior)
        return [tint ** (1 / (2 * cos(inside))) for tint in self.tint]

    def value(self, u, v):
        parts = zip(self.top.value(u, v), self.base.value(u, v), self.transmitted(u.theta), self.transmitted(v.theta),
                    self.clear(u.theta), self.clear(v.theta))
        return tuple(top + base * t_u * t_v * clear_u * clear_v for top, base, t_u, t_v, clear_u, clear_v in parts)

    def mirror(self, u):
        return 0.0, 0.0, 0.0
