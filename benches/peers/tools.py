"""What is here of what rows need: compilers, headers, and packages of Python. A row without its tools is left out, and said to be.

Invariant: nothing is installed unless PACKAGES is "all", which run.py chooses before it reads a section.
"""

import functools
import json
import os
import shutil
import sys

import build

# "all": those of requirements.txt, in an environment of their own; "installed": what there is; "none".
PACKAGES = "all"
# By what they miss, the rows that the section at hand has to do without.
LEFT_OUT = {}

C, CPP, EIGEN = "a C compiler", "a C++ compiler", "Eigen (`libeigen3-dev`, or the folder of its headers in `EIGEN`)"
PINOCCHIO = "Pinocchio's headers (headers.txt)"
NAMES = ("numpy", "scipy", "numba", "llvmlite", "heyoka", "casadi", "sympy", "symengine", "symforce", "pydy", "cython", "matplotlib")
HEYOKA, NUMBA = ("numpy", "heyoka"), ("numpy", "numba")
# A Python says which it has; a folder of that name is none.
VERSIONS = """
import importlib.metadata, json, sys
have = {found.metadata["Name"].lower(): found.version for found in importlib.metadata.distributions()}
print(json.dumps({name: have[name] for name in sys.argv[1:] if name in have}))
"""


def has(row, *needs):
    """Whether all of these are here; if not, the row is noted as left out."""
    if missing := next((need for need in needs if not here(need)), None):
        rows = LEFT_OUT.setdefault(missing, [])
        rows += [row] if row not in rows else []
    return missing is None


def here(need):
    if need in (C, CPP):
        return shutil.which(build.compiler() if need == C else build.compiler_plus()) is not None
    if need == PINOCCHIO:
        return pinocchio() is not None
    return build.eigen() is not None if need == EIGEN else need in packages()


@functools.cache
def python():
    """The Python that the workers run in."""
    return build.python(install=True) if PACKAGES == "all" else build.python(install=False) or sys.executable


@functools.cache
def packages():
    """The versions of the packages that this Python has."""
    if PACKAGES == "none":
        return {}
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    return json.loads(build.lines([python(), "-c", VERSIONS, *NAMES], environment)[-1])


@functools.cache
def pinocchio():
    """The folder of Pinocchio's headers; none if they are not here."""
    return None if PACKAGES == "none" else build.headers(python(), install=PACKAGES == "all")


def worker(name, *words):
    """The command of a Python worker."""
    return [python(), "-B", build.WORKERS / name, *words]


def left_out():
    """What the section at hand did without, in words."""
    if PACKAGES == "none" and (rows := [row for need in (*NAMES, PINOCCHIO) for row in LEFT_OUT.get(need, [])]):
        yield f"- Left out, since packages of Python were not asked for: {'; '.join(dict.fromkeys(rows))}."
    for need, rows in LEFT_OUT.items():
        if PACKAGES != "none" or need not in (*NAMES, PINOCCHIO):
            yield f"- Left out, since {need} is not here: {'; '.join(rows)}."
