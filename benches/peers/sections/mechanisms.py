"""How long it takes to derive mechanisms with loops, wheels and seven joints from their model files, and how many operations come out."""

import math

import build
import problems
import size
import tools
from measure import error, interleaved, repeats, started
from tables import aims, duration, table

MODELS = {
    "whipple_bicycle": build.ROOT / "models/whipple_bicycle/model.toml",
    "four_bar": build.ROOT / "models/four_bar/model.toml",
    "squeezer": build.ROOT / "models/squeezer/model.toml",
    "panda": build.ROOT / "benches/models/panda.toml",
}
PROBLEMS = list(MODELS) if not size.SMALL else ["four_bar", "squeezer"]
ABOUTS = {
    "whipple_bicycle": "Whipple bicycle",
    "four_bar": "four-bar",
    "squeezer": "squeezer",
    "panda": "arm, 7 joints",
}
# Where accelerations are compared: nothing is at rest, and nothing is symmetric.
STARTS = {
    "whipple_bicycle": (
        "x = 0.1\ny = -0.2\npsi = 0.3\nphi = 0.2\ndelta = 0.4\nthR = 0.5\nthF = 0.6\nu1 = 0.7\nu2 = -0.8\nu3 = -9",
        "theta = 0.02",
    ),
    "four_bar": ("q1 = 0.5\nu1 = 20", "q2 = 0.6\nq3 = 1.2"),
    "squeezer": (
        "beta = -0.06\nbeta_rate = 5",
        "theta = 0\ngamma = 0.455\ndelta = 0.487\nphi = 0.223\nepsilon = 1.23\nomega = -0.223",
    ),
    "panda": (
        "\n".join(f"q{i} = {0.3 + 0.9 * math.sin(2 * i):.3f}\nu{i} = {math.cos(3 * i):.3f}" for i in range(1, 8)),
        "",
    ),
}
OURS = ("kane", "lagrange")
MULTIPLIERS, PROJECTED = "CasADi, multipliers, Hessian of T", "CasADi, partial velocities, projected"
SYMPY = "SymPy, `KanesMethod`"
LIMIT = 120
AGREEMENT = 1e-8
# What takes longer is not asked again.
SLOW = 5

ABOUT = [
    "From the model file to the matrix and the right-hand side, all parameters symbolic. Tripos and SymPy by Kane's method, for the independent",
    "speeds of the file: SymPy by its frames, points, configuration and velocity constraints, with what solves for the dependent speeds as rows of its",
    "matrix. CasADi in SX: Lagrange's equations with multipliers (M by Hessian, the constraints' matrix and right-hand side beside it) as Tripos by",
    "Lagrange has them, and partial velocities projected on the independent speeds, as Kane has them. All are solved for q'' at one state on the",
    "constraints, loops closed and wheels rolling, and agree to 1e-8.",
]


def section(rounds):
    peers = started(rows())
    for problem in PROBLEMS:
        write(problem, peers["Tripos, kane"])
    results = {problem: measured(peers, problem, rounds) for problem in PROBLEMS}
    for peer in peers.values():
        peer.close()
    return ["## Mechanisms", "", *ABOUT, "", *overview(results), "", *operations(results), "", *judged(results)]


def rows():
    """What each row needs, and its command."""
    program = build.example("derivation", native=False)
    ours = {f"Tripos, {f}": ((), lambda f=f: [program, f, problems.FOLDER]) for f in OURS}
    casadi = lambda tool: lambda: tools.worker("mechanisms_casadi.py", tool, problems.FOLDER)
    theirs = {name: (("numpy", "casadi"), casadi(tool)) for name, tool in ((MULTIPLIERS, "multipliers"), (PROJECTED, "projected"))}
    return ours | theirs | {SYMPY: (("numpy", "sympy"), lambda: tools.worker("mechanisms_sympy.py", str(LIMIT), problems.FOLDER))}


