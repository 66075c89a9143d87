#!/usr/bin/env python3
"""Writes independent_values.json: what BRDFs are worth at pairs of directions, and their albedos.

The values come from independent_models.py and from the quadrature here. independent_test compares the library with the
table. Usage: independent_values.py [--check | --check-all]
  --check      writes nothing, and fails unless the table is what this script would write: all values, and one albedo of
               each instance, by few directions. The albedos in renderer/MODELS.md are compared with the table, too.
  --check-all  the same with all albedos, as they were made. It takes minutes.
"""
import json
import pathlib
import sys
from math import cos, pi, sin

sys.dont_write_bytecode = True
from independent_basics import Direction, gauss_legendre, merl_place  # noqa: E402
from independent_layers import Layered  # noqa: E402
from independent_models import Instance, neumann_albedo  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
TABLE = FOLDER / 'independent_values.json'
DOCUMENT = FOLDER.parent.parent / 'renderer' / 'MODELS.md'

# Angles of u and v in degrees: theta and phi of each. They cover the mirror direction, retro-reflection,
# directions across the plane of incidence, and grazing.
PAIRS = [
    (0, 0, 0, 0), (0, 0, 35, 10), (20, 15, 22, 200), (20, 15, 31, 150), (33, 70, 30, 240), (33, 70, 48, 265),
    (45, 120, 40, 310), (45, 120, 52, 100), (45, 200, 15, 290), (50, 340, 50, 330), (57, 25, 63, 207), (57, 25, 20, 31),
    (62, 95, 66, 260), (62, 95, 71, 130), (66, 310, 12, 45), (70, 185, 77, 352), (74, 60, 8, 190), (78, 255, 81, 80),
    (83, 20, 45, 205), (87, 100, 84, 285),
]

# The examples of MODELS.md, as the parameter sets of the thesis' table 5.5 there.
DOCUMENTED = [
    'specular ks=0.9', 'diffuse kd=0.5', 'phong n=100 ks=0.4 kd=0.6', 'blinn n=100 ks=1 kd=0.67',
    'lewis n=100 ks=1 kd=0', 'ward sx=0.2 sy=0.2 ks=0.5 kd=0.5', 'minnaert k=0.8 kd=1',
    'lafortune n=100 kp=0.96 Cx=-1 Cy=-1 Cz=1', 'oren s=0.4 r=0.9',
    'torrance rough=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3', 'coupled Rm=1 R0=0.05',
    'ashikhmin ex=25 ey=25 Rs=0.39 Rd=0.6', 'schlick SC=0.7 Sr=0.31 Sp=1 Ly=false',
    'strauss s=0.76 m=0.91 ks=0.64 kd=0.5', 'neumann r=0.2',
    'beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5',
    'kajiya sigma=0.2 taux=1 tauy=4 nreal=2.485 nimag=3.433',
    'hanrahan nreal=1.4 g=0.25 albedo=(0.95, 0.85, 0.75) depth=10 rough=0.3 ks=1 kd=(0.4, 0.2, 0.12)',
    'westin sigma=0.1 tau=3 nreal=0.617 nimag=2.63', 'granier nreal=(1.5, 1.51, 1.52) d=250 n=100 m=20 tilt=0 ks=1 kt=0.9 kd=0',
    'poulin d=2 h=0.01 n=100 ks=0.8 kd=0.2', 'he sigma=0.5 tau=3 lambda=800', 'eon rough=0.8 kd=0.9',
    'ggx alpha=0.3 nreal=0.617 nimag=2.63 ks=1', 'sheen rough=0.3 ks=1',
    'gltf baseColor=(0.8, 0.25, 0.1) metallic=0 roughness=0.35 clearcoat=0.5 coatRoughness=0.4',
    'openpbr baseColor=(0.6, 0.1, 0.05) metalness=0.5 roughness=0.4 coatWeight=1 coatRoughness=0.3',
    'thinfilm alpha=0.1 thickness=350 film=1.5 nreal=2.5 nimag=3.4 ks=1',
    'glass ior=1.5 colour=(0.7, 0.9, 0.8) distance=0.1',
    'oren s=0 r=1', 'schlick SC=0.7 Sr=0.31 Sp=1 Ly=true DC=1 Dr=0 Dp=1',
]
DOCUMENTED_VIEWS = [(0, 0), (45, 0), (80, 0)]

