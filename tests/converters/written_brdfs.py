#!/usr/bin/env python3
"""Prints the rows of written_brdfs_test.cpp: the parts of BRDFs, worked out from the table of FORMATS.md.

No line of it is shared with the converters. F is Fresnel's reflectance at the normal (Hecht, "Optics", 4.6), and the
light that a layer of `hanrahan` scatters once is integrated by numbers (Hanrahan and Krueger 1993, section 3.1)."""
from math import cos, exp, inf, pi, sin, sqrt


def fresnel(n, k=0):
    return abs((complex(n, k) - 1) / (complex(n, k) + 1)) ** 2


def film_reflectance(thickness, film, base, wavelength):
    """At the normal, by the characteristic matrix of the film (Born and Wolf, "Principles of Optics", 1.6)."""
    delay = 2 * pi / wavelength * film * thickness
    first = cos(delay) - 1j * sin(delay) * base / film
    second = -1j * film * sin(delay) + cos(delay) * base
    return abs((first - second) / (first + second)) ** 2


def scattered_once(n, albedo, g, depth, steps=200000):
    """Light from the normal, of which a depth t goes straight back as exp(-t (1 + 1/c)) to a cosine c."""
    least = sqrt(1 - 1 / n ** 2)
    phase = (1 - g * g) / (1 + g * g + 2 * g) ** 1.5
    width = (1 - least) / steps
    total = 0
    for i in range(steps):
        c = least + (i + 0.5) * width
        total += 0.5 * c / (1 + c) * width
    return albedo * phase * total * (1 - exp(-2 * depth))


