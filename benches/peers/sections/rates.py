"""What one call of the right-hand side costs: independent calls, and calls that each wait for the one before."""

import time

import build
import problems
import size
import tools
from measure import Peer, interleaved, must_agree
from tables import aims, duration, table

PROBLEMS = ["disk", *(problems.chain(n) for n in size.of((2, 5, 10), ()))]
BUILDS = size.of({"Tripos, native": True, "Tripos, default build": False}, {"Tripos, default build": False})
OURS = next(iter(BUILDS))
# What a call of the rows above takes; other kinds that the Tripos worker gains have rows of their own.
ONE = "one"
HAND = "C by hand, closed form"
OURS_IN_C = "Tripos, C"
GENERATED = {
    "casadi-ldl": "CasADi C, L D L'",
    "casadi-qr": "CasADi C, QR",
    "sympy": "SymPy C, L D L'",
    "symforce": "SymForce C++, Eigen LLT",
}
NUMBA, HEYOKA = "numba, closed form", "heyoka `cfunc`, closed form, one state"
HEYOKA_BATCH = "heyoka `cfunc`, closed form, {} states at a time"
WIDTHS = (4, 8)
NEEDS = {
    "casadi-ldl": (tools.C, "casadi"),
    "casadi-qr": (tools.C, "casadi"),
    "sympy": (tools.C, "sympy"),
    "symforce": (tools.C, tools.CPP, tools.EIGEN, "symforce"),
}
# What is compiled in the process, by the word that its worker knows it by.
COMPILED = {NUMBA: ("numba", tools.NUMBA), HEYOKA: ("heyoka-1", tools.HEYOKA)}
COMPILED |= {HEYOKA_BATCH.format(w): (f"heyoka-{w}", tools.HEYOKA) for w in WIDTHS}
# Calls of a sample, in passes over 128 states; answers at so many states are compared.
PASSES, COMPARED, AGREEMENT = size.of(200, 2), 8, 1e-9


def section(rounds):
    folders = {problem: problems.write(problem) for problem in PROBLEMS}
    emitted = build.emitted_crate("rates", "lagrange", folders)
    builds = {name: build.program_of_emitted("rates", native) for name, native in BUILDS.items()}
    kinds = build.lines([builds[OURS][0], "kinds"])
    lines = ["## Right-hand side", "", *ABOUT, ""]
    results, made = {}, {}
    for problem in PROBLEMS:
        build.say(f"right-hand side of {problem}")
        peers, seconds = started(problem, folders[problem], builds, kinds)
        made |= {(problem, name): value for name, value in seconds.items()}
        results[problem] = measured(peers, problem, rounds)
        for peer in peers.values():
            peer.close()
    lines += [*overview(results), "", *compiled(results, made, emitted, builds), "", *judged(results)]
    return lines


ABOUT = [
    "(q', q'') from (q, q') and the parameters, all in memory, by a call that is not inlined, at 128 states in turn. Throughput:",
    "calls that do not wait for one another. Chained: each waits for the accelerations of the one before. Nanoseconds a state,",
    "medians, and in brackets the fastest sample. C with `-O3 -march=native`, Tripos also as everyone builds it; derived forms are",
    "made by each tool from the same M and f as in the section on derivation. All give the same numbers to 1e-9.",
]