# Other instances, with view angles for the albedo: no parameter at its default, 0 or 1, where that could hide
# a mistake.
CHOSEN = [
    ('specular ks=(0.2, 0.6, 0.9)', [(30, 10), (70, 200)]),
    ('diffuse kd=(0.9, 0.4, 0.1)', [(30, 10), (70, 200)]),
    ('phong n=7.5 ks=(0.5, 0.2, 0.7) kd=(0.1, 0.3, 0.2)', [(20, 10), (65, 200)]),
    ('blinn n=13.5 ks=(0.5, 0.2, 0.7) kd=(0.1, 0.3, 0.2)', [(20, 10), (65, 200)]),
    ('lewis n=6.5 ks=(0.5, 0.2, 0.7) kd=(0.1, 0.3, 0.2)', [(20, 10), (65, 200)]),
    ('ward sx=0.35 sy=0.6 ks=(0.7, 0.4, 0.2) kd=(0.1, 0.3, 0.2)', [(25, 10), (60, 70), (70, 160)]),
    ('ward sx=0.9 sy=0.25 ks=0.8 kd=0', [(40, 30)]),
    ('minnaert k=2.6 kd=(0.9, 0.5, 0.2)', [(25, 10), (70, 200)]),
    ('minnaert k=0.4 kd=0.3', [(60, 0)]),
    ('lafortune n=5.5 kp=(0.2, 0.1, 0.3) Cx=-0.9 Cy=-0.6 Cz=0.8', [(30, 10), (60, 100)]),
    ('lafortune n=3 kp=0.1 Cx=0.7 Cy=1.1 Cz=0.9', [(30, 20), (65, 70)]),
    ('lafortune n=40 kp=0.3 Cx=-1.02 Cy=-1.02 Cz=1.01', [(35, 0)]),
    ('oren s=0.85 r=(0.9, 0.5, 0.2)', [(25, 10), (70, 200)]),
    ('oren s=0.15 r=0.7', [(50, 0)]),
    ('eon rough=0.7 kd=(0.9, 0.5, 0.2)', [(25, 10), (70, 200)]),
    ('eon rough=0.2 kd=0.7', [(50, 0)]),
    ('eon rough=1 kd=1', [(10, 0), (85, 0)]),
    ('ggx alpha=0.35 ay=0.6 rotation=0.7 nreal=(0.2,0.6,1.4) nimag=(3.6,2.5,1.9) ks=(0.9,0.7,0.5) scattering=single',
     [(25, 10), (65, 100)]),
    ('ggx alpha=0.6 anisotropy=0.7 F0=(0.9,0.5,0.2) F82=(0.7,0.9,1)', [(40, 30)]),
    ('ggx alpha=0.5 nreal=1.7 scattering=scaled', [(70, 0)]),
    ('gltf baseColor=(0.9,0.5,0.2) metallic=0.6 roughness=0.7 anisotropy=0.5 rotation=0.4', [(25, 10), (65, 100)]),
    ('gltf baseColor=0.6 roughness=0.45 ior=1.8 specular=0.7 specularColor=(0.5,1,2)', [(40, 30)]),
    ('gltf baseColor=(0.9,0.5,0.2) roughness=0.6 clearcoat=0.7 clearcoatRoughness=0.5 sheenColor=(0.2,0.5,0.9) sheenRoughness=0.4',
     [(50, 0)]),
    ('gltf baseColor=(0.7,0.5,0.3) metallic=0.4 roughness=0.6 specular=0.8 iridescence=0.7 iridescenceIor=1.5 filmThickness=250',
     [(30, 0)]),
    ('openpbr baseWeight=0.9 baseColor=(0.9,0.5,0.2) metalness=0.6 specularWeight=0.8 specularColor=(0.7,0.9,1) roughness=0.7 '
     'anisotropy=0.5 rotation=0.4 ior=1.7', [(25, 10), (65, 100)]),
    ('openpbr baseColor=(0.9,0.5,0.2) diffuseRough=0.6 roughness=0.5 specularWeight=1.4 coatWeight=0.7 '
     'coatColor=(0.9,0.6,0.3) coatRoughness=0.4 coatAnisotropy=0.3 coatIor=1.7 coatDarkening=0.8', [(40, 30)]),
    ('openpbr baseColor=0.4 roughness=0.6 coatWeight=0.4 coatRoughness=0.6 fuzzWeight=0.7 fuzzColor=(0.2,0.5,0.9) '
     'fuzzRoughness=0.4', [(50, 0)]),
    ('openpbr baseColor=(0.7,0.5,0.3) metalness=0.3 specularColor=(0.6,0.8,0.9) roughness=0.6 filmWeight=0.7 filmThickness=0.35',
     [(30, 0)]),
    ('thinfilm alpha=0.3 ay=0.5 thickness=420 film=1.33 nreal=1 ks=(0.9,0.7,0.5)', [(25, 10), (65, 100)]),
    ('thinfilm alpha=0.5 thickness=150 film=2.2 nreal=(0.2,0.6,1.4) nimag=(3.6,2.5,1.9)', [(40, 30)]),
    ('glass ior=1.8 colour=(0.9,0.5,0.2) thin=true', [(30, 10), (75, 200)]),
    ('sheen rough=0.65 ks=(0.9,0.5,0.3)', [(30, 10), (75, 200)]),
    ('torrance rough=0.5 nreal=1.5 nimag=0 ks=(0.9, 0.5, 0.3) kd=(0.1, 0.2, 0.3)', [(25, 10), (70, 200)]),
    ('torrance rough=0.25 nreal=2.485 nimag=3.433 ks=0.6 kd=0.2', [(60, 0)]),
    ('torrance rough=0.8 nreal=0.7 nimag=0 ks=0.8 kd=0.1', [(40, 0)]),
    ('coupled Rm=0 R0=0.3', [(30, 0), (75, 0)]),
    ('coupled Rm=(0.35, 0.6, 0.8) R0=(0.3, 0.1, 0.6)', [(0, 0), (30, 10), (75, 200)]),
    ('ashikhmin ex=12 ey=60 Rs=(0.5, 0.2, 0.1) Rd=(0.3, 0.6, 0.8)', [(25, 10), (60, 100)]),
    ('ashikhmin ex=150 ey=9 Rs=0.3 Rd=0', [(45, 40), (70, 80)]),
    ('schlick SC=(0.6, 0.3, 0.1) Sr=0.2 Sp=0.5', [(25, 10), (60, 100)]),
    ('schlick SC=(0.1, 0.4, 0.2) Sr=0.25 Sp=0.7 Ly=true DC=(0.8, 0.3, 0.5) Dr=0.7 Dp=0.6', [(25, 80), (65, 30)]),
    ('schlick SC=0.2 Sr=0 Ly=true DC=(0.8, 0.3, 0.5) Dr=0.4 Dp=1', [(50, 0)]),
    ('strauss s=0.4 m=0.3 ks=(0.9, 0.6, 0.4) kd=(0.8, 0.3, 0.1)', [(25, 10), (70, 200)]),
    ('strauss s=0.6 m=0 ks=0.7 kd=0.3', [(50, 0), (65, 0)]),
    ('neumann r=0.3 ry=1.5 ks=(0.7, 0.4, 0.2) kd=(0.1, 0.2, 0.3)', [(25, 10), (60, 100)]),
    ('neumann r=0.8 ry=0.45 retro=true ks=0.6 kd=0.2', [(40, 30), (70, 80)]),
    ('beardmaxwell omega=0.4 tau=0.5 nreal=1.5 Rs=(0.9, 0.6, 0.3) Rd=(0.1, 0.2, 0.3) Rv=(0.2, 0.1, 0.05) sigma=0.45',
     [(25, 10), (70, 200)]),
    ('beardmaxwell omega=1.7 tau=0.15 nreal=2 nimag=3 Rs=0.8 Rd=0 Rv=0 sigma=1', [(50, 0)]),
    ('beardmaxwell omega=0.8 tau=2 nreal=1.3 nimag=0.5 Rs=0.8 Rd=0.1 Rv=0.3 sigma=2.5', [(40, 0)]),
    ('kajiya sigma=0.3 taux=1.2 tauy=0.8 nreal=1.6 nimag=0 ks=(0.7, 0.5, 0.3) kd=(0.1, 0.2, 0.3)', [(25, 10), (60, 100)]),
    ('kajiya sigma=0.25 taux=0.9 tauy=2 nreal=0.4 nimag=2.8 ks=0.9 kd=0', [(70, 40)]),
    ('hanrahan nreal=1.7 g=-0.5 albedo=(1, 0.6, 0.3) depth=0.7 rough=0.5 ks=(0.8, 0.5, 0.3) kd=(0.1, 0.3, 0.5)',
     [(25, 10), (70, 200)]),
    ('hanrahan nreal=1.3 g=0.6 albedo=0.9 depth=2 rough=0.35 ks=0.5 kd=0', [(50, 0)]),
    ('westin sigma=0.12 tau=1.1 lambda=(700, 500, 400) nreal=1.5 ks=(0.9, 0.6, 0.4) kd=(0.05, 0.2, 0.1)', [(25, 10), (70, 200)]),
    ('westin sigma=0 nreal=1.5 ks=0.8 kd=0.3', [(60, 0)]),
    ('westin sigma=0.4 tau=1 lambda=600 nreal=2.5 nimag=3.4 ks=0.7 kd=0.1', [(65, 0)]),
    ('granier nreal=(1.3, 1.5, 1.8) d=300 n=18 m=25 tilt=0.25 ks=(0.9, 0.7, 0.8) kt=(0.6, 0.9, 0.7) kd=(0.02, 0.1, 0.05)',
     [(25, 10), (60, 100)]),
    ('granier nreal=1.6 d=150 n=40 m=12 tilt=0 ks=0.9 kt=0.8 kd=0.05', [(45, 0)]),
    ('granier nreal=1.4 d=9000 n=30 m=15 tilt=0.1 ks=0.9 kt=0.5 kd=0', []),
    ('poulin d=3.3 h=0.2 n=14 ks=(0.5, 0.3, 0.7) kd=(0.3, 0.1, 0.2)', [(30, 80), (65, 200)]),
    ('poulin d=1.2 h=0 n=30 ks=0.4 kd=0.5', [(60, 65)]),
    ('poulin d=2.4 h=0.6 n=0.7 ks=0.5 kd=0.3', [(70, 100)]),
    ('he sigma=0.12 tau=0.5 lambda=(700, 500, 400) nreal=1.5 ks=(0.9, 0.6, 0.4) kd=(0.05, 0.2, 0.1)', [(25, 10), (75, 200)]),
    ('he sigma=0.4 tau=1 lambda=600 nreal=2.5 nimag=3.4 ks=0.7 kd=0.1', [(65, 0), (80, 0)]),
    ('coat alpha=0.3 over diffuse kd=0.8', [(0, 0), (30, 10), (65, 200)]),
    ('coat alpha=0.4 ior=1.8 tint=(0.9,0.5,0.2) over ggx alpha=0.5 F0=0.7', [(25, 10), (70, 200)]),
    ('ggx alpha=0.5 F0=0.3 over eon rough=0.8 kd=0.7', [(0, 0), (45, 0), (70, 0)]),
    ('eon rough=0.6 kd=(0.2,0.4,0.6) over lewis n=6 ks=0.5 kd=0.3', [(25, 10), (60, 100)]),
]


