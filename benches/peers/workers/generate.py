"""Right-hand sides by tools that generate code: `generate.py casadi-ldl|casadi-qr|sympy|symforce LENGTHS FILE`.

LENGTHS is the numbers of coordinates and of parameters, as in `5,3`. The file defines, in C or C++,
`void rates(const double *p, const double *y, double *out)` with y = (q, q') and out = (q', q''). All start from the same M and f
as the derivation is measured with; how M q'' = f is solved is what the tool does best or what C or Eigen does.
"""

import os
import sys
from pathlib import Path

import mechanics

INTERFACE = "void rates(const double *p, const double *y, double *out)"


def casadi(solver, n, m, file):
    """CasADi's own C of q', q'', with M factored symbolically."""
    import casadi as ca

    q, v, p, M, f = mechanics.of_casadi(n, m)
    a = ca.ldl_solve(f, *ca.ldl(M)) if solver == "ldl" else ca.solve(M, f)
    function = ca.Function("equations", [p, ca.vertcat(q, v)], [ca.vertcat(v, a)], {"cse": True})
    # It writes where it stands.
    os.chdir(file.parent)
    text = Path(function.generate("equations.c")).read_text()
    body = f"const double *arg[{function.sz_arg()}] = {{p, y}}; double *res[{function.sz_res()}] = {{out}};"
    work = f"double work[{function.sz_w() or 1}];"
    file.write_text(f"{text}\n{INTERFACE}\n{{\n    {body}\n    {work}\n    equations(arg, res, 0, work, 0);\n}}\n")


def sympy(n, m, file):
    """SymPy's C of M and f with common subexpressions shared, then L D L' written out without what is zero."""
    import sympy as sm

    q, v, p, M, f = mechanics.of_symbols(sm, n, m)
    lower = [(i, j) for i in range(n) for j in range(i + 1) if M[i][j] != 0]
    shared, values = sm.cse([M[i][j] for i, j in lower] + f, symbols=sm.numbered_symbols("t"))
    arguments = [("y", x) for x in q + v] + [("p", x) for x in p]
    starts = {"y": 0, "p": 2 * n}
    lines = [f"const double {x} = {source}[{i - starts[source]}];" for i, (source, x) in enumerate(arguments)]
    lines += [f"const double {name} = {code(value)};" for name, value in shared]
    lines += [f"double m{i}_{j} = {code(value)};" for (i, j), value in zip(lower, values)]
    lines += [f"double f{i} = {code(value)};" for i, value in enumerate(values[len(lower) :])]
    lines += solved(n, lower)
    lines += [f"out[{i}] = y[{n + i}]; out[{n + i}] = f{i};" for i in range(n)]
    text = "\n    ".join(lines)
    file.write_text(f"#include <math.h>\n{INTERFACE}\n{{\n    {text}\n}}\n")


def code(value):
    """C of a value; small powers as products, since pow is no instruction."""
    import sympy as sm
    from sympy.codegen.rewriting import create_expand_pow_optimization

    return sm.ccode(create_expand_pow_optimization(4)(sm.sympify(value)))


def solved(n, lower):
    """C that leaves the solution of M x = f in f: the row with the fewest neighbours goes first, so that little fills in."""
    name = lambda i, j: f"m{max(i, j)}_{min(i, j)}"
    near = {i: {j for j in range(n) if j != i and (max(i, j), min(i, j)) in lower} for i in range(n)}
    lines, back = [], []
    while near:
        k = min(near, key=lambda i: (len(near[i]), -i))
        left = sorted(near.pop(k))
        lines.append(f"const double r{k} = 1 / {name(k, k)};")
        for i in left:
            near[i].discard(k)
            lines += [f"const double l{i}_{k} = {name(i, k)} * r{k};", f"f{i} -= l{i}_{k} * f{k};"]
        for at, i in enumerate(left):
            for j in left[: at + 1]:
                filled = i != j and j not in near[i]
                lines.append(f"{'double ' if filled else ''}{name(i, j)} {'= -' if filled else '-= '}l{i}_{k} * {name(j, k)};")
                if filled:
                    near[i].add(j)
                    near[j].add(i)
        back.append(f"f{k} = f{k} * r{k}" + "".join(f" - l{i}_{k} * f{i}" for i in left) + ";")
    return lines + back[::-1]


def symforce(n, m, file):
    """SymForce's C++ of M and f, shared by its own symengine; Eigen solves by its L L' of fixed size."""
    import symforce

    symforce.set_symbolic_api("symengine")
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce.values import Values

    q, v, p, M, f = mechanics.of_symbols(sf.sympy, n, m)
    vector = lambda x: sf.Matrix([x]).T
    inputs = Values(p=vector(p), q=vector(q), v=vector(v))
    outputs = Values(M=sf.Matrix(M), f=vector(f))
    config = codegen.CppConfig(use_eigen_types=True)
    written = codegen.Codegen(inputs=inputs, outputs=outputs, config=config, name="equations")
    folder = file.with_suffix("")
    header = written.generate_function(output_dir=folder, skip_directory_nesting=True).generated_files
    header = next(path for path in header if path.name == "equations.h")
    text = f"""#include "{header}"
#include <Eigen/Dense>
extern "C" {INTERFACE}
{{
    using V = Eigen::Matrix<double, {n}, 1>;
    Eigen::Matrix<double, {n}, {n}> M;
    V f;
    sym::Equations<double>(Eigen::Map<const Eigen::Matrix<double, {m}, 1>>(p), Eigen::Map<const V>(y), Eigen::Map<const V>(y + {n}), &M, &f);
    Eigen::Map<V> rate(out), acceleration(out + {n});
    rate = Eigen::Map<const V>(y + {n});
    acceleration = M.llt().solve(f);
}}
"""
    file.write_text(text)


def main():
    tool, lengths, file = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    n, m = map(int, lengths.split(","))
    match tool.split("-"):
        case ["casadi", solver]:
            casadi(solver, n, m, file)
        case ["sympy"]:
            sympy(n, m, file)
        case ["symforce"]:
            symforce(n, m, file)


main()