def write(problem, tripos):
    """The model file, a scene, and the state where it starts: loops are closed by Tripos, which every other tool checks."""
    folder, (start, guess) = problems.FOLDER / problem, STARTS[problem]
    build.write_text(folder / "model.toml", MODELS[problem].read_text())
    build.write_text(folder / "scene.toml", f'model = "model.toml"\nspan = [0, 1]\n[start]\n{start}\n{guess and f"[guess]{chr(10)}{guess}{chr(10)}"}')
    count, *numbers = tripos.ask(f"start {problem}")
    lines = [numbers[: int(count)], numbers[int(count) :]]
    build.write_text(folder / "states", "".join(" ".join(map(repr, line)) + "\n" for line in lines))


def measured(peers, problem, rounds):
    """By peer: samples, or None where it did not get there, then operations and functions of M and f, and of both at once."""
    build.say(f"mechanism {problem}")
    found, solutions, askings = {}, {}, {}
    for name, peer in peers.items():
        ours = name.startswith("Tripos")
        (seconds,) = peer.ask(f"derive {problem} 1")
        if math.isnan(seconds):
            found[name] = None
            continue
        solutions[name] = peer.ask("solve")
        found[name] = (peer.ask("count"), peer.ask("together") if ours else None)
        line = f"formulate {repeats(seconds)}" if ours else f"derive {problem} {repeats(seconds)}"
        askings[name] = lambda peer=peer, line=line, seconds=seconds: seconds if seconds > SLOW else peer.ask(line)[0]
    first, reference = next(iter(solutions.items()))
    for name, solution in solutions.items():
        if error(solution, reference) > AGREEMENT:
            raise SystemExit(f"{problem}: {name} has other accelerations than {first}:\n  {solution}\n  {reference}")
    samples = interleaved(askings, rounds)
    return {name: counts and (samples[name], *counts) for name, counts in found.items()}


def overview(results):
    rows = []
    for name in results[PROBLEMS[0]]:
        cells = [results[problem][name] for problem in PROBLEMS]
        rows.append([name, *(f"{duration(c[0].median)} (± {100 * c[0].spread:.0f} %)" if c else f"not in {LIMIT} s" for c in cells)])
    return table(("model file to M and f", *(ABOUTS[problem] for problem in PROBLEMS)), rows)


def operations(results):
    yield "Operations of M and f, then sines, cosines and roots. Tripos: its functions for M and for f, which share nothing, and after `=` both as one"
    yield "function, where that takes a tenth off; the others share common subexpressions of M and f, and of the constraints where multipliers need them."
    yield ""
    rows = []
    for name in results[PROBLEMS[0]]:
        cells = [results[problem][name] for problem in PROBLEMS]
        rows.append([name, *(counts(c) for c in cells)])
    yield from table(("operations", *(ABOUTS[problem] for problem in PROBLEMS)), rows)


def counts(cell):
    if cell is None:
        return "–"
    _, apart, together = cell
    text = f"{apart[0]:.0f} + {apart[1]:.0f}" if apart[0] == apart[0] else f"not in {LIMIT} s"
    return f"{text} = {together[0]:.0f} + {together[1]:.0f}" if together and together != apart else text


def judged(results):
    """Tripos by the better of Kane and Lagrange, beside whichever of the others is best; and the bicycle beside what is asked of it."""
    rows = []
    for problem in PROBLEMS:
        of, found = ABOUTS[problem], {name: r for name, r in results[problem].items() if r}
        others = [name for name in found if not name.startswith("Tripos")]
        for what, value in (("time", lambda r: r[0].median), ("operations", lambda r: (r[2] or r[1])[0])):
            figures = {name: value(r) for name, r in found.items() if value(r) == value(r)}
            ours = min(figures[f"Tripos, {f}"] for f in OURS)
            if theirs := {name: figures[name] for name in others if name in figures}:
                best = min(theirs, key=theirs.get)
                rows.append((f"{of}, {what}", best, ours, theirs[best], 1.0))
            if problem == "whipple_bicycle":
                rows.append((f"{of}, {what}, Kane", *asked(figures, what)))
    yield from aims(rows)
    yield ""
    if rows and not size.SMALL:
        yield "Tripos by the better of Kane and Lagrange, with M and f as one function where there is one. Of the bicycle by Kane's method 0.2 s and 1500"
        yield "operations are asked."


def asked(figures, what):
    text, number = {"time": ("0.2 s", 0.2), "operations": ("1500", 1500)}[what]
    return text, figures["Tripos, kane"], number, 1.0
