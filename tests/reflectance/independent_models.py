"""The BRDF models as their papers have them, in double precision and without any care for speed.

Nothing here is taken from renderer/reflectance: angles where that has vectors, complex numbers for Fresnel's
equations, series term by term, roots by bisection, normalisations by quadrature, and for `poulin` rays that meet
circles. Each model is a function of its parameters (one colour channel) and of the directions u, to the eye, and v,
to the light; its value is in 1/sr, without the Dirac part, which is in MIRRORS.
"""
import cmath
import functools
import operator
import struct
from math import acos, asin, atan2, cos, erfc, exp, hypot, pi, sin, sqrt, tan

from independent_basics import (added, angles_of_half, dot, fresnel, half_lobe_scale, integral, lobe, mirror_angle,
                                schlick_fresnel, unit)
from independent_surfaces import he, he_mirror, poulin, westin, westin_mirror


def black(p, u, v):
    return 0.0


def diffuse(p, u, v):
    return p.kd / pi


def minnaert(p, u, v):
    return p.kd / pi * (cos(u.theta) * cos(v.theta)) ** (p.k - 1)


def phong(p, u, v):
    return p.kd / pi + p.ks * lobe(mirror_angle(u, v), p.n)


def blinn(p, u, v):
    return p.kd / pi + p.ks * lobe(angles_of_half(u, v)[0], p.n)


def lewis(p, u, v):
    return p.kd / pi + p.ks * (p.n + 2) / (2 * pi) * lobe(mirror_angle(u, v), p.n)


def ward(p, u, v):
    delta, phi, _ = angles_of_half(u, v)
    slopes = (cos(phi) / p.sx) ** 2 + (sin(phi) / p.sy) ** 2
    return p.kd / pi + p.ks * exp(-tan(delta) ** 2 * slopes) / (
        4 * pi * p.sx * p.sy * sqrt(cos(u.theta) * cos(v.theta)))


def torrance(p, u, v):
    delta, _, beta = angles_of_half(u, v)
    facets = exp(-(tan(delta) / p.rough) ** 2) / (p.rough ** 2 * cos(delta) ** 4)
    grooves = min(1, 2 * cos(delta) * cos(u.theta) / cos(beta), 2 * cos(delta) * cos(v.theta) / cos(beta))
    return p.kd / pi + p.ks * facets * grooves * fresnel(beta, p.nreal, p.nimag) / (
        4 * pi * cos(u.theta) * cos(v.theta))


def schlick_layer(u, v, r, p):
    def seen(angle):
        return cos(angle) / (r - r * cos(angle) + cos(angle))
    delta, phi, _ = angles_of_half(u, v)
    t, w = cos(delta), abs(cos(phi))
    if delta == 0:
        w = sqrt(p / (1 + p))  # h = n has no azimuth: by convention, where the factor is 1
    zenith = r / (1 + r * t ** 2 - t ** 2) ** 2
    azimuth = sqrt(p / (p ** 2 - p ** 2 * w ** 2 + w ** 2))
    both = seen(u.theta) * seen(v.theta)
    return (both * azimuth * zenith + 1 - both) / (4 * pi * cos(u.theta) * cos(v.theta))


def schlick(p, u, v):
    beta = angles_of_half(u, v)[2]
    first = schlick_fresnel(p.SC, beta)
    value = first * schlick_layer(u, v, p.Sr, p.Sp) if p.Sr > 0 else 0.0
    if p.Ly and p.Dr > 0:
        value += (1 - first) * schlick_fresnel(p.DC, beta) * schlick_layer(u, v, p.Dr, p.Dp)
    return value


def schlick_mirror(p, u):
    first = schlick_fresnel(p.SC, u.theta)
    value = first if p.Sr == 0 else 0.0
    if p.Ly and p.Dr == 0:
        value += (1 - first) * schlick_fresnel(p.DC, u.theta)
    return value


def oren(p, u, v):
    alpha, beta = max(u.theta, v.theta), min(u.theta, v.theta)
    turn = cos(u.phi - v.phi)
    s2 = p.s ** 2
    c1 = 1 - 0.5 * s2 / (s2 + 0.33)
    if turn >= 0:
        c2 = 0.45 * s2 / (s2 + 0.09) * sin(alpha)
    else:
        c2 = 0.45 * s2 / (s2 + 0.09) * (sin(alpha) - (2 * beta / pi) ** 3)
    c3 = 0.125 * s2 / (s2 + 0.09) * (4 * alpha * beta / pi ** 2) ** 2
    direct = c1 + turn * c2 * tan(beta) + (1 - abs(turn)) * c3 * tan((alpha + beta) / 2)
    between = 0.17 * s2 / (s2 + 0.13) * (1 - turn * (2 * beta / pi) ** 2)
    return max(0.0, p.r / pi * direct + p.r ** 2 / pi * between)


def fon_albedo(rough, theta):
    scale = 1 / (1 + (1 / 2 - 2 / (3 * pi)) * rough)
    slope = sin(theta) * (theta - sin(theta) * cos(theta))
    slope += 2 / 3 * (tan(theta) * (1 - sin(theta) ** 3) - sin(theta))
    return scale * (1 + rough / pi * slope)


