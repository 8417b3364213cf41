"""Whole runs: the ten states of the disk at t = 10 s to a given error, by all equations and by those of a scene."""

import build
import problems
import size
import tools
from measure import error, interleaved
from measure import started as present
from sections import scenes
from sections.search import Question, search
from tables import aims, details, duration, quotients, table

# The smallest tolerance that is tried is what doubles allow.
TOLERANCES = size.of([10.0 ** (-k / 2) for k in range(4, 29)], [1e-6, 1e-9, 1e-12])
TARGETS = size.of([1e-3, 1e-6, 1e-8, 1e-9], [1e-3, 1e-6])
# Tolerances of the two references, each below what changes their 16th digit; and how near they must be to each other. At the small
# size some digits less will do.
TRIPOS_REFERENCE, HEYOKA_REFERENCE, AGREEMENT = size.of((1e-22, 1e-30, 1e-14), (1e-18, 1e-30, 1e-12))

# The method of rows that do not name one.
METHOD = "dop853"
# Rows of Tripos, as the best build that there is.
LAGRANGE, KANE, DYN = (f"Tripos, {what}, {build.BUILD}" for what in ("Lagrange", "Kane", "through `dyn System`"))
LAGRANGE_DEFAULT = "Tripos, Lagrange, default build"
DYN_DEFAULT = "Tripos, through `dyn System`, default build"
UNFUSED = "C by hand, loops, nothing fused"
LOOPS = "C by hand, loops"
VECTORS = "C by hand, vector types"
HEYOKA = "heyoka, Taylor"
ODE = "SciPy `ode('dop853')`, numba"
SOLVE_IVP = "SciPy `solve_ivp`, DOP853, numba"
PEERS = [UNFUSED, LOOPS, VECTORS, HEYOKA, ODE, SOLVE_IVP]
SCIPY = ("scipy", *tools.NUMBA)


def section(rounds):
    peers, (ten, two) = started(), scenes.started()
    check_start([*peers.values(), *ten.values(), *two.values()])
    reference = checked_reference(peers)
    whole = Question("whole", TARGETS, TOLERANCES, reference)
    rows = peers | {name: ten[name] for name in scenes.REDUCED}
    for peer in rows.values():
        search(peer, whole)
    questions = [whole, *scenes.asked(ten, two, reference)]
    askings = {}
    # All workers in turn for one error, then for the next.
    for question in questions:
        for key in sorted(question.reached, key=lambda key: question.targets.index(key[1])):
            found = question.reached[key]
            line = f"run {found.tolerance!r} {found.repeats}"
            askings[question.name, *key] = lambda peer=found.peer, line=line: peer.ask(line)[0]
    samples = interleaved(askings, rounds)
    for question in questions:
        for key, found in question.reached.items():
            found.samples = samples[question.name, *key]
    reached = whole.reached
    lines = ["## Whole runs of the disk, t = 0 … 10 s", "", *ABOUT, ""]
    lines += [*times(rows, reached), "", *ratios(peers, reached), *judged(rows, reached)]
    lines += [*HOW, "", *details(reached), "", *notes(peers, reached, whole.best), "", *scenes.lines(*questions[1:])]
    for peer in [*peers.values(), *ten.values(), *two.values()]:
        peer.close()
    return lines


ABOUT = [
    "Time to reach an error in the end state (the largest of ten, |e|/(1 + |reference|)), and in brackets how many",
    f"times that of the row “{LAGRANGE}”. Methods: DOP853 everywhere but in heyoka, and where another is named. Reduced: by the",
    "equations of the scene itself, as `tripos simulate` runs it, with the constants that its start fixes and all ten outputs.",
]
HOW = [
    "How it was reached: rtol = atol, the loosest of a list; steps tried; evaluations of the right-hand side; what a run took for",
    "each of these; half the distance between the quartiles of the samples. For a Taylor method an evaluation is one of all",
    "coefficients.",
]


def started():
    """Each worker by the name of its row. A method that the Tripos worker gains has rows of its own."""
    builds = {"default build": build.example("peer", native=False)}
    if build.NATIVE:
        builds["native"] = build.example("peer", native=True)
    best, default = builds[build.BUILD], builds["default build"]
    commands = {
        LAGRANGE: [best, "lagrange", METHOD],
        KANE: [best, "kane", METHOD],
        DYN: [best, "eliminated-lagrange", METHOD],
        LAGRANGE_DEFAULT: [default, "lagrange", METHOD],
        DYN_DEFAULT: [default, "eliminated-lagrange", METHOD],
    }
    for method in build.lines([best, "methods"]):
        if method != METHOD:
            ordered = sorted(builds, key=lambda name: name != build.BUILD)
            commands |= {by_method(method, name): [builds[name], "lagrange", method] for name in ordered}
    ours = {name: ((), lambda words=words: words) for name, words in commands.items()}
    return present(ours | others(), "start")


