#!/usr/bin/env python3
"""Compares generated code with what a processor can do at most: `python3 benches/bounds.py [--cpu NAME]`.

For right-hand sides in four and in eight lanes (states at once), prints a Markdown table in processor cycles a state:

- `resources`: the units of the processor are always busy, and no instruction waits for another. No order of the same
  instructions takes less.
- `modelled`: the processor reorders the instructions as far as its buffers allow. llvm-mca computes both numbers from
  the machine code, with the name of a processor as LLVM knows it, such as znver3.
- `measured`: the time of a call on this machine, in cycles of its clock. The clock is measured by a chain of
  multiplications of whole numbers, each of which takes three cycles.

The instructions of a function are counted once, without its jumps and calls: the range reduction of large angles is a
call. Needs cargo, and llvm-objdump and llvm-mca of LLVM 14 or newer (Debian: `llvm`). Everything made is in
target/bounds. `--small` measures one function, to show that all works.
"""

import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "target" / "bounds"

#: Right-hand sides: module of the model, module and type of the equations, numbers of parameters, coordinates, speeds.
PROBLEMS = [
    ("disk", "lagrange", "Lagrange", 3, 5, 5),
    ("cart_pendulum_3", "lagrange", "Lagrange", 9, 4, 4),
    ("floating_chain", "kane", "Kane", 9, 5, 5),
]

MANIFEST = """\
[package]
name = "bounds"
edition = "2024"

[workspace]

[dependencies]
tripos-traits = {{ path = "{root}/sim/traits" }}

[profile.release]
debug = false
"""

PROGRAM = """\
#![allow(unused, non_snake_case)]
use std::hint::black_box;
use std::time::Instant;
use tripos_traits::{{Lanes, Scalar, System, lane_width}};

{modules}

/// Seconds of one call of the right-hand side, the least of many rounds.
fn seconds<const N: usize, E: System<Lanes<N>>>(equations: &E, counts: [usize; 3]) -> f64 {{
    let [p, q, v] = counts.map(|count| {{
        let value = |i: usize, lane: usize| 0.3 + 0.17 * i as f64 + 0.01 * lane as f64;
        (0..count).map(|i| Lanes::<N>(std::array::from_fn(|lane| value(i, lane)))).collect::<Vec<_>>()
    }});
    let (mut q_dot, mut v_dot) = (q.clone(), v.clone());
    let mut round = || {{
        let begun = Instant::now();
        for _ in 0..{calls} {{
            let equations = black_box(equations);
            equations.derivative(black_box(&p), black_box(&q), black_box(&v), &mut q_dot, &mut v_dot);
            black_box((&q_dot, &v_dot));
        }}
        begun.elapsed().as_secs_f64() / {calls} as f64
    }};
    (0..{rounds}).map(|_| round()).fold(f64::INFINITY, f64::min)
}}

/// Seconds of one cycle of the clock, from a chain of multiplications that take three cycles each.
fn seconds_of_cycle() -> f64 {{
    const COUNT: u32 = 3_000_000;
    let round = || {{
        let begun = Instant::now();
        let mut x = black_box(3_u64);
        for _ in 0..COUNT / 8 {{
            for _ in 0..8 {{
                x = x.wrapping_mul(x);
            }}
        }}
        black_box(x);
        begun.elapsed().as_secs_f64() / f64::from(3 * COUNT)
    }};
    (0..{rounds}).map(|_| round()).fold(f64::INFINITY, f64::min)
}}

fn main() {{
    println!("{{}} {{}}", lane_width(), seconds_of_cycle());
{calls_of_problems}
}}
"""


def program(problems, small):
    """Text of a program that measures the right-hand sides in four and in eight lanes."""
    modules = [f'#[path = "{ROOT}/generated/src/{name}/mod.rs"]\npub mod {name};' for name, *_ in problems]
    calls = [
        f'    println!("{name} {lanes} {{}}", seconds::<{lanes}, _>(&{name}::code::{module}::{unit}, [{p}, {q}, {v}]));'
        for name, module, unit, p, q, v in problems
        for lanes in (4, 8)
    ]
    rounds, count = (3, 100) if small else (200, 2000)
    return PROGRAM.format(
        modules="\n".join(modules), calls_of_problems="\n".join(calls), rounds=rounds, calls=count
    )


