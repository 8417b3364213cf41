"""Accelerations of long mechanisms by CasADi, `growth_worker.py hessian|bodies FOLDER`: a worker of run.py.

`hessian`: M and f from Hessian and directional derivatives of the energies, solved by L D L'. `bodies`: articulated bodies (R. Featherstone,
Rigid Body Dynamics Algorithms, 2008, table 7.1) written in SX, whose structural zeros cost nothing. Both with common subexpressions shared.
"""

import itertools
import os
import sys
import time
from pathlib import Path

import casadi as ca

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import families  # noqa: E402  beside this folder


def turned(axis, angle):
    """The rotation from the frame before to the turned one."""
    s, c = ca.sin(angle), ca.cos(angle)
    j, k = axis % 3, (axis + 1) % 3
    matrix = ca.SX.eye(3)
    matrix[j, j] = matrix[k, k] = c
    matrix[j, k], matrix[k, j] = s, -s
    return matrix


def cross(a):
    return ca.vertcat(ca.horzcat(0, -a[2], a[1]), ca.horzcat(a[2], 0, -a[0]), ca.horzcat(-a[1], a[0], 0))


def inertia_matrix(entries):
    xx, yy, zz, xy, yz, zx = entries
    return ca.vertcat(ca.horzcat(xx, xy, zx), ca.horzcat(xy, yy, yz), ca.horzcat(zx, yz, zz))


def symmetric(matrix):
    """The upper triangle, mirrored: what is below is not computed."""
    return ca.triu2symm(ca.triu(matrix))


def joint_angles(problem, x):
    """Angles, or rates, from the link before."""
    if families.split(problem)[0] != "absolute":
        return list(x)
    return [x[0]] + [b - a for a, b in zip(x, x[1:])]


def bodies(problem, q, v, p):
    """q'' by articulated bodies."""
    rows, gravity = families.links(problem, p)
    angles, rates = joint_angles(problem, q), joint_angles(problem, v)
    ways, twists, coriolis, heavy, bias, axes = [], [], [], [], [], []
    before = ca.SX.zeros(6)
    for (axis, place, mass, centre, inertia), angle, rate in zip(rows, angles, rates):
        turn, arm = turned(axis, angle), cross(ca.vertcat(*place))
        way = ca.blockcat([[turn, ca.SX(3, 3)], [-turn @ arm, turn]])
        along = ca.SX(6, 1)
        along[axis - 1] = 1
        twist = way @ before + along * rate
        c = cross(ca.vertcat(*centre))
        about = inertia_matrix(inertia) + mass * (c @ c.T)
        rigid = ca.blockcat([[about, mass * c], [mass * c.T, mass * ca.SX.eye(3)]])
        spin, speed = cross(twist[:3]), cross(twist[3:])
        motion = ca.blockcat([[spin, ca.SX(3, 3)], [speed, spin]])
        coriolis.append(motion @ (along * rate))
        heavy.append(rigid)
        bias.append(-motion.T @ (rigid @ twist))
        ways.append(way), twists.append(twist), axes.append(axis - 1)
        before = twist
    gains = []
    for i in reversed(range(len(rows))):
        column = heavy[i][:, axes[i]]
        d, u = column[axes[i]], -bias[i][axes[i]]
        gains.append((column, d, u))
        if i:
            rest = symmetric(heavy[i] - column @ column.T / d)
            push = bias[i] + rest @ coriolis[i] + column * (u / d)
            heavy[i - 1] = heavy[i - 1] + symmetric(ways[i].T @ (rest @ ways[i]))
            bias[i - 1] = bias[i - 1] + ways[i].T @ push
    acceleration, out = ca.vertcat(0, 0, 0, *[-x for x in gravity]), []
    for way, c, axis, (column, d, u) in zip(ways, coriolis, axes, reversed(gains)):
        acceleration = way @ acceleration + c
        out.append((u - column.T @ acceleration) / d)
        acceleration[axis] += out[-1]
    if families.split(problem)[0] == "absolute":
        out = itertools.accumulate(out)
    return ca.vertcat(*out)


