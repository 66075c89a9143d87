"""Transforms between GRF, whose y axis is up, and Blender, whose z axis is: (x, y, z) becomes (x, -z, y)."""
from math import sqrt

from mathutils import Euler, Matrix, Vector

from .grf_text import vector

TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
TO_GRF = TO_BLENDER.transposed()
KINDS = ("scale", "rotation", "translation")


def point_to_blender(p):
    return (p[0], -p[2], p[1])


def point_to_grf(p):
    return (p[0], p[2], -p[1])


def step_groups(steps):
    """Splits steps into groups that an object's location, rotation and scale can represent, the inner ones first."""
    groups = [{}]
    for kind, value in steps:
        if any(KINDS.index(known) >= KINDS.index(kind) for known in groups[-1]):
            groups.append({})
        groups[-1][kind] = value
    return groups


def place(obj, group):
    """Gives an object the scale, rotation and translation of a group of steps."""
    x, y, z = group.get("scale", (1, 1, 1))
    obj.scale = (x, z, y)
    if "rotation" in group:
        rotation = Euler(group["rotation"], "XYZ").to_matrix().to_4x4()
        obj.rotation_euler = (TO_BLENDER @ rotation @ TO_GRF).to_euler("XYZ")
    obj.location = point_to_blender(group.get("translation", (0, 0, 0)))


def flattened(matrix):
    return [value for row in matrix for value in row]


def is_close(a, b):
    """Compares 16 numbers to the precision of a float."""
    scale = max([1e-30] + [abs(value) for value in a])
    return len(a) == len(b) and all(abs(x - y) <= 1e-6 * max(scale, abs(x)) for x, y in zip(a, b))


def is_identity(matrix):
    return flattened(matrix) == flattened(Matrix.Identity(4))


def steps_text(blender_matrix):
    """The steps of GRF for a matrix of Blender, or nothing if it flattens what it transforms."""
    matrix = TO_GRF @ blender_matrix @ TO_BLENDER
    linear = matrix.to_3x3()
    turn, stretch, turn_after = decomposed(linear)
    if min(abs(value) for value in stretch) < 1e-12 * max(abs(value) for value in stretch):
        return None
    parts = []
    for kind, values, neutral in (("rotation", turn.to_euler("XYZ"), 0), ("scale", stretch, 1),
                                  ("rotation", turn_after.to_euler("XYZ"), 0),
                                  ("translation", matrix.to_translation(), 0)):
        if any(abs(value - neutral) > 1e-7 for value in values):
            parts.append(f"{kind} {vector(values)}")
    return " ".join(parts) or "translation (0, 0, 0)"


def decomposed(linear):
    """A matrix as rotation, scale and rotation, in the order in which they act. The first one is needed for shears."""
    columns = [linear.col[i] for i in range(3)]
    lengths = [column.length for column in columns]
    largest = max(lengths)
    sheared = any(abs(columns[i].dot(columns[j])) > 2e-6 * max(lengths[i] * lengths[j], 1e-12 * largest * largest)
                  for i, j in ((0, 1), (0, 2), (1, 2)))
    if sheared:
        turn, lengths, columns = principal_axes(linear)
    else:
        turn = Matrix.Identity(3)
    if min(lengths) <= 1e-12 * largest:
        return turn, lengths, Matrix.Identity(3)
    after = Matrix([column / length for column, length in zip(columns, lengths)]).transposed()
    if after.determinant() < 0:
        lengths = [-length for length in lengths]
        after = -1 * after
    return turn, lengths, after


def principal_axes(linear):
    """The singular values of a matrix: the rotation into its principal axes, their lengths and images. Jacobi's method
    on the transpose times the matrix."""
    rows = [list(row) for row in linear.transposed() @ linear]
    axes = [[float(i == j) for j in range(3)] for i in range(3)]
    for _ in range(30):
        for p, q in ((0, 1), (0, 2), (1, 2)):
            if abs(rows[p][q]) < 1e-30:
                continue
            theta = (rows[q][q] - rows[p][p]) / (2 * rows[p][q])
            t = (1 if theta >= 0 else -1) / (abs(theta) + sqrt(theta * theta + 1))
            c = 1 / sqrt(t * t + 1)
            s = t * c
            for i in range(3):
                rows[i][p], rows[i][q] = c * rows[i][p] - s * rows[i][q], s * rows[i][p] + c * rows[i][q]
            for i in range(3):
                rows[p][i], rows[q][i] = c * rows[p][i] - s * rows[q][i], s * rows[p][i] + c * rows[q][i]
                axes[i][p], axes[i][q] = c * axes[i][p] - s * axes[i][q], s * axes[i][p] + c * axes[i][q]
    into = Matrix(axes).transposed()
    if into.determinant() < 0:
        into[0] = -into[0]
    images = [linear @ Vector(into[i]) for i in range(3)]
    return into, [image.length for image in images], images


