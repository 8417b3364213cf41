"""The closed form of the disk by numba, or by heyoka's compiled function: `rates_worker.py numba|heyoka-WIDTH STATES`.

A worker of run.py. heyoka is called once for all states, so that what the call from Python costs is spread over them; it cannot be
called from compiled code, so that calls which wait for one another are not measured. WIDTH is how many states it takes at a time.
"""

import math
import sys
import time

import numpy as np

COPIES = 16  # of the states, for heyoka


def loaded(path):
    lines = [[float(x) for x in line.split()] for line in open(path)]
    return lines[0], np.array(lines[1:])


def of_numba(parameters, states):
    import numba

    _, R, g = parameters

    @numba.njit("void(float64[::1], float64[::1])")
    def rates(y, out):
        s1, c1 = math.sin(y[0]), math.cos(y[0])
        s2, c2 = math.sin(y[1]), math.cos(y[1])
        r1, r2, r3 = y[5], y[6], y[7]
        a1 = -2 * r2 * r3 / c2
        a2 = (s2 * 4 * (g / R) + c2 * (r1 * (r1 * s2 + 2 * r3) - 4 * r2 * r2 * s2)) / (1 + 4 * s2 * s2)
        turn, carry = s2 * a1, c2 * r1 * r2
        radial = R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2)
        across = R * (turn + 2 * carry)
        for i in range(5):
            out[i] = y[5 + i]
        out[5] = a1
        out[6] = a2
        out[7] = -(turn + carry)
        out[8] = c1 * across - s1 * radial
        out[9] = c1 * radial + s1 * across

    @numba.njit("void(float64[:, ::1], float64[:, ::1], int64)")
    def throughput(states, out, passes):
        for _ in range(passes):
            for i in range(len(states)):
                rates(states[i], out[i])

    @numba.njit("float64(float64[:, ::1], int64)")
    def chained(states, passes):
        carried, y, f = 0.0, np.empty(10), np.empty(10)
        for _ in range(passes):
            for i in range(len(states)):
                for j in range(10):
                    y[j] = states[i, j] + 1e-300 * carried
                rates(y, f)
                carried = f[6] + f[8] + f[9]
        return carried

    out = np.empty_like(states)
    throughput(states, out, 1)
    calls = lambda passes: throughput(states, out, passes)
    return calls, lambda passes: chained(states, passes), lambda count: out[:count].ravel(), len(states)


def of_heyoka(parameters, states, width):
    import heyoka as hy
    from closed_form import equations

    # What was compiled before would hide how long it takes.
    hy.llvm_state.set_diskcache_enabled(False)
    pairs = equations(*parameters[1:])
    function = hy.cfunc([rate for _, rate in pairs], vars=[x for x, _ in pairs], batch_size=width)
    inputs = np.ascontiguousarray(np.tile(states, (COPIES, 1)).T)
    outputs = np.empty_like(inputs)

    def calls(passes):
        for _ in range(passes):
            function(inputs, outputs=outputs)

    calls(1)
    return calls, None, lambda count: outputs[:, :count].T.ravel(), inputs.shape[1]


def main():
    kind, path = sys.argv[1:]
    begin = time.perf_counter()
    name, _, width = kind.partition("-")
    made = of_numba(*loaded(path)) if name == "numba" else of_heyoka(*loaded(path), int(width))
    throughput, chained, values, states = made
    compiled = time.perf_counter() - begin
    for line in sys.stdin:
        match line.split():
            case ["compiled"]:
                answer = [compiled]
            case ["throughput" | "chained" as what, passes]:
                # As many calls as of the others.
                passes = max(1, int(passes) * 128 // states)
                begin = time.perf_counter()
                (throughput if what == "throughput" else chained)(passes)
                answer = [(time.perf_counter() - begin) / passes / states]
            case ["values", count]:
                answer = values(int(count))
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(repr(float(x)) for x in answer), flush=True)


main()
