#!/usr/bin/env python3
"""Writes the files of rgl/: measured BRDFs in the format of the RGL data base, made of analytic ones, and values.json.

The files follow Dupuy and Jakob 2018 ("An Adaptive Parameterization for Efficient Material Acquisition and Rendering"):
a table of visible half vectors warps a uniform square to half vectors, and the BRDF times the cosine, over the density of
the ideal microfacet sampler, is tabulated in that square. values.json has what the analytic BRDFs are worth at pairs of
directions. Nothing here is shared with the library. Usage: rgl_files.py [--check]
  --check  writes nothing, and fails unless the files are what this script would write.
"""
import json
import pathlib
import struct
import sys
from bisect import bisect_right
from math import cos, erf, exp, pi, sin, sqrt

FOLDER = pathlib.Path(__file__).resolve().parent / 'rgl'
UINT8, FLOAT32 = 1, 10


def direction(theta, phi):
    return (sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def reflect(u, m):
    """Mirrors u at a facet with the normal m."""
    return tuple(2 * dot(u, m) * b - a for a, b in zip(u, m))


class Facets:
    """Beckmann's distribution of facets with the shadowing function of Smith, in the form of Walter et al. 2007."""

    def __init__(self, along, across):
        self.along, self.across = along, across

    def ndf(self, m):
        if m[2] <= 0:
            return 0.0
        slope = ((m[0] / self.along) ** 2 + (m[1] / self.across) ** 2) / m[2] ** 2
        return exp(-slope) / (pi * self.along * self.across * m[2] ** 4)

    def lit(self, w):
        """The fraction of facets that are seen from w, of those that face it."""
        if w[2] <= 0:
            return 0.0
        rough = sqrt((self.along * w[0]) ** 2 + (self.across * w[1]) ** 2)
        if rough < 1e-9:
            return 1.0
        a = w[2] / rough
        return 2 / (1 + erf(a) + exp(-a * a) / (a * sqrt(pi)))

    def sigma(self, w):
        """The area of the facets that are seen from w, projected to w."""
        return max(w[2], 1e-9) / self.lit((w[0], w[1], max(w[2], 1e-9)))


class Gloss:
    """Facets that reflect all light to v, without shadows there: f cos(v) is D/(4 sigma) times a colour.

    The colour is `normal` per channel where u and the half vector are parallel, gets whiter with the angle between them,
    and is tinted by the half vector: `turn` makes it differ on both sides of u, and `x2` and `xy` along and across. Such
    slow functions of the half vector are interpolated well even where D is small.
    """

    def __init__(self, along, across, normal, turn=0.0, x2=0.0, xy=0.0):
        self.facets = Facets(along, across)
        self.normal, self.turn, self.x2, self.xy = normal, turn, x2, xy

    def times_cosine(self, u, v, m):
        rest = 0.2 * (1 - max(0.0, dot(u, m)))
        tint = 0.7 + self.turn * (u[0] * m[1] - u[1] * m[0]) + self.x2 * m[0] ** 2 + self.xy * m[0] * m[1]
        return [(f + (1 - f) * rest) * tint for f in self.normal]

    def value(self, u, v):
        total = [a + b for a, b in zip(u, v)]
        length = sqrt(dot(total, total))
        m = tuple(a / length for a in total)
        lobe = self.facets.ndf(m) / (4 * self.facets.sigma(u) * v[2])
        return [f * lobe for f in self.times_cosine(u, v, m)]


class Matte:
    """Lambert's BRDF. Its half vectors are those of wide facets, which are only a way to parameterise it."""

    def __init__(self, albedo):
        self.facets = Ellipsoid(0.7)
        self.albedo = albedo

    def times_cosine(self, u, v, m):
        # Below the horizon it goes on with negative values, so that interpolation across it is good.
        return [a / pi * v[2] * 4 * self.facets.sigma(u) / self.facets.ndf(m) for a in self.albedo]

    def value(self, u, v):
        return [a / pi for a in self.albedo]


class Ellipsoid:
    """The facets of an ellipsoid (Trowbridge and Reitz 1975), whose projected area is simple."""

    def __init__(self, rough):
        self.rough = rough

    def ndf(self, m):
        return self.rough ** 2 / (pi * (m[2] ** 2 * (self.rough ** 2 - 1) + 1) ** 2)

    def sigma(self, w):
        return (w[2] + sqrt(w[2] ** 2 + self.rough ** 2 * (1 - w[2] ** 2))) / 2


def half_vector(x, y, turn):
    theta = x * x * pi / 2
    return direction(theta, (2 * y - 1) * pi + turn), theta


class Warp:
    """The warp of a density that is bilinear between nodes, rows[y][x]; all by bisection of its integrals."""

    def __init__(self, rows):
        self.rows = rows
        self.across = [self.sums(row) for row in rows]
        self.up = self.sums([sums[-1] for sums in self.across])

    @staticmethod
    def sums(values):
        result = [0.0]
        for a, b in zip(values, values[1:]):
            result.append(result[-1] + (a + b) / 2)
        return result

    @staticmethod
    def find(values, sums, target):
        """The place where the integral of the function that is linear between `values` has reached `target`."""
        cell = min(max(bisect_right(sums, target) - 1, 0), len(values) - 2)
        a, b = values[cell], values[cell + 1]
        low, high = 0.0, 1.0
        for _ in range(60):
            t = (low + high) / 2
            if sums[cell] + t * a + t * t / 2 * (b - a) < target:
                low = t
            else:
                high = t
        return cell, low

    def point(self, x, y):
        row, up = self.find([sums[-1] for sums in self.across], self.up, y * self.up[-1])
        mixed = [(1 - up) * a + up * b for a, b in zip(self.rows[row], self.rows[row + 1])]
        sums = self.sums(mixed)
        column, along = self.find(mixed, sums, x * sums[-1])
        return (column + along) / (len(mixed) - 1), (row + up) / (len(self.rows) - 1)


def places(count):
    return [i / (count - 1) for i in range(count)]


def rows_of(width, height, function):
    return [[function(x, y) for x in places(width)] for y in places(height)]


def flat(nested):
    if isinstance(nested, list):
        return [value for inner in nested for value in flat(inner)]
    return [nested]


class File:
    """A tensor file that is being made."""

    def __init__(self):
        self.fields = []

    def add(self, name, shape, data, kind=FLOAT32):
        values = flat(data)
        count = 1
        for extent in shape:
            count *= extent
        assert count == len(values), name
        packed = bytes(values) if kind == UINT8 else struct.pack(f'<{count}f', *values)
        self.fields.append((name.encode(), kind, shape, packed))

    def bytes(self):
        head = b'tensor_file\0' + bytes([1, 0]) + struct.pack('<I', len(self.fields))
        offset = len(head) + sum(13 + len(name) + 8 * len(shape) for name, _, shape, _ in self.fields)
        data = b''
        for name, kind, shape, packed in self.fields:
            head += struct.pack('<H', len(name)) + name + struct.pack('<HBQ', len(shape), kind, offset + len(data))
            head += struct.pack(f'<{len(shape)}Q', *shape)
            data += packed
        return head + data


class Material:
    """A BRDF, and the resolution of its file; angles are in degrees."""

    def __init__(self, brdf, azimuths, angles, half_nodes, colour_nodes, wavelengths=None):
        self.brdf, self.azimuths, self.angles = brdf, azimuths, angles
        self.half_nodes, self.colour_nodes, self.wavelengths = half_nodes, colour_nodes, wavelengths
        self.isotropic = len(azimuths) == 1

    def view_tables(self, theta, phi):
        """Visible half vectors, luminance, and channels, of one view direction."""
        u = direction(theta, phi)
        turn = phi if self.isotropic else 0.0
        facets = self.brdf.facets

        def visible(x, y):
            m, theta_m = half_vector(x, y, turn)
            return max(0.0, dot(u, m)) * facets.ndf(m) * x * sin(theta_m)

        def channels(x, y):
            m, _ = half_vector(*warp.point(x, y), turn)
            return self.brdf.times_cosine(u, reflect(u, m), m)

        rows = rows_of(*self.half_nodes, visible)
        warp = Warp(rows)
        colours = rows_of(self.colour_nodes, self.colour_nodes, channels)
        luminance = [[max(0.0, sum(value)) for value in row] for row in colours]
        by_channel = [[[value[k] for value in row] for row in colours] for k in range(len(colours[0][0]))]
        return rows, luminance, by_channel

    def bytes(self, description):
        facets = self.brdf.facets
        angles = [theta * pi / 180 for theta in self.angles]
        azimuths = [phi * pi / 180 for phi in self.azimuths]
        tables = [[self.view_tables(theta, phi) for theta in angles] for phi in azimuths]
        visible, luminance, colours = ([[view[k] for view in row] for row in tables] for k in range(3))
        views = [len(azimuths), len(angles)]
        width, height = self.half_nodes
        channels = len(colours[0][0])

        def density(x, y):
            return facets.ndf(half_vector(x, y, 0)[0])

        def projected(x, y):
            w, _ = half_vector(x, y, 0)
            return facets.sigma(w)

        file = File()
        file.add('description', [len(description)], list(description.encode()), UINT8)
        file.add('phi_i', [len(azimuths)], azimuths)
        file.add('theta_i', [len(angles)], angles)
        azimuth_nodes = 2 if self.isotropic else 49
        for name, function in ('ndf', density), ('sigma', projected):
            file.add(name, [azimuth_nodes, 65], rows_of(65, azimuth_nodes, function))
        file.add('vndf', views + [height, width], visible)
        file.add('luminance', views + 2 * [self.colour_nodes], luminance)
        if self.wavelengths:
            file.add('wavelengths', [len(self.wavelengths)], self.wavelengths)
        name = 'spectra' if self.wavelengths else 'rgb'
        file.add(name, views + [channels] + 2 * [self.colour_nodes], colours)
        file.add('jacobian', [1], [1], UINT8)
        return file.bytes()


def bell(wavelength, centre, below, above):
    return exp(-((wavelength - centre) / (below if wavelength < centre else above)) ** 2 / 2)


def rgb_of_spectrum(wavelengths, values):
    """Linear sRGB under light of equal energy, balanced to white, by the observer of Wyman et al. 2013."""
    def between(wavelength):
        if wavelength <= wavelengths[0]:
            return values[0]
        for (l0, l1), (v0, v1) in zip(zip(wavelengths, wavelengths[1:]), zip(values, values[1:])):
            if wavelength <= l1:
                return v0 + (v1 - v0) * (wavelength - l0) / (l1 - l0)
        return values[-1]

    matrix = ((3.2406, -1.5372, -0.4986), (-0.9689, 1.8758, 0.0415), (0.0557, -0.2040, 1.0570))
    sums, whites = [0.0] * 3, [0.0] * 3
    for step in range(3600, 8301):
        l = step / 10
        xyz = (1.056 * bell(l, 599.8, 37.9, 31.0) + 0.362 * bell(l, 442.0, 16.0, 26.7) - 0.065 * bell(l, 501.1, 20.4, 26.2),
               0.821 * bell(l, 568.8, 46.9, 40.5) + 0.286 * bell(l, 530.9, 16.3, 31.1),
               1.217 * bell(l, 437.0, 11.8, 36.0) + 0.681 * bell(l, 459.0, 26.0, 13.8))
        for k in range(3):
            weight = dot(matrix[k], xyz)
            sums[k] += weight * between(l)
            whites[k] += weight
    return [a / b for a, b in zip(sums, whites)]


WAVELENGTHS = [380, 420, 460, 500, 530, 560, 590, 620, 660, 720]
COPPER = [0.45, 0.5, 0.52, 0.55, 0.58, 0.65, 0.8, 0.9, 0.94, 0.96]
ANGLES = [0, 12, 25, 38, 51, 63, 74, 83]
BRUSHED = Gloss(0.25, 0.5, (0.9, 0.6, 0.3), turn=0.25, xy=0.4)
MIRRORED = Gloss(0.25, 0.5, (0.9, 0.6, 0.3), x2=0.15)

MATERIALS = {
    'copper': Material(Gloss(0.35, 0.35, COPPER, turn=0.3), [0], ANGLES, (48, 32), 24, WAVELENGTHS),
    'matte': Material(Matte((1.0, 0.5, 0.1)), [0], ANGLES, (48, 32), 32),
    'brushed': Material(BRUSHED, [-180, -150, -120, -90, -60, -30, 0, 30, 60, 90, 120, 150, 180],
                        [0, 20, 40, 60, 78], (22, 21), 12),
    'brushed_half': Material(BRUSHED, [-180, -150, -120, -90, -60, -30, 0], [0, 20, 40, 60, 78], (22, 21), 12),
    'brushed_quarter': Material(MIRRORED, [-180, -165, -150, -135, -120, -105, -90], [0, 20, 40, 60, 78], (24, 24), 16),
}

# Angles of u and v in degrees. The first views are at nodes of all tables.
PAIRS = [
    (0, 0, 10, 20), (0, 0, 45, 130), (0, 0, 70, 250), (0, 0, 0, 0),
]
LIGHTS = [(5, 40), (20, 200), (35, 170), (45, 235), (60, 300), (70, 185)]


def pairs_of(material):
    """Pairs of directions: views at the nodes of the tables, and between them."""
    nodes = [material.angles[k] for k in (1, 2, 3)]
    azimuths = [30, -120] if not material.isotropic else [0, 77]
    at_nodes = PAIRS + [(theta, phi, *light) for theta in nodes for phi in azimuths for light in LIGHTS]
    between = [(theta, phi, *light) for theta in (7, 33, 56) for phi in (17, 100, 200, 295) for light in LIGHTS]
    return at_nodes, between


def values_of(material, pairs):
    lines = []
    for theta_u, phi_u, theta_v, phi_v in pairs:
        u = direction(theta_u * pi / 180, phi_u * pi / 180)
        v = direction(theta_v * pi / 180, phi_v * pi / 180)
        value = material.brdf.value(u, v)
        line = {'pair': [theta_u, phi_u, theta_v, phi_v]}
        if material.wavelengths:
            line['spectrum'] = [float(f'{channel:.6g}') for channel in value]
            value = rgb_of_spectrum(material.wavelengths, value)
        line['rgb'] = [float(f'{channel:.6g}') for channel in value]
        lines.append(line)
    return lines


def files():
    """All files by name."""
    result, table = {}, {}
    for name, material in MATERIALS.items():
        result[f'{name}.bsdf'] = material.bytes(f'{name} of rgl_files.py')
        at_nodes, between = pairs_of(material)
        table[name] = {'at_nodes': values_of(material, at_nodes), 'between': values_of(material, between)}
    lines = json.dumps(table).replace('{"pair"', '\n{"pair"')
    result['values.json'] = (lines + '\n').encode()
    return result


def main():
    made = files()
    if sys.argv[1:] == ['--check']:
        wrong = [name for name, data in made.items() if (FOLDER / name).read_bytes() != data]
        sys.exit(f'{FOLDER} is not what rgl_files.py writes: {", ".join(wrong)}' if wrong else 0)
    if sys.argv[1:]:
        sys.exit(__doc__)
    for name, data in made.items():
        (FOLDER / name).write_bytes(data)


main()