class Resolution:
    """Of a quadrature over the hemisphere: places over theta, in two halves, and azimuths."""

    def __init__(self, thetas, azimuths, grooves):
        self.thetas, self.azimuths, self.grooves = thetas, azimuths, grooves


FINE = Resolution(32, 128, (24, 72))
COARSE = Resolution(8, 24, (5, 16))


def albedo(instance, view, resolution):
    """The integral of f cos over the hemisphere, and the mirror part: Gauss and Legendre's rule over theta, with an edge
    at the view's, where formulas have kinks, and the midpoint rule over a function of the azimuth."""
    u = Direction(*view)
    total = list(instance.mirror(u))
    if instance.keyword == 'neumann':  # the steps of which no quadrature sees well
        return tuple(a + b for a, b in zip(total, instance.by_channel(lambda p: neumann_albedo(p, u))))
    is_poulin = instance.keyword == 'poulin'
    thetas, azimuths = resolution.grooves if is_poulin else (resolution.thetas, resolution.azimuths)
    options = {'count': 50, 'nodes': 24} if is_poulin else {}
    edges = [0, view[0], 90] if view[0] > 0 else [0, 30, 90]
    for low, high in zip(edges, edges[1:]):
        for place, weight in gauss_legendre(thetas):
            theta = (low + high) / 2 + place * (high - low) / 2
            sine, cosine = sin(theta * pi / 180), cos(theta * pi / 180)
            share = weight * (high - low) / 2 * pi / 180 * sine * cosine * 2 * pi / azimuths
            for k in range(azimuths):
                # The grid is ten times as dense about the mirror direction, where lobes are narrow towards
                # grazing.
                place = 2 * pi * (k + 0.5) / azimuths - pi
                turn, density = place - 0.9 * sin(place), 1 - 0.9 * cos(place)
                f = instance.value(u, Direction(theta, view[1] + 180 + turn * 180 / pi), **options)
                for channel in range(3):
                    total[channel] += share * density * f[channel]
    return tuple(total)


