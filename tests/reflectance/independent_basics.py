"""Directions, quadrature and Fresnel's equations for independent_models.py: with angles, rotations and complex numbers.
Nothing here is taken from renderer/reflectance.
"""
import cmath
import functools
from math import acos, atan2, cos, hypot, pi, sin, sqrt


class Direction:
    """A unit vector by its angles from the normal and around it, in degrees."""

    def __init__(self, theta_degrees, phi_degrees):
        self.theta, self.phi = theta_degrees * pi / 180, phi_degrees * pi / 180
        self.x = sin(self.theta) * cos(self.phi)
        self.y = sin(self.theta) * sin(self.phi)
        self.z = cos(self.theta)

    def vector(self):
        return self.x, self.y, self.z


def dot(a, b):
    return sum(i * j for i, j in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def scaled(a, factor):
    return tuple(factor * i for i in a)


def added(a, b):
    return tuple(i + j for i, j in zip(a, b))


def unit(a):
    return scaled(a, 1 / sqrt(dot(a, a)))


def half_vector(u, v):
    return unit(added(u.vector(), v.vector()))


def angles_of_half(u, v):
    """Of the half vector, the angles from the normal, around it, and from both directions."""
    h = half_vector(u, v)
    return atan2(hypot(h[0], h[1]), h[2]), atan2(h[1], h[0]), acos(min(1, dot(h, v.vector())))


@functools.lru_cache(maxsize=None)
def gauss_legendre(count):
    """Places in [-1, 1] and weights, the places by Newton's method from Tricomi's estimate."""
    rule = []
    for i in range(count):
        x = cos(pi * (i + 0.75) / (count + 0.5))
        for _ in range(100):
            p, before = 1.0, 0.0
            for k in range(count):
                p, before = ((2 * k + 1) * x * p - k * before) / (k + 1), p
            slope = count * (x * p - before) / (x * x - 1)
            x -= p / slope
            if abs(p / slope) < 1e-15:
                break
        rule.append((x, 2 / ((1 - x * x) * slope * slope)))
    return rule


def rotated(a, axis, angle):
    """Rodrigues' rotation about an axis of length 1."""
    turned = cross(axis, a)
    along = dot(axis, a)
    return tuple(cos(angle) * i + sin(angle) * j + (1 - cos(angle)) * along * k for i, j, k in zip(a, turned, axis))


def merl_place(u, v):
    """Where a file of the MERL data base has this pair, in cells over theta_h, theta_d and phi_d (of 90, 90 and 180), as
    the data base's own reader finds it: phi_d of the light, after h was turned to the normal. None where h is the normal,
    or the directions are one, and an angle has no meaning."""
    theta_half, phi_half, theta_difference = angles_of_half(u, v)
    difference = rotated(rotated(v.vector(), (0, 0, 1), -phi_half), (0, 1, 0), -theta_half)
    if theta_half < 1e-6 or theta_difference < 1e-6:
        return None
    phi_difference = atan2(difference[1], difference[0]) % pi
    return 90 * sqrt(theta_half / (pi / 2)), 90 * theta_difference / (pi / 2), 180 * phi_difference / pi


def integral(function, low, high, pieces=1, count=32):
    width = (high - low) / pieces
    total = 0.0
    for i in range(pieces):
        centre = low + (i + 0.5) * width
        total += sum(w * function(centre + x * width / 2) for x, w in gauss_legendre(count))
    return total * width / 2


def root(function, low, high):
    """Where a rising function is 0."""
    for _ in range(50):
        middle = (low + high) / 2
        if function(middle) < 0:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def fresnel(incidence, nreal, nimag):
    """Fresnel's equations for unpolarised light from air, with Snell's law in complex numbers; n = 0 is a perfect
    conductor."""
    if nreal == 0:
        return 1.0
    index = complex(nreal, nimag)
    outside = cos(incidence)
    inside = cmath.sqrt(1 - (sin(incidence) / index) ** 2)
    senkrecht = (outside - index * inside) / (outside + index * inside)
    parallel = (index * outside - inside) / (index * outside + inside)
    return (abs(senkrecht) ** 2 + abs(parallel) ** 2) / 2


def schlick_fresnel(normal, incidence):
    return normal + (1 - normal) * (1 - cos(incidence)) ** 5


def mirror_angle(u, v):
    """Between u and the mirror direction of v."""
    return acos(max(-1, min(1, dot(u.vector(), (-v.x, -v.y, v.z)))))


def lobe(angle, exponent):
    return cos(angle) ** exponent if angle < pi / 2 else 0.0


@functools.lru_cache(maxsize=None)
def half_lobe_scale(exponent):
    """What makes the lobe cos(angle of h)^n reflect 1 at normal incidence, where h is at half of the light's angle."""
    reflected = integral(lambda t: cos(t / 2) ** exponent * cos(t) * 2 * pi * sin(t), 0, pi / 2, 16)
    return 1 / reflected
