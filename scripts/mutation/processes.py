"""Runs programs and kills all their processes when they hang or when the run is interrupted."""

import os
import selectors
import signal
import subprocess
import threading
import time
import uuid
from dataclasses import dataclass
from pathlib import Path

MARK = "MUTATION_RUN"


class Interrupted(Exception):
    """The run was interrupted."""


@dataclass
class Outcome:
    code: int
    output: str
    is_hanging: bool


class Runner:
    """Runs one program at a time; `stop` kills it."""

    def __init__(self, stop: threading.Event, environment=None):
        self.stop = stop
        self.mark = uuid.uuid4().hex
        self.environment = {**os.environ, **(environment or {}), MARK: self.mark}

    def run(self, command, folder, is_late=lambda: False, on_line=lambda line: None, environment=None):
        """Runs a program until it exits, or hangs by `is_late`; `on_line` receives its output line by line."""
        if self.stop.is_set():
            raise Interrupted
        process = subprocess.Popen(
            [str(part) for part in command], cwd=folder, env={**self.environment, **(environment or {})},
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            output, is_hanging = self._follow(process, is_late, on_line)
        finally:
            self._end(process)
        if process.returncode < 0 and not is_hanging:
            raise RuntimeError(f"{command[0]} was killed by signal {-process.returncode}, so the mutant was not tested")
        return Outcome(process.returncode, output, is_hanging)

    def _follow(self, process, is_late, on_line):
        lines, rest = [], b""
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ)
            while True:
                if self.stop.is_set():
                    raise Interrupted
                if is_late():
                    return "\n".join(lines), True
                if not selector.select(timeout=0.2):
                    # Its child processes may hold the pipe open after it exits.
                    if process.poll() is not None:
                        break
                    continue
                data = os.read(process.stdout.fileno(), 1 << 16)
                if not data:
                    break
                *complete, rest = (rest + data).split(b"\n")
                for line in (part.decode(errors="replace") for part in complete):
                    lines.append(line)
                    on_line(line)
        # After the end of its output a program may need a while to exit.
        while process.poll() is None:
            if self.stop.is_set():
                raise Interrupted
            if is_late():
                return "\n".join(lines), True
            time.sleep(0.02)
        return "\n".join([*lines, rest.decode(errors="replace")]), False

    def _end(self, process):
        if process.poll() is None:
            process.terminate()  # so that ninja takes away what it has half written
            try:
                process.wait(timeout=2)
            except subprocess.TimeoutExpired:
                process.kill()
        while left := self._left():
            for number in left:
                try:
                    os.kill(number, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            process.poll()
            time.sleep(0.02)
        process.wait()
        process.stdout.close()

    def _left(self):
        """Finds processes that this runner started, by their environment, including orphans."""
        mark = f"{MARK}={self.mark}".encode()
        found = []
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                if mark in (folder / "environ").read_bytes().split(b"\0"):
                    found.append(int(folder.name))
            except OSError:
                continue  # it has ended, or is somebody else's
        return found