def values(instance):
    return [instance.value(Direction(*pair[:2]), Direction(*pair[2:])) for pair in PAIRS]


def merl_places():
    return [merl_place(Direction(*pair[:2]), Direction(*pair[2:])) for pair in PAIRS]


def mirrors(instance):
    return [instance.mirror(Direction(*pair[:2])) for pair in PAIRS]


def requests():
    return [(text, DOCUMENTED_VIEWS) for text in DOCUMENTED] + CHOSEN


def entry(text, views, resolution):
    instance = Layered(text) if ' over ' in text else Instance(text)
    row = {'brdf': text, 'values': values(instance)}
    if any(weight > 0 for weights in mirrors(instance) for weight in weights):
        row['mirrors'] = mirrors(instance)
    row['albedos'] = [{'view': view, 'albedo': albedo(instance, view, resolution)} for view in views]
    return row


def rounded(thing):
    if isinstance(thing, float):
        return float(f'{thing:.9g}')
    if isinstance(thing, (list, tuple)):
        # A grey value is stored as one number.
        if len(thing) == 3 and all(isinstance(part, float) and part == thing[0] for part in thing):
            return rounded(thing[0])
        return [rounded(part) for part in thing]
    if isinstance(thing, dict):
        return {name: rounded(part) for name, part in thing.items()}
    return thing


