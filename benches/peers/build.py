"""Makes the workers ready: a Python environment of their own, the C and C++ programs, and two builds of each Rust program."""

import json
import os
import platform
import shutil
import subprocess
import sys
import time
import venv
from pathlib import Path

import size

HERE = Path(__file__).resolve().parent
WORKERS = HERE / "workers"
ROOT = HERE.parent.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target")
PLACE = TARGET / size.of("peers", "peers/small")
# The environment of the packages is one for both sizes.
ENVIRONMENT = TARGET / "peers/python"
# How Rust is built, and where cargo puts that. What the tests have built is not built again for the small size.
PROFILE = "release"
# Whether programs are built for this processor, too; and what the rows of the best build are called.
NATIVE = size.of(True, False)
BUILD = size.of("native", "default build")
REQUIREMENTS = HERE / "requirements.txt"
# Headers that come as packages of Python, in a folder of their own: these ask for other versions of what the environment has.
HEADERS, HEADERS_FOLDER = HERE / "headers.txt", TARGET / "peers/headers"
C_FLAGS = ["-std=gnu17", "-O3", "-march=native"]
CPP_FLAGS = ["-std=c++17", "-O3", "-march=native", "-DNDEBUG"]
# Without leave to fuse a multiplication and an addition, which rustc does only where a program asks for it.
UNFUSED = "-ffp-contract=off"


def python(install):
    """The Python of an environment with exactly the pinned packages, made anew when these change; none if it may not be made."""
    program = ENVIRONMENT / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    stamp = ENVIRONMENT / "made-for.json"
    wanted = json.dumps([sys.version, REQUIREMENTS.read_text()])
    if program.exists() and stamp.exists() and stamp.read_text() == wanted:
        return program
    if not install:
        return None
    say("a Python environment with the packages of requirements.txt (once; needs a network)")
    venv.create(ENVIRONMENT, clear=True, with_pip=True)
    pip = ["-m", "pip", "install", "--quiet", "--no-input", "--disable-pip-version-check"]
    call([program, *pip, "-r", REQUIREMENTS])
    stamp.write_text(wanted)
    return program


def headers(python, install):
    """The folder of Pinocchio's headers and of those that they include; none if there are none and they may not be fetched."""
    stamp, wanted = HEADERS_FOLDER / "made-for.txt", HEADERS.read_text()
    if not (stamp.exists() and stamp.read_text() == wanted):
        if not install:
            return None
        say("the packages of headers.txt (once; needs a network)")
        shutil.rmtree(HEADERS_FOLDER, ignore_errors=True)
        pip = ["-m", "pip", "install", "--quiet", "--no-input", "--disable-pip-version-check", "--no-deps"]
        call([python, *pip, "--target", HEADERS_FOLDER, "-r", HEADERS])
        stamp.write_text(wanted)
    return HEADERS_FOLDER / "cmeel.prefix/include"


def c_program(name, *more):
    PLACE.mkdir(parents=True, exist_ok=True)
    flags = [*C_FLAGS, *more]
    program = PLACE / "".join([name, *more])
    say(f"{compiler()} {' '.join(flags)} {name}.c")
    call([compiler(), *flags, WORKERS / f"{name}.c", "-o", program, "-lm"])
    return program


def rates_program(source, lengths, include=None):
    """The loops of rates.c around the function of one file, and the seconds that compiling this file took."""
    return loops_program("rates", source, dict(zip(("COORDINATES", "PARAMETERS"), lengths)), include)


def loops_program(worker, source, defines, include=None):
    """The loops of a worker in C around the functions of one file, and the seconds that compiling this file took."""
    program = source.with_name(f"{source.stem}-{worker}")
    defines = [f"-D{name}={value}" for name, value in defines.items()]
    say(f"{source.name} -> {program.name}")
    call([compiler(), *C_FLAGS, *defines, "-c", WORKERS / f"{worker}.c", "-o", f"{program}-loops.o"])
    plus = source.suffix == ".cpp"
    command = [compiler_plus(), *CPP_FLAGS, "-I", include] if plus else [compiler(), *C_FLAGS]
    begin = time.perf_counter()
    call([*command, "-c", source, "-o", f"{program}.o"])
    seconds = time.perf_counter() - begin
    linker = compiler_plus() if plus else compiler()
    call([linker, f"{program}-loops.o", f"{program}.o", "-o", program, "-lm"])
    return program, seconds


