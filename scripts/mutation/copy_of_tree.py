"""Makes a copy of the tree for mutants; the tree itself is only read."""

import hashlib
import shutil
from contextlib import contextmanager

from mutation.choice import files_of

# Results stay valid when these files change.
TOOLS = ("scripts/mutate", "scripts/mutation/")


def fingerprint(tree, files):
    """Computes a digest of all files of the tree that affect tests."""
    digest = hashlib.sha256()
    for path in files:
        if not path.endswith(".md") and not path.startswith(TOOLS):
            digest.update(f"{path}\0".encode() + hashlib.sha256((tree / path).read_bytes()).digest())
    return digest.hexdigest()[:16]


class CopyOfTree:
    def __init__(self, tree, folder):
        self.tree = tree
        self.folder = folder

    def bring_up_to_date(self):
        """Synchronises the copy with the tree, whatever an earlier run has left. Equal files are not written again,
        so that they are not rebuilt."""
        files = set(files_of(self.tree))
        known = self.folder / ".copied"
        before = set(known.read_text().split("\0")) if known.exists() else set()
        for path in before - files:
            (self.folder / path).unlink(missing_ok=True)
        self.folder.mkdir(parents=True, exist_ok=True)
        known.write_text("\0".join(sorted(before | files)))
        for path in files:
            self._bring_up_to_date(path)
        known.write_text("\0".join(sorted(files)))

    def text_of(self, path):
        return (self.folder / path).read_text()

    @contextmanager
    def planted(self, mutant):
        path = self.folder / mutant.path
        before = path.read_bytes()
        try:
            path.write_text(mutant.applied(self.text_of(mutant.path)))
            yield
        finally:
            path.write_bytes(before)

    def _bring_up_to_date(self, path):
        source, target = self.tree / path, self.folder / path
        if target.exists() and source.read_bytes() == target.read_bytes():
            if source.stat().st_mode != target.stat().st_mode:
                shutil.copymode(source, target)
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)  # with the time of now: it has to be built again
        shutil.copymode(source, target)