def write():
    rows = []
    for text, views in requests():
        rows.append(json.dumps(rounded(entry(text, views, FINE))))
        print(text, flush=True)
    TABLE.write_text('{"written by": "independent_values.py",\n"pairs": %s,\n"merl": %s,\n"instances": [\n%s\n]}\n' % (
        json.dumps(PAIRS), json.dumps(rounded(merl_places())), ',\n'.join(rows)))


def is_near(one, other, tolerance):
    if isinstance(one, (list, tuple)):
        return isinstance(other, (list, tuple)) and len(one) == len(other) and all(
            is_near(a, b, tolerance) for a, b in zip(one, other))
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return abs(one - other) <= tolerance * max(abs(one), 1e-12)
    return one == other


def albedos_in_document():
    """By instance, those at 0, 45 and 80 degrees: of the models' examples and of the thesis' sets."""
    examples = {text.split()[0]: text for text in reversed(DOCUMENTED)}
    for line in DOCUMENT.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip('|').split('|')]
        try:
            albedos = [[float(number) for number in cell.split(',')] for cell in cells[-3:]]
        except ValueError:
            continue
        if len(cells) == 7 and cells[0] in examples:
            yield examples[cells[0]], albedos
        elif len(cells) == 4 and cells[0].startswith('`'):
            yield cells[0].strip('`'), albedos


