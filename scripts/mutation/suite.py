"""Lists CTest's tests, and runs those of one program."""

import json
import os
import re
import subprocess
import time
from dataclasses import dataclass, field

# Tests of source formatting and of generated documents are excluded: their expected values are not independent of the
# code.
EXCLUDED = r"^(format|tidy|documents_test)$|^documents_test\.|\.Documents\."
GTEST_FILTER = "-Documents.*"

STARTED = re.compile(r"^\s*Start\s+\d+: (\S+)")
ENDED = re.compile(r"^\s*\d+/\d+ Test\s+#\d+: (\S+) \.*\s*(\*{3})?(\S.*?)\s+(\d+\.\d+) sec")
FINE = ("Passed", "Skipped", "Not Run (Disabled)")


@dataclass
class Group:
    """The tests of one program with one label."""

    program: str  # its path in the build's folder
    label: str
    folder: str  # of the tests, as in the tree
    names: list = field(default_factory=list)
    selection: str = ""  # the expression that selects them
    seconds: dict = field(default_factory=dict)  # the time of each test without mutants
    refused: list = field(default_factory=list)  # tests that fail without mutants

    @property
    def key(self):
        return f"{self.program} {self.label}"

    @property
    def duration(self):
        return sum(self.seconds.values())


@dataclass
class Verdict:
    kind: str  # passed, failed or hanging
    test: str = ""


class Suite:
    def __init__(self, build, runner, labels, excluded, memory):
        self.build = build
        self.runner = runner
        self.labels = labels
        self.excluded = excluded
        self.memory = memory

    def groups(self, targets):
        """Lists the tests that can run: those of programs that are built, except those that measure time."""
        found, others = {}, []
        for test in self._listed():
            group = self._group_of(test)
            if group is None or (targets and os.path.basename(group.program) not in targets):
                others.append(test["name"])
                continue
            found.setdefault(group.key, group).names.append(test["name"])
        for group in found.values():
            group.selection = selection(group.names, set(others).union(
                *(other.names for other in found.values() if other is not group)))
        return list(found.values())

    def set_up(self, groups):
        """Runs the fixtures once, without a mutant that could affect their output."""
        chosen = {name for group in groups for name in group.names}
        tests = [(test["name"], properties_of(test)) for test in self._listed()]
        needed = {fixture for name, properties in tests if name in chosen
                  for fixture in properties.get("FIXTURES_REQUIRED", [])}
        makers = [re.escape(name) for name, properties in tests
                  if needed.intersection(properties.get("FIXTURES_SETUP", []))]
        if makers:
            command = ["ctest", "--test-dir", self.build.folder, "--tests-regex", f"^({'|'.join(makers)})$"]
            self.runner.run(command, self.build.copy.folder)

    def _listed(self):
        command = ["ctest", "--test-dir", self.build.folder, "--show-only=json-v1"]
        # A separate session, so that it does not receive interrupts.
        listed = subprocess.run(command, check=True, capture_output=True, text=True, start_new_session=True)
        return json.loads(listed.stdout)["tests"]

    def run(self, group, limit_of, on_end=lambda name, is_fine, seconds: None, stop_on_failure=True):
        """Runs tests; `limit_of` returns the time limit of each in seconds."""
        command = ["prlimit", "--core=0", f"--fsize={4 << 30}"]
        if self.memory:
            command.append(f"--data={int(self.memory * (1 << 30))}")
        command += ["ctest", "--test-dir", self.build.folder, "--parallel", self.build.jobs, "--no-tests=error",
                    "--tests-regex", group.selection, "--label-regex", f"^{group.label}$"]
        if stop_on_failure:
            command.append("--stop-on-failure")
        excluded = "|".join([self.excluded] * bool(self.excluded) + [f"^{re.escape(name)}$" for name in group.refused])
        if excluded:
            command += ["--exclude-regex", excluded]
        running, failed = {}, []

        def read(line):
            if match := STARTED.match(line):
                running[match[1]] = time.monotonic()
            elif match := ENDED.match(line):
                running.pop(match[1], None)
                is_fine = match[3] in FINE
                on_end(match[1], is_fine, float(match[4]))
                if not is_fine:
                    failed.append(match[1])

        def late():
            now = time.monotonic()
            return [name for name, start in running.items() if now - start > limit_of(name)]

        environment = {"GTEST_FILTER": GTEST_FILTER} if "GTEST_FILTER" not in os.environ else {}
        if stop_on_failure:
            environment["GTEST_FAIL_FAST"] = "1"
        outcome = self.runner.run(command, self.build.copy.folder, late, read, environment)
        if outcome.is_hanging:
            return Verdict("hanging", late()[0] if late() else group.program)
        if outcome.code == 0:
            return Verdict("passed")
        return Verdict("failed", failed[0] if failed else outcome.output.strip().split("\n")[-1])

    def _group_of(self, test):
        properties = properties_of(test)
        labels = [label for label in self.labels if label in properties.get("LABELS", [])]
        if not labels or re.search(self.excluded or r"\A\Z.", test["name"]) or properties.get("RUN_SERIAL"):
            return None
        program = self._program_of(test.get("command", []))
        if program is None:
            return None
        folder = os.path.relpath(properties.get("WORKING_DIRECTORY", self.build.folder), self.build.folder)
        return Group(program, labels[0], folder)

    def _program_of(self, command):
        """Returns whether a test runs a program that is built here, directly or by another program."""
        for part in command:
            if part.startswith(f"{self.build.folder}/") and os.path.isfile(part) and os.access(part, os.X_OK):
                return os.path.relpath(part, self.build.folder)
        return None


def properties_of(test):
    return {each["name"]: each["value"] for each in test["properties"]}


def selection(names, others):
    """Returns a regular expression that selects these tests: their common prefix, if no other test has it, because a
    mutant may change the names of tests."""
    start = os.path.commonprefix(names)
    if len(names) > 1 and start and not any(name.startswith(start) for name in others):
        return f"^{re.escape(start)}"
    return "^(" + "|".join(re.escape(name) for name in names) + ")$"
