"""Applies mutants one by one to a copy of the tree, and runs the tests that may kill them."""

import json
import shutil
import time
from pathlib import PurePath

from mutation.build import Build
from mutation.copy_of_tree import CopyOfTree
from mutation.processes import Runner
from mutation.results import KILLED, NOT_COMPILED, SAME_CODE, SURVIVED, TIMEOUT, Result
from mutation.suite import Suite

# A test hangs if it takes this many times as long as without a mutant, and longer than the limit in seconds.
SLOWER = 8
LEAST_LIMIT = 20


class Worker:
    def __init__(self, tree, folder, options, stop, log):
        # Files that killed tests leave are removed with the copy.
        self.temporary = folder / "temporary"
        # All copies share the compiler cache.
        self.runner = Runner(stop, {"TMPDIR": str(self.temporary), "CCACHE_BASEDIR": str(folder.parent),
                                    "CCACHE_NOHASHDIR": "1"})
        self.copy = CopyOfTree(tree, folder / "tree")
        self.build = Build(self.copy, self.runner, options.preset, options.processors, options.configure)
        self.suite = Suite(self.build, self.runner, options.labels, options.exclude, options.memory)
        self.log = log
        self.targets = options.targets
        self.least_limit = options.least_limit
        self.groups = []
        self.digests = {}
        self._reliant = {}
        self._sources = {}

    def prepare(self):
        """Builds the copy without mutants."""
        self.empty()
        self.build.prepare(self.targets)
        self.groups = self.suite.groups(self.targets)
        self.suite.set_up(self.groups)
        for group in self.groups:
            self.digests[group.program] = self.build.digest(self.build.programs_of(group.program))

    def empty(self):
        """Removes files that tests have left."""
        shutil.rmtree(self.temporary, ignore_errors=True)
        self.temporary.mkdir(parents=True)

    def measure(self, paths, known_times):
        """Runs the tests that depend on the files without mutants, to measure their times and find failing ones."""
        times = json.loads(known_times.read_text()) if known_times.exists() else {}
        for group in self.groups:
            if not any(self.build.depends(group.program, path) for path in paths):
                continue
            digest = self.digests[group.program]
            entry = times.get(group.key)
            if entry is None or entry["digest"] != digest or entry["names"] != group.names:
                self.log(f"running {group.key} without mutants")
                entry = {"digest": digest, "names": group.names, **self._measured(group)}
                times[group.key] = entry
                known_times.write_text(json.dumps(times))
            group.seconds, group.refused = entry["seconds"], entry["refused"]
            for name in group.refused:
                self.log(f"left out, because it fails without a mutant: {name}")

    def take_times(self, other):
        """Takes the times that another worker has measured."""
        for group, measured in zip(self.groups, other.groups, strict=True):
            group.seconds, group.refused = measured.seconds, measured.refused

    def _measured(self, group):
        seconds, refused = {}, []

        def on_end(name, is_fine, duration):
            seconds[name] = duration
            if not is_fine:
                refused.append(name)

        self.suite.run(group, lambda name: 3600, on_end, stop_on_failure=False)
        return {"seconds": seconds, "refused": refused}

    def groups_for(self, path):
        """Returns the tests that can detect a change of a file: quick tests first, of these those of its folder."""
        if path not in self._reliant:
            self._reliant[path] = [group for group in self.groups if self.build.depends(group.program, path)]
        labels = self.suite.labels
        return sorted(self._reliant[path],
                      key=lambda group: (labels.index(group.label), -self._closeness(group, path), group.duration))

    def _closeness(self, group, path):
        parts = {*PurePath(path).parent.parts}
        if group.program not in self._sources:
            self._sources[group.program] = [PurePath(each).name for each in self.build.sources_of(group.program)]
        is_about_it = f"{PurePath(path).stem}_test.cpp" in self._sources[group.program]
        return len(parts & set(PurePath(group.folder).parts)) + is_about_it

    def judge(self, mutant):
        start = time.monotonic()
        diff = mutant.diff(self.copy.text_of(mutant.path))
        built = []
        with self.copy.planted(mutant):
            verdict, test = self._try_all(mutant, built)
        if built:
            self.build.build(built)  # as it was, since tests may run programs that they do not say they need
        self.empty()
        return Result(mutant.id, mutant.path, mutant.line, verdict, test, round(time.monotonic() - start, 1), diff)

    def _try_all(self, mutant, built):
        is_changed = False
        groups = self.groups_for(mutant.path)
        for group in groups:
            built.append(group.program)
            state = self.build.build([group.program])
            if state == "not compiled":
                return NOT_COMPILED, ""
            if state != "done":
                return (TIMEOUT if state == "hanging" else KILLED), f"the build of {group.program}"
            if self.build.digest(self.build.programs_of(group.program)) == self.digests[group.program]:
                continue
            is_changed = True
            found = self.suite.run(group, lambda name: self._limit(group, name))
            if found.kind != "passed":
                return (TIMEOUT if found.kind == "hanging" else KILLED), found.test
        return (SURVIVED, "") if is_changed or not groups else (SAME_CODE, "")

    def _limit(self, group, name):
        return max(self.least_limit, SLOWER * group.seconds.get(name, 0))
