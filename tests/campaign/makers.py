"""The kinds of random mechanisms, with their weights, and their starts."""
import numpy as np
import loops, rollers, trees
from fittings import fit
from mechanism import Mechanism
from oracle import closed, equations, permitted

MAKERS = [(trees.joint_tree, 8), (trees.placed_tree, 4), (loops.plane_loop, 2), (loops.stated_loop, 1.5),
          (loops.space_loop, 1.5), (rollers.disc, 1), (rollers.ball, 1), (rollers.sleigh, 1), (rollers.tied, 3)]


class Case:
    """A random mechanism: its text, how this program reads it, and a start that satisfies its constraints."""
    def __init__(self, random, hostile=False, makers=None):
        makers = makers or MAKERS
        make = random.choices([m for m, _ in makers], [w for _, w in makers])[0]
        d = fit(make(random, hostile))
        choose_speeds(d)
        self.draft, self.text, self.tags = d, d.text(), d.tags | {make.__name__} | ({"hostile"} if hostile else set())
        self.mechanism = Mechanism(self.text)
        self.q = {name: d.start[name][0] for name in self.mechanism.coordinates}
        self.rates = {name: d.start[name][1] for name in self.mechanism.coordinates}
        self.q = closed(self.mechanism, self.q)
        if self.q is not None:
            self.rates = permitted(self.mechanism, self.q, self.rates)


def choose_speeds(d):
    """Speeds of the file's own for a constrained mechanism: rates that determine the motion well at the start."""
    joints = d.sections["joints"].values()
    if not d.constrained or d.sections["speeds"] or d.random.random() < 0.6:
        return
    m = Mechanism(d.text())
    q = closed(m, {name: d.start[name][0] for name in m.coordinates})
    if q is None:
        return
    rates = permitted(m, q, {name: d.start[name][1] for name in m.coordinates})
    free = equations(m, q, rates).free
    count = free.shape[1]
    for _ in range(20):
        chosen = sorted(d.random.sample(range(len(m.coordinates)), count))
        if count and np.linalg.cond(free[chosen]) < 30:
            break
    else:
        return
    for joint in joints:
        if joint["kind"] != "weld" and not joint.get("body_at"):
            joint["speeds"] = []
    for k in chosen:
        d.sections["speeds"][d.name("u")] = f"{m.coordinates[k]}'"
    d.tags.add("own speeds")


def state_text(q, rates, section="state"):
    """A state or a start with every coordinate and every rate."""
    lines = [f"[{section}]", *(f"{name} = {value!r}" for name, value in q.items())]
    return "\n".join(lines + [f"\"{name}'\" = {value!r}" for name, value in rates.items()]) + "\n"