def eon(p, u, v):
    if p.rough == 0:
        return p.kd / pi
    s = sin(u.theta) * sin(v.theta) * cos(u.phi - v.phi)
    t = max(cos(u.theta), cos(v.theta)) if s > 0 else 1
    scale = 1 / (1 + (1 / 2 - 2 / (3 * pi)) * p.rough)
    single = p.kd / pi * scale * (1 + p.rough * s / t)
    mean = scale * (1 + (2 / 3 - 28 / (15 * pi)) * p.rough)
    colour = p.kd ** 2 * mean / (1 - p.kd * (1 - mean))
    return single + colour / pi * (1 - fon_albedo(p.rough, u.theta)) * (1 - fon_albedo(p.rough, v.theta)) / (1 - mean)


def schlick_of(normal, cosine):
    return normal + (1 - normal) * (1 - cosine) ** 5


# By power of s and of alpha, and that of the grazing part: the fit is of this project, and part of the model.
# ggx_test compares it with what it is a fit to.
MISSING = [(0, 2.378, 49.321, 8.092), (10.432, -24.078, -150.165, -112.998), (-29.369, 60.822, 186.681, 315.358),
           (28.639, -56.561, -108.613, -338.756), (-9.438, 16.757, 27.192, 128.04)]
MEAN_MISSING = (0.2721, 1.10382, -0.40785, 1.06386, -0.32809)


def ggx_missing(theta, alpha):
    s = alpha / (alpha + cos(theta))
    fit = (1 - s) * sum(a * s ** i * alpha ** j for i, row in enumerate(MISSING) for j, a in enumerate(row))
    return max(0, s ** 2 * (fit + 0.084 * alpha * (sqrt(1 - s) - (1 - s))))


def ggx(p, u, v):
    less = 1 - p.anisotropy
    ax = p.alpha * sqrt(2 / (1 + less ** 2))
    ay = max(1e-4, p.ay * less * sqrt(2 / (1 + less ** 2)))
    alpha = sqrt((ax ** 2 + ay ** 2) / 2)

    def hidden(w):
        slope2 = (ax * cos(w.phi - p.rotation)) ** 2 + (ay * sin(w.phi - p.rotation)) ** 2
        return (sqrt(1 + slope2 * tan(w.theta) ** 2) - 1) / 2
    delta, phi, beta = angles_of_half(u, v)
    slopes = (cos(phi - p.rotation) / ax) ** 2 + (sin(phi - p.rotation) / ay) ** 2
    facets = 1 / (pi * ax * ay * cos(delta) ** 4 * (1 + tan(delta) ** 2 * slopes) ** 2)
    facets /= 4 * cos(u.theta) * cos(v.theta) * (1 + hidden(u) + hidden(v))
    if any(channel > 0 for channel in p.of_all_channels['F0']):
        normal, at_82 = p.F0, p.F82 * schlick_of(p.F0, 1 / 7)
    else:
        normal, at_82 = fresnel(0, p.nreal, p.nimag), fresnel(acos(1 / 7), p.nreal, p.nimag)
    dip = (schlick_of(normal, 1 / 7) - at_82) / (1 / 7 * (6 / 7) ** 6)
    if any(channel > 0 for channel in p.of_all_channels['F0']):
        reflectance = max(0, schlick_of(normal, cos(beta)) - dip * cos(beta) * (1 - cos(beta)) ** 6)
    else:
        reflectance = fresnel(beta, p.nreal, p.nimag)
    lobe_value = reflectance * facets
    if p.scattering == 'scaled':
        fit = ggx_missing(u.theta, alpha)
        missing = fit + 0.0025 * fit / (fit + 0.02)
        lobe_value *= 1 + normal * missing / (1 - missing)
    if p.scattering == 'reciprocal':
        mean = 1 - alpha ** 2 / sum(a * alpha ** i for i, a in enumerate(MEAN_MISSING))
        all_angles = min(1, max(0, normal + (1 - normal) / 21 - dip / 126))
        leaves = all_angles ** 2 * mean / (1 - all_angles * (1 - mean))
        lobe_value += leaves * ggx_missing(u.theta, alpha) * ggx_missing(v.theta, alpha) / (pi * (1 - mean))
    return p.ks * lobe_value


def rgb_of_wavelength(wavelength):
    """Linear sRGB of the CIE 1931 observer by Wyman, Sloan and Shirley (2013)."""
    def part(factor, centre, below, above):
        return factor * exp(-((wavelength - centre) / (below if wavelength < centre else above)) ** 2 / 2)
    x = part(1.056, 599.8, 37.9, 31) + part(0.362, 442, 16, 26.7) + part(-0.065, 501.1, 20.4, 26.2)
    y = part(0.821, 568.8, 46.9, 40.5) + part(0.286, 530.9, 16.3, 31.1)
    z = part(1.217, 437, 11.8, 36) + part(0.681, 459, 26, 13.8)
    return {'red': 3.2406 * x - 1.5372 * y - 0.4986 * z, 'green': -0.9689 * x + 1.8758 * y + 0.0415 * z,
            'blue': 0.0557 * x - 0.204 * y + 1.057 * z}


def film_at(p, theta, wavelength):
    """By the characteristic matrix of the film (Born and Wolf, "Principles of Optics", 1.6)."""
    inside, base = asin(sin(theta) / p.film), complex(p.nreal, p.nimag)
    base_cosine = cmath.sqrt(1 - (sin(theta) / base) ** 2)
    delay = 2 * pi / wavelength * p.film * p.thickness * cos(inside)
    total = 0
    for outer, film, under in ((cos(theta), p.film * cos(inside), base * base_cosine),
                               (1 / cos(theta), p.film / cos(inside), base / base_cosine)):
        first = cos(delay) - 1j * sin(delay) * under / film
        second = -1j * film * sin(delay) + cos(delay) * under
        total += abs((outer * first - second) / (outer * first + second)) ** 2 / 2
    return total


