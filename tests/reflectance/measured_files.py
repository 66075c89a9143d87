#!/usr/bin/env python3
"""Writes the files of measured/: small files of measured BRDFs in several formats, and values.json.

values.json has what the files are worth at pairs of directions, by the published descriptions of the formats: the
index formula of the UTIA data base's own reader (Filip and Vavra 2014), the coordinates of the BSDF Data Interchange
format (Rykowski 2008), LightTools' azimuth of incidence of 90 degrees, the columns of ASTM E1392, and for scattered
values the method of Shepard as Franke and Nielson modified it (1980), in the coordinates of Rusinkiewicz (1998).
Directions are turned by rotation matrices. Nothing here is shared with the library. Usage: measured_files.py [--check]
  --check  writes nothing, and fails unless the files are what this script would write.
"""
import json
import pathlib
import sys
from math import acos, atan2, cos, floor, hypot, pi, radians, sin, sqrt

FOLDER = pathlib.Path(__file__).resolve().parent / 'measured'


def turn(axis, angle, d):
    """Turns a direction about an axis by the right-hand rule (Rodrigues)."""
    c, s = cos(angle), sin(angle)
    dot = sum(a * b for a, b in zip(axis, d))
    cross = (axis[1] * d[2] - axis[2] * d[1], axis[2] * d[0] - axis[0] * d[2], axis[0] * d[1] - axis[1] * d[0])
    return tuple(c * b + s * x + (1 - c) * dot * a for a, b, x in zip(axis, d, cross))


def from_normal(theta, phi):
    """The normal turned about the y axis, and then about the z axis."""
    return turn((0, 0, 1), phi, turn((0, 1, 0), theta, (0, 0, 1)))


# --- UTIA
STEP_T, STEP_P, NT, NP = 15, 7.5, 6, 48


def utia_number(index):
    """The number at an index of the file: any that tells indices apart, and is not linear in them."""
    return 0.05 + (index * 7919 % 100_003) / 100_003


def utia_value(light, view):
    """The value for (theta, phi) in degrees, as the data base's reader computes it."""
    def places(theta, phi):
        t = min(int(floor(theta / STEP_T)), NT - 2)
        p = int(floor(phi / STEP_P))
        wt = (theta - STEP_T * t) / STEP_T
        wp = (phi - STEP_P * p) / STEP_P
        return [(t + i, (p + k) % NP, (wt if i else 1 - wt) * (wp if k else 1 - wp))
                for i in (0, 1) for k in (0, 1)]
    columns = NP * NT
    rgb = []
    for plane in range(3):
        total = 0.0
        for ti, pi_, wi in places(*light):
            for tv, pv, wv in places(*view):
                index = plane * columns * columns + columns * (NP * ti + pi_) + NP * tv + pv
                total += wi * wv * utia_number(index)
        rgb.append(max(0.0, total))
    return rgb


UTIA_PAIRS = [((15, 30), (45, 97.5)), ((0, 0), (75, 352.5)), ((20, 33), (52, 101)), ((70, 358), (3, 356)),
              ((82, 10), (40, 200)), ((33, 111), (86, 270))]


# --- BSDF Data Interchange (Zemax)
def line(numbers):
    return ' '.join(f'{number:.6g}' for number in numbers)


class Grid:
    """Values over angles of incidence, azimuth and radius in degrees."""

    def __init__(self, incidence, azimuth, radial, value):
        self.incidence, self.azimuth, self.radial = incidence, azimuth, radial
        self.rows = [[[float(f'{value(i, a, r):.6g}') for r in radial] for a in azimuth] for i in incidence]

    def at(self, incidence, azimuth, radial):
        """Interpolates; constant beyond the ends."""
        def place(nodes, x):
            x = min(max(x, nodes[0]), nodes[-1])
            k = max(i for i in range(len(nodes) - 1) if nodes[i] <= x)
            return k, (x - nodes[k]) / (nodes[k + 1] - nodes[k])
        i, wi = place(self.incidence, incidence)
        a, wa = place(self.azimuth, azimuth)
        r, wr = place(self.radial, radial)
        return sum((wi if x else 1 - wi) * (wa if y else 1 - wa) * (wr if z else 1 - wr) *
                   self.rows[i + x][a + y][r + z]
                   for x in (0, 1) for y in (0, 1) for z in (0, 1))

    def blocks(self):
        return ['TIS 0.5\n' + '\n'.join(line(row) for row in rows) for rows in self.rows]


