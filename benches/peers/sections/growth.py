"""How derivation, operations and times of accelerations grow with the length of chains and arms."""

import build
import families
import problems
import size
import tools
from measure import Peer, error, interleaved, must_agree, repeats, started
from tables import aims, duration, ratio, table

CHAIN_LENGTHS, ARM_LENGTHS = size.of((2, 5, 10, 20, 40), (2,)), size.of((6, 10, 20, 40), (2,))
LENGTHS = {"absolute": CHAIN_LENGTHS, "relative": CHAIN_LENGTHS, "arm": ARM_LENGTHS}
PROBLEMS = [f"{family}_{n}" for family, lengths in LENGTHS.items() for n in lengths]
OURS = "Tripos, kane"
BODIES, HESSIAN = "CasADi, articulated bodies", "CasADi, Hessian of T, L D L'"
TOOLS = {BODIES: "bodies", HESSIAN: "hessian"}
# Where a Hessian has thousands of operations more than what it is compared with, it is left out.
LONGEST_HESSIAN = {"absolute": 20, "relative": 20, "arm": 6}
AGREEMENT, PASSES, COMPARED = 1e-8, size.of(200, 2), 2
STATES = 128
NATIVE = size.of(True, False)

ABOUT = [
    "Accelerations of planar links with point masses and of arms with full inertias, n of them, all parameters symbolic: from a model file that",
    "is read, or from a tool's own symbols, to their steps. CasADi: articulated bodies written in SX, whose structural zeros cost nothing, and the",
    "Hessian of T with L D L'; both with common subexpressions shared. Operations are one + − × ÷ each, sines and cosines apart. Right-hand sides:",
    "nanoseconds a state at 128 states in turn, compiled for this processor, `-O3`. All agree to 1e-8.",
]


def section(rounds):
    for problem in PROBLEMS:
        write(problem)
    peers = started(rows())
    results = {problem: derived(peers, problem, min(rounds, 5)) for problem in PROBLEMS}
    times = right_hand_sides(peers, results, rounds)
    for peer in peers.values():
        peer.close()
    lines = ["## Growth", "", *ABOUT, ""]
    for family, about in families.FAMILIES.items():
        lines += [*overview(family, about, results, times), ""]
    lines += judged(results, times)
    if not size.SMALL:
        draw(results, times)
    return lines


def rows():
    program = build.example("derivation", native=False)
    command = lambda tool: lambda: tools.worker("growth_worker.py", tool, problems.FOLDER)
    ours = {OURS: ((), lambda: [program, "kane", problems.FOLDER])}
    return ours | {name: (("casadi",), command(tool)) for name, tool in TOOLS.items()}


def write(problem):
    """The model file and the states, each with accelerations behind, which only inverse dynamics asks for."""
    folder, n = problems.FOLDER / problem, families.split(problem)[1]
    about = families.start(problem) + [0.0] * n
    lines = [list(families.values(problem).values()), *problems.spread(about, [1.0] * (3 * n), STATES)]
    build.write_text(folder / "states", "".join(" ".join(map(repr, line)) + "\n" for line in lines))
    # What right-hand sides are called at: (q, q') alone.
    shorter = [lines[0], *(line[: 2 * n] for line in lines[1:])]
    build.write_text(folder / "pairs", "".join(" ".join(map(repr, line)) + "\n" for line in shorter))
    build.write_text(folder / "model.toml", families.model_text(problem))


def derived(peers, problem, rounds):
    """(seconds, operations, functions) by peer."""
    build.say(f"accelerations of {problem}")
    family, n = families.split(problem)
    found, solutions, askings = {}, {}, {}
    for name, peer in peers.items():
        if name == HESSIAN and n > LONGEST_HESSIAN[family]:
            continue
        seconds, *counts = peer.ask(f"accelerations {problem} 1")
        solutions[name] = peer.ask("solve")
        found[name] = counts
        line = f"accelerations {problem} {repeats(seconds)}"
        askings[name] = lambda peer=peer, line=line: peer.ask(line)[0]
    for name, solution in solutions.items():
        if error(solution, solutions[OURS]) > AGREEMENT:
            raise SystemExit(f"{problem}: {name} has other accelerations than {OURS}:\n  {solution}\n  {solutions[OURS]}")
    samples = interleaved(askings, rounds)
    return {name: (samples[name], *counts) for name, counts in found.items()}