@functools.lru_cache(maxsize=None)
def film_reflectance(p, theta):
    numbers = [1 / 720 + i / 27 * (1 / 385 - 1 / 720) for i in range(28)]
    weights = [rgb_of_wavelength(1 / number)[p.channel] / number ** 2 for number in numbers]
    values = [film_at(p, theta, 1 / number) for number in numbers]
    return min(1, max(0, sum(map(operator.mul, weights, values)) / sum(weights)))


def thinfilm(p, u, v):
    white = Parameters(alpha=p.alpha, ay=p.ay, anisotropy=0, rotation=0, F0=1, F82=1, ks=1, scattering='single',
                       of_all_channels={'F0': (1,)})
    alpha = sqrt((p.alpha ** 2 + p.ay ** 2) / 2)
    mean = 1 - alpha ** 2 / sum(a * alpha ** i for i, a in enumerate(MEAN_MISSING))
    all_angles = sum(film_reflectance(p, acos(sqrt(0.5 + side / sqrt(12)))) for side in (-1, 1)) / 2
    leaves = all_angles ** 2 * mean / (1 - all_angles * (1 - mean))
    further = leaves * ggx_missing(u.theta, alpha) * ggx_missing(v.theta, alpha) / (pi * (1 - mean))
    return p.ks * (film_reflectance(p, angles_of_half(u, v)[2]) * ggx(white, u, v) + further)


# The fits of what facets with Schlick's second part reflect; gltf_test compares them with quadrature.
GRAZING_LEAST = (1.0165, 0.3781, -2.2341, 1.3077)
GRAZING = ((-1.366, 4.6269, -2.7931), (7.0018, -26.2794, 18.4785), (-8.7116, 30.7108, -22.2822))


def grazing_cosine(theta, alpha):
    c, root = cos(theta), sqrt(alpha)
    least = sum(a * root ** (1.5 + i) for i, a in enumerate(GRAZING_LEAST))
    place = hypot(c, least) + sum(a * c ** (i + 1) * root ** (j + 1) for i, row in enumerate(GRAZING) for j, a in enumerate(row))
    return min(1, max(0, place))


def ggx_grazing(theta, alpha):
    return (1 - grazing_cosine(theta, alpha)) ** 5 * (1 - ggx_missing(theta, alpha))


def white_facets(u, v, ax, ay, rotation):
    return ggx(Parameters(alpha=ax, ay=ay, anisotropy=0, rotation=rotation, F0=1, F82=1, ks=1, scattering='single',
                          of_all_channels={'F0': (1,)}), u, v)


def gltf_normals(p):
    return [min(1, ((p.ior - 1) / (p.ior + 1)) ** 2 * colour) * p.specular for colour in p.of_all_channels['specularColor']]


@functools.lru_cache(maxsize=None)
def gltf_films(p):
    """By metal and channel, the film over a dielectric of the same reflectance at normal incidence."""
    def film(normal, colour):
        root = min(0.995, max(0.01, sqrt(normal)))
        return Parameters(film=p.iridescenceIor, thickness=p.filmThickness, nreal=(1 + root) / (1 - root), nimag=0, channel=colour)
    films = {(True, colour): film(base, colour) for colour, base in zip(COLOURS, p.of_all_channels['baseColor'])}
    if p.specular > 0:
        films.update({(False, colour): film(normal / p.specular, colour) for colour, normal in zip(COLOURS, gltf_normals(p))})
    return films