def zemax_text(symmetry, content, grids):
    first = grids[0][1]
    text = ['# Values of a formula, not of a material.', 'Source  Measured', f'Symmetry  {symmetry}',
            f'SpectralContent  {content}', 'ScatterType  BRDF', 'SampleRotation  1', '0',
            f'AngleOfIncidence  {len(first.incidence)}', line(first.incidence), f'ScatterAzimuth {len(first.azimuth)}',
            line(first.azimuth), f'ScatterRadial {len(first.radial)}', line(first.radial), '']
    for name, grid in grids:
        text += [name, 'DataBegin', *grid.blocks(), 'DataEnd']
    return '\n'.join(text) + '\n'


def about_mirror(incidence, light_phi, azimuth, radial):
    """The light, and the direction at these angles, in degrees, about its mirror direction.

    Radius 0 is the mirror direction. Azimuth 0 is towards the normal, so the mirror direction is turned towards the
    normal by the radius, and then about the mirror direction, counter-clockwise for who looks at it from outside.
    """
    i, p = radians(incidence), radians(light_phi)
    light = from_normal(i, p)
    mirror = from_normal(i, p + pi)
    side = turn((0, 0, 1), p + pi, (0, 1, 0))  # turning about it takes the normal to the mirror direction
    towards_normal = turn(side, -radians(radial), mirror)
    return light, turn(mirror, radians(azimuth), towards_normal)


ZEMAX = Grid([0, 20, 45, 70], [0, 60, 120, 180], [0, 5, 20, 60, 110],
             lambda i, a, r: (0.2 + 0.01 * i) / (1 + (r / 8) ** 2) + 0.05 + 0.00001 * (180 - a) * min(r, 20))
ZEMAX_PLACES = [(20, 0, 60, 5), (45, 35, 120, 20), (0, 0, 180, 20), (70, 200, 0, 60), (33, 80, 95, 11), (80, 5, 40, 3)]
FULL = [0, 90, 180, 270]
ZEMAX_XYZ = [Grid([10, 50], FULL, [0, 30, 90],
                  lambda i, a, r, k=k: 0.1 + 0.03 * k + 0.002 * a / (1 + k) + 0.001 * i + 0.0005 * r)
             for k in range(3)]
XYZ_PLACES = [(10, 0, 90, 30), (50, 120, 270, 30), (30, 15, 45, 12)]


def srgb(xyz):
    """Linear sRGB of white D65 (IEC 61966-2-1)."""
    matrix = ((3.2404542, -1.5371385, -0.4985314), (-0.9692660, 1.8760108, 0.0415560),
              (0.0556434, -0.2040259, 1.0572252))
    return [sum(m * x for m, x in zip(row, xyz)) for row in matrix]


# --- LightTools
LIGHTTOOLS = Grid([15, 40, 65], [0, 45, 90, 135, 180, 225, 270, 315, 360], [0, 10, 30, 50, 70, 90],
                  lambda i, a, r: 0.1 + 0.002 * i + 0.0004 * r + 0.02 * (1 + sin(radians(a + i))) * sin(radians(r)))
LIGHTTOOLS_PLACES = [(15, 0, 45, 30), (40, 70, 270, 40), (52, 300, 100, 63), (30, 10, 350, 20)]


def lighttools_text():
    head = ['# Values of a formula', 'Symmetry Asymmetric', 'SpectralContent Monochrome',
            f'ScatterAzimuth {len(LIGHTTOOLS.azimuth)}', line(LIGHTTOOLS.azimuth),
            f'ScatterRadial {len(LIGHTTOOLS.radial)}', line(LIGHTTOOLS.radial), 'DataBegin']
    blocks = []
    for incidence, block in reversed(list(zip(LIGHTTOOLS.incidence, LIGHTTOOLS.blocks()))):
        blocks.append(f'AOI {incidence}\nPOI 0\nSide Front\nWavelength 550\nScatterType BRDF\n{block}')
    blocks.append('AOI 15\nPOI 0\nSide Front\nWavelength 550\nScatterType BTDF\n' + LIGHTTOOLS.blocks()[0])
    return '\n'.join(head + blocks + ['DataEnd']) + '\n'


