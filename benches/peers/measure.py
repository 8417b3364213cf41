"""Workers as child processes that answer lines, and times of what they are asked."""

import statistics
import subprocess
import time
from dataclasses import dataclass, field

import tools


@dataclass
class Samples:
    """Times of one thing, in seconds."""

    seconds: list = field(default_factory=list)

    @property
    def median(self):
        return statistics.median(self.seconds) if self.seconds else float("inf")

    @property
    def fastest(self):
        return min(self.seconds, default=float("inf"))

    @property
    def spread(self):
        """Half the distance between the quartiles, as a part of the median."""
        if len(self.seconds) < 2:
            return 0.0
        first, _, third = statistics.quantiles(self.seconds, n=4)
        return (third - first) / 2 / self.median


class Peer:
    """A worker that waits for lines; the seconds until it answers the first, if one is given, are `ready`."""

    def __init__(self, name, command, greeting=None):
        self.name = name
        begin = time.perf_counter()
        command = [str(word) for word in command]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.greeting = self.ask(greeting) if greeting else None
        self.ready = time.perf_counter() - begin

    def ask(self, line):
        try:
            self.process.stdin.write(line + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        answer = self.process.stdout.readline()
        if not answer:
            raise SystemExit(f"{self.name} did not answer `{line}` (exit status {self.process.wait()})")
        return [float(word) for word in answer.split()]

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def started(rows, greeting=None):
    """The workers of these rows, each given as what it needs and what makes its command; rows without their tools are left out."""
    here = {name: command for name, (needs, command) in rows.items() if tools.has(name, *needs)}
    return {name: Peer(name, command(), greeting) for name, command in here.items()}


def interleaved(askings, rounds):
    """Samples by key: `askings` says for each key what gives its seconds once. Each in turn, again and again, so that what slows
    the machine slows all of them."""
    samples = {key: Samples() for key in askings}
    for _ in range(rounds):
        for key, ask in askings.items():
            samples[key].seconds.append(ask())
    return samples


def repeats(seconds, wanted=3e-3):
    """How many calls make a sample: shorter than the turn a busy system gives a process, much longer than a clock's tick."""
    return max(1, round(wanted / max(seconds, 1e-12)))


def error(values, reference):
    """The largest error of a component, relative to it or to 1, whichever is more; NaN counts as infinite."""
    errors = [abs(e - r) / (1 + abs(r)) for e, r in zip(values, reference, strict=True)]
    return max((e if e == e else float("inf") for e in errors))


def must_agree(values, tolerance):
    """All answers, by name, must be those of the first."""
    (first, reference), *others = values.items()
    for name, answer in others:
        if error(answer, reference) > tolerance:
            raise SystemExit(f"{name} computes other numbers than {first}:\n  {answer}\n  {reference}")
