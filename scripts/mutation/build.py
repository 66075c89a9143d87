"""Builds a copy of the tree, and tracks which programs depend on which sources."""

import hashlib
import os
import re
import subprocess
import tempfile
import time
from collections import defaultdict

# A translation unit that compiles in a minute may take far longer when a mutant makes a template recurse, or a program
# that runs during the build hang.
LONGEST_BUILD = 3600


class BuildError(Exception):
    """The unchanged tree does not build, so no mutant can be tested."""


class Build:
    def __init__(self, copy, runner, preset, jobs, configure):
        self.copy = copy
        self.runner = runner
        self.preset = preset
        self.jobs = jobs
        self.folder = copy.folder / "build" / preset
        self._configure = configure
        self._objects = {}
        self._inputs = {}

    def prepare(self, targets):
        """Configures, and builds the targets (all, if none are given) without mutants."""
        outcome = self.runner.run(["cmake", "--preset", self.preset, *self._configure], self.copy.folder)
        if outcome.code != 0:
            raise BuildError(outcome.output)
        outcome = self._run(targets, lambda: False)
        if outcome.code != 0:
            raise BuildError(outcome.output)
        self._objects = self._objects_of_sources()
        self._inputs = {}

    def build(self, targets):
        """Builds the targets and returns the result: "done", "not compiled", "failed" or "hanging"."""
        end = time.monotonic() + LONGEST_BUILD
        outcome = self._run(targets, lambda: time.monotonic() > end)
        if outcome.is_hanging:
            return "hanging"
        if outcome.code == 0:
            return "done"
        failed = re.findall(r"^FAILED: (.*)$", outcome.output, re.MULTILINE)
        if any(outputs.split(" ")[0].endswith(".o") for outputs in failed) or "ld returned" in outcome.output:
            return "not compiled"
        return "failed"

    def programs_of(self, program):
        """Returns a program and those that are built before it, which it may run."""
        return [path for path in self._inputs_of(program)
                if not os.path.isabs(path) and is_program(self.folder / path)]

    def depends(self, program, source):
        path = str(self.copy.folder / source)
        inputs = self._inputs_of(program)
        return path in inputs or not self._objects[path].isdisjoint(inputs)

    def sources_of(self, program):
        """Returns the sources that a program itself is compiled from, without its libraries."""
        own = f"/{os.path.basename(program)}.dir/"
        inputs = self._inputs_of(program)
        return [source for source, objects in self._objects.items()
                if any(own in each and each in inputs for each in objects)]

    def digest(self, programs):
        """Computes a digest of the code of programs; source lines in debug information do not matter."""
        digest = hashlib.sha256()
        with tempfile.NamedTemporaryFile() as bare:
            for program in sorted(programs):
                subprocess.run(
                    ["objcopy", "--strip-all", "--remove-section=.note.gnu.build-id", self.folder / program, bare.name],
                    check=True, start_new_session=True)
                with open(bare.name, "rb") as file:
                    digest.update(hashlib.sha256(file.read()).digest())
        return digest.hexdigest()

    def _run(self, targets, is_late):
        command = ["cmake", "--build", "--preset", self.preset, "--parallel", self.jobs]
        if targets:
            command += ["--target", *targets]
        return self.runner.run(command, self.copy.folder, is_late)

    def _ninja(self, *arguments):
        outcome = self.runner.run(["ninja", "-C", self.folder, "-t", *arguments], self.copy.folder)
        if outcome.code != 0:
            raise BuildError(outcome.output)
        return outcome.output.split("\n")

    def _inputs_of(self, program):
        if program not in self._inputs:
            self._inputs[program] = {program, *(line.strip() for line in self._ninja("inputs", program))}
        return self._inputs[program]

    def _objects_of_sources(self):
        """Returns the objects that include each file of the tree."""
        found = defaultdict(set)
        mine, current = f"{self.copy.folder}/", None
        for line in self._ninja("deps"):
            path = line.strip()
            if path and line == path:
                current = path.split(": #deps")[0]
            elif path:
                path = os.path.normpath(self.folder / path)
                if path.startswith(mine):
                    found[path].add(current)
        return found


def is_program(path):
    return path.is_file() and os.access(path, os.X_OK) and path.suffix not in (".so", ".sh")