def gltf(p, u, v):
    across = max(1e-4, p.roughness ** 2)
    along = across + (1 - across) * p.anisotropy ** 2
    alpha = sqrt((along ** 2 + across ** 2) / 2)
    least = alpha ** 2 / sum(a * alpha ** i for i, a in enumerate(MEAN_MISSING))

    def schlick(normal, grazing, angle):
        return normal + (grazing - normal) * (1 - cos(angle)) ** 5

    def filmed(normal, grazing, angle, metal=False, colour=p.channel):
        bare = schlick(normal, grazing, angle)
        if p.iridescence == 0 or grazing == 0:
            return bare
        return interpolated(bare, grazing * film_reflectance(gltf_films(p)[metal, colour], angle), p.iridescence)

    def mean_of(normal, grazing, metal=False, colour=p.channel):
        mean = normal + (grazing - normal) / 21
        if p.iridescence == 0 or grazing == 0:
            return mean
        film = gltf_films(p)[metal, colour]
        covered = sum(film_reflectance(film, acos(sqrt(0.5 + side / sqrt(12)))) for side in (-1, 1)) / 2
        return interpolated(mean, grazing * covered, p.iridescence)

    def leaves(mean):
        return mean ** 2 * (1 - least) / (1 - mean * least)

    def facets(theta, a, normal, grazing, further):
        missing = ggx_missing(theta, a)
        return normal * (1 - missing) + (grazing - normal) * ggx_grazing(theta, a) + further * missing

    normals = gltf_normals(p)
    normal, largest = normals[COLOURS.index(p.channel)], max(normals)
    further = leaves(max(mean_of(each, p.specular, colour=colour) for each, colour in zip(normals, COLOURS)))

    def passed(theta):
        if p.iridescence == 0:
            return 1 - facets(theta, alpha, largest, p.specular, further)
        missing, angle = ggx_missing(theta, alpha), fresnel_angle(theta, alpha)
        reflected = max(filmed(each, p.specular, angle, colour=colour) for each, colour in zip(normals, COLOURS))
        return max(0, 1 - reflected * (1 - missing) - further * missing)

    if p.iridescence == 0:
        mean_passed = 1 - (largest * (1 - least) + further * least + (p.specular - largest) /
                           (21 * (1 + alpha * (2.603 + alpha * (14.151 - 0.653 * alpha)))))
    else:
        mean_passed = 2 * sum(weight * passed(acos(place)) for place, weight in THREE_PLACES)
    m, beta = p.metallic, angles_of_half(u, v)[2]
    value = ((1 - m) * filmed(normal, p.specular, beta) + m * filmed(p.baseColor, 1, beta, True)) * white_facets(
        u, v, along, across, p.rotation)
    between = (1 - m) * leaves(mean_of(normal, p.specular)) + m * leaves(mean_of(p.baseColor, 1, True))
    value += between * ggx_missing(u.theta, alpha) * ggx_missing(v.theta, alpha) / (pi * least)
    value += (1 - m) * p.baseColor / pi / mean_passed * passed(u.theta) * passed(v.theta)
    strongest = max(p.of_all_channels['sheenColor'])
    if strongest > 0:
        value *= 1 - strongest * max(sheen_albedo(cos(w.theta), p.sheenRoughness) for w in (u, v))
        value += sheen(Parameters(rough=p.sheenRoughness, ks=p.sheenColor), u, v)
    if p.clearcoat > 0:
        coat = max(1e-4, p.coatRoughness ** 2)
        value *= 1 - p.clearcoat * max(facets(w.theta, coat, 0.04, 1, 0) for w in (u, v))
        value += p.clearcoat * schlick(0.04, 1, beta) * white_facets(u, v, coat, coat, 0)
    return value


# The fit of the mean of u.h over what facets reflect, by power of the cosine and of the root of alpha; openpbr_test
# compares it with quadrature. The rule is table 25.8 of Abramowitz and Stegun, "Handbook of Mathematical Functions".
MEAN_COSINE = ((0.0047, -0.2894, 4.5399, -6.5855, 2.7786), (0.1532, -3.5316, 10.1567, -8.4211, 1.9925),
               (-0.1155, 3.9313, -17.4517, 19.2256, -6.5784))
THREE_PLACES = ((0.2123405382, 0.0698269799), (0.5905331356, 0.2292411064), (0.9114120405, 0.2009319137))


def fresnel_angle(theta, alpha):
    square = cos(theta) ** 2 + sum(a * cos(theta) ** i * alpha ** ((j + 1) / 2)
                                   for i, row in enumerate(MEAN_COSINE) for j, a in enumerate(row))
    mean = sqrt(min(1, max(0, square)))
    return acos(mean + (grazing_cosine(theta, alpha) - mean) * sin(theta) ** 2)


def mean_of_dipped(normal, at_82):
    """Of Schlick's approximation that dips to a value at 82 degrees (Hoffman 2023), over the hemisphere."""
    dip = (schlick_of(normal, 1 / 7) - at_82) / (1 / 7 * (6 / 7) ** 6)
    return min(1, max(0, normal + (1 - normal) / 21 - dip / 126))


def interpolated(first, second, weight):
    return first + (second - first) * weight


