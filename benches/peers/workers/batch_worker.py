"""heyoka's batch integrator or its ensembles on the closed form: `batch_worker.py batch|ensemble WIDTH`, a worker of run.py.

A batch integrator takes WIDTH runs side by side, each with steps of its own, and is given new starts when all of them are done. An
ensemble copies it for each group of runs, in one thread here.
"""

import sys
import time

import heyoka as hy
import numpy as np
from closed_form import equations
from worker import PARAMETERS, SPAN, START

SAMPLE = 16  # runs whose ends are answered, evenly spaced


class Batch:
    def __init__(self, kind, width):
        self.ensemble, self.width, self.integrators = kind == "ensemble", width, {}

    def prepare(self, tolerance):
        # What was compiled before, in this process or another, would hide how long it takes.
        hy.llvm_state.set_diskcache_enabled(False)
        hy.llvm_state.clear_memcache()
        state = np.repeat(np.array(START)[:, None], self.width, axis=1)
        _, R, g = PARAMETERS
        self.integrators[tolerance] = hy.taylor_adaptive_batch(equations(R, g), state, tol=tolerance)

    def run(self, starts, tolerance):
        """Steps, and the ends, a row a run."""
        integrator, groups = self.integrators[tolerance], starts.reshape(-1, self.width, 10).transpose(0, 2, 1).copy()
        if self.ensemble:
            return self.run_ensemble(integrator, groups)
        ends, steps = np.empty_like(groups), 0
        for group, end in zip(groups, ends):
            integrator.set_time(0.0)
            integrator.state[:] = group
            integrator.propagate_until(SPAN)
            steps += sum(result[3] for result in integrator.propagate_res)
            end[:] = integrator.state
        return steps, ends

    def run_ensemble(self, integrator, groups):
        integrator.set_time(0.0)

        def started(copy, k):
            copy.state[:] = groups[k]
            return copy

        done = hy.ensemble_propagate_until_batch(integrator, SPAN, len(groups), started, algorithm="thread", max_workers=1)
        steps = sum(result[3] for one, *_ in done for result in one.propagate_res)
        return steps, np.array([one.state for one, *_ in done])


def main():
    batch = Batch(sys.argv[1], int(sys.argv[2]))
    for line in sys.stdin:
        match line.rstrip("\n").split(" ", 3):
            case ["start"]:
                answer = PARAMETERS + START
            case ["prepare", tolerance]:
                begin = time.perf_counter()
                batch.prepare(float(tolerance))
                answer = (time.perf_counter() - begin,)
            case ["batch", count, tolerance, path]:
                count = int(count)
                starts = np.fromfile(path).reshape(-1, 10)[:count]
                # Whole groups: the last one is filled with its last start.
                filled = np.concatenate([starts, np.repeat(starts[-1:], -count % batch.width, axis=0)])
                begin = time.perf_counter()
                steps, ends = batch.run(filled, float(tolerance))
                seconds = time.perf_counter() - begin
                ends = ends.transpose(0, 2, 1).reshape(-1, 10)
                answer = (seconds, steps, *ends[[k * count // SAMPLE for k in range(SAMPLE)]].ravel())
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(repr(float(x)) for x in answer), flush=True)


main()
