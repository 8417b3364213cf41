"""How long it takes to derive one formulation to M and f, and how many operations come out."""

import build
import problems
import size
import tools
from measure import error, interleaved, repeats, started
from tables import aims, duration, ratio, table

FORMULATIONS = ("kane", "lagrange", "newton-euler")
TOOLS = {
    "casadi": "CasADi, SX, Hessian of T",
    "symengine": "symengine, derivatives",
    "sympy": "SymPy, derivatives",
    "kane": "SymPy, `KanesMethod`",
}
PACKAGES = {"casadi": ["casadi"], "symengine": ["symengine", "sympy"], "sympy": ["sympy"], "kane": ["sympy"]}
CHAINS = [problems.chain(n) for n in size.of((5, 10, 20), (2, 3))]
PROBLEMS = ["disk", *CHAINS]
# What takes too long to be worth its time here: SymPy's method on the longer chains, and code of the longest.
LEFT_OUT = {("kane", problems.chain(10)), ("kane", problems.chain(20))}
WITH_CODE = ["disk", *size.of(CHAINS[:1], [])]
# Slower than this is sampled three times only.
SLOW = 0.2
AGREEMENT = 1e-8


def section(rounds):
    for problem in PROBLEMS:
        problems.write(problem)
    peers = started(rows())
    lines = ["## Derivation to M and f", "", *ABOUT, ""]
    results = {problem: measured(peers, problem, rounds) for problem in PROBLEMS}
    lines += [*overview(peers, results), "", *operations(peers, results), "", *code(peers, rounds), "", *judged(results)]
    for peer in peers.values():
        peer.close()
    return lines


def rows():
    """What each row needs, and its command."""
    program = build.example("derivation", native=False)
    ours = {f"Tripos, {f}": ((), lambda f=f: [program, f, problems.FOLDER]) for f in FORMULATIONS}
    command = lambda tool: lambda: tools.worker("derivation_worker.py", tool, problems.FOLDER)
    return ours | {name: (("numpy", *PACKAGES[tool]), command(tool)) for tool, name in TOOLS.items()}


ABOUT = [
    "From the model as data, or a tool's own symbols, to the matrix and the right-hand side of one formulation, once; each tool by",
    "its fastest way to these (`workers/mechanics.py`, and `KanesMethod` from frames and points). All are solved for q'' at one",
    "state, and agree to 1e-8. The chain is the cart of `models/cart_pendulum_3` with n links, angles from upright, point masses.",
]


def measured(peers, problem, rounds):
    """(samples, counts) by peer."""
    build.say(f"derivation of {problem}")
    solutions, counts, fast, slow = {}, {}, {}, {}
    for name, peer in peers.items():
        tool = next((tool for tool, known in TOOLS.items() if known == name), None)
        if (tool, problem) in LEFT_OUT:
            continue
        (seconds,) = peer.ask(f"derive {problem} 1")
        counts[name] = peer.ask("count")
        solutions[name] = peer.ask("solve")
        line = f"derive {problem} {repeats(seconds)}"
        (slow if seconds > SLOW else fast)[name] = lambda peer=peer, line=line: peer.ask(line)[0]
    first, reference = next(iter(solutions.items()))
    for name, solution in solutions.items():
        if error(solution, reference) > AGREEMENT:
            raise SystemExit(f"{problem}: {name} has other accelerations than {first}:\n  {solution}\n  {reference}")
    samples = interleaved(fast, rounds) | interleaved(slow, min(3, rounds))
    return samples, counts


def overview(peers, results):
    rows = []
    for name in peers:
        cells = [results[problem][0].get(name) for problem in PROBLEMS]
        rows.append([name, *(f"{duration(s.median)} (± {100 * s.spread:.0f} %)" if s else "–" for s in cells)])
    return table(("time of one derivation", "disk", *(f"chain, n = {problems.links(c)}" for c in CHAINS)), rows)


def operations(peers, results):
    yield "Operations of M and f together: additions, subtractions, multiplications, divisions, powers and sign changes, then sines"
    yield "and cosines. Tripos: the counts in the headers of its functions for M and for f, which share nothing with each other;"
    yield "CasADi: the instructions of one function with common subexpressions shared; symengine and SymPy: the same after `cse`."
    yield ""
    rows = []
    for name in peers:
        cells = [results[problem][1].get(name) for problem in PROBLEMS]
        rows.append([name, *(f"{c[0]:.0f} + {c[1]:.0f}" if c else "–" for c in cells)])
    yield from table(("operations", "disk", *(f"chain, n = {problems.links(c)}" for c in CHAINS)), rows)


def code(peers, rounds):
    """What else Tripos does: reading the file, and all formulations with their code."""
    peer = peers["Tripos, lagrange"]
    rows = []
    for problem in PROBLEMS:
        peer.ask(f"derive {problem} 1")
        read = interleaved({0: lambda: peer.ask("read 10")[0]}, rounds)[0]
        emitted = interleaved({0: lambda: peer.ask("code 1")[0]}, min(3, rounds))[0] if problem in WITH_CODE else None
        rows.append([problem, duration(read.median), duration(emitted.median) if emitted else "–"])
    head = (
        "Tripos, not in the times above",
        "model file read and checked",
        "all three formulations from the file, with their code",
    )
    return table(head, rows)


def judged(results):
    """Tripos by the better of Kane and Lagrange, whose M is what the others derive: Newton-Euler's has the reactions, too."""
    ours = lambda problem, of: min(of(f"Tripos, {f}") for f in FORMULATIONS[:2])
    time = lambda problem: lambda name: results[problem][0][name].median
    count = lambda problem: lambda name: results[problem][1][name][0]
    longest = CHAINS[-1]
    casadi, symengine, n = TOOLS["casadi"], TOOLS["symengine"], problems.links(longest)
    rows = []
    if symengine in results["disk"][0]:
        rows.append(("disk, time", "symengine", ours("disk", time("disk")), time("disk")(symengine), 1.0))
    if casadi in results["disk"][0]:
        rows.append((f"chain n = {n}, time", "CasADi", ours(longest, time(longest)), time(longest)(casadi), 0.5))
        rows.append((f"chain n = {n}, operations", "CasADi", ours(longest, count(longest)), count(longest)(casadi), 0.6))
    yield from aims(rows)
    if symengine not in results["disk"][0]:
        return
    yield ""
    each = (f"{f} {ratio(time('disk')(f'Tripos, {f}') / time('disk')(symengine))}" for f in FORMULATIONS)
    yield "Tripos by the better of Kane and Lagrange, whose unknowns are those of the others; Newton-Euler's are the reactions, too."
    yield f"Disk, time ÷ symengine: {', '.join(each)}."