# --- Scattered values
def spread(count, seed):
    """Numbers between 0 and 1 that are spread well (a Kronecker sequence)."""
    steps = (0.7548776662466927, 0.5698402909980532, 0.4301597090019468)
    return [tuple((seed + i * step) % 1 for step in steps) for i in range(1, count + 1)]


def scatter_points():
    """(theta_i, phi_i, theta_s, phi_s) in degrees, with the light in one plane."""
    return [(round(80 * a, 2), 0.0, round(80 * b, 2), round(360 * c, 2)) for a, b, c in spread(60, 0.1)]


def lobe(light, view):
    h = [a + b for a, b in zip(light, view)]
    length = sqrt(sum(a * a for a in h))
    return 0.1 + 0.5 * (h[2] / length) ** 20


def half_difference(light, view):
    """theta_h, phi_h, theta_d and phi_d of Rusinkiewicz, by his rotations."""
    h = [a + b for a, b in zip(light, view)]
    length = sqrt(sum(a * a for a in h))
    h = [a / length for a in h]
    theta_h, phi_h = acos(min(1.0, h[2])), atan2(h[1], h[0]) if hypot(h[0], h[1]) > 1e-12 else 0.0
    d = turn((0, 1, 0), -theta_h, turn((0, 0, 1), -phi_h, light))
    return theta_h, phi_h, acos(min(1.0, d[2])), atan2(d[1], d[0])


def shepard(data, light, view, isotropic):
    def point(light, view):
        theta_h, phi_h, theta_d, phi_d = half_difference(light, view)
        s, d = sqrt(theta_h * 2 / pi), theta_d * 2 / pi
        if isotropic:
            return s, d, s * d * cos(2 * phi_d), s * d * sin(2 * phi_d)
        return s * cos(phi_h), s * sin(phi_h), d * cos(2 * (phi_d + phi_h)), d * sin(2 * (phi_d + phi_h))
    here = point(light, view)
    near = sorted((sqrt(sum((a - b) ** 2 for a, b in zip(here, point(*pair)))), value) for pair, value in data)
    if near[0][0] < 1e-6:
        return near[0][1]
    reach = near[8][0]
    weights = [((reach - r) / (reach * r)) ** 2 for r, _ in near[:8]]
    return sum(w * value for w, (_, value) in zip(weights, near)) / sum(weights)


def astm_files():
    """A file in degrees with one column, and its values."""
    rows, data = [], []
    for theta_i, phi_i, theta_s, phi_s in scatter_points():
        light = from_normal(radians(theta_i), radians(phi_i))
        view = from_normal(radians(theta_s), radians(phi_s))
        value = float(f'{lobe(light, view):.6g}')
        rows.append(f'{theta_i},{phi_i},{theta_s},{phi_s},{value}')
        data.append(((light, view), value))
    head = f'SAMPLE_ID\tformula\nNUM_POINTS\t{len(rows)}\nVARS\ttheta_i,phi_i,theta_s,phi_s,BRDF\n'
    return head + '\n'.join(rows) + '\n', data


def spectral_astm():
    """In radians, with three wavelengths whose values are equal, and a negative angle: the other side of the normal."""
    rows = ['0.3,0,-0.5,0.2,0.25,0.25,0.25', '0.3,0,0.6,2.5,0.5,0.5,0.5', '0.9,0,0.1,1,0.125,0.125,0.125']
    return 'VARS theta_i,phi_i,theta_s,phi_s,450nm,550nm,650nm\n' + '\n'.join(rows) + '\n'


