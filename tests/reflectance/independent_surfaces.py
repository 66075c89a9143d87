"""The models of independent_models.py that are more than a formula: series of wave optics, and rays that meet cylinders.
"""
import functools
from math import asin, atan2, cos, erfc, exp, hypot, lgamma, log, pi, sin, sqrt, tan

from independent_basics import (added, angles_of_half, cross, dot, fresnel, half_lobe_scale, half_vector, integral, root,
                                scaled)

# Wave optics. Lengths are in micrometres, wavelengths in nanometres.

def wave_series(g, b):
    """sum of g^m e^-g / (m! m) e^(-b/m), term by term until they have fallen behind the largest."""
    if g == 0:
        return 0.0
    total, m, before = 0.0, 1, 0.0
    while True:
        term = exp(m * log(g) - g - lgamma(m + 1) - log(m) - b / m)
        total += term
        if term <= before and term < 1e-13 * total or m > 40 * (1 + g + b):
            return total
        before, m = term, m + 1


def hidden_slope(w, p):
    return 0.0 if w.theta == 0 else tan(w.theta) * erfc(p.tau / (2 * p.sigma) / tan(w.theta))


def paper_roughness(p, u, v):
    """He's effective roughness: from the root of sqrt(pi/2) z = sigma/4 (Ki + Kr) exp(-z^2/(2 sigma^2))."""
    slopes = hidden_slope(u, p) + hidden_slope(v, p)
    if slopes < 1e-15:
        return p.sigma
    z = root(lambda z: sqrt(pi / 2) * z - p.sigma / 4 * slopes * exp(-z * z / (2 * p.sigma ** 2)), 0,
             p.sigma * (1 + slopes))
    return p.sigma / sqrt(1 + (z / p.sigma) ** 2)


def own_roughness(p, u, v):
    return p.sigma


def wave_shadowing(w, p):
    if w.theta == 0:
        return 1.0
    cot = 1 / tan(w.theta)
    hidden = erfc(p.tau * cot / (2 * p.sigma))
    rough = (2 * p.sigma / (sqrt(pi) * p.tau * cot) - hidden) / 2
    return (1 - hidden / 2) / (rough + 1)


def polarisation_geometry(u, v):
    """He's G for unpolarised light, from the vectors of s and p polarisation."""
    into, out = scaled(v.vector(), -1), u.vector()
    change = added(out, scaled(into, -1))
    across = cross(out, into)
    if dot(across, across) < 1e-16:
        return (dot(change, change) / change[2]) ** 2

    def axes(k):
        s = (sin(atan2(k[1], k[0])), -cos(atan2(k[1], k[0])), 0)
        return s, cross(s, k)
    s_in, p_in = axes(into)
    s_out, p_out = axes(out)
    scattered = dot(s_out, into) ** 2 + dot(p_out, into) ** 2
    incident = dot(s_in, out) ** 2 + dot(p_in, out) ** 2
    return (dot(change, change) / change[2]) ** 2 * scattered * incident / dot(across, across) ** 2


def wave_lobe(p, u, v, roughness):
    if p.sigma == 0:
        return p.kd / pi
    wavelength = p['lambda'] / 1000
    sigma = roughness(p, u, v)
    change = added(u.vector(), v.vector())
    g = (2 * pi * sigma / wavelength * change[2]) ** 2
    b = (pi * p.tau / wavelength) ** 2 * (change[0] ** 2 + change[1] ** 2)
    diffraction = (pi * p.tau / (2 * wavelength)) ** 2 * wave_series(g, b)
    beta = angles_of_half(u, v)[2]
    shadowing = wave_shadowing(u, p) * wave_shadowing(v, p)
    directional = fresnel(beta, p.nreal, p.nimag) * polarisation_geometry(u, v) * shadowing * diffraction / (
        pi * cos(u.theta) * cos(v.theta))
    return p.ks * directional + p.kd / pi


