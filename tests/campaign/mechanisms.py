"""Kind `mechanisms`: equations of random mechanisms at random states against the oracle."""
import os
import numpy as np
import loads
from formula import evaluate
from makers import Case, state_text
from mechanism import Unknown
from oracle import closed, equations, permitted
from verdict import Outcome

FORMULATIONS = ["kane", "lagrange", "newton-euler", "gibbs-appell"]
# Parts of the size of a number up to which two values are equal; rounding grows with the condition of the equations.
RELATIVE, PER_CONDITION = 1e-9, 1e-13
WORST_CONDITION, NEAR_SINGULAR = 1e8, 1e-6


class Judge:
    """Compares the answers about one case and collects mismatches."""
    def __init__(self, case, program, folder):
        self.case, self.program, self.folder = case, program, folder
        self.model, self.state = os.path.join(folder, "model.toml"), os.path.join(folder, "state.toml")
        write(self.model, case.text)
        write(self.state, state_text(case.q, case.rates))
        self.numbers, self.wrong, self.refusals = 0, [], []
        self.eq = equations(case.mechanism, case.q, case.rates)
        # Accelerations that happen to be 0 are compared by the size of the motion.
        speed = max(map(abs, case.rates.values()), default=0.0)
        self.scale = float(np.abs(self.eq.accelerations).max(initial=0)) + 1e-2 * (1 + speed**2)
        self.tolerance = RELATIVE + PER_CONDITION * self.eq.condition

    def compare(self, what, theirs, mine, scale=0.0):
        """One number against the oracle's, relative to its size or to `scale`."""
        self.numbers += 1
        if theirs is None or not abs(theirs - mine) <= self.tolerance * (abs(mine) + scale):
            self.wrong.append(f"{what}: printed {theirs!r}, right {mine!r}")

    def ask(self, *arguments):
        """The JSON of a command; `None` if the program refuses."""
        answer = self.program(*arguments, "--json")
        if answer.panicked:
            raise Stopped("panic", " ".join(map(str, arguments[:1])) + ": " + answer.reason)
        if answer.expired:
            raise Stopped("time-out", " ".join(map(str, arguments[:1])))
        if not isinstance(answer.json, dict) or "error" in answer.json or answer.status == 2:
            return answer.reason, None
        return None, answer.json

    def formulation(self, by, state=None):
        return self.ask("evaluate", self.model, "--by", by, "--at", state or self.state)

    def judge(self):
        for by in FORMULATIONS:
            reason, answer = self.formulation(by)
            if answer is None:
                self.refusals.append((by, reason))
                if by == "kane":
                    return
                continue
            self.one_formulation(by, answer)
            if by == "kane":
                self.given_power = answer["power"]
                self.power(answer)
        self.check()
        self.proofs()

    def rate(self, name):
        """The oracle's value of u' or q''."""
        eq = self.eq
        if name.endswith("''"):
            return eq.accelerations[self.case.mechanism.coordinates.index(name[:-2])]
        return eq.i.rate_of(eq.i.speed(name[:-1]), eq.accelerations)

    def one_formulation(self, by, answer):
        eq, i = self.eq, self.eq.i
        scale = self.scale
        for name, value in answer["accelerations"].items():
            self.compare(f"{by} {name}", value, self.rate(name), scale)
        self.compare(f"{by} T", answer["kinetic_energy"], eq.kinetic, 1e-6 * abs(eq.kinetic) + 1e-12)
        gravity = loads.gravity_energy(i)
        size = sum(abs(float(w.force @ w.place)) for w in loads.gravity(i))
        if answer.get("gravity_potential") is not None:
            self.compare(f"{by} gravity", answer["gravity_potential"], gravity, size + 1e-12)
        self.matrix(by, answer)
        drives = answer["multipliers"].get("lambda_t")
        if drives is not None and not any(i.m.data.get(s) for s in ("constraints", "rolling")):
            true = eq.drives()
            if true is not None:
                self.compare(f"{by} lambda_t", drives, true, abs(eq.power) + abs(eq.kinetic) + 1e-6)

    def matrix(self, by, answer):
        """M v' = f at the oracle's accelerations; M symmetric and positive definite in Kane's equations."""
        m, f = np.array(answer["mass_matrix"], float), np.array(answer["forcing"], float)
        if m.size == 0 or any(entry is None for row in answer["mass_matrix"] for entry in row):
            return
        values = []
        for name in answer["unknowns"]:
            if name.endswith("'"):
                if name == "t''":
                    return
                values.append(self.rate(name))
            else:
                given = {**answer["reactions"], **answer["multipliers"]}
                if given.get(name) is None:
                    return
                values.append(given[name])
        v = np.array(values)
        sizes = np.abs(m) @ (np.abs(v) + self.scale) + np.abs(f)
        scale = sizes + 1e-5 * sizes.max(initial=0)
        for k, (left, right) in enumerate(zip(m @ v, f)):
            self.compare(f"{by} row {k + 1} of M v' = f", left, right, scale[k])
        if by in ("kane", "gibbs-appell"):
            self.numbers += 1
            d = np.sqrt(np.maximum(np.abs(np.diag(m)), 1e-300))
            unit = m / np.outer(d, d)
            if np.abs(unit - unit.T).max() > self.tolerance:
                self.wrong.append(f"{by}: the mass matrix is not symmetric")
            elif self.eq.eigenvalues.min() > 1e-9 and np.linalg.eigvalsh(unit).min() < -1e-9:
                self.wrong.append(f"{by}: the mass matrix is not positive definite")

    def power(self, answer):
        """W − dV/dt is the power of all loads, gravity included."""
        case, h = self.case, 1e-4
        values = []
        if case.tags & {"drive", "time"}:
            return
        for step in (h, -h):
            q = closed(case.mechanism, {name: case.q[name] + step * case.rates[name] for name in case.q})
            if q is None:
                return
            path = os.path.join(self.folder, "near.toml")
            write(path, state_text(q, permitted(case.mechanism, q, case.rates)))
            reason, near = self.formulation("kane", path)
            if near is None or near["potential_energy"] is None:
                return
            values.append(near["potential_energy"])
        slope = (values[0] - values[1]) / (2 * h)
        size = abs(self.eq.power) + abs(slope) + sum(
            abs(float(w.generalized(self.eq.i) @ self.eq.i.rates)) for w in self.eq.wrenches)
        self.numbers += 1
        error = abs(answer["power"] - slope - self.eq.power)
        if not error <= 3e-6 * (size + abs(values[0]) * 1e-4 + 1e-6):
            self.wrong.append(f"W - dV/dt: printed {answer['power'] - slope!r}, right {self.eq.power!r}")

    def check(self):
        reason, answer = self.ask("check", self.model)
        if answer is None:
            self.refusals.append(("check", reason))
            return
        self.numbers += 1
        freedom = self.eq.i.n - self.eq.rank
        if self.eq.gap < 1e-11 and answer["degrees_of_freedom"] != freedom:
            self.wrong.append(f"degrees of freedom: printed {answer['degrees_of_freedom']}, right {freedom}")
        if answer["loads"] and all(load["energy"] in ("keeps", "dissipates") for load in answer["loads"]):
            self.numbers += 1
            if self.given_power > 1e-9:
                self.wrong.append(f"no load creates energy by `check`; the power W is {self.given_power!r}")

    def proofs(self):
        """First integrals are constant along the oracle's motion; the formulations are equivalent."""
        reason, answer = self.ask("prove", self.model)
        if answer is None:
            self.refusals.append(("prove", reason))
            return
        for pair in answer["pairs"]:
            self.numbers += 1
            if pair["verdict"] in ("different", "not equal"):
                self.wrong.append(f"prove: {pair['left']} and {pair['right']} are said to differ")
        self.eq.i.expressions = {**self.eq.i.expressions, **answer["names"]}
        for integral in answer["integrals"]:
            if integral["verdict"] != "proved":
                continue
            self.numbers += 1
            try:
                number = evaluate(integral["expression"], self.eq.i.velocity)
            except Unknown:
                continue        # a parameter that the program made of a number with a unit
            if not hasattr(number, "g"):
                self.wrong.append(f"first integral {integral['name']} is a constant")
                continue
            rates = np.concatenate([self.eq.i.rates, self.eq.accelerations])
            size = float(np.abs(number.g) @ np.abs(rates)) + float(abs(number.v))
            rate = float(number.g @ rates)
            if not abs(rate) <= 1e2 * self.tolerance * (size + 1e-12):
                self.wrong.append(f"first integral {integral['name']} has the rate {rate!r} of {size!r}")