def csv_file():
    """Anisotropic values, by angles in degrees."""
    rows, data = [], []
    for k, (a, b, c) in enumerate(spread(80, 0.37)):
        light = from_normal(radians(round(70 * a, 2)), radians(round(360 * c, 2)))
        view_angles = (round(70 * b, 2), round(360 * ((7 * a + c) % 1), 2))
        view = from_normal(radians(view_angles[0]), radians(view_angles[1]))
        value = float(f'{lobe(light, view) * (1 + 0.5 * (light[0] + view[0])):.6g}')
        rows.append(f'{view_angles[0]},{view_angles[1]},{round(70 * a, 2)},{round(360 * c, 2)},{value}')
        data.append(((light, view), value))
    return 'theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg,value\n' + '\n'.join(rows) + '\n', data


def cases():
    """The files, and (name, light, view, RGB) of pairs."""
    files, values = {}, []
    for light, view in UTIA_PAIRS:
        values.append(('utia', from_normal(*map(radians, light)), from_normal(*map(radians, view)),
                       utia_value(light, view)))
    files['zemax.bsdf'] = zemax_text('PlaneSymmetrical', 'Monochrome', [('Monochrome', ZEMAX)])
    for incidence, phi, azimuth, radial in ZEMAX_PLACES:
        for side in (1, -1):
            light, view = about_mirror(incidence, phi, side * azimuth, radial)
            values.append(('zemax.bsdf', light, view, [ZEMAX.at(incidence, azimuth, radial)] * 3))
    names = ('TristimulusX', 'TristimulusY', 'TristimulusZ')
    files['zemax_xyz.bsdf'] = zemax_text('ASymmetrical', 'XYZ', list(zip(names, ZEMAX_XYZ)))
    for incidence, phi, azimuth, radial in XYZ_PLACES:
        light, view = about_mirror(incidence, phi, azimuth, radial)
        xyz = [grid.at(incidence, azimuth, radial) for grid in ZEMAX_XYZ]
        values.append(('zemax_xyz.bsdf', light, view, srgb(xyz)))
    files['lighttools.bsdf'] = lighttools_text()
    for incidence, phi, azimuth, radial in LIGHTTOOLS_PLACES:
        light = from_normal(radians(incidence), radians(phi))
        view = from_normal(radians(radial), radians(phi + azimuth - 90))
        values.append(('lighttools.bsdf', light, view, [LIGHTTOOLS.at(incidence, azimuth, radial)] * 3))
    files['degrees.astm'], data = astm_files()
    places = [data[0][0], data[7][0], data[20][0][::-1]]
    places += [(from_normal(radians(a), radians(p)), from_normal(radians(b), radians(q)))
               for a, p, b, q in ((30, 40, 25, 230), (60, 10, 20, 100), (5, 0, 50, 300))]
    for light, view in places:
        values.append(('degrees.astm', light, view, [shepard(data, light, view, True)] * 3))
    files['spectral.astm'] = spectral_astm()
    for row in ((0.3, 0, 0.5, 0.2 + pi, 0.25), (0.3, 1, 0.6, 3.5, 0.5), (0.9, 0, 0.1, 1, 0.125)):
        values.append(('spectral.astm', from_normal(*row[:2]), from_normal(*row[2:4]), [row[4]] * 3))
    files['scattered.csv'], data = csv_file()
    places = [data[3][0], data[40][0][::-1]]
    places += [(from_normal(radians(a), radians(p)), from_normal(radians(b), radians(q)))
               for a, p, b, q in ((30, 40, 25, 230), (60, 10, 20, 100), (5, 0, 50, 300))]
    for light, view in places:
        values.append(('scattered.csv', light, view, [shepard(data, light, view, False)] * 3))
    def rounded(numbers, digits):
        return [round(x, digits) for x in numbers]
    entries = ',\n'.join(json.dumps({'file': name, 'light': rounded(light, 9), 'view': rounded(view, 9),
                                     'value': rounded(value, 7)}) for name, light, view, value in values)
    files['values.json'] = '[\n' + entries + '\n]\n'
    return files


def main():
    files = cases()
    if sys.argv[1:] == ['--check']:
        wrong = [name for name, text in files.items() if (FOLDER / name).read_text() != text]
        sys.exit('; '.join(f'{name} is not what the script writes' for name in wrong) or 0)
    FOLDER.mkdir(exist_ok=True)
    for name, text in files.items():
        (FOLDER / name).write_text(text)


main()
