"""Results as tables, in Markdown."""

import datetime

import build
from measure import TARGETS

LAGRANGE = "Tripos, Lagrange, native"
KANE = "Tripos, Kane, native"
DYN = "Tripos, through `dyn System`, native"
LAGRANGE_DEFAULT = "Tripos, Lagrange, default build"
DYN_DEFAULT = "Tripos, through `dyn System`, default build"
UNFUSED = "C by hand, loops, nothing fused"
LOOPS = "C by hand, loops"
VECTORS = "C by hand, vector types"
HEYOKA = "heyoka, Taylor"
ODE = "SciPy `ode('dop853')`, numba"
SOLVE_IVP = "SciPy `solve_ivp`, DOP853, numba"
PEERS = [UNFUSED, LOOPS, VECTORS, HEYOKA, ODE, SOLVE_IVP]
# Those whose every call of the right-hand side is part of a DOP853 of their own, and who tell what it costs.
DOP853 = [LAGRANGE, KANE, DYN, LAGRANGE_DEFAULT, DYN_DEFAULT, UNFUSED, LOOPS, VECTORS]


def tables(peers, rounds, loads):
    base = next(peer for peer in peers if peer.name == LAGRANGE)
    return "\n".join(
        [
            "# Tripos and its peers on the disk, t = 0 … 10 s",
            "",
            f"Written by `python3 benches/peers/run.py --rounds {rounds}` on {datetime.date.today()}.",
            "",
            "Time to reach an error in the end state (the largest of ten, |e|/(1 + |reference|)), and in brackets how many",
            f"times that of the row “{base.name}”. Methods: DOP853 everywhere but in heyoka.",
            "",
            *times(peers, base),
            "",
            *ratios(peers, base),
            "",
            "How it was reached: rtol = atol; steps tried; evaluations of the right-hand side; half the distance between the",
            "quartiles of the samples. For heyoka an evaluation is one of all Taylor coefficients.",
            "",
            *details(peers),
            "",
            "Where the time goes: a call of the right-hand side by itself, its arguments and results in memory, each waiting",
            f"for the one before; and a run to the error {TARGETS[-1]:.0e}, divided by its calls. The first is rough: it depends",
            "on where in memory a process starts, and a run hides part of it.",
            "",
            *shares(peers),
            "",
            *notes(peers, rounds, loads),
            "",
        ]
    )


def seconds(peer, target):
    return peer.reached[target].seconds if target in peer.reached else float("inf")


def times(peers, base):
    yield "| | " + " | ".join(f"error {target:.0e}" for target in TARGETS) + " |"
    yield "|---|" + "---:|" * len(TARGETS)
    for peer in peers:
        cells = [cell(seconds(peer, target), seconds(base, target)) for target in TARGETS]
        yield f"| {peer.name} | {' | '.join(cells)} |"


def cell(time, unit):
    if time == float("inf"):
        return "not reached"
    return f"{milliseconds(time)} ({time / unit:.2f})"


def milliseconds(time):
    return f"{time * 1e3:#.3g}".rstrip(".") + " ms"


def ratios(peers, base):
    yield "| Tripos ÷ peer, by medians (by fastest samples) | " + " | ".join(f"error {target:.0e}" for target in TARGETS) + " |"
    yield "|---|" + "---:|" * len(TARGETS)
    for peer in peers:
        if peer.name in PEERS:
            cells = [quotients(base.reached.get(target), peer.reached.get(target)) for target in TARGETS]
            yield f"| {peer.name} | {' | '.join(cells)} |"


def quotients(ours, theirs):
    if ours is None or theirs is None:
        return "not reached"
    return f"{ratio(ours.seconds / theirs.seconds)} ({ratio(min(ours.samples) / min(theirs.samples))})"


def ratio(value):
    return f"{value:.2f}" if value > 0.1 else f"1/{1 / value:.0f}"


def details(peers):
    yield "| | error | tolerance | error reached | steps | evaluations | a sample | fastest | spread |"
    yield "|---|---:|---:|---:|---:|---:|---:|---:|---:|"
    for peer in peers:
        for target, reached in peer.reached.items():
            a = reached.answer
            runs = "1 run" if reached.repeats == 1 else f"{reached.repeats} runs"
            yield (
                f"| {peer.name} | {target:.0e} | {reached.tolerance:.1e} | {a.error:.1e} | {a.steps} | {a.evaluations} "
                f"| {runs} | {milliseconds(min(reached.samples))} | {100 * reached.spread:.1f} % |"
            )


def shares(peers):
    yield "| | right-hand side alone | the run, for each call |"
    yield "|---|---:|---:|"
    for peer in peers:
        if peer.rates is not None:
            reached = peer.reached[TARGETS[-1]]
            whole = reached.seconds / reached.answer.evaluations
            cells = [f"{time * 1e9:.1f} ns" for time in (peer.rates, whole)]
            yield f"| {peer.name} | {' | '.join(cells)} |"


def notes(peers, rounds, loads):
    by_name = {peer.name: peer for peer in peers}
    compiled = [f"{reached.prepared:.1f} s for {target:.0e}" for target, reached in by_name[HEYOKA].reached.items()]
    floors = sorted(peer.best for peer in peers)
    yield f"- Medians of {rounds} samples, taken in turns; load average {loads[0]:.1f} before, {loads[1]:.1f} after. What runs"
    yield "  longer than a turn of the scheduler, as SciPy does, waits for other programs if there are any: see `fastest`."
    yield f"- Not in the times: heyoka's compilation ({', '.join(compiled)});"
    yield f"  numba's, with the start of Python ({by_name[ODE].ready:.1f} s)."
    yield "- `native`: built with `-C target-cpu=native`, as the C programs are with `-march=native`. gcc then fuses"
    yield f"  multiplications with additions, unless told not to (`{build.UNFUSED}`); Tripos asks for that in stage sums only. Parameters are known to"
    yield "  heyoka and numba when they compile, not to C and Rust."
    yield f"- Smallest errors at any tolerance: {floors[0]:.0e} to {floors[-1]:.0e}, the rounding of the start included."
    yield "- Reference: DOP853 in 32 digits (`DoubleDouble`); heyoka's Taylor method in 33 digits gives the same to 14 or more."
    for what, value in build.machine().items():
        yield f"- {what}: {value}."