def by_method(method, name):
    return f"Tripos, Lagrange, {method}, {name}"


def others():
    """What the rows of the peers need, and their commands."""
    return {
        UNFUSED: ((tools.C,), lambda: [build.c_program("disk_loops", build.UNFUSED)]),
        LOOPS: ((tools.C,), lambda: [build.c_program("disk_loops")]),
        VECTORS: ((tools.C,), lambda: [build.c_program("disk_vectors")]),
        HEYOKA: (tools.HEYOKA, lambda: tools.worker("heyoka_worker.py", "double")),
        ODE: (SCIPY, lambda: tools.worker("scipy_worker.py", "ode")),
        SOLVE_IVP: (SCIPY, lambda: tools.worker("scipy_worker.py", "solve_ivp")),
    }


def check_start(peers):
    """All take the same start, and it is the scene's."""
    wanted = problems.parameters("disk") + problems.start("disk")
    start = peers[0].greeting
    for peer in peers:
        if peer.greeting != start or error(peer.greeting, wanted) > 4e-16:
            raise SystemExit(f"{peer.name} starts from {peer.greeting}, the scene from {wanted}")


def checked_reference(peers):
    """The end by DOP853 in 32 digits, if a Taylor method says the same: heyoka's in 33 digits, or our own in 32."""
    reference = peers[LAGRANGE].ask(f"reference {TRIPOS_REFERENCE!r}")
    witness, tolerance = (HEYOKA, HEYOKA_REFERENCE) if HEYOKA in peers else (by_method("taylor", build.BUILD), TRIPOS_REFERENCE)
    other = peers[witness].ask(f"reference {tolerance!r}")
    if error(reference, other) > AGREEMENT:
        raise SystemExit(f"the references differ:\n  {reference}\n  {other}")
    return reference


def seconds(reached, name, target):
    found = reached.get((name, target))
    return found.samples.median if found else float("inf")


def times(peers, reached):
    rows = []
    for name in peers:
        cells = [(seconds(reached, name, target), seconds(reached, LAGRANGE, target)) for target in TARGETS]
        shown = (duration(t) if t == float("inf") else f"{duration(t)} ({t / unit:.2f})" for t, unit in cells)
        rows.append([name, *shown])
    return table(("", *(f"error {target:.0e}" for target in TARGETS)), rows)


def ratios(peers, reached):
    rows = []
    for name in (name for name in PEERS if name in peers):
        pairs = [(reached.get((LAGRANGE, target)), reached.get((name, target))) for target in TARGETS]
        rows.append([name, *(quotients(*pair, otherwise="not reached") for pair in pairs)])
    head = (f"{LAGRANGE} ÷ peer, by medians (by fastest samples)", *(f"error {target:.0e}" for target in TARGETS))
    return [*table(head, rows), ""] if rows else []


def judged(rows_of, reached):
    """The fastest method of Tripos against heyoka, by all equations and by those of the scene."""
    rows = []
    ours = [name for name in rows_of if name.startswith("Tripos")]
    for target in (1e-3, 1e-6, 1e-9) if HEYOKA in rows_of else ():
        for group in ([name for name in ours if name not in scenes.REDUCED], scenes.REDUCED):
            fastest = min(group, key=lambda name: seconds(reached, name, target))
            what = f"error {target:.0e}, by {fastest.removeprefix('Tripos, ')}"
            rows.append((what, HEYOKA, seconds(reached, fastest, target), seconds(reached, HEYOKA, target), 0.6))
    return [*aims(rows), ""] if rows else []


def notes(peers, reached, best):
    compiled = [f"{r.prepared:.1f} s for {target:.0e}" for (name, target), r in reached.items() if name == HEYOKA]
    floors = sorted(best.values())
    if HEYOKA in peers:
        yield f"- Not in the times: heyoka's compilation ({', '.join(compiled)})."
    if ODE in peers:
        yield f"- Not in the times: numba's compilation, with the start of Python ({peers[ODE].ready:.1f} s)."
        yield "- What runs longer than a turn of the scheduler, as SciPy does, waits for other programs if there are any: see `fastest`."
    yield f"- Smallest errors at any tolerance: {floors[0]:.0e} to {floors[-1]:.0e}, the rounding of the start included."
    witness = "heyoka's Taylor method in 33 digits" if HEYOKA in peers else "Tripos' Taylor method in 32 digits"
    yield f"- Reference: DOP853 in 32 digits (`DoubleDouble`); {witness} gives the same to 14 or more."