def right_hand_sides(peers, results, rounds):
    """Samples by (problem, peer): the shortest form of each tool, compiled."""
    models = {problem: problems.FOLDER / problem / "model.toml" for problem in PROBLEMS}
    build.emitted_crate("arms", "kane", models, "growth")
    program, _ = build.program_of_emitted("growth", NATIVE)
    times = {}
    for problem in PROBLEMS:
        build.say(f"right-hand side of {problem}")
        folder, n = problems.FOLDER / problem, families.split(problem)[1]
        best = min((name for name in results[problem] if name != OURS), key=lambda name: results[problem][name][1], default=None)
        workers, answers = {OURS: Peer(OURS, [program, problem, folder / "states"])}, {}
        answers[OURS] = [x for k in range(COMPARED) for x in workers[OURS].ask(f"values {COMPARED}")[2 * k * n : (2 * k + 1) * n]]
        if best and tools.has(best, tools.C):
            peers[best].ask(f"accelerations {problem} 1")
            peers[best].ask(f"code {folder / 'casadi.c'}")
            compiled, _ = build.rates_program(folder / "casadi.c", (n, len(families.values(problem))))
            workers[best] = Peer(best, [compiled, folder / "pairs"])
            values = workers[best].ask(f"values {COMPARED}")
            answers[best] = [x for k in range(COMPARED) for x in values[(2 * k + 1) * n : (2 * k + 2) * n]]
        must_agree(answers, AGREEMENT)
        lines = {OURS: f"forward {PASSES}", best: f"throughput {PASSES}"}
        askings = {(problem, name): lambda worker=worker, line=lines[name]: worker.ask(line)[0] for name, worker in workers.items()}
        times |= interleaved(askings, rounds)
        for worker in workers.values():
            worker.close()
    return times


def overview(family, about, results, times):
    lengths = LENGTHS[family]
    names = dict.fromkeys(name for n in lengths for name in results[f"{family}_{n}"])
    at = lambda n, name: results[f"{family}_{n}"].get(name)
    cell = lambda found, text: text(found) if found else "–"
    rows = []
    for name in names:
        rows.append([f"{name}: derivation", *(cell(at(n, name), lambda r: duration(r[0].median)) for n in lengths)])
        rows.append([f"{name}: operations", *(cell(at(n, name), lambda r: f"{r[1]:.0f} + {r[2]:.0f}") for n in lengths)])
        timed = [times.get((f"{family}_{n}", name)) for n in lengths]
        if any(timed):
            rows.append([f"{name}: a state", *(cell(s, lambda s: f"{1e9 * s.median:.0f} ns (± {100 * s.spread:.0f} %)") for s in timed)])
    return table((about, *(f"n = {n}" for n in lengths)), rows)


def judged(results, times):
    rows = []
    for problem in PROBLEMS:
        others = [name for name in results[problem] if name != OURS]
        if not others:
            continue
        family, n = families.split(problem)
        fewest = min(others, key=lambda name: results[problem][name][1])
        rows.append((f"{family}, n = {n}, operations", fewest, results[problem][OURS][1], results[problem][fewest][1], 0.6))
        if (problem, fewest) in times:
            ours, theirs = times[problem, OURS].median, times[problem, fewest].median
            rows.append((f"{family}, n = {n}, a state", f"{fewest}, C", ours, theirs, 0.6))
    return aims(rows)


def draw(results, times):
    """The figure and its data, in docs/figures."""
    if not tools.has("docs/figures/lengths.svg", "matplotlib"):
        return
    folder = build.ROOT / "docs/figures"
    lines = ["family,n,tool,derivation_s,operations,sines_and_cosines,state_ns"]
    for problem in PROBLEMS:
        family, n = families.split(problem)
        for name, (seconds, operations, functions) in results[problem].items():
            timed = times.get((problem, name))
            state = f"{1e9 * timed.median:.1f}" if timed else ""
            lines.append(f'{family},{n},"{name}",{seconds.median:.6g},{operations:.0f},{functions:.0f},{state}')
    build.write_text(folder / "lengths.csv", "\n".join(lines) + "\n")
    build.call(tools.worker("growth_figure.py", folder / "lengths.csv", folder / "lengths.svg"))