def build(problems, small):
    """Builds the program, with symbols from which the functions can be told, and returns its path."""
    (FOLDER / "src").mkdir(parents=True, exist_ok=True)
    (FOLDER / "Cargo.toml").write_text(MANIFEST.format(root=ROOT), encoding="utf-8")
    (FOLDER / "src" / "main.rs").write_text(program(problems, small), encoding="utf-8")
    command = ["cargo", "rustc", "--release", "--quiet", "--", "-C", "symbol-mangling-version=v0"]
    subprocess.run(command, cwd=FOLDER, check=True)
    return FOLDER / "target" / "release" / "bounds"


def instructions_of_functions(executable):
    """Instructions of each function of a program in AT&T's syntax, by the function's name with its generic types."""
    command = ["llvm-objdump", "--disassemble", "--demangle", "--no-show-raw-insn", str(executable)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    functions, body = {}, None
    for line in text.splitlines():
        if head := re.fullmatch(r"[0-9a-f]+ <(.*)>:", line):
            body = functions.setdefault(head[1], [])
        elif body is not None and (instruction := re.match(r"\s+[0-9a-f]+:\s+(\S.*)", line)):
            body.append(re.sub(r"\s*#.*|<.*>", "", instruction[1]))
    return functions


def straight_line(instructions):
    """Instructions without jumps, calls and the saving of registers."""
    left_out = re.compile(r"(j|call|ret|push|pop|nop|int3|ud2|data16|cs )")
    return [instruction for instruction in instructions if not left_out.match(instruction)]


def cycles(instructions, processor):
    """Cycles of one pass over the instructions by llvm-mca: by the units of a processor alone, and with its buffers."""
    passes = 200
    command = ["llvm-mca", "-mtriple=x86_64", f"-mcpu={processor}", f"-iterations={passes}"]
    found = subprocess.run(command, input="\n".join(instructions) + "\n", capture_output=True, text=True, check=False)
    if found.returncode != 0:
        sys.exit(f"llvm-mca refuses the code for {processor}: {found.stderr.strip().splitlines()[0]}")
    resources = float(re.search(r"Block RThroughput:\s+([\d.]+)", found.stdout)[1])
    return resources, float(re.search(r"Total Cycles:\s+(\d+)", found.stdout)[1]) / passes


def function_in_lanes(functions, name, lanes, wide):
    """Instructions of the right-hand side of a model for so many lanes, with the widest registers of the processor."""
    dispatch = "avx512" if wide and lanes == 8 else "avx2"
    found = [
        body
        for symbol, body in functions.items()
        if f"dispatch::{dispatch}" in symbol and f"::{name}::" in symbol and re.search(rf"Lanes<{lanes}(_?usize)?>", symbol)
    ]
    if len(found) != 1:
        sys.exit(f"{len(found)} functions of `{name}` for {lanes} lanes in the program, not one")
    return straight_line(found[0])


def main():
    """Builds, measures and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cpu", default="native", help="a processor as LLVM knows it; this machine's unless given")
    parser.add_argument("--small", action="store_true", help="one function, measured shortly")
    given = parser.parse_args()
    missing = [tool for tool in ("cargo", "llvm-objdump", "llvm-mca") if shutil.which(tool) is None]
    if missing:
        sys.exit(f"{' and '.join(missing)} not found; Debian has LLVM's tools in the package `llvm`")
    problems = PROBLEMS[:1] if given.small else PROBLEMS
    executable = build(problems, given.small)
    functions = instructions_of_functions(executable)
    first, *rest = subprocess.run([str(executable)], check=True, capture_output=True, text=True).stdout.splitlines()
    width, cycle = first.split()
    print(f"{given.cpu}, clock {1e-9 / float(cycle):.2f} GHz, in cycles a state\n")
    print("| right-hand side | lanes | instructions | resources | modelled | measured |")
    print("|---|---:|---:|---:|---:|---:|")
    for line in rest:
        name, lanes, seconds = line.split()
        body = function_in_lanes(functions, name, int(lanes), width == "8")
        numbers = [*cycles(body, given.cpu), float(seconds) / float(cycle)]
        cells = [f"{number / int(lanes):.0f}" for number in numbers]
        print(f"| `{name}` | {lanes} | {len(body)} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
