"""Chooses mutants at random by a seed, more often where a mistake would matter and is easy to make."""

import hashlib
import math
import subprocess
from collections import Counter

from mutation.mutants import mutants_of

ENDINGS = (".cpp", ".h", ".glsl")

# Path prefixes and their weights in the choice of mutants; the longest prefix counts.
PLACES = {
    "grf/": 1,
    "renderer/": 1,
    "renderer/bake/": 3,
    "renderer/display/": 3,
    "renderer/image/": 3,
    "renderer/plan/": 3,
    "renderer/reflectance/": 3,
    "renderer/transport/": 3,
    "converters/": 1,
    "converters/mesh_builder": 3,
    "converters/mesh_operations/": 3,
    "converters/assign_default_brdf": 3,
    "converters/world_meshes": 3,
    "editor/document/": 1,
}

# Many mutants of some kinds are equivalent: they change nothing that a test could detect.
KINDS = {
    "operator": 3,
    "sign": 2,
    "factor": 3,
    "term": 2,
    "number": 3,
    "comparison": 2,
    "bound": 0.5,
    "logic": 1.5,
    "negation": 1,
    "condition": 1.5,
    "guard": 1.5,
    "swap": 2,
    "statement": 3,
}


def files_of(tree):
    """Lists the files of the tree: those that git tracks or does not ignore."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=tree, check=True, capture_output=True, text=True)
    return sorted({path for path in listed.stdout.split("\0") if path and (tree / path).is_file()})


def place_weight(path):
    fitting = [place for place in PLACES if path.startswith(place)]
    return PLACES[max(fitting, key=len)] if fitting else 0


def candidates(tree, files, only):
    """Lists the mutants of the files and folders in `only`."""
    found = []
    for path in files:
        if not path.endswith(ENDINGS) or not place_weight(path):
            continue
        if not only or any(path == place or path.startswith(place.rstrip("/") + "/") for place in only):
            found += mutants_of(path, (tree / path).read_text())
    return found


def drawn(mutants, seed):
    """Shuffles mutants so that each kind is as frequent as its weight, not as its number of occurrences."""
    total = Counter()
    for mutant in mutants:
        total[mutant.kind] += place_weight(mutant.path)

    def key(mutant):
        weight = KINDS[mutant.kind] * place_weight(mutant.path) / total[mutant.kind]
        digest = hashlib.sha256(f"{seed} {mutant.id}".encode()).digest()
        # Efraimidis and Spirakis 2006, "Weighted random sampling with a reservoir".
        return -math.log((int.from_bytes(digest[:8], "big") + 1) / 2**64) / weight

    return sorted(mutants, key=key)
