"""The disk's scenes by their reduced equations: ten outputs to an error that no peer reaches in doubles, and two states of ten."""

import build
import size
import tools
from measure import started as present
from sections.search import Question, search
from tables import aims, details, duration, quotients, table

# Ten outputs: beyond what all ten equations reach in doubles. The tightest is below the rounding of 80-bit numbers.
FINE, FINE_TOLERANCES = size.of(([1e-12], [10.0 ** (-k / 2) for k in range(22, 38)]), ([1e-9], [1e-12, 1e-14]))
# Two outputs.
LEAN, LEAN_TOLERANCES = size.of(([1e-6, 1e-9], [10.0 ** (-k / 2) for k in range(4, 29)]), ([1e-6], [1e-9, 1e-12]))
# At most so much of heyoka's time, and so many seconds by quadrature; so much of the time of all ten equations.
OF_HEYOKA, QUADRATURE_SECONDS = 0.1, 1e-4
STEPPED_OF_FULL, QUADRATURE_OF_FULL = 0.5, 0.25

HEYOKA_LONG = "heyoka, Taylor, long double"
QUADRATURE = f"Tripos, reduced, quadrature, {build.BUILD}"
QUADRATURE_DEFAULT = "Tripos, reduced, quadrature, default build"
METHODS = ("dop853", "taylor")
STEPPED = {method: f"Tripos, reduced, {method}, {build.BUILD}" for method in METHODS}
PROJECTED = {method: f"Tripos, reduced, {method} on the energy, {build.BUILD}" for method in METHODS}
REDUCED = [*STEPPED.values(), *PROJECTED.values(), QUADRATURE]
FULL = {"dop853": ("lagrange", "kane"), "taylor": ("lagrange", "kane")}


def commands(scene):
    program = build.example("scene", build.NATIVE)
    words = {STEPPED[method]: method for method in METHODS} | {PROJECTED[method]: f"{method}-energy" for method in METHODS}
    words[QUADRATURE] = "quadrature"
    return {name: [program, scene, word] for name, word in words.items()}


def full(equations, method):
    return f"Tripos, all equations, {equations.capitalize()}, {method}, {build.BUILD}"


def started():
    """The workers of both tables: ten outputs, then two."""
    peer = build.example("peer", build.NATIVE)
    ours = lambda commands: {name: ((), lambda words=words: words) for name, words in commands.items()}
    default = {QUADRATURE_DEFAULT: [build.example("scene", native=False), "report-10s", "quadrature"]}
    ten = ours(commands("report-10s") | default) | {HEYOKA_LONG: (tools.HEYOKA, lambda: tools.worker("heyoka_worker.py", "long"))}
    two = {full(form, method): [peer, form, method] for method, forms in FULL.items() for form in forms}
    return [present(group, "start") for group in (ten, ours(two | commands("lean")))]


def asked(ten, two, reference):
    """Both questions, with how each error is reached."""
    fine = Question("fine", FINE, FINE_TOLERANCES, reference)
    # u1 is -q2'.
    lean = Question("lean", LEAN, LEAN_TOLERANCES, [reference[1], -reference[6]])
    both = lambda end: end if len(end) == 2 else [end[1], -end[6]]
    for peer in ten.values():
        search(peer, fine)
    for peer in two.values():
        search(peer, lean, both)
    return fine, lean


def lines(fine, lean):
    goal = f"{FINE[0]:.0e}"
    yield from [f"## Ten outputs of the disk to {goal}", "", *ABOUT_FINE, ""]
    against = seconds(fine, HEYOKA_LONG, FINE[0]) if HEYOKA_LONG in fine.best else None
    rows = []
    for name in fine.best:
        time = seconds(fine, name, FINE[0])
        pair = (fine.reached.get((row, FINE[0])) for row in (name, HEYOKA_LONG))
        rows.append([name, duration(time), quotients(*pair, otherwise=""), f"{fine.best[name]:.1e}"])
    head = ("", f"error {goal}", "÷ heyoka, by medians (by fastest samples)", "smallest error")
    yield from table(head, rows)
    yield from ["", *aims(list(judged(fine, against))), "", *details(fine.reached), "", *NOTES_FINE, ""]
    yield from ["## Two states of the disk", "", *ABOUT_LEAN, ""]
    rows = [[name, *(duration(seconds(lean, name, target)) for target in LEAN)] for name in lean.best]
    yield from table(("", *(f"error {target:.0e}" for target in LEAN)), rows)
    yield from ["", *aims(list(compared(lean))), "", *details(lean.reached)]


def judged(fine, against):
    """The fastest steps and quadrature, against heyoka if it is here; quadrature against the clock."""
    stepped = min((name for name in REDUCED if name != QUADRATURE), key=lambda name: seconds(fine, name, FINE[0]))
    for name in (stepped, QUADRATURE) if against else ():
        yield short(name), HEYOKA_LONG, seconds(fine, name, FINE[0]), against, OF_HEYOKA
    yield short(QUADRATURE), duration(QUADRATURE_SECONDS), seconds(fine, QUADRATURE, FINE[0]), QUADRATURE_SECONDS, 1.0


ABOUT_FINE = [
    "The scene `report-10s` by its own equations, four states of which two are integrals along the others, in doubles: the ten outputs",
    f"at t = 10 s to an error of {FINE[0]:.0e}, measured as above. A run is everything from the start that the scene states to the outputs:",
    "constants of the motion, which are taken from it in twice the precision of a double, and by quadrature all integrals.",
    "heyoka integrates the ten equations in C's `long double`, of 80 bits here, from the start in these numbers: in doubles it stays",
    "above, as do all others (smallest errors above).",
]
NOTES_FINE = [
    "- Quadrature has no tolerance: evaluations are points at which its integrands were evaluated.",
    "- Not in the times: heyoka's compilation, which takes 1 to 3 s at such an order. A run of it here is longer than a turn of the",
    "  scheduler and waits for other programs if there are any: see `fastest`.",
]
ABOUT_LEAN = [
    "The scene `lean`, which asks for q2 and u1 alone, by its own two equations, beside all ten equations solved for the accelerations:",
    "time to the same error in q2 and u1 at t = 10 s (the largest of the two). Constants of the motion count with the run as above.",
]


def seconds(question, name, target):
    found = question.reached.get((name, target))
    return found.samples.median if found else float("inf")


def short(name):
    return name.removeprefix("Tripos, ").removesuffix(f", {build.BUILD}")


def compared(lean):
    """Each method, then the fastest of all steps, then quadrature."""
    methods = {method: ([full(form, method) for form in FULL[method]], [STEPPED[method], PROJECTED[method]]) for method in METHODS}
    every, reduced = (sum(lists, []) for lists in zip(*methods.values()))
    for target in LEAN:
        fastest = lambda names: min(seconds(lean, name, target) for name in names)
        for method, (theirs, ours) in methods.items():
            yield f"error {target:.0e}, {method}", f"all equations, {method}", fastest(ours), fastest(theirs), STEPPED_OF_FULL
        yield f"error {target:.0e}, fastest steps", FASTEST, fastest(reduced), fastest(every), STEPPED_OF_FULL
        yield f"error {target:.0e}, quadrature", FASTEST, fastest([QUADRATURE]), fastest(every), QUADRATURE_OF_FULL


FASTEST = "all equations, fastest steps"
