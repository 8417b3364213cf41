"""How long it takes from an edited model to the first result, with whatever is compiled."""

import json
import os
import shutil
import time

import build
import problems
import size
import tools
from measure import error, interleaved
from tables import duration, table

# The edit: the axial moment of inertia, as hundredths of M R^2 that no run before had; 50 are the most that a body can have.
TOLERANCE, AGREEMENT = 1e-9, 1e-3
COMPILED = "Tripos, `tripos regenerate disk` and `cargo run` in the workspace: compiled"
EMITTED = "Tripos, `tripos emit` of one formulation and `cargo build` of a crate of one's own"
INTERPRETED = "Tripos, interpreted"
FORM = "heyoka, closed form derived again by hand (not in the time), JIT"
SYMPY = ("numpy", "scipy", "sympy")
SCRIPTS = {
    FORM: ("first_heyoka.py form", tools.HEYOKA),
    "CasADi, CVODES, its C compiled": ("first_casadi.py c", ("casadi", tools.C)),
    "CasADi, CVODES, interpreted": ("first_casadi.py machine", ("casadi",)),
    "SymPy `KanesMethod`, PyDy through Cython, SciPy DOP853": ("first_sympy.py pydy", (*SYMPY, "pydy", "cython", tools.C)),
    "SymPy `KanesMethod`, `lambdify`, SciPy DOP853": ("first_sympy.py lambdify", SYMPY),
}
# More than ten times as long as the others: once.
LAGRANGIAN = {"heyoka, from its Lagrangian, JIT": ("first_heyoka.py lagrangian", tools.HEYOKA)}
MOST_ROUNDS = 3
PLACE = build.PLACE / "edited"


def section(rounds):
    rounds = min(rounds, MOST_ROUNDS)
    runs = commands()
    build.say("first builds, so that only what an edit changes is compiled in what is timed")
    for name in (COMPILED, EMITTED):
        if name in runs:
            runs[name](50)
    # The edit of round k is the same for all, so that their results can be compared.
    ends, edits = {}, {name: iter(range(49, 49 - rounds, -1)) for name in runs}
    samples = interleaved({name: lambda name=name: timed(runs[name], next(edits[name]), ends, name) for name in runs}, rounds)
    once = {name: lambda run=run, name=name: timed(run, 49, ends, name) for name, run in scripts(size.of(LAGRANGIAN, {})).items()}
    samples |= interleaved(once, 1)
    for (name, share), end in ends.items():
        if error(end, ends[INTERPRETED, share]) > AGREEMENT:
            raise SystemExit(f"{name} ends elsewhere: {end}\n  {ends[INTERPRETED, share]}")
    rows = [[name, duration(s.median), duration(s.fastest)] for name, s in samples.items()]
    return [*title(rounds), *table(("", "median", "fastest"), rows), *size.of([], SMALLER)]


SMALLER = ["", "Left out at this size: what compiles the workspace again, and heyoka from the Lagrangian."]


def commands():
    """What gives the end for an edit, by row. At the small size without what compiles the workspace: a test of its own does."""
    tripos = build.command()
    runs = {INTERPRETED: lambda share: interpreted(tripos, share)}
    if not size.SMALL:
        workspace = copied_workspace()
        runs[COMPILED] = lambda share: compiled(tripos, workspace, share)
    runs[EMITTED] = lambda share: emitted(tripos, share)
    return runs | scripts(SCRIPTS)


def scripts(rows):
    here = {name: words for name, (words, needs) in rows.items() if tools.has(name, *needs)}
    return {name: lambda share, words=words: script(words, share) for name, words in here.items()}


def title(rounds):
    yield "## From an edited model to the first result"
    yield ""
    yield "The time of the whole command, its start included: the disk with another axial moment of inertia, never met before, from"
    yield f"the edited model to its coordinates at t = 10 s, at rtol = atol = {TOLERANCE:.0e}; Tripos by DOP853. What is not of it is"
    yield f"compiled beforehand. Medians of {rounds} samples; of heyoka's Lagrangian one. All end in the same place to {AGREEMENT:.0e}."
    yield ""