def pinocchio_program(headers):
    """The worker around Pinocchio, and the seconds that compiling it took."""
    PLACE.mkdir(parents=True, exist_ok=True)
    program = PLACE / "arms-pinocchio"
    say("arms.cpp -> arms-pinocchio")
    # Headers alone: what is called is compiled here, with the flags of the other programs.
    includes = ["-isystem", headers, "-isystem", headers / "eigen3"]
    begin = time.perf_counter()
    call([compiler_plus(), *CPP_FLAGS, "-w", *includes, WORKERS / "arms.cpp", "-o", program])
    return program, time.perf_counter() - begin


def eigen():
    """The folder of Eigen's headers; none if there are none."""
    places = [os.environ.get("EIGEN", ""), "/usr/include/eigen3", "/usr/local/include/eigen3", "/opt/homebrew/include/eigen3"]
    return next((Path(place) for place in places if place and (Path(place) / "Eigen/Core").exists()), None)


def eigen_version():
    if not eigen():
        return "no Eigen"
    text = (eigen() / "Eigen/src/Core/util/Macros.h").read_text()
    numbers = (text.split(f"#define EIGEN_{part}_VERSION ")[1].split()[0] for part in ("WORLD", "MAJOR", "MINOR"))
    return "Eigen " + ".".join(numbers)


def example(name, native):
    """An example of the workspace: as everyone builds it, or with leave to use all that this processor has, as the C programs."""
    cargo([*size.of(["-p", "tripos-models"], ["--workspace"]), "--example", name], native)
    return rust_target(native) / PROFILE / "examples" / executable(name)


def command():
    """The command `tripos`. What only tests depend on adds features to its dependencies, all of which would be built anew without
    them: an example depends on that, too, so that the small size asks for one beside it."""
    cargo([*size.of(["-p", "tripos-cli"], ["--workspace", "--example", "peer"]), "--bin", "tripos"], native=False)
    return rust_target(native=False) / PROFILE / executable("tripos")


def emitted_crate(worker, formulation, models, name=None):
    """A crate around the modules that `tripos emit` writes of these model files, for a worker in Rust, and the seconds that emitting
    each took. It is called as the worker is, unless it has a name of its own."""
    name = name or worker
    place = PLACE / f"emitted-{name}"
    tripos, seconds = command(), {}
    for problem, path in models.items():
        say(f"tripos emit {problem} --formulation {formulation}")
        begin = time.perf_counter()
        call([tripos, "emit", path, "--out", place / "src" / problem, "--formulation", formulation], quiet=True)
        seconds[problem] = time.perf_counter() - begin
    manifest = EMITTED.format(traits=ROOT / "sim/traits", worker=name, path=WORKERS / f"{worker}.rs")
    write_crate(place, manifest, {"src/lib.rs": emitted_library(models)})
    return seconds


# Functions of the loops in C, by the functions that `tripos emit --language c` writes.
IN_C = {
    "rates": ("derivative", "void rates(const double *p, const double *y, double *out)", "p, y, y + N_, out, out + N_"),
    "forward": ("accelerations", "void forward(const double *p, const double *q, const double *u, double *out)", "p, q, u, out"),
    "inverse": (
        "inverse_dynamics",
        "void inverse(const double *p, const double *q, const double *u, const double *a, double *out)",
        "p, q, u, a, out",
    ),
}


def emitted_c(problem, path, formulation, wanted=("rates",)):
    """A C file with the wanted functions of IN_C around those that `tripos emit --language c` writes, and the seconds that emitting
    took."""
    place = PLACE / "emitted-c" / problem
    begin = time.perf_counter()
    functions = ",".join(IN_C[name][0] for name in wanted)
    options = ["--language", "c", "--formulation", formulation, "--functions", functions]
    call([command(), "emit", path, "--out", place, *options], quiet=True)
    seconds = time.perf_counter() - begin
    source = next(place.glob(f"*_{formulation}.c"))
    text = f"#include \"{source.name}\"\n"
    for function, head, arguments in (IN_C[name] for name in wanted):
        text += f"{head}\n{{\n    {source.stem}_{function}({arguments});\n}}\n"
    text = text.replace("N_", f"{source.stem.upper()}_COORDINATES")
    write_text(place / "tripos.c", text)
    return place / "tripos.c", seconds


