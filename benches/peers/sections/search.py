"""How a worker reaches an error: the loosest tolerance that does."""

from dataclasses import dataclass, field

import build
import size
from measure import Peer, Samples, error, repeats

# What every worker must come down to: one that does not solves another problem.
SAME_PROBLEM = size.of(1e-7, 1e-5)


@dataclass
class Reached:
    """How a worker reaches an error."""

    peer: Peer
    tolerance: float
    error: float
    steps: int
    evaluations: int
    prepared: float
    repeats: int
    samples: Samples = None


@dataclass
class Question:
    """What is to be reached: one of these errors in the reference, with tolerances from loose to tight."""

    name: str
    targets: list
    tolerances: list
    reference: list
    # How each worker reached each error, by (name, error).
    reached: dict = field(default_factory=dict)
    # The smallest error at any tolerance, by name.
    best: dict = field(default_factory=dict)


def search(peer, question, seen=lambda end: end):
    """For each target the loosest tolerance that reaches it; keeps the smallest error of all.

    `seen` takes from the end that a worker answers what the question is about.
    """
    build.say(f"which tolerances: {peer.name}")
    best = float("inf")
    for tolerance in question.tolerances:
        (prepared,) = peer.ask(f"prepare {tolerance!r}")
        _, steps, evaluations, *end = peer.ask(f"run {tolerance!r} 1")
        found = error(seen(end), question.reference)
        best = min(best, found)
        for target in question.targets:
            if found <= target and (peer.name, target) not in question.reached:
                seconds = peer.ask(f"run {tolerance!r} 1")[0]
                counts = (int(steps), int(evaluations), prepared, repeats(seconds))
                question.reached[peer.name, target] = Reached(peer, tolerance, found, *counts)
    if best > SAME_PROBLEM:
        raise SystemExit(f"{peer.name} comes no nearer to the reference than {best:.1e}")
    question.best[peer.name] = best
