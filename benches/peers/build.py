"""Makes the workers ready: a Python environment of their own, the C programs, and two builds of the Rust program."""

import json
import os
import platform
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target")
PLACE = TARGET / "peers"
REQUIREMENTS = HERE / "requirements.txt"
C_FLAGS = ["-std=gnu17", "-O3", "-march=native"]
# Without leave to fuse a multiplication and an addition, which rustc does only where a program asks for it.
UNFUSED = "-ffp-contract=off"


def python():
    """The Python of an environment with exactly the pinned packages, made anew when these change."""
    folder = PLACE / "python"
    program = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    stamp = folder / "made-for.json"
    wanted = json.dumps([sys.version, REQUIREMENTS.read_text()])
    if not (program.exists() and stamp.exists() and stamp.read_text() == wanted):
        say("a Python environment with the packages of requirements.txt (once; needs a network)")
        venv.create(folder, clear=True, with_pip=True)
        pip = ["-m", "pip", "install", "--quiet", "--no-input", "--disable-pip-version-check"]
        call([program, *pip, "-r", REQUIREMENTS])
        stamp.write_text(wanted)
    return program


def c_program(name, *more):
    PLACE.mkdir(parents=True, exist_ok=True)
    flags = [*C_FLAGS, *more]
    program = PLACE / "".join([name, *more])
    say(f"{compiler()} {' '.join(flags)} {name}.c")
    call([compiler(), *flags, HERE / f"{name}.c", "-o", program, "-lm"])
    return program


def rust_program(native):
    """The example `peer`: as everyone builds it, or with leave to use all that this processor has, as the C programs."""
    target = PLACE / "native" if native else TARGET
    environment = {**os.environ, "CARGO_TARGET_DIR": str(target)}
    flags = "-C target-cpu=native" if native else ""
    environment.pop("RUSTFLAGS", None)
    if flags:
        environment["RUSTFLAGS"] = flags
    say(f"cargo build --release -p tripos --example peer {flags and f'(RUSTFLAGS={flags!r})'}".rstrip())
    call(["cargo", "build", "--release", "--quiet", "-p", "tripos", "--example", "peer"], environment)
    return target / "release/examples" / ("peer.exe" if os.name == "nt" else "peer")


def compiler():
    return os.environ.get("CC", "cc")


def call(command, environment=None):
    subprocess.run([str(word) for word in command], cwd=ROOT, env=environment, check=True)


def say(text):
    print(f"== {text}", file=sys.stderr, flush=True)


def machine():
    """What the times depend on; neither names nor places."""
    pinned = [line for line in REQUIREMENTS.read_text().split() if "==" in line]
    return {
        "processor": f"{processor()}, {os.cpu_count()} cores visible",
        "system": f"{platform.system()} {platform.machine()}, {' '.join(platform.libc_ver())}".rstrip(", "),
        "C": f"{first_line([compiler(), '--version'])}; {' '.join(C_FLAGS)}",
        "Rust": first_line(["rustc", "--version"]),
        "Python": f"{platform.python_version()}; {', '.join(line.replace('==', ' ') for line in pinned)}",
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


def first_line(command):
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()[0]