def emitted_library(problems):
    """The modules, and a macro that does something with the one of a name; `None` if there is none of it."""
    modules = "".join(f"pub mod {problem};\n" for problem in problems)
    arms = "".join(f"            {problem!r} => $served!({problem}, $($more),*),\n".replace("'", '"') for problem in problems)
    return f"#![allow(non_snake_case)]\n{modules}{CHOOSING.replace('ARMS', arms)}"


def write_crate(place, manifest, files):
    """A crate outside the workspace that has its versions; what is as it was keeps its age, so that nothing is built anew."""
    texts = {"Cargo.toml": manifest, **files}
    if not (place / "Cargo.lock").exists():
        texts["Cargo.lock"] = (ROOT / "Cargo.lock").read_text()
    for path, text in texts.items():
        write_text(place / path, text)


def write_text(path, text):
    """Unless the file has this text already."""
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def program_of_emitted(worker, native):
    """The program that times the modules of that crate, and the seconds that compiling them took."""
    manifest = ["--manifest-path", PLACE / f"emitted-{worker}/Cargo.toml"]
    environment = rust_environment(native)
    call(["cargo", "clean", "--quiet", *manifest, "--profile", PROFILE, "-p", "emitted"], environment)
    begin = time.perf_counter()
    cargo(manifest, native)
    seconds = time.perf_counter() - begin
    return rust_target(native) / PROFILE / executable(worker), seconds


CHOOSING = """
#[macro_export]
macro_rules! choose {
    ($problem:expr, $served:ident, $($more:expr),*) => {
        match $problem {
ARMS            _ => None,
        }
    };
}
"""
EMITTED = """[package]
name = "emitted"
version = "0.0.0"
edition = "2024"

[[bin]]
name = "{worker}"
path = '{path}'

[dependencies]
tripos-traits = {{ path = '{traits}' }}

[workspace]
"""


def cargo(arguments, native):
    flags = rust_environment(native).get("RUSTFLAGS", "")
    words = " ".join(word.name if isinstance(word, Path) else word for word in arguments)
    say(f"cargo build --profile {PROFILE} {words} {flags and f'(RUSTFLAGS={flags!r})'}".rstrip())
    call(["cargo", "build", "--profile", PROFILE, "--quiet", *arguments], rust_environment(native))


def rust_target(native):
    return PLACE / "native" if native else TARGET


def rust_environment(native):
    environment = {**os.environ, "CARGO_TARGET_DIR": str(rust_target(native))}
    environment.pop("RUSTFLAGS", None)
    if native:
        environment["RUSTFLAGS"] = "-C target-cpu=native"
    return environment


def executable(name):
    return f"{name}.exe" if os.name == "nt" else name


def compiler():
    return os.environ.get("CC", "cc")


def compiler_plus():
    return os.environ.get("CXX", "c++")


def call(command, environment=None, quiet=False, place=ROOT):
    """What a command prints, if that is to be kept from the terminal."""
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=place, env=environment, capture_output=quiet, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(words)}\n{done.stderr or ''}exit status {done.returncode}")
    return done.stdout


def say(text):
    print(f"== {text}", file=sys.stderr, flush=True)


def machine(packages):
    """What the times depend on; neither names nor places. Packages by name with their versions."""
    versions = ", ".join(f"{name} {version}" for name, version in packages.items())
    return {
        "processor": f"{processor()}, {os.cpu_count()} cores visible",
        "system": f"{platform.system()} {platform.machine()}, {' '.join(platform.libc_ver())}".rstrip(", "),
        "C": f"{version_of(compiler())}; {' '.join(C_FLAGS)}",
        "C++": f"{version_of(compiler_plus())}; {' '.join(CPP_FLAGS)}; {eigen_version()}",
        "Rust": first_line(["rustc", "--version"]),
        "Python": f"{platform.python_version()}; {versions or 'no packages'}",
    }


def processor():
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    about = {}
    for line in lines:
        key, _, value = line.partition(":")
        about.setdefault(key.strip(), value.strip())
    wanted = [about.get("model name", platform.machine())]
    wanted += [f"{key} {about[key]}" for key in ("cpu family", "model") if key in about]
    return ", ".join(wanted)


def version_of(program):
    return first_line([program, "--version"]) if shutil.which(program) else "none"


def first_line(command):
    return lines(command)[0]


def lines(command, environment=None, place=ROOT):
    """What a command prints."""
    return call(command, environment, quiet=True, place=place).splitlines()
