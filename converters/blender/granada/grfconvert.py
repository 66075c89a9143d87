"""Runs `grfconvert`, the converter of Granada."""
import os
import shutil
import subprocess


class ConversionError(RuntimeError):
    """What `grfconvert` said, or that there is none."""


def find(preferred):
    """The path of the program: the one in the preferences, or what PATH has."""
    if preferred:
        if shutil.which(preferred):
            return preferred
        raise ConversionError(f"grfconvert is not at '{preferred}': correct its path in the preferences of the add-on")
    found = shutil.which("grfconvert")
    if not found:
        raise ConversionError("grfconvert was not found on PATH: install Granada, or give the path of grfconvert in "
                              "the preferences of the add-on")
    return found


def convert(program, source, target):
    """Runs a conversion. Returns its warnings; an error is raised with its messages."""
    try:
        done = subprocess.run([program, source, "-o", target], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              stdin=subprocess.DEVNULL, check=False)
    except OSError as problem:
        raise ConversionError(f"grfconvert cannot be run: {problem}") from problem
    messages = done.stderr.decode(errors="replace").strip()
    if done.returncode != 0 or not os.path.exists(target):
        raise ConversionError(messages or f"grfconvert ended with the code {done.returncode}")
    return [line for line in messages.split("\n") if "warning: " in line]
