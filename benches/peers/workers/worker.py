"""What the Python workers share: the scene, and the lines that run.py documents."""

import sys
import time

# M, R, g; q1 ... q5 and their rates. The angles are 10, 2 and 45 degrees.
PARAMETERS = (1.0, 1.0, 9.81)
START = (0.17453292519943295, 0.03490658503988659, 0.7853981633974483, 5.0, 1.0, 0.01, -0.1, 0.02, 0.4, 0.1)
SPAN = 10.0


def serve(peer):
    """Answers lines until there are no more.

    `peer.run(tolerance)` makes one run and returns its end. `peer.prepare(tolerance)` makes ready whatever such a run needs
    and returns its counts of steps and evaluations. Optional: `reference(tolerance)`, the end in numbers of more digits.
    """
    counts = {}
    for line in sys.stdin:
        match line.split():
            case ["start"]:
                answer = PARAMETERS + START
            case ["prepare", tolerance]:
                begin = time.perf_counter()
                counts[float(tolerance)] = peer.prepare(float(tolerance))
                answer = (time.perf_counter() - begin,)
            case ["run", tolerance, repeats]:
                seconds, end = measured(peer, float(tolerance), int(repeats))
                answer = (seconds, *counts[float(tolerance)], *end)
            case ["reference", tolerance]:
                answer = peer.reference(float(tolerance))
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(x if isinstance(x, int) else repr(float(x)) for x in answer), flush=True)


def measured(peer, tolerance, repeats):
    begin = time.perf_counter()
    for _ in range(repeats):
        end = peer.run(tolerance)
    return (time.perf_counter() - begin) / repeats, end