def rows():
    yield "diffuse kd=(0.1, 0.2, 0.3)", (0.1, 0.2, 0.3), 0, 0
    yield "minnaert kd=0.3", 0.3, 0, 0
    yield "oren s=0.4 r=0.25", 0.25, 0, 0
    yield "specular ks=(0.5, 0.25, 0.75)", 0, (0.5, 0.25, 0.75), inf
    yield "coupled Rm=0.5 R0=0.2", 0.5 * 0.8, 0.2, inf
    yield "glass ior=3", 0, fresnel(3), inf
    yield "lewis n=20 ks=0.25 kd=0.5", 0.5, 0.25, 4 * 20
    yield "phong n=10 ks=0.3 kd=0.2", 0.2, 0.3 * 2 * pi / 12, 4 * 10
    yield "blinn n=10 ks=0.3 kd=0.2", 0.2, 0.3 * 8 * pi * (10 + 2 ** -5) / (12 * 14), 10
    yield "lafortune Cz=0.9 n=8 kp=0.2", 0.2, 0.9 ** 8 * 2 * pi / 10, 4 * 8
    yield "ward sx=0.1 sy=0.4 ks=0.3 kd=0.2", 0.2, 0.3, 2 / 0.04 - 2
    yield "torrance rough=0.25 nreal=1.5 nimag=0.5 ks=0.8 kd=0.1", 0.1, 0.8 * fresnel(1.5, 0.5), 2 / 0.25 ** 2 - 2
    yield "ashikhmin ex=16 ey=100 Rs=0.25 Rd=0.5", 0.5 * 0.75, 0.25, 40
    yield "schlick Ly=true DC=0.5 SC=0.4 Sr=0.1", 0.5 * 0.6, 0.4, 2 / 0.1 - 2
    strauss = [(1 - 0.4 * 0.5) * (1 - 0.5 ** 3) * c for c in (0.6, 0.3, 0.15)]
    tinted = [0.5 * 0.5 ** 3 * (0.6 + 0.4 * c / 0.6) for c in (0.6, 0.3, 0.15)]
    yield "strauss kd=(0.6, 0.3, 0.15) s=0.5 m=0.4 ks=0.5", strauss, tinted, 12 / 0.5
    yield "neumann r=0.2 ry=0.5 ks=0.6 kd=0.1", 0.1, 0.6, 16 / 0.1 - 8
    yield "beardmaxwell Rd=0.2 Rv=0.1 Rs=0.5 nreal=2 nimag=0 sigma=0.25", 0.3, 0.5 * fresnel(2), 2 / 0.25 ** 2 - 2
    yield "kajiya taux=1 tauy=4 sigma=0.1 ks=0.5 kd=0.1 nreal=2", 0.1, 0.5 * fresnel(2), 4 / (2 * 0.1 ** 2) - 2
    below = (0.1 + scattered_once(1.5, 0.5, 0.3, 0.2)) * (1 - fresnel(1.5)) ** 2
    yield ("hanrahan kd=0.1 albedo=0.5 depth=0.2 g=0.3 nreal=1.5 rough=0.25 ks=0.5", below, 0.5 * fresnel(1.5),
           2 / 0.25 ** 2 - 2)
    yield "westin tau=4 sigma=0.5 ks=0.75 kd=0.1 nreal=1.5 nimag=2", 0.1, 0.75 * fresnel(1.5, 2), 16 / (2 * 0.25) - 2
    yield "he tau=4 sigma=0.5 ks=0.75 kd=0.1 nreal=1.5 nimag=2", 0.1, 0.75 * fresnel(1.5, 2), 16 / (2 * 0.25) - 2
    film = fresnel(1.5)
    yield ("granier kd=0.1 ks=0.8 kt=0.5 nreal=1.5 m=45 n=30", 0.1, 0.8 * film + 0.5 * (1 - film) ** 2, 45 / 1.5 ** 2)
    yield "granier kd=0.1 ks=0.8 kt=0.02 nreal=1.5 m=45 n=30", 0.1, 0.8 * film + 0.02 * (1 - film) ** 2, 30
    yield "poulin kd=0.2 ks=0.3 n=30", 0.2, 0.3, 30
    yield "ggx alpha=0.25 ay=0.5 nreal=1.5 ks=0.5", 0, 0.5 * fresnel(1.5), 2 / (0.25 * 0.5) - 2
    yield "ggx ax=0.5 F0=(0.9, 0.6, 0.3)", 0, (0.9, 0.6, 0.3), 2 / 0.25 - 2
    yield ("gltf baseColor=(0.8, 0.4, 0.2) metallic=0.25 roughness=0.5 ior=1.5 specular=0.5 anisotropy=0.5",
           (0.6, 0.3, 0.15), tuple(0.25 * colour + 0.75 * 0.5 * 0.04 for colour in (0.8, 0.4, 0.2)),
           2 / (0.25 * (0.25 + 0.75 * 0.25)) - 2)
    wide = 0.25 * sqrt(2 / (1 + 0.75 ** 2))
    yield ("openpbr baseWeight=0.5 baseColor=(0.8, 0.4, 0.2) metalness=0.25 specularWeight=0.5 specularColor=(1, 0.5, 0.25) "
           "roughness=0.5 anisotropy=0.25", (0.3, 0.15, 0.075),
           tuple(0.5 * (0.25 * 0.5 * colour + 0.75 * tint * fresnel(1.5))
                 for colour, tint in ((0.8, 1), (0.4, 0.5), (0.2, 0.25))), 2 / (wide * 0.75 * wide) - 2)
    yield ("thinfilm alpha=0.25 ay=0.5 thickness=250 film=1.5 nreal=2 nimag=3 ks=0.8", 0,
           tuple(0.8 * film_reflectance(250, 1.5, 2 + 3j, wavelength) for wavelength in (610, 550, 465)),
           2 / (0.25 * 0.5) - 2)
    width = 0.5 * (0.0206607 + 1.58491 * 0.5) / (0.0379424 + 0.5 * (1.32227 + 0.5))
    centre = 0.5 * (-0.193854 + 0.5 * (-1.14885 + 0.5 * (1.7932 - 0.95943 * 0.25))) / (0.046391 + 0.5)
    base = 0.5 * (0.000654023 + (-0.0207818 + 0.119681 * 0.5) * 0.5) / (1.26264 + 0.5 * (-1.92021 + 0.5))
    mean = 0
    for i in range(100000):
        c = (i + 0.5) / 100000
        mean += 2e-5 * c * (exp(-((c - centre) / width) ** 2 / 2) / (width * sqrt(2 * pi)) + base)
    yield "sheen rough=0.5 ks=0.8", 0.8 * mean, 0, 0
    once = (1 + (2 / 3 - 28 / (15 * pi)) * 0.75) / (1 + (1 / 2 - 2 / (3 * pi)) * 0.75)
    yield "eon rough=0.75 kd=0.5", 0.5 * once / (1 - 0.5 * (1 - once)), 0, 0


def colour(value):
    values = list(value) if hasattr(value, "__iter__") else [value] * 3
    return "{" + ", ".join(f"{v:.8g}" for v in values) + "}"


for brdf, diffuse, glossy, exponent in rows():
    written = "MirrorExponent" if exponent == inf else f"{exponent:.8g}"
    print(f'      {{"{brdf}", {colour(diffuse)}, {colour(glossy)}, {written}}},')