def started(problem, folder, builds, kinds):
    """The workers of a problem, and for each generated one the seconds to generate and to compile."""
    states, seconds = folder / "states", {}
    peers = {}
    for name, (program, _) in builds.items():
        for kind in kinds:
            row = name if kind == ONE else f"{name}, {kind}"
            peers[row] = Peer(row, [program, problem, kind, states])
    lengths = (len(problems.start(problem)) // 2, len(problems.parameters(problem)))
    if problem == "disk" and tools.has(HAND, tools.C):
        program, compiling = build.rates_program(copied("disk_rates.c"), lengths)
        peers[HAND], seconds[HAND] = Peer(HAND, [program, states]), (0.0, compiling)
    if tools.has(OURS_IN_C, tools.C):
        source, emitting = build.emitted_c(problem, folder, "lagrange")
        program, compiling = build.rates_program(source, lengths)
        peers[OURS_IN_C], seconds[OURS_IN_C] = Peer(OURS_IN_C, [program, states]), (emitting, compiling)
    for tool, name in GENERATED.items():
        if tools.has(name, *NEEDS[tool]):
            program, seconds[name] = generated(tool, folder, lengths)
            peers[name] = Peer(name, [program, states])
    if problem == "disk":
        for name, (kind, needs) in COMPILED.items():
            if tools.has(name, *needs):
                peers[name] = Peer(name, tools.worker("rates_worker.py", kind, states), "compiled")
                seconds[name] = (0.0, peers[name].greeting[0])
    return peers, seconds


def generated(tool, folder, lengths):
    """The program of a tool's code, and the seconds to generate and to compile that."""
    source = folder / f"{tool}.{'cpp' if tool == 'symforce' else 'c'}"
    begin = time.perf_counter()
    build.call(tools.worker("generate.py", tool, "{},{}".format(*lengths), source), quiet=True)
    generating = time.perf_counter() - begin
    program, compiling = build.rates_program(source, lengths, build.eigen())
    return program, (generating, compiling)


def copied(name):
    """A C file of the workers beside the files it includes, in a place where programs may be made."""
    folder = problems.FOLDER / "hand"
    folder.mkdir(parents=True, exist_ok=True)
    for file in (name, "disk_form.h"):
        (folder / file).write_text((build.WORKERS / file).read_text())
    return folder / name


def measured(peers, problem, rounds):
    must_agree({name: peer.ask(f"values {COMPARED}") for name, peer in peers.items()}, AGREEMENT)
    askings = {}
    for name, peer in peers.items():
        for what in ("throughput", "chained"):
            if what == "throughput" or "heyoka" not in name:
                askings[name, what] = lambda peer=peer, what=what: peer.ask(f"{what} {PASSES}")[0]
    return interleaved(askings, rounds)


def overview(results):
    for title, group in (("disk", ["disk"]), *size.of([("cart and chain", PROBLEMS[1:])], [])):
        names = dict.fromkeys(name for problem in group for name, _ in results[problem])
        head = [f"n = {problems.links(p)}, {what}" if len(group) > 1 else what for p in group for what in ("throughput", "chained")]
        rows = []
        for name in names:
            samples = [results[problem].get((name, what)) for problem in group for what in ("throughput", "chained")]
            rows.append([name, *(f"{1e9 * s.median:.1f} ({1e9 * s.fastest:.1f})" if s else "–" for s in samples)])
        yield from table((title, *head), rows)
        yield ""


def compiled(results, made, emitted, builds):
    yield "To generate the code, and to compile it (heyoka and numba: in the process, with the tool's own start):"
    yield ""
    rows = []
    for name in dict.fromkeys(name for _, name in made):
        cells = [made.get((problem, name)) for problem in PROBLEMS]
        rows.append([name, *(" + ".join(duration(seconds) for seconds in c if seconds) if c else "–" for c in cells)])
    everything = ", ".join(f"{duration(seconds)} ({name.removeprefix('Tripos, ')})" for name, (_, seconds) in builds.items())
    rows.insert(0, ["Tripos, `tripos emit`", *(duration(emitted[problem]) for problem in PROBLEMS)])
    yield from table(("", *PROBLEMS), rows)
    yield ""
    yield f"Tripos' modules together, all their functions, compile in {everything}."


def judged(results):
    seconds = lambda problem, name, what: results[problem][name, what].median
    compared = lambda problem, name, what: (seconds(problem, OURS, what), seconds(problem, name, what))
    names = dict.fromkeys(name for name, _ in results["disk"])
    rows = []
    for what in ("throughput", "chained") if HAND in names else ():
        rows.append(("disk, " + what, "C by hand", *compared("disk", HAND, what), 1.0))
    derived = [name for name in GENERATED.values() if name in names and "QR" not in name]
    rows += [("disk, throughput", name, *compared("disk", name, "throughput"), 0.2) for name in derived]
    # In lanes a call takes several states: what C for one state cannot do, and heyoka's batches can.
    lanes = min((name for name in names if name.startswith("Tripos")), key=lambda name: seconds("disk", name, "throughput"))
    what, ours = f"disk, per state, {lanes}", seconds("disk", lanes, "throughput")
    rows += [(what, name, ours, seconds("disk", name, "throughput"), 0.2) for name in derived if "SymForce" not in name]
    if batches := [seconds("disk", name, "throughput") for name in names if name in COMPILED and "at a time" in name]:
        rows.append((what, "heyoka `cfunc`, batch", ours, min(batches), 0.25))
    others = [name for name in derived if "SymForce" not in name]
    for problem in PROBLEMS[1:] if others else ():
        for what in ("throughput", "chained"):
            best = min(seconds(problem, name, what) for name in others)
            title = f"chain n = {problems.links(problem)}, {what}"
            rows.append((title, "best of SymPy C, CasADi C", seconds(problem, OURS, what), best, 0.6))
    return aims(rows)
