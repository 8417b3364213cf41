"""What became of one case."""
from collections import Counter

OUTCOMES = ["right", "refused", "undecided", "wrong", "panic", "time-out", "unjudged"]


class Outcome:
    """The outcome of a case: one of `OUTCOMES`, the reason, and how many numbers were compared."""
    def __init__(self, outcome, reason="", numbers=0, files=None):
        self.outcome, self.reason, self.numbers, self.files = outcome, reason, numbers, files or {}


class Tally:
    """Counts of the outcomes of a kind."""
    def __init__(self):
        self.counts, self.reasons, self.numbers, self.saved, self.tags = Counter(), {}, 0, [], Counter()

    def add(self, outcome, saved=None):
        self.counts[outcome.outcome] += 1
        self.numbers += outcome.numbers
        if outcome.reason:
            self.reasons.setdefault(outcome.outcome, Counter())[general(outcome.reason)] += 1
        if saved:
            self.saved.append((outcome.outcome, saved, outcome.reason))

    def common(self, outcome, most=6):
        """The commonest reasons of an outcome with their numbers."""
        return self.reasons.get(outcome, Counter()).most_common(most)

    @property
    def total(self):
        return sum(self.counts.values())

    @property
    def judged(self):
        """Cases with an answer whose truth is known."""
        return self.counts["right"] + self.counts["wrong"]

    def bound(self):
        """Upper 95 % bound of the rate of wrong answers among the answers given."""
        return upper_bound(self.counts["wrong"], self.judged)


def upper_bound(wrong, cases):
    """Clopper and Pearson's upper bound at 95 %; without a wrong case about 3/n (the rule of three)."""
    if cases == 0 or wrong >= cases:
        return 1.0
    from math import exp, lgamma, log, log1p

    def at_most(p):
        return sum(exp(lgamma(cases + 1) - lgamma(k + 1) - lgamma(cases - k + 1) + k * log(p) + (cases - k) * log1p(-p))
                   for k in range(wrong + 1))
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if at_most(middle) > 0.05 else (low, middle)
    return high


def general(reason):
    """A reason without the names and numbers of its case."""
    import re
    reason = re.sub(r"`[^`]*`", "`…`", reason)
    reason = re.sub(r"\b[A-Za-z]+_*\d+(_\w+)?'*\b'*", "…", reason)
    reason = re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", reason)
    return reason[:110]