def timed(run, share, ends, name):
    build.say(f"{name}, {share} hundredths")
    begin = time.perf_counter()
    end = run(share)
    seconds = time.perf_counter() - begin
    ends[name, share] = end[:5]
    return seconds


def edited_model(share):
    text = problems.model_text("disk")
    if text.count('"M*R^2/2"') != 1:
        raise SystemExit("models/disk/model.toml no longer has the moment of inertia that this edits")
    return text.replace('"M*R^2/2"', f'"{share}*M*R^2/100"')


def simulated(command, share, is_compiled, environment=None, place=build.ROOT):
    tolerance = repr(TOLERANCE)
    options = ["--method", "dop853", "--rtol", tolerance, "--atol", tolerance, "--json"]
    answer = json.loads("\n".join(build.lines([*command, *options], environment, place)))
    if answer["compiled"] is not is_compiled:
        raise SystemExit(f"{command[0]} ran {'interpreted' if is_compiled else 'compiled'} code for {share} hundredths")
    return [answer["state"][f"q{i}"] for i in range(1, 6)]


def interpreted(tripos, share):
    scene = PLACE / "outside/scenes/run.toml"
    scene.parent.mkdir(parents=True, exist_ok=True)
    scene.write_text(problems.SCENE.read_text())
    (PLACE / "outside/model.toml").write_text(edited_model(share))
    return simulated([tripos, "simulate", scene], share, is_compiled=False)


def copied_workspace():
    """The workspace without its history and what was built, in a place where a model may be edited."""
    place = PLACE / "workspace"
    ignored = shutil.ignore_patterns("target", ".git*", "__pycache__")
    for path in build.ROOT.iterdir():
        if path.name == "target" or path.name.startswith(".git"):
            continue
        # What is as it was keeps its age.
        copy = place / path.name
        if path.is_dir():
            shutil.copytree(path, copy, ignore=ignored, dirs_exist_ok=True, copy_function=shutil.copy2)
        else:
            place.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, copy)
    return place


def compiled(tripos, workspace, share):
    (workspace / "models/disk/model.toml").write_text(edited_model(share))
    # Without Python no SymPy derives it too, which would be measured with it.
    environment = {**os.environ, "TRIPOS_PYTHON": "/no/such/python"}
    build.lines([tripos, "regenerate", "disk"], environment, workspace)
    environment = build.rust_environment(native=False) | {"CARGO_TARGET_DIR": str(PLACE / "target")}
    command = ["cargo", "run", "--release", "--quiet", "--", "simulate", "models/disk/scenes/report-10s.toml"]
    return simulated(command, share, is_compiled=True, environment=environment, place=workspace)


def emitted(tripos, share):
    """A crate with the module and one page of its user's own."""
    crate = PLACE / "crate"
    manifest = MANIFEST.format(traits=build.ROOT / "sim/traits", sim=build.ROOT / "sim")
    build.write_crate(crate, manifest, {"src/main.rs": (build.WORKERS / "first_result.rs").read_text()})
    (crate / "disk.toml").write_text(edited_model(share))
    out = crate / "src/disk"
    build.call([tripos, "emit", crate / "disk.toml", "--out", out, "--formulation", "lagrange"], quiet=True)
    environment = build.rust_environment(native=False) | {"CARGO_TARGET_DIR": str(PLACE / "target")}
    numbers = [*problems.parameters("disk"), *problems.start("disk"), TOLERANCE]
    command = ["cargo", "run", "--profile", build.PROFILE, "--quiet", "--", *map(repr, numbers)]
    return [float(word) for word in build.lines(command, environment, crate)[-1].split()]


MANIFEST = """[package]
name = "first-result"
version = "0.0.0"
edition = "2024"

[dependencies]
tripos-traits = {{ path = '{traits}' }}
tripos-sim = {{ path = '{sim}' }}

[workspace]
"""


def script(words, share):
    name, kind = words.split()
    # From a folder of its own, since some leave files where they stand.
    place = PLACE / "scripts"
    place.mkdir(parents=True, exist_ok=True)
    command = tools.worker(name, kind, repr(share / 100), repr(TOLERANCE))
    environment = {**os.environ, "PYTHONPATH": str(build.WORKERS)}
    return [float(word) for word in build.lines(command, environment, place)[-1].split()]