class Stopped(Exception):
    """A panic or a time-out."""
    def __init__(self, outcome, reason):
        super().__init__(reason)
        self.outcome, self.reason = outcome, reason


def write(path, text):
    with open(path, "w") as file:
        file.write(text)


def judge(random, program, folder, hostile):
    """One case of the kind."""
    try:
        case = Case(random, hostile)
    except (ZeroDivisionError, FloatingPointError, np.linalg.LinAlgError):
        return Outcome("unjudged", "the oracle has no start")
    if case.q is None:
        write(os.path.join(folder, "model.toml"), case.text)
        return Outcome("unjudged", "the loops of the random start do not close")
    return verdict(case, program, folder)


def verdict(case, program, folder):
    try:
        judge = Judge(case, program, folder)
    except (np.linalg.LinAlgError, FloatingPointError, ZeroDivisionError):
        return Outcome("unjudged", "the oracle's equations are singular")
    eq = judge.eq
    if not np.isfinite(eq.accelerations).all() or not eq.condition < WORST_CONDITION:
        judge.tolerance = np.inf
    elif eq.smallest < NEAR_SINGULAR or eq.gap > 1e-12 or eq.unmet > 1e-9:
        judge.tolerance = np.inf
    try:
        judge.judge()
    except Stopped as stop:
        return Outcome(stop.outcome, stop.reason, judge.numbers)
    kane = [reason for by, reason in judge.refusals if by == "kane"]
    if kane:
        return Outcome("refused", kane[0])
    if judge.tolerance == np.inf:
        return Outcome("unjudged", "near a singular pose of the oracle", judge.numbers)
    if judge.wrong:
        return Outcome("wrong", "; ".join(judge.wrong[:4]), judge.numbers)
    partly = [f"{by}: {reason}" for by, reason in judge.refusals]
    return Outcome("right", "; ".join(partly[:1]), judge.numbers)
