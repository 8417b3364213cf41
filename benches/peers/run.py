#!/usr/bin/env python3
"""Measures Tripos against its peers, side by side: `python3 benches/peers/run.py [--rounds N]`.

The question: the ten states of the disk at t = 10 s (models/disk/scenes/report-10s.toml), to a given error. The same for all:
start and parameters to the last bit, rtol = atol, one thread, only the end is asked for. Each takes the loosest tolerance
of a list that reaches the error. Writes the tables to standard output and to benches/peers/results.md.

Needs Python 3.11 or newer with `venv`, a C compiler, cargo, and a network the first time. Everything made is in target/peers.

A worker reads lines and answers each with one line of numbers:

    start                    M R g, then the start it takes: q1 ... q5 and their rates
    prepare TOLERANCE        SECONDS that it took to make runs at this tolerance ready (compilation)
    run TOLERANCE REPEATS    SECONDS_PER_RUN STEPS EVALUATIONS, then the end; steps count attempts
    rates REPEATS            SECONDS_PER_CALL of the right-hand side, and a number that depends on all calls
    reference TOLERANCE      the end, computed with more than 30 digits from the start as the scene writes it
"""

import argparse
import math
import os
import sys
import tomllib

sys.dont_write_bytecode = True  # nothing is written beside the sources

import build
import measure
import report

SCENE = build.ROOT / "models/disk/scenes/report-10s.toml"
# Tolerances of the two references, each below what changes their 16th digit; and how near they must be to each other.
TRIPOS_REFERENCE, HEYOKA_REFERENCE, AGREEMENT = 1e-22, 1e-30, 1e-14
# What every worker must come down to: one that does not solves another problem.
SAME_PROBLEM = 1e-7


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=31, help="samples of each time (31)")
    parser.add_argument("--dry", action="store_true", help="leave results.md as it is")
    arguments = parser.parse_args()
    peers = started()
    check_start(peers)
    reference = checked_reference(peers)
    loads = [os.getloadavg()[0]]
    for peer in peers:
        build.say(f"which tolerances: {peer.name}")
        measure.search(peer, reference)
        if peer.best > SAME_PROBLEM:
            raise SystemExit(f"{peer.name} comes no nearer to the reference than {peer.best:.1e}")
    build.say(f"{arguments.rounds} rounds")
    measure.sample(peers, arguments.rounds, reference)
    measure.sample_rates([peer for peer in peers if peer.name in report.DOP853], arguments.rounds)
    loads.append(os.getloadavg()[0])
    text = report.tables(peers, arguments.rounds, loads)
    print(text)
    if not arguments.dry:
        (build.HERE / "results.md").write_text(text)
    for peer in peers:
        peer.close()


def started():
    python = build.python()
    loops, vectors = build.c_program("disk_loops"), build.c_program("disk_vectors")
    unfused = build.c_program("disk_loops", build.UNFUSED)
    default, native = build.rust_program(native=False), build.rust_program(native=True)
    commands = {
        report.LAGRANGE: [native, "lagrange"],
        report.KANE: [native, "kane"],
        report.DYN: [native, "eliminated-lagrange"],
        report.LAGRANGE_DEFAULT: [default, "lagrange"],
        report.DYN_DEFAULT: [default, "eliminated-lagrange"],
        report.UNFUSED: [unfused],
        report.LOOPS: [loops],
        report.VECTORS: [vectors],
        report.HEYOKA: [python, "-B", build.HERE / "heyoka_worker.py"],
        report.ODE: [python, "-B", build.HERE / "scipy_worker.py", "ode"],
        report.SOLVE_IVP: [python, "-B", build.HERE / "scipy_worker.py", "solve_ivp"],
    }
    return [measure.Peer(name, command) for name, command in commands.items()]


def check_start(peers):
    """All take the same start, and it is the scene's."""
    scene = tomllib.loads(SCENE.read_text())
    names = [f"q{i}" for i in range(1, 6)]
    wanted = [scene["parameters"][name] for name in ("M", "R", "g")]
    wanted += [number(scene["start"][name]) for name in names + [f"{name}'" for name in names]]
    if scene["span"] != [0, 10]:
        raise SystemExit("the scene no longer runs from 0 to 10 s, as the workers do")
    for peer in peers:
        if peer.start != peers[0].start or any(not math.isclose(a, b, rel_tol=4e-16) for a, b in zip(peer.start, wanted)):
            raise SystemExit(f"{peer.name} starts from {peer.start}, the scene from {wanted}")


def number(value):
    """A number of a scene, or one in degrees."""
    return math.radians(float(value.removesuffix("*deg"))) if isinstance(value, str) else value


def checked_reference(peers):
    """The end by DOP853 in 32 digits, if the Taylor method in 33 digits says the same."""
    by_name = {peer.name: peer for peer in peers}
    reference = by_name[report.LAGRANGE].ask(f"reference {TRIPOS_REFERENCE!r}")
    other = by_name[report.HEYOKA].ask(f"reference {HEYOKA_REFERENCE!r}")
    if measure.error(reference, other) > AGREEMENT:
        raise SystemExit(f"the references differ:\n  {reference}\n  {other}")
    return reference


if __name__ == "__main__":
    main()
