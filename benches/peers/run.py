#!/usr/bin/env python3
"""Measures Tripos against its peers, side by side: `python3 benches/peers/run.py [--rounds N] [--only SECTION,…]`.

Sections: derivation, mechanisms, rhs, arms, growth, runs, batches, first-result. In each all compute the same numbers, or nothing is measured, and
all take turns. Writes the tables to standard output, and those of each section to benches/peers/results/SECTION.md.

Needs Python 3.11 or newer with `venv`, a C and a C++ compiler, cargo, and a network the first time; for SymForce the headers of Eigen.
What is not here is left out, and said to be. `--packages installed` installs nothing, `--packages none` measures without Python's
packages. `--small` does as little as shows that all works, in seconds, and writes no results: a test runs it.
Everything made is in target/peers.

A worker reads lines and answers each with one line of numbers. A problem is a folder of target/peers/problems (problems.py).

    derive PROBLEM REPEATS         SECONDS of one derivation to M and f           (derivation)
    formulate REPEATS              SECONDS to read the file of what was derived last and to derive it     (mechanisms)
    start PROBLEM                  COUNT of parameters, these, q and q' where the scene in its folder starts
    together                       OPERATIONS FUNCTIONS of M and f as one function
    count | solve                  OPERATIONS FUNCTIONS of M and f | q'' at the first state, of what was derived last
    accelerations PROBLEM REPEATS  SECONDS OPERATIONS FUNCTIONS of one derivation to q''; `solve` then gives them    (growth)
    code FILE                      SECONDS to write C of them                     (growth)
    throughput | chained PASSES    SECONDS for a state of the right-hand side     (rhs)
    forward | inverse PASSES       SECONDS for a state of the accelerations, of the torques for given ones         (arms)
    values COUNT                   the derivatives at the first states, or accelerations and torques
    start                          M R g, then the start it takes: q1 ... q5 and their rates (runs, batches)
    prepare TOLERANCE              SECONDS that it took to make runs at this tolerance ready (compilation)
    run TOLERANCE REPEATS          SECONDS_PER_RUN STEPS EVALUATIONS, then the end; steps count attempts
    reference TOLERANCE [K FILE]   the end, computed with more than 30 digits from the start as the scene writes it, or from
                                   the K-th of a file
    batch COUNT TOLERANCE FILE     SECONDS STEPS for runs from so many starts of a file of doubles; then the ends of a sample
"""

import argparse
import datetime
import importlib
import os
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is written beside the sources

import size

SECTIONS = {
    "derivation": "sections.derivation",
    "mechanisms": "sections.mechanisms",
    "rhs": "sections.rates",
    "arms": "sections.arms",
    "growth": "sections.growth",
    "runs": "sections.runs",
    "batches": "sections.batches",
    "first-result": "sections.first_result",
}


def main():
    arguments = asked()
    # Before anything that states both sizes is read.
    size.SMALL = arguments.small
    tools = importlib.import_module("tools")
    tools.PACKAGES = arguments.packages
    for name in arguments.only:
        tools.LEFT_OUT.clear()
        begin, loads = time.monotonic(), [os.getloadavg()[0]]
        block = importlib.import_module(SECTIONS[name]).section(arguments.rounds)
        loads.append(os.getloadavg()[0])
        minutes = (time.monotonic() - begin) / 60
        text = "\n".join([*head(arguments, name), *block, "", *tail(tools, arguments.rounds, loads, minutes)]) + "\n"
        print(text, flush=True)
        if not (arguments.dry or arguments.small):
            results = Path(__file__).resolve().parent / "results"
            results.mkdir(exist_ok=True)
            (results / f"{name}.md").write_text(text)


def asked():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, help="samples of each time (31, or 1 with --small)")
    parser.add_argument("--only", type=sections, default=list(SECTIONS), help=f"some of {','.join(SECTIONS)}")
    packages = {"choices": ("all", "installed", "none"), "default": "all"}
    parser.add_argument("--packages", **packages, help="of Python: install all, take what there is, or none")
    parser.add_argument("--small", action="store_true", help="as little as shows that all works; writes no results")
    parser.add_argument("--dry", action="store_true", help="leave results/ as it is")
    arguments = parser.parse_args()
    arguments.rounds = arguments.rounds or (1 if arguments.small else 31)
    return arguments


def sections(text):
    """Each once, in the order of the results."""
    asked = text.split(",")
    if unknown := [name for name in asked if name not in SECTIONS]:
        raise argparse.ArgumentTypeError(f"there is no section {unknown[0]!r}: give some of {','.join(SECTIONS)}")
    return [name for name in SECTIONS if name in asked]


def head(arguments, name):
    packages = "" if arguments.packages == "all" else f" --packages {arguments.packages}"
    options = f"--rounds {arguments.rounds} --only {name}{packages}{' --small' if arguments.small else ''}"
    yield f"Written by `python3 benches/peers/run.py {options}` on {datetime.date.today()}."
    yield ""


def tail(tools, rounds, loads, minutes):
    build = tools.build
    yield "## How it was measured"
    yield ""
    if size.SMALL:
        yield "- Small: few calls of programs that are not built to be fast. That all works is seen here, nothing of speed."
    yield f"- Medians of {rounds} samples, fewer where the text says so, taken in turns; {minutes:.0f} minutes in"
    yield f"  all; load average {loads[0]:.1f} before, {loads[1]:.1f} after."
    if build.NATIVE:
        yield "- `native`: built with `-C target-cpu=native`, as the C programs are with `-march=native`. gcc then fuses"
        yield f"  multiplications with additions, unless told not to (`{build.UNFUSED}`); Tripos does where it asks for that. Parameters"
        yield "  are known to heyoka and numba when they compile, not to C and Rust."
    yield from tools.left_out()
    for what, value in build.machine(tools.packages()).items():
        yield f"- {what}: {value}."


if __name__ == "__main__":
    main()