def hessian(problem, q, v, p):
    """q'' from the energies."""
    rows, gravity = families.links(problem, p)
    qs, vs = ca.vertsplit(q), ca.vertsplit(v)
    kinetic = potential = 0
    orientation, place, speed, spin = ca.SX.eye(3), ca.SX.zeros(3), ca.SX.zeros(3), ca.SX.zeros(3)
    for (axis, arm, mass, centre, inertia), angle, rate in zip(rows, joint_angles(problem, qs), joint_angles(problem, vs)):
        # Velocities in the frame of each link.
        arm = ca.vertcat(*arm)
        turn = turned(axis, angle)
        place = place + orientation @ arm
        speed, spin = turn @ (speed + ca.cross(spin, arm)), turn @ spin
        spin[axis - 1] += rate
        orientation = orientation @ turn.T
        centre = ca.vertcat(*centre)
        moving = speed + ca.cross(spin, centre)
        kinetic += mass * ca.dot(moving, moving) / 2 + ca.dot(spin, inertia_matrix(inertia) @ spin) / 2
        potential -= mass * ca.dot(ca.vertcat(*gravity), place + orientation @ centre)
    M, momenta = ca.hessian(kinetic, v)
    f = ca.gradient(kinetic - potential, q) - ca.jtimes(momenta, q, v)
    return ca.ldl_solve(f, *ca.ldl(M))


TOOLS = {"hessian": hessian, "bodies": bodies}


def derived(tool, problem):
    n = families.split(problem)[1]
    names = list(families.values(problem))
    q, v, p = (ca.SX.sym(name, count) for name, count in (("q", n), ("v", n), ("p", len(names))))
    by_name = dict(zip(names, ca.vertsplit(p)))
    arguments = (ca.vertsplit(q), ca.vertsplit(v)) if tool == "bodies" else (q, v)
    return ca.Function("accelerations", [q, v, p], [TOOLS[tool](problem, *arguments, by_name)], {"cse": True})


def count(function):
    ids = [function.instruction_id(k) for k in range(function.n_instructions())]
    calls = sum(i in (ca.OP_SIN, ca.OP_COS) for i in ids)
    return len(ids) - sum(i in (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST) for i in ids) - calls, calls


def main():
    tool, folder = sys.argv[1], Path(sys.argv[2])
    for line in sys.stdin:
        match line.split():
            case ["accelerations", problem, repeats]:
                begin = time.perf_counter()
                for _ in range(int(repeats)):
                    function = derived(tool, problem)
                answer = [(time.perf_counter() - begin) / int(repeats), *count(function)]
            case ["solve"]:
                p, row = [[float(x) for x in line.split()] for line in (folder / problem / "states").open()][:2]
                n = families.split(problem)[1]
                answer = function(row[:n], row[n : 2 * n], p).full().ravel()
            case ["code", path]:
                n, m = families.split(problem)[1], len(families.values(problem))
                # As generate.py writes it: C of (q', q'') from the parameters and (q, q').
                p, y = ca.SX.sym("p", m), ca.SX.sym("y", 2 * n)
                whole = ca.Function("equations", [p, y], [ca.vertcat(y[n:], function(y[:n], y[n:], p))], {"cse": True})
                answer = [written(whole, Path(path))]
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(repr(float(x)) for x in answer), flush=True)


def written(function, file):
    """Seconds to write the C of a right-hand side."""
    begin = time.perf_counter()
    os.chdir(file.parent)
    text = Path(function.generate("equations.c")).read_text()
    body = f"const double *arg[{function.sz_arg()}] = {{p, y}}; double *res[{function.sz_res()}] = {{out}};"
    work = f"double work[{function.sz_w() or 1}];"
    interface = "void rates(const double *p, const double *y, double *out)"
    file.write_text(f"{text}\n{interface}\n{{\n    {body}\n    {work}\n    equations(arg, res, 0, work, 0);\n}}\n")
    return time.perf_counter() - begin


if __name__ == "__main__":
    main()
