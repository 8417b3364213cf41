"""Workers as child processes, and what is asked of them: which tolerance reaches an error, and how long that takes."""

import statistics
import subprocess
import time
from dataclasses import dataclass, field

TOLERANCES = [10.0 ** (-k / 2) for k in range(4, 29)]
TARGETS = [1e-3, 1e-6, 1e-8]
# A sample is this long, or one run: shorter than the turn a busy system gives a process, much longer than a clock's tick.
SAMPLE_SECONDS = 3e-3


@dataclass
class Answer:
    seconds: float
    steps: int
    evaluations: int
    error: float


@dataclass
class Reached:
    """How a worker reaches an error."""

    tolerance: float
    answer: Answer
    prepared: float
    repeats: int = 1
    samples: list = field(default_factory=list)

    @property
    def seconds(self):
        return statistics.median(self.samples)

    @property
    def spread(self):
        """Half the distance between the quartiles, as a part of the median."""
        first, _, third = statistics.quantiles(self.samples, n=4)
        return (third - first) / 2 / self.seconds


class Peer:
    """A worker that waits for lines."""

    def __init__(self, name, command):
        self.name = name
        self.reached = {}
        self.best = None
        self.rates = None
        begin = time.perf_counter()
        command = [str(word) for word in command]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.start = self.ask("start")
        self.ready = time.perf_counter() - begin

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            raise SystemExit(f"{self.name} did not answer `{line}` (exit status {self.process.wait()})")
        return [float(word) for word in answer.split()]

    def run(self, tolerance, repeats, reference):
        seconds, steps, evaluations, *end = self.ask(f"run {tolerance!r} {repeats}")
        return Answer(seconds, int(steps), int(evaluations), error(end, reference))

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def error(end, reference):
    """The largest error of a component, relative to it or to 1, whichever is more; NaN counts as infinite."""
    errors = [abs(e - r) / (1 + abs(r)) for e, r in zip(end, reference, strict=True)]
    return max((e if e == e else float("inf") for e in errors))


def search(peer, reference):
    """For each target the loosest tolerance that reaches it, and the smallest error of all."""
    peer.best = float("inf")
    for tolerance in TOLERANCES:
        (prepared,) = peer.ask(f"prepare {tolerance!r}")
        answer = peer.run(tolerance, 1, reference)
        peer.best = min(peer.best, answer.error)
        for target in TARGETS:
            if answer.error <= target and target not in peer.reached:
                again = peer.run(tolerance, 1, reference)
                repeats = max(1, round(SAMPLE_SECONDS / again.seconds))
                peer.reached[target] = Reached(tolerance, answer, prepared, repeats)


def sample(peers, rounds, reference):
    """Every worker in turn, again and again, so that what slows the machine slows all of them."""
    for _ in range(rounds):
        for target in TARGETS:
            for peer in peers:
                if reached := peer.reached.get(target):
                    answer = peer.run(reached.tolerance, reached.repeats, reference)
                    reached.samples.append(answer.seconds)


def sample_rates(peers, rounds):
    """Seconds for one call of the right-hand side, of those that tell it."""
    samples = {peer.name: [] for peer in peers}
    for _ in range(rounds):
        for peer in peers:
            samples[peer.name].append(peer.ask("rates 50000")[0])
    for peer in peers:
        peer.rates = statistics.median(samples[peer.name])