class OpenPbr:
    """What depends on the parameters of one channel (OpenPBR 1.1, sections "Base Substrate" to "Fuzz")."""

    def __init__(self, p):
        self.p, self.colour = p, p.baseWeight * p.baseColor
        wider = min(1, p.roughness ** 4 + 2 * p.coatRoughness ** 4) ** 0.25
        self.along, self.across, self.alpha = self.facets(interpolated(p.roughness, wider, p.coatWeight), p.anisotropy)
        self.coat_along, self.coat_across, self.coat_alpha = self.facets(p.coatRoughness, p.coatAnisotropy)
        ratio = interpolated(p.ior, p.ior / p.coatIor, p.coatWeight)
        slight = min(0.95, sqrt(p.specularWeight * fresnel(0, ratio, 0)))
        self.index = (1 + slight) / (1 - slight)
        # Gulbrandsen 2014: n between its least and greatest values, and k from the reflectance.
        r = min(max(self.colour, 0.01 ** 2), 0.995 ** 2)
        self.metal = interpolated((1 + sqrt(r)) / (1 - sqrt(r)), (1 - r) / (1 + r), p.specularColor)
        self.metal_nimag = sqrt(max(0, r * (self.metal + 1) ** 2 - (self.metal - 1) ** 2) / (1 - r))
        self.films = {metal: Parameters(film=p.filmIor, thickness=1000 * p.filmThickness, channel=p.channel,
                                        nreal=self.metal if metal else max(1.02, self.index), nimag=self.metal_nimag if metal else 0)
                      for metal in (False, True)}
        self.least = self.alpha ** 2 / sum(a * self.alpha ** i for i, a in enumerate(MEAN_MISSING))
        self.mean_bare = mean_of_dipped(fresnel(0, self.index, 0), fresnel(acos(1 / 7), self.index, 0))
        self.mean = interpolated(self.mean_bare, self.mean_film(False), p.filmWeight)
        normal = self.colour
        self.mean_metal = min(1, p.specularWeight) * interpolated(
            mean_of_dipped(normal, p.specularColor * schlick_of(normal, 1 / 7)), self.mean_film(True), p.filmWeight)
        self.mean_passed = 2 * sum(weight * self.passed(acos(place)) for place, weight in THREE_PLACES)

    @staticmethod
    def facets(roughness, anisotropy):
        along = max(1e-4, roughness ** 2) * sqrt(2 / (1 + (1 - anisotropy) ** 2))
        across = max(1e-4, along * (1 - anisotropy))
        return along, across, sqrt((along ** 2 + across ** 2) / 2)

    def mean_film(self, metal):
        if self.p.filmWeight == 0:
            return 0
        return sum(film_reflectance(self.films[metal], acos(sqrt(0.5 + side / sqrt(12)))) for side in (-1, 1)) / 2

    def film(self, bare, angle, metal):
        if self.p.filmWeight == 0:
            return bare
        return interpolated(bare, film_reflectance(self.films[metal], angle), self.p.filmWeight)

    def dielectric(self, angle):
        return self.film(fresnel(angle, self.index, 0), angle, False)

    def reflecting_metal(self, angle):
        c = cos(angle)
        dip = (1 - self.p.specularColor) * schlick_of(self.colour, 1 / 7) / (1 / 7 * (6 / 7) ** 6)
        tinted = max(0, schlick_of(self.colour, c) - dip * c * (1 - c) ** 6)
        return min(1, self.p.specularWeight) * self.film(tinted, angle, True)

    def leaves(self, mean):
        return mean ** 2 * (1 - self.least) / (1 - mean * self.least)

    def passed(self, theta):
        missing = ggx_missing(theta, self.alpha)
        reflected = self.dielectric(fresnel_angle(theta, self.alpha))
        return max(0, 1 - reflected * (1 - missing) - self.leaves(self.mean) * missing)

    def base(self, u, v):
        p, beta = self.p, angles_of_half(u, v)[2]
        m = p.metalness
        value = white_facets(u, v, self.along, self.across, p.rotation) * (
            (1 - m) * p.specularColor * self.dielectric(beta) + m * self.reflecting_metal(beta))
        between = (1 - m) * self.leaves(self.mean * p.specularColor) + m * self.leaves(self.mean_metal)
        value += between * ggx_missing(u.theta, self.alpha) * ggx_missing(v.theta, self.alpha) / (pi * self.least)
        diffuse = eon(Parameters(rough=p.diffuseRough, kd=self.colour), u, v)
        return value + (1 - m) * diffuse * self.passed(u.theta) * self.passed(v.theta) / self.mean_passed

    def coat_albedo(self, theta):
        return fresnel(fresnel_angle(theta, self.coat_alpha), self.p.coatIor, 0) * (1 - ggx_missing(theta, self.coat_alpha))

    def below_coat(self, u, v):
        p, m = self.p, self.p.metalness
        normal = self.dielectric(0)
        base = (1 - m) * (normal * p.specularColor + (1 - normal) * self.colour) + m * self.reflecting_metal(0)
        smooth = fresnel(angles_of_half(u, v)[2], p.coatIor, 0)
        outside = mean_of_dipped(fresnel(0, p.coatIor, 0), fresnel(acos(1 / 7), p.coatIor, 0))
        diffuse = 1 - (1 - outside) / p.coatIor ** 2
        of_dielectric = interpolated(1, p.roughness, fresnel(0, self.index, 0))
        inside = interpolated(smooth, diffuse, interpolated(of_dielectric, p.roughness, m))
        darkening = interpolated(1, (1 - inside) / (1 - base * inside), p.coatWeight * p.coatDarkening)
        path = sum(1 / cos(asin(sin(w.theta) / p.coatIor)) for w in (u, v)) / 2
        passed = p.coatColor ** path * (1 - max(self.coat_albedo(w.theta) for w in (u, v)))
        return darkening * interpolated(1, passed, p.coatWeight)

    def value(self, u, v):
        p = self.p
        value = self.base(u, v)
        if p.coatWeight > 0:
            value *= self.below_coat(u, v)
            value += (p.coatWeight * fresnel(angles_of_half(u, v)[2], p.coatIor, 0) *
                      white_facets(u, v, self.coat_along, self.coat_across, p.rotation))
        if p.fuzzWeight > 0:
            value *= 1 - p.fuzzWeight * max(sheen_albedo(cos(w.theta), p.fuzzRoughness) for w in (u, v))
            value += p.fuzzWeight * sheen(Parameters(rough=p.fuzzRoughness, ks=p.fuzzColor), u, v)
        return value


@functools.lru_cache(maxsize=None)
def openpbr_of(p):
    return OpenPbr(p)


def openpbr(p, u, v):
    return openpbr_of(p).value(u, v)


def sheen_albedo(c, y):
    s = y * (0.0206607 + 1.58491 * y) / (0.0379424 + y * (1.32227 + y))
    m = y * (-0.193854 + y * (-1.14885 + y * (1.7932 - 0.95943 * y * y))) / (0.046391 + y)
    o = y * (0.000654023 + (-0.0207818 + 0.119681 * y) * y) / (1.26264 + y * (-1.92021 + y))
    return exp(-0.5 * ((c - m) / s) ** 2) / (s * sqrt(2 * pi)) + o