def check_document(table):
    """The document's albedos come from samples, to three digits."""
    known = {same_for_all_spellings(row['brdf']): row['albedos'] for row in table['instances'] if ' over ' not in row['brdf']}
    failures, seen = [], 0
    for text, albedos in albedos_in_document():
        seen += 1
        expected = known.get(same_for_all_spellings(text))
        for got, right in zip(albedos, expected or [{'albedo': 'no row'}] * 3):
            right = right['albedo']
            channels = right if isinstance(right, list) else [right] * len(got)
            if len(channels) != len(got) or not all(
                    isinstance(b, float) and abs(a - b) <= 6e-4 + 2e-3 * b for a, b in zip(got, channels)):
                failures.append(f'{DOCUMENT}: {text}: {got}, expected {right}')
    return failures + ([] if seen == 45 else [f'{DOCUMENT}: {seen} rows of albedos, expected 45'])


def same_for_all_spellings(text):
    return text.split()[0], repr([sorted((name, repr(value)) for name, value in channel.items())
                                  for channel in Instance(text).channels])


def check(resolution, tolerance, views_of_each):
    table = json.loads(TABLE.read_text())
    failures = [] if is_near(table['pairs'], PAIRS, 0) else ['the pairs are others']
    if not is_near(table['merl'], rounded(merl_places()), 1e-7):
        failures.append('the places in tables of the MERL data base are others')
    if [row['brdf'] for row in table['instances']] != [text for text, _ in requests()]:
        failures.append('the instances are others')
    for row, (text, views) in zip(table['instances'], requests()):
        again = rounded(entry(text, views[:views_of_each], resolution))
        for name in ('values', 'mirrors'):
            if not is_near(row.get(name), again.get(name), 1e-7):
                failures.append(f'{text}: other {name}')
        for one, other in zip(row['albedos'], again['albedos']):
            if one['view'] != other['view'] or not is_near(one['albedo'], other['albedo'], tolerance):
                failures.append(f"{text}: the albedo at {one['view']} is {one['albedo']}, but {other['albedo']} here")
        if len(row['albedos']) != len(views):
            failures.append(f'{text}: other views')
    failures += check_document(table)
    print('\n'.join(failures) or f'{TABLE} is what {sys.argv[0]} writes')
    return not failures


if __name__ == '__main__':
    if sys.argv[1:] == ['--check']:
        sys.exit(0 if check(COARSE, 0.05, 1) else 1)
    elif sys.argv[1:] == ['--check-all']:
        sys.exit(0 if check(FINE, 1e-6, None) else 1)
    elif sys.argv[1:]:
        sys.exit(__doc__)
    write()