def wave_mirror(p, u, roughness):
    if p.sigma == 0:
        return p.ks * fresnel(u.theta, p.nreal, p.nimag)
    g = (4 * pi * roughness(p, u, u) * cos(u.theta) / (p['lambda'] / 1000)) ** 2
    return p.ks * fresnel(u.theta, p.nreal, p.nimag) * wave_shadowing(u, p) ** 2 * exp(-g)


def he(p, u, v):
    return wave_lobe(p, u, v, paper_roughness)


def he_mirror(p, u):
    return wave_mirror(p, u, paper_roughness)


def westin(p, u, v):
    return wave_lobe(p, u, v, own_roughness)


def westin_mirror(p, u):
    return wave_mirror(p, u, own_roughness)


# Parallel cylinders, cut across: circles of radius 1 whose centres are d apart on a line, and a floor h above it.

class Grooves:
    """One period of the profile: the arc of a circle about its top, and the floor to the next circle."""

    def __init__(self, d, h):
        self.d, self.h = d, h
        half_width = sqrt(1 - h * h)
        self.steepest = asin(min(1, half_width, d / 2))
        self.floor = (half_width, max(half_width, d - half_width))

    def sees(self, point, normal, psi):
        """Whether a ray from a point of the profile at the angle psi from the vertical leaves it."""
        ray = (sin(psi), cos(psi))
        if normal[0] * ray[0] + normal[1] * ray[1] <= 0:
            return False
        for k in range(-2, 4):
            centre = (k * self.d - point[0], -point[1])
            along = centre[0] * ray[0] + centre[1] * ray[1]
            beside = abs(centre[0] * ray[1] - centre[1] * ray[0])
            # The circle that contains the point cannot occlude it: a ray only touches it.
            on_it = abs(hypot(*centre) - 1) < 1e-12
            if not on_it and along > 0 and beside < 1:
                return False
        return True

    def arc_point(self, a):
        return (sin(a), cos(a)), (sin(a), cos(a))

    def floor_point(self, y):
        return (y, self.h), (0.0, 1.0)

    def seen(self, at, low, high, psi, count):
        """The stretch of a part of the profile that is seen, its ends by bisection; None if nothing is."""
        if not high > low:
            return None
        step = (high - low) / count
        places = [low + (i + 0.5) * step for i in range(count)]
        visible = [place for place in places if self.sees(*at(place), psi)]
        if not visible:
            return None

        def end(inner, outer):
            for _ in range(45):
                middle = (inner + outer) / 2
                inner, outer = (middle, outer) if self.sees(*at(middle), psi) else (inner, middle)
            return inner
        first, last = visible[0], visible[-1]
        return end(first, max(low, first - step)), end(last, min(high, last + step))

    @functools.lru_cache(maxsize=None)
    def seen_from(self, psi, count):
        return (self.seen(self.arc_point, -self.steepest, self.steepest, psi, count),
                self.seen(self.floor_point, *self.floor, psi, count))


grooves_of = functools.lru_cache(maxsize=None)(Grooves)


def common(one, other):
    if one is None or other is None:
        return 0.0, 0.0
    return max(one[0], other[0]), min(one[1], other[1])


def poulin(p, u, v, count=100, nodes=64):
    h = half_vector(u, v)
    scale = half_lobe_scale(p.n)

    def element(m):
        """A piece of the surface with that normal."""
        return p.kd / pi + p.ks * scale * max(0.0, dot(m, h)) ** p.n

    def on_arc(a):
        m = (0.0, sin(a), cos(a))
        return element(m) * max(0.0, dot(u.vector(), m)) * max(0.0, dot(v.vector(), m))
    surface = grooves_of(p.d, p.h)
    of_u = surface.seen_from(round(atan2(u.y, u.z), 14), count)
    of_v = surface.seen_from(round(atan2(v.y, v.z), 14), count)
    low, high = common(of_u[0], of_v[0])
    arc = integral(on_arc, low, high, 1, nodes) if high > low else 0.0
    low, high = common(of_u[1], of_v[1])
    floor = max(0.0, high - low) * element((0.0, 0.0, 1.0)) * u.z * v.z
    return (arc + floor) / (p.d * u.z * v.z)