def sheen(p, u, v):
    x, y = cos(u.theta), p.rough
    a = (2.58126 * x + 0.813703 * y) * y / (1 + 0.310327 * x * x + 2.60994 * x * y)
    b = sqrt(1 - x) * (y - 1) * y ** 3 / (0.0000254053 + 1.71228 * x - 1.71506 * x * y + 1.34174 * y * y)
    turn = v.phi - u.phi
    before = (a * sin(v.theta) * cos(turn) + b * cos(v.theta), a * sin(v.theta) * sin(turn), cos(v.theta))
    return p.ks * sheen_albedo(x, y) * a ** 2 / (pi * sum(part ** 2 for part in before) ** 2)


def strauss(p, u, v):
    def f(x):
        kf = 1.12
        return (1 / (x - kf) ** 2 - 1 / kf ** 2) / (1 / (1 - kf) ** 2 - 1 / kf ** 2)

    def g(x):
        kg = 1.01
        return (1 / (1 - kg) ** 2 - 1 / (x - kg) ** 2) / (1 / (1 - kg) ** 2 - 1 / kg ** 2)

    kj = 0.1
    light, eye = v.theta / (pi / 2), u.theta / (pi / 2)
    exponent = 3 / (1 - p.s)
    diffuse_reflectivity = 1 - p.s ** 3
    normal = 1 - diffuse_reflectivity
    reflectivity = min(1, normal + (normal + kj) * f(light) * g(light) * g(eye))
    colour = p.kd / max(p.of_all_channels['kd']) if max(p.of_all_channels['kd']) > 0 else 1
    colour = 1 + p.m * (1 - f(light)) * (colour - 1)
    return (p.kd * (1 - p.m * p.s) * diffuse_reflectivity / pi +
            p.ks * colour * reflectivity * (exponent + 2) / (2 * pi) * lobe(mirror_angle(u, v), exponent))


def lafortune(p, u, v):
    base = p.Cx * u.x * v.x + p.Cy * u.y * v.y + p.Cz * u.z * v.z
    return p.kp / pi + (base ** p.n if base > 0 else 0.0)


def coupled(p, u, v):
    passed = (1 - schlick_fresnel(p.R0, u.theta)) * (1 - schlick_fresnel(p.R0, v.theta))
    return 21 * p.Rm / (20 * pi * (1 - p.R0)) * passed


def coupled_mirror(p, u):
    return schlick_fresnel(p.R0, u.theta)


def glass_mirror(p, u):
    """Of a pane, with each of the beams that come back from inside."""
    surface = fresnel(u.theta, p.ior, 0)
    if not p.thin:
        return surface
    left = p.colour ** (1 / cos(asin(sin(u.theta) / p.ior)))
    total, beam = surface, (1 - surface) * left
    for side in range(1000):
        if side % 2 == 1:
            total += beam * (1 - surface)
        beam *= surface * left
    return total


def ashikhmin(p, u, v):
    delta, phi, beta = angles_of_half(u, v)
    exponent = p.ex * cos(phi) ** 2 + p.ey * sin(phi) ** 2
    glossy = sqrt((p.ex + 1) * (p.ey + 1)) / (8 * pi) * cos(delta) ** exponent * schlick_fresnel(p.Rs, beta) / (
        cos(beta) * max(cos(u.theta), cos(v.theta)))
    matte = 28 * p.Rd / (23 * pi) * (1 - p.Rs) * (1 - (1 - cos(u.theta) / 2) ** 5) * (1 - (1 - cos(v.theta) / 2) ** 5)
    return glossy + matte


@functools.lru_cache(maxsize=None)
def ellipse_in_disc(a, b, x, y):
    """The area of the ellipse with half axes a and b about (x, y) in the unit disc, by its chords along y."""
    def chord(at):
        if abs(at) >= 1 or abs(at - x) >= a:
            return 0.0
        disc = sqrt(1 - at * at)
        ellipse = b * sqrt(1 - ((at - x) / a) ** 2)
        return max(0.0, min(disc, y + ellipse) - max(-disc, y - ellipse))
    low, high = max(-1, x - a), min(1, x + a)
    # Chords end like a square root; in this variable they are smooth there.
    middle, extent = (low + high) / 2, (high - low) / 2
    return integral(lambda t: chord(middle - extent * cos(t)) * extent * sin(t), 0, pi, 2000, 4)


def neumann(p, u, v):
    sign = -1 if p.retro else 1
    x, y = v.x + sign * u.x, v.y + sign * u.y
    inside = (x / p.r) ** 2 + (y / p.ry) ** 2 <= 1
    return p.kd / pi + (p.ks / ellipse_in_disc(p.r, p.ry, 0.0, 0.0) if inside else 0.0)


def neumann_albedo(p, u):
    sign = 1 if p.retro else -1
    return p.kd + p.ks * ellipse_in_disc(p.r, p.ry, sign * u.x, sign * u.y) / ellipse_in_disc(p.r, p.ry, 0.0, 0.0)


@functools.lru_cache(maxsize=None)
def cauchy_scale(sigma):
    """What makes the integral of D cos over the hemisphere 1, D = 1/(cos (sigma^2 + tan^2))."""
    return 1 / integral(lambda t: 2 * pi * sin(t) / (sigma ** 2 + tan(t) ** 2), 0, pi / 2, 400)


