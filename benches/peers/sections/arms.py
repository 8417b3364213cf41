"""What forward and inverse dynamics of an arm cost: generated functions against a library that is given its model as it starts."""

import math

import arms
import build
import problems
import size
import tools
from measure import Peer, interleaved, must_agree
from tables import aims, duration, table

ARMS = {"panda": "seven joints, the inertias of a Panda", "arm6": "six joints, full inertias, made up"}
BUILDS = size.of({"Tripos, native": True, "Tripos, default build": False}, {"Tripos, default build": False})
OURS_IN_C = "Tripos, C"
PINOCCHIO = "Pinocchio, C++"
WORK = {"forward": "forward dynamics", "inverse": "inverse dynamics"}
PASSES, COMPARED, AGREEMENT = size.of(400, 2), 8, 1e-9
STATES = 128

ABOUT = [
    "Accelerations from (q, u), and torques from (q, u, u'), by the functions that `tripos emit --formulation kane` writes in Rust and",
    "in C, and by Pinocchio's articulated bodies (`aba`) and recursive Newton-Euler (`rnea`). C and C++ are compiled with `-O3",
    "-march=native`; Rust also as everyone builds it. All take masses, inertias and distances as numbers in memory. Nanoseconds a state,",
    "at 128 states in turn, medians, and in brackets the fastest sample. All give the same numbers to 1e-9.",
]


def section(rounds):
    models = {name: arms.MODELS / f"{name}.toml" for name in ARMS}
    emitted = build.emitted_crate("arms", "kane", models)
    builds = {name: build.program_of_emitted("arms", native) for name, native in BUILDS.items()}
    pinocchio = build.pinocchio_program(tools.pinocchio()) if tools.has(PINOCCHIO, tools.CPP, tools.PINOCCHIO) else None
    results, in_c = {}, {}
    for name in ARMS:
        build.say(f"dynamics of {name}")
        states, chain = written(name)
        peers = {row: Peer(row, [program, name, states]) for row, (program, _) in builds.items()}
        if tools.has(OURS_IN_C, tools.C):
            source, _ = build.emitted_c(name, models[name], "kane", ("forward", "inverse"))
            lengths = {"JOINTS": len(arms.model(name)["coordinates"]), "PARAMETERS": len(arms.parameters(name))}
            program, in_c[name] = build.loops_program("arms", source, lengths)
            peers[OURS_IN_C] = Peer(OURS_IN_C, [program, states])
        if pinocchio:
            peers[PINOCCHIO] = Peer(PINOCCHIO, [pinocchio[0], chain, states])
        must_agree({row: peer.ask(f"values {COMPARED}") for row, peer in peers.items()}, AGREEMENT)
        askings = {
            (row, work): lambda peer=peer, work=work: peer.ask(f"{work} {PASSES}")[0] for row, peer in peers.items() for work in WORK
        }
        results[name] = interleaved(askings, rounds)
        for peer in peers.values():
            peer.close()
    return ["## Arms", "", *ABOUT, "", *overview(results), "", *made(emitted, builds, in_c, pinocchio), "", *judged(results)]


def written(name):
    """The files of states and of joints."""
    folder = problems.FOLDER / name
    n = len(arms.model(name)["coordinates"])
    # Angles over the whole turn, rates and accelerations of a few units.
    widths = [math.pi] * n + [2.0] * n + [5.0] * n
    lines = [arms.parameters(name), *problems.spread([0.3] * (3 * n), widths, STATES)]
    gravity, joints = arms.joints(name)
    for path, rows in (("states", lines), ("chain", [gravity, *joints])):
        build.write_text(folder / path, "".join(" ".join(map(repr, row)) + "\n" for row in rows))
    return folder / "states", folder / "chain"


def overview(results):
    for name, about in ARMS.items():
        rows = []
        for row in dict.fromkeys(row for row, _ in results[name]):
            cells = (results[name][row, work] for work in WORK)
            rows.append([row, *(f"{1e9 * s.median:.0f} ({1e9 * s.fastest:.0f}), ± {100 * s.spread:.1f} %" for s in cells)])
        yield from table((about, *WORK.values()), rows)
        yield ""


def made(emitted, builds, in_c, pinocchio):
    seconds = ", ".join(f"{name} {duration(taken)}" for name, taken in emitted.items())
    compiled = ", ".join(f"{duration(taken)} ({name.removeprefix('Tripos, ')})" for name, (_, taken) in builds.items())
    yield f"`tripos emit` took {seconds}; both modules together, all their functions, compile in {compiled}."
    if in_c:
        yield f"C of both functions compiles in {', '.join(f'{duration(taken)} ({name})' for name, taken in in_c.items())}."
    if pinocchio:
        yield f"The program around Pinocchio's headers compiles in {duration(pinocchio[1])}."


def judged(results):
    rows, native = [], next(iter(BUILDS))
    for name in ARMS:
        for work, title in WORK.items():
            if (OURS_IN_C, work) in results[name]:
                in_c, ours = results[name][OURS_IN_C, work], results[name][native, work]
                rows.append((f"{name}, {title}, C", native, in_c.median, ours.median, 1.1))
            for row in BUILDS:
                if (PINOCCHIO, work) in results[name]:
                    of = results[name]
                    rows.append((f"{name}, {title}, {row.removeprefix('Tripos, ')}", PINOCCHIO, of[row, work].median, of[PINOCCHIO, work].median, 0.5))
    return aims(rows)
