"""Many runs of the disk from spread starts, on one core."""

import statistics

import build
import problems
import size
import tools
from measure import error, interleaved
from measure import started as present
from sections.runs import TRIPOS_REFERENCE
from tables import aims, duration, table

COUNT, TOLERANCE = size.of(10_000, 32), 1e-6
# The error that is asked for beside the tolerance: of half the sample.
TARGET = 1e-6
TOLERANCES = size.of([10.0 ** (-k / 2) for k in range(8, 27)], [1e-9, 1e-11])
# Runs of the search for a tolerance; what is sampled in all.
FEW, SAMPLE, MOST_ROUNDS = size.of(64, 32), 16, 5

TRIPOS = {
    f"Tripos, DOP853, one by one, {build.BUILD}": "lagrange dop853",
    f"Tripos, Taylor, one by one, {build.BUILD}": "lagrange taylor",
    f"Tripos, DOP853 in lanes, {build.BUILD}": "lagrange lanes-dop853",
    f"Tripos, Taylor in lanes, {build.BUILD}": "lagrange lanes-taylor",
}
# As everyone builds it: what the processor has is asked when lanes run.
DEFAULT = size.of({name.replace("native", "default build"): words for name, words in TRIPOS.items() if "in lanes" in name}, {})
# The scene's reduced equations, which have no tolerance, and answer ten outputs.
QUADRATURE = f"Tripos, reduced, quadrature, {build.BUILD}"
QUADRATURE_DEFAULT = size.of(["Tripos, reduced, quadrature, default build"], [])
LOOPS, VECTORS = "C by hand, loops", "C by hand, vector types"
BATCH, ENSEMBLE = "heyoka, batches of {}", "heyoka, ensemble of batches of {}"
WIDTHS = (8, 16)


def section(rounds):
    rounds = min(rounds, MOST_ROUNDS)
    starts = problems.write_starts(COUNT)
    peers = started()
    few = problems.write_starts(FEW)
    tripos = peers[next(iter(TRIPOS))]
    references = {path: sampled(tripos, count, path) for path, count in {few: FEW, starts: COUNT}.items()}
    tolerances = {name: loosest(name, peer, few, references[few]) for name, peer in peers.items()}
    askings, errors, steps = {}, {}, {}
    for name, peer in peers.items():
        for column, tolerance in (("tolerance", TOLERANCE), ("error", tolerances[name])):
            peer.ask(f"prepare {tolerance!r}")
            line = f"batch {COUNT} {tolerance!r} {starts}"
            _, tried, *ends = peer.ask(line)
            errors[name, column], steps[name, column] = errors_of(ends, references[starts]), tried
            askings[name, column] = lambda peer=peer, line=line: peer.ask(line)[0] / COUNT
    build.say(f"{COUNT} runs of the disk, {rounds} rounds")
    samples = interleaved(askings, rounds)
    for peer in peers.values():
        peer.close()
    return [*title(rounds), *overview(peers, samples, steps, errors, tolerances), "", *judged(peers, samples)]


def title(rounds):
    yield "## Batches"
    yield ""
    yield f"{COUNT} runs of the disk over 10 s on one core, from starts spread about that of the section on runs (a low-discrepancy"
    yield f"sequence; half its widths, in the order of the state: {', '.join(map(str, problems.RUN_WIDTHS))}). The time of a run, median of"
    yield f"{rounds} samples; steps tried; errors of {SAMPLE} ends, the middle one and the largest, from DOP853 in 32 digits. First all at"
    yield f"rtol = atol = {TOLERANCE:.0e}, then each at the loosest tolerance by which the middle error is at most {TARGET:.0e} in a"
    yield f"sample of {SAMPLE} of {FEW} runs. Reduced: by the equations of the scene itself, with the constants that each start fixes,"
    yield "taken from it in twice the precision of a double; quadrature has no tolerance, and its steps are those of the output."
    yield ""


def started():
    best = build.example("peer", build.NATIVE)
    rows = {name: ((), lambda words=words: [best, *words.split()]) for name, words in TRIPOS.items()}
    if DEFAULT:
        everyone = build.example("peer", native=False)
        rows |= {name: ((), lambda words=words: [everyone, *words.split()]) for name, words in DEFAULT.items()}
    scene = build.example("scene", build.NATIVE)
    rows[QUADRATURE] = ((), lambda: [scene, "report-10s", "quadrature"])
    for name in QUADRATURE_DEFAULT:
        of_everyone = build.example("scene", native=False)
        rows[name] = ((), lambda: [of_everyone, "report-10s", "quadrature"])
    rows[LOOPS] = ((tools.C,), lambda: [build.c_program("disk_loops")])
    rows[VECTORS] = ((tools.C,), lambda: [build.c_program("disk_vectors")])
    kinds = {BATCH.format(width): ("batch", width) for width in WIDTHS} | {ENSEMBLE.format(8): ("ensemble", 8)}
    rows |= {name: (tools.HEYOKA, lambda words=words: tools.worker("batch_worker.py", *words)) for name, words in kinds.items()}
    return present(rows, "start")


def sampled(tripos, count, path):
    """References of the runs whose ends are compared."""
    build.say(f"references of {SAMPLE} runs of {count}")
    return [tripos.ask(f"reference {TRIPOS_REFERENCE!r} {k * count // SAMPLE} {path}") for k in range(SAMPLE)]


def errors_of(ends, references):
    return [error(ends[10 * k : 10 * k + 10], reference) for k, reference in enumerate(references)]


def loosest(name, peer, path, references):
    """The loosest tolerance that reaches the target in half the sample."""
    smallest = float("inf")
    for tolerance in TOLERANCES:
        peer.ask(f"prepare {tolerance!r}")
        _, _, *ends = peer.ask(f"batch {FEW} {tolerance!r} {path}")
        smallest = min(smallest, middle := statistics.median(errors_of(ends, references)))
        if middle <= TARGET:
            return tolerance
    raise SystemExit(f"{name} comes no nearer to the references than {smallest:.1e}, not to {TARGET:.0e}")


def overview(peers, samples, steps, errors, tolerances):
    rows = []
    for name in peers:
        cells = []
        for column in ("tolerance", "error"):
            key = name, column
            found = f"{statistics.median(errors[key]):.0e}, {max(errors[key]):.0e}"
            cells += [duration(samples[key].median), f"{steps[key] / COUNT:.0f}", found]
        rows.append([name, *cells[:3], f"{tolerances[name]:.1e}", *cells[3:]])
    head = ("", f"at {TOLERANCE:.0e}", "steps", "errors", "tolerance", f"to {TARGET:.0e}", "steps", "errors")
    return table(head, rows)


def judged(peers, samples):
    """The fastest of Tripos against the fastest of heyoka, if it is here: by all equations, and by those of the scene."""
    rows = []
    heyoka = [name for name in peers if name.startswith("heyoka")]
    ours = [name for name in peers if name.startswith("Tripos")]
    own = [QUADRATURE, *QUADRATURE_DEFAULT]
    groups = {"all equations": [name for name in ours if name not in own], "the scene's own": own}
    columns = (("tolerance", f"a run at tolerance {TOLERANCE:.0e}"), ("error", f"a run to an error of {TARGET:.0e}"))
    for column, what in columns if heyoka else ():
        fastest = lambda names: min(samples[name, column].median for name in names)
        for group, names in groups.items():
            rows.append((f"{what}, {group}", "heyoka, its fastest", fastest(names), fastest(heyoka), 0.4))
    return aims(rows)