def beardmaxwell(p, u, v):
    delta, _, beta = angles_of_half(u, v)
    facets = cauchy_scale(p.sigma) / (cos(delta) * (p.sigma ** 2 + tan(delta) ** 2))
    facing = exp(-2 * beta / p.tau) if p.tau > 0 else 0.0
    kept = (1 + delta / p.omega * facing) / (1 + delta / p.omega)
    first = fresnel(beta, p.nreal, p.nimag) * facets * kept / (4 * cos(u.theta) * cos(v.theta))
    return p.Rs * first + p.Rd / pi + p.Rv / pi * 2 / (cos(u.theta) + cos(v.theta))


def smith(w, ax, ay):
    """Smith's shadowing of Gaussian slopes."""
    width = hypot(ax * cos(w.phi), ay * sin(w.phi)) * tan(w.theta)
    if width == 0:
        return 1.0
    x = 1 / width
    return 1 / (1 + (exp(-x * x) / (x * sqrt(pi)) - erfc(x)) / 2)


def beckmann_lobe(u, v, ax, ay):
    delta, phi, _ = angles_of_half(u, v)
    slopes = (cos(phi) / ax) ** 2 + (sin(phi) / ay) ** 2
    facets = exp(-tan(delta) ** 2 * slopes) / (pi * ax * ay * cos(delta) ** 4)
    return facets * smith(u, ax, ay) * smith(v, ax, ay) / (4 * cos(u.theta) * cos(v.theta))


def kajiya(p, u, v):
    beta = angles_of_half(u, v)[2]
    surface = beckmann_lobe(u, v, 2 * p.sigma / p.taux, 2 * p.sigma / p.tauy)
    return p.ks * fresnel(beta, p.nreal, p.nimag) * surface + p.kd / pi


def refracted(w, index):
    """The angle inside by Snell's law, and the direction, which points up."""
    theta = asin(sin(w.theta) / index)
    return theta, (sin(theta) * cos(w.phi), sin(theta) * sin(w.phi), cos(theta))


def hanrahan(p, u, v):
    beta = angles_of_half(u, v)[2]
    passed = (1 - fresnel(u.theta, p.nreal, 0)) * (1 - fresnel(v.theta, p.nreal, 0))
    theta_u, inner_u = refracted(u, p.nreal)
    theta_v, inner_v = refracted(v, p.nreal)
    turned = -dot(inner_u, inner_v)
    phase = (1 - p.g ** 2) / (4 * pi * (1 + p.g ** 2 - 2 * p.g * turned) ** 1.5)
    path = p.depth * (1 / cos(theta_u) + 1 / cos(theta_v))
    single = p.albedo * passed * phase * (1 - exp(-path)) / (p.nreal ** 2 * (cos(theta_u) + cos(theta_v)))
    surface = fresnel(beta, p.nreal, 0) * beckmann_lobe(u, v, p.rough, p.rough)
    return p.ks * surface + single + p.kd * passed / pi


def wavelength_of(channel):
    return {'red': 645, 'green': 525, 'blue': 445}[channel]


def granier(p, u, v):
    delta, _, beta = angles_of_half(u, v)
    normal = ((p.nreal - 1) / (p.nreal + 1)) ** 2
    outer = p.ks * schlick_fresnel(normal, beta) * half_lobe_scale(p.n) * cos(delta) ** p.n
    inner_half = unit(added(refracted(u, p.nreal)[1], refracted(v, p.nreal)[1]))
    inner_cosine = sin(p.tilt) * inner_half[0] + cos(p.tilt) * inner_half[2]
    entering = (1 - schlick_fresnel(normal, u.theta)) * (1 - schlick_fresnel(normal, v.theta))
    inner = p.kt * entering * half_lobe_scale(p.m) * max(0, inner_cosine) ** p.m / p.nreal ** 2
    order = 2 * p.nreal * p.d * cos(delta) / wavelength_of(p.channel)
    # Fringes above order 20 fade, and are averaged from 100 on: three wavelengths cannot resolve them.
    shown = 1 if order <= 20 else 0 if order >= 100 else (100 - order) / 80
    beams = outer + inner + shown * 2 * cos(2 * pi * order) * sqrt(outer * inner)
    return p.kd / pi + max(0.0, beams)


COLOURS = ('red', 'green', 'blue')
FUNCTIONS = {function.__name__: function for function in (
    diffuse, phong, blinn, lewis, ward, minnaert, lafortune, oren, torrance, coupled, ashikhmin, schlick, strauss, neumann,
    beardmaxwell, kajiya, hanrahan, westin, granier, poulin, he, eon, ggx, sheen, thinfilm, gltf,
    openpbr)}
FUNCTIONS['specular'] = black
FUNCTIONS['glass'] = black
MIRRORS = {'specular': lambda p, u: p.ks, 'coupled': coupled_mirror, 'schlick': schlick_mirror, 'he': he_mirror,
           'westin': westin_mirror, 'glass': glass_mirror}
