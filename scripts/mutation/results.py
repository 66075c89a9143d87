"""Stores the result of each mutant in a file at once, so that an interrupted run can resume."""

import json
from collections import Counter, defaultdict
from dataclasses import asdict, dataclass

KILLED, TIMEOUT, SURVIVED = "killed", "timeout", "survived"
NOT_COMPILED, SAME_CODE = "not compiled", "same code"
COUNTED = (KILLED, TIMEOUT, SURVIVED)


@dataclass(frozen=True)
class Result:
    id: str
    path: str
    line: int
    verdict: str
    test: str  # that has seen it
    seconds: float
    diff: str

    @property
    def is_counted(self):
        return self.verdict in COUNTED


class Results:
    """Results for one state of the tree and one choice of tests."""

    def __init__(self, path, state):
        self.path = path
        self.state = state
        self.known = {}
        if path.exists():
            for line in path.read_text().splitlines():
                self._read(line)

    def _read(self, line):
        try:
            record = json.loads(line)
        except json.JSONDecodeError:
            return  # half a line: the run was ended while it wrote
        if record.pop("state") == self.state:
            result = Result(**record)
            self.known[result.id] = result

    def add(self, result):
        self.known[result.id] = result
        self.path.parent.mkdir(parents=True, exist_ok=True)
        with self.path.open("a") as file:
            file.write(json.dumps({"state": self.state, **asdict(result)}) + "\n")


def rate(results):
    counted = sum(result.is_counted for result in results)
    seen = sum(result.verdict in (KILLED, TIMEOUT) for result in results)
    return 100 * seen / counted if counted else 100.0


def report(results):
    """Formats a table by folder, and a list of survivors with their positions."""
    by_folder = defaultdict(Counter)
    for result in results:
        by_folder[result.path.rpartition("/")[0]][result.verdict] += 1
    columns = (KILLED, TIMEOUT, SURVIVED, NOT_COMPILED, SAME_CODE)
    lines = [f"{'folder':40}" + "".join(f"{column:>14}" for column in columns)]
    for folder, counts in sorted(by_folder.items()):
        lines.append(f"{folder:40}" + "".join(f"{counts[column]:14}" for column in columns))
    total = sum(by_folder.values(), Counter())
    lines.append(f"{'all':40}" + "".join(f"{total[column]:14}" for column in columns))
    survivors = [result for result in results if result.verdict == SURVIVED]
    for result in sorted(survivors, key=lambda each: (each.path, each.line)):
        lines += ["", f"survived: {result.id}", result.diff]
    lines += ["", f"{rate(results):.1f} % of {sum(result.is_counted for result in results)} mutants were killed."]
    return "\n".join(lines)