DEFAULTS = {
    'specular': 'ks=1',
    'diffuse': 'kd=0.5',
    'phong': 'n=100 ks=0.4 kd=0.6',
    'blinn': 'n=100 ks=0.4 kd=0.6',
    'lewis': 'n=100 ks=0.4 kd=0.6',
    'ward': 'sx=0.2 sy=@sx ks=0.5 kd=0.5',
    'minnaert': 'k=1 kd=0.5',
    'lafortune': 'n=20 kp=0.5 Cx=-1 Cy=-1 Cz=1',
    'oren': 's=0.3 r=0.5',
    'torrance': 'rough=0.35 nreal=1.5 nimag=0 ks=0.7 kd=0.3',
    'coupled': 'Rm=0.5 R0=0.05',
    'glass': 'ior=1.5 colour=1 distance=1 thin=false',
    'ashikhmin': 'ex=25 ey=@ex Rs=0.39 Rd=0.6',
    'schlick': 'SC=0.7 Sr=0.31 Sp=1 Ly=false DC=0.5 Dr=1 Dp=1',
    'strauss': 's=0.5 m=0 ks=0.5 kd=0.5',
    'neumann': 'r=0.2 ry=@r retro=false ks=1 kd=0',
    'beardmaxwell': 'omega=1 tau=0 nreal=1.65 nimag=0 Rs=1 Rd=0.3 Rv=0.1 sigma=0.3',
    'kajiya': 'sigma=0.2 taux=1 tauy=4 nreal=0 nimag=0 ks=1 kd=0',
    'hanrahan': 'nreal=1.4 g=0.25 albedo=0.8 depth=10 rough=0.3 ks=1 kd=0.2',
    'westin': 'sigma=0.2 tau=2 lambda=(645,525,445) nreal=0 nimag=0 ks=1 kd=0',
    'granier': 'nreal=(1.50,1.51,1.52) d=400 n=100 m=20 tilt=0 ks=1 kt=0.8 kd=0',
    'poulin': 'd=2 h=0 n=50 ks=0.5 kd=0.5',
    'he': 'sigma=0.2 tau=2 lambda=(645,525,445) nreal=0 nimag=0 ks=1 kd=0',
    'eon': 'rough=0.5 kd=0.5',
    'openpbr': 'baseWeight=1 baseColor=0.8 metalness=0 diffuseRough=0 specularWeight=1 specularColor=1 roughness=0.3 '
               'anisotropy=0 rotation=0 ior=1.5 coatWeight=0 coatColor=1 coatRoughness=0 coatAnisotropy=0 coatIor=1.6 '
               'coatDarkening=1 fuzzWeight=0 fuzzColor=1 fuzzRoughness=0.5 filmWeight=0 filmThickness=0.5 filmIor=1.4',
    'sheen': 'rough=0.3 ks=1',
    'gltf': 'baseColor=1 metallic=0 roughness=0.5 ior=1.5 specular=1 specularColor=1 anisotropy=0 rotation=0 clearcoat=0 '
            'coatRoughness=0 sheenColor=0 sheenRoughness=0.3 iridescence=0 iridescenceIor=1.3 filmThickness=400',
    'thinfilm': 'alpha=0.1 ay=@alpha thickness=300 film=1.33 nreal=1.5 nimag=0 ks=1',
    'ggx': 'alpha=0.3 ay=@alpha anisotropy=0 rotation=0 nreal=1.5 nimag=0 F0=0 F82=1 ks=1 scattering=reciprocal',
}
ALIASES = {'torrance': {'m': 'rough'}, 'ashikhmin': {'nu': 'ex', 'nv': 'ey', 'ks': 'Rs', 'kd': 'Rd'}, 'coupled': {'Ro': 'R0'}, 'glass': {'color': 'colour'},
           'ggx': {'ax': 'alpha', 'ior': 'nreal'}, 'gltf': {'clearcoatRoughness': 'coatRoughness', 'iridescenceThicknessMaximum': 'filmThickness'}}


def to_float(text):
    """As a scene keeps it, in single precision."""
    return struct.unpack('f', struct.pack('f', float(text)))[0]


def value_of(text):
    if text in ('true', 'false'):
        return text == 'true'
    if text.isalpha():
        return text
    if text.startswith('('):
        return tuple(to_float(part) for part in text.strip('()').split(','))
    return to_float(text)


def arguments(text):
    """`sx=0.1 ks=(1, 0.5, 0)` as a dictionary."""
    tokens = text.replace(', ', ',').split()
    return dict(token.split('=') for token in tokens)


class Parameters(dict):
    """Those of one colour channel, as attributes too."""
    __getattr__ = dict.__getitem__

    def __hash__(self):
        return id(self)


class Instance:
    """A BRDF as a scene writes it, such as `ward sx=0.1 ks=0.4`."""

    def __init__(self, text):
        self.keyword, _, rest = text.partition(' ')
        aliases = ALIASES.get(self.keyword, {})
        given = {aliases.get(name, name): value for name, value in arguments(rest).items()}
        values = {}
        for name, default in arguments(DEFAULTS[self.keyword]).items():
            chosen = given.pop(name, default)
            values[name] = values[chosen[1:]] if chosen.startswith('@') else value_of(chosen)
        assert not given, given
        split = {name: value if isinstance(value, tuple) else (value,) * 3 for name, value in values.items()}
        self.channels = []
        for k, colour in enumerate(COLOURS):
            channel = Parameters({name: value[k] for name, value in split.items()})
            channel['channel'], channel['of_all_channels'] = colour, split
            self.channels.append(channel)
        coloured = any(isinstance(value, tuple) for value in values.values())
        self.is_grey = not coloured and self.keyword not in ('gltf', 'granier', 'openpbr', 'thinfilm')

    def by_channel(self, function):
        if self.is_grey:
            return (function(self.channels[0]),) * 3
        return tuple(function(channel) for channel in self.channels)

    def value(self, u, v, **options):
        return self.by_channel(lambda p: FUNCTIONS[self.keyword](p, u, v, **options))

    def mirror(self, u):
        weight = MIRRORS.get(self.keyword)
        return self.by_channel(lambda p: weight(p, u) if weight else 0.0)
