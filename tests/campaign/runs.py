"""Kind `runs`: scenes of random mechanisms against the oracle's motion, and contacts against closed forms."""
import os
import numpy as np
import impacts
import trees, loops, rollers
from draft import toml
from formula import evaluate
from makers import Case, state_text
from mechanisms import Stopped, write
from motion import Lost, Motion
from oracle import closed, permitted
from reactions import Reactions
from verdict import Outcome

# A stated error is an estimate by a second run. An answer is wrong if its error exceeds FACTOR times the stated one (a
# digit too many), plus the oracle's own error, plus the rounding of the printed number. From CLOSE times on, the case
# is right and named among the reasons.
FACTOR, CLOSE, ROUNDING = 10.0, 3.0, 1e-13
MAKERS = [(trees.joint_tree, 6), (trees.placed_tree, 4), (loops.plane_loop, 2), (loops.stated_loop, 1),
          (loops.space_loop, 1), (rollers.disc, 1), (rollers.ball, 1), (rollers.sleigh, 1), (rollers.tied, 2)]
CONTACTS = 0.2


class Run:
    """A scene of a case, what the program says of it, and the oracle's motion."""
    def __init__(self, random, case, folder):
        self.random, self.case = random, case
        length = round(random.choice([0.2, 0.5, 1.0, 1.5]) * random.uniform(0.6, 1.2), 2)
        begin = random.choice([0.0, 0.0, 0.0, 1.3, -0.7])
        self.span = (begin, round(begin + length * (-1 if random.random() < 0.12 else 1), 2))
        self.settings_of_scene()
        self.path = os.path.join(folder, "scene.toml")
        self.outputs, self.truths = [], {}
        self.shown()
        r = random
        self.method = r.choice(["ode45", "ode45", "dopri5", "dop853", "dop853", "taylor", "gauss6", "radau5"])
        self.rtol = r.choice([1e-3, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12])
        settings = [f'method = "{self.method}"', f"rtol = {self.rtol}",
                    f"atol = {self.rtol * r.choice([1, 1e-2, 1e-3])}"]
        if r.random() < 0.15:
            self.method = r.choice(["rk4", "gauss6", "dop853"])
            settings = [f'method = "{self.method}"', f"step = {r.choice([0.02, 0.01, 0.005])}"]
        self.event = r.choice([*case.mechanism.coordinates, None, None])
        lines = ['model = "model.toml"', f"span = [{self.span[0]}, {self.span[1]}]", f"outputs = {self.listed()}",
                 *(line for name, table in (("parameters", self.given), ("inputs", self.inputs)) if table
                   for line in (f"[{name}]", *(f"{k} = {toml(v)}" for k, v in table.items()))),
                 state_text(case.q, case.rates, "start"), "[integration]", *settings]
        if self.event:
            lines += ["[[events]]", 'name = "crossing"', f'zero = "{self.event}"']
        write(os.path.join(folder, "model.toml"), case.text)
        write(self.path, "\n".join(lines) + "\n")

    def settings_of_scene(self):
        """Other values of masses, stiffnesses and inputs than the model's, and a start at the first instant."""
        r, d, m = self.random, self.case.draft, self.case.mechanism
        self.given, self.inputs = {}, {}
        for name in d.sections["parameters"]:
            if name[0] in "mkg" and name[1].isdigit() and r.random() < 0.1:
                self.given[name] = round(m.values()[name] * r.uniform(0.6, 1.5), 3) or 1.0
        for name in d.sections["inputs"]:
            if r.random() < 0.5:
                self.inputs[name] = r.choice([1.5, "2*sin(3*t)", "1 - t", "exp(-t)", "0.3*t^2"])
        self.parameters = m.values(self.given)
        if self.span[0]:
            q = closed(m, self.case.q, self.span[0], self.parameters)
            if q is None:
                raise Lost("no start at the first instant")
            self.case.q = q
            self.case.rates = permitted(m, q, self.case.rates, self.span[0], self.parameters)

    def derivative(self):
        """The option for derivatives with respect to a parameter that changes no geometry, in small models."""
        r, d = self.random, self.case.draft
        names = [n for n in d.sections["parameters"] if n[0] in "mkgIJTf" and n[1].isdigit()]
        self.varied = r.choice(names) if names and len(self.case.q) <= 4 and r.random() < 0.25 else None
        return ["--sensitivity", self.varied] if self.varied else []

    def listed(self):
        return "[" + ", ".join(f'"{o}"' if isinstance(o, str) else
                               f'{{ name = "{o[0]}", value = "{o[1]}" }}' for o in self.outputs) + "]"

    def shown(self):
        """Random outputs, each with the oracle's function of a solved state."""
        r, m, d = self.random, self.case.mechanism, self.case.draft
        every = [*m.coordinates, *m.speeds]
        chosen = every if r.random() < 0.5 else r.sample(every, r.randint(1, len(every)))
        for name in chosen:
            self.show(name, lambda eq, name=name: number(eq, name))
        if r.random() < 0.5:
            self.show("kinetic_energy", lambda eq: eq.kinetic)
        points = [*m.data.get("points", {}), *(m.centre_of(b) for b in m.bodies)]
        for k in range(r.choice([0, 1, 1, 2])):
            point = r.choice(points)
            frame = r.choice(["N", *(m.frame_of(b) for b in m.bodies)])
            axis = r.choice([1, 2, 3])
            form = r.choice([f"p({point}) @ N [{axis}]", f"v({point}) @ {frame} [{axis}]"])
            if m.bodies and r.random() < 0.4:
                form = f"omega({r.choice(list(m.bodies))}) @ {frame} [{axis}]"
            self.outputs.append((f"out{k}", form))
            self.truths[f"out{k}"] = lambda eq, form=form: number(eq, form)
        if m.joints and not d.sections["potentials"] and not d.sections["constraints"] and not d.sections["rolling"] \
                and not d.sections["particles"] and "added mass" not in d.tags and r.random() < 0.5:
            joint, axis = r.choice([j for j in m.joints.values() if j.kind != "free"] or [None]), r.randrange(3)
            if joint is None:
                return
            kind, giver = r.choice(["force", "force", "torque"]), joint.to
            name = f"{kind}({giver or 'ground'} on {joint.body}) @ N [{axis + 1}]"
            self.show(name, lambda eq: Reactions(eq).component(kind, giver, joint.body, axis))

    def show(self, name, truth):
        if name not in self.outputs:
            self.outputs.append(name)
            self.truths[name] = truth


class Mistakes(list):
    """Wrong numbers of a run, and how many stated errors are too small by CLOSE to FACTOR."""
    optimistic = 0


def number(eq, form):
    value = evaluate(form, eq.i.velocity)
    return float(value.v) if hasattr(value, "v") else float(value)


def ask(program, scene, *more):
    """The JSON of a run, or an outcome without one."""
    answer = program("simulate", scene, "--json", *more)
    if answer.panicked:
        raise Stopped("panic", answer.reason)
    if answer.expired:
        raise Stopped("time-out", "simulate")
    if not isinstance(answer.json, dict) or "error" in answer.json:
        raise Stopped("refused", answer.reason)
    if answer.json.get("failure") or answer.status == 3:
        failure = answer.json.get("failure")
        code = failure.get("code", failure) if isinstance(failure, dict) else failure
        raise Stopped("refused", f"the run stopped: {code or answer.json['stop']}")
    # Errors that are not assessed are null.
    answer.json["uncertainty"] = answer.json["uncertainty"] or {}
    answer.json["sensitivity_uncertainty"] = answer.json.get("sensitivity_uncertainty") or {}
    return answer.json


def compare(wrong, what, printed, stated, truth, oracle_error, scale=0.0):
    """One number of a run against the truth; whether its error is stated."""
    if printed is None or stated is None:
        return False
    own = oracle_error + ROUNDING * (abs(truth) + scale)
    error = abs(printed - truth)
    if CLOSE * stated + own < error <= FACTOR * stated + own:
        wrong.optimistic += 1
    if not error <= FACTOR * stated + own:
        wrong.append(f"{what}: printed {printed!r} with the error {stated:.2g}, right {truth!r}")
    return True


def judge(random, program, folder, hostile):
    """One case of the kind."""
    try:
        if random.random() < CONTACTS:
            return impacts.judge(random, program, folder, ask, compare, Mistakes())
        case = Case(random, hostile, MAKERS)
        if case.q is None:
            return Outcome("unjudged", "the loops of the random start do not close")
        run = Run(random, case, folder)
        more = run.derivative()
        if random.random() < 0.5:
            more += ["--by", random.choice(["kane", "lagrange", "newton-euler"])]
        return verdict(run, ask(program, run.path, *more), program)
    except Stopped as stop:
        return Outcome(stop.outcome, stop.reason)
    except Lost as lost:
        return Outcome("unjudged", f"the oracle lost the motion: {lost}")
    except (np.linalg.LinAlgError, ZeroDivisionError, FloatingPointError):
        return Outcome("unjudged", "the oracle's equations are singular")


def verdict(run, answer, program):
    case, wrong, numbers, open_ = run.case, Mistakes(), 0, []
    motion = Motion(case.mechanism, case.q, case.rates, run.span, parameters=run.parameters, inputs=run.inputs)
    for name, truth in run.truths.items():
        value = truth(motion.end)
        if value is None:
            continue
        printed = answer["state"].get(name)
        numbers += 1
        if not compare(wrong, name, printed, answer["uncertainty"].get(name), value, motion.spread(truth),
                       1.0 + abs(motion.end.kinetic)):
            open_.append(name)
    numbers += energies(run, answer, motion, program, wrong)
    numbers += events(run, answer, motion, wrong)
    numbers += derivatives(run, answer, motion, wrong)
    if wrong and answer["warnings"]:
        return Outcome("right", "outside its stated error, with a warning", numbers)
    if wrong:
        how = f"{answer['formulation']}, {run.method}, rtol {run.rtol}"
        return Outcome("wrong", f"{how}: " + "; ".join(wrong[:3]), numbers)
    if open_:
        return Outcome("undecided", "no error is stated", numbers)
    if wrong.optimistic:
        return Outcome("right", "a stated error is too small by a factor of 3 to 10", numbers)
    return Outcome("right", "", numbers)


def derivatives(run, answer, motion, wrong):
    """Derivatives with respect to a parameter, by differences of the oracle's motions."""
    given = (answer.get("sensitivity") or {}).get(run.varied)
    if not run.varied or not given:
        return 0
    step, ends = 1e-3 * abs(run.parameters[run.varied]) + 1e-6, []
    for k in (1, -1):
        # Formulas of other parameters do not contain this one: all values of random models are numbers.
        parameters = run.case.mechanism.values({**run.given, run.varied: run.parameters[run.varied] + k * step})
        ends.append(Motion(run.case.mechanism, run.case.q, run.case.rates, run.span, parameters=parameters,
                           inputs=run.inputs, checked=False).end)
    numbers = 0
    for name, truth in run.truths.items():
        values = [truth(end) for end in ends]
        if given.get(name) is None or None in values:
            continue
        numbers += 1
        slope, here = (values[0] - values[1]) / (2 * step), truth(motion.end)
        bend = abs(values[0] + values[1] - 2 * here) / step
        stated = (answer["sensitivity_uncertainty"].get(run.varied) or {}).get(name)
        compare(wrong, f"derivative of {name} with respect to {run.varied}", given[name], stated, slope,
                0.02 * bend + 1e-4 * abs(slope) + 1e-7 / step * (1e-3 + abs(here)))
    return numbers


def energies(run, answer, motion, program, wrong):
    """The work of a run: the change of T of the oracle's motion and of the program's V at the oracle's states.

    A run that does not watch the work has no drift of the energy, and is not judged.
    """
    if answer["drift"]["energy"] is None or run.case.tags & {"drive", "time"} or run.given:
        return 0
    if not (answer["digits"] or 0) > 4:
        return 0
    case, energy = run.case, []
    for q, rates, kinetic in ((case.q, case.rates, motion.at(run.span[0]).kinetic),
                              (motion.q, motion.rates, motion.end.kinetic)):
        path = run.path.replace("scene.toml", "state.toml")
        write(path, state_text(q, rates))
        model = run.path.replace("scene.toml", "model.toml")
        there = program("evaluate", model, "--by", "kane", "--at", path, "--json")
        if not there.json or there.json.get("potential_energy") is None:
            return 0
        energy.append((kinetic, there.json["potential_energy"]))
    work = sum(energy[1]) - sum(energy[0])
    if abs(answer["work"] - work) > 1e-3 * (sum(map(abs, energy[0] + energy[1])) + abs(work)) + 1e-9:
        wrong.append(f"work: printed {answer['work']!r}, right {work!r}")
    return 1


def events(run, answer, motion, wrong):
    """Every crossing is found, at its instant."""
    if not run.event:
        return 0
    k = motion.names.index(run.event)
    roots = motion.crossings(lambda t: motion.fine.sol(min(max(t, min(run.span)), max(run.span)))[k], run.span)
    if roots is None or any(abs(s) < 1e-2 for _, s in roots) or run.rtol > 1e-5 or run.method == "rk4":
        return 0
    printed = [e for e in answer["events"] if e["name"] == "crossing" and e["kind"] in ("rising", "falling")]
    if len(printed) != len(roots):
        wrong.append(f"{len(printed)} crossings of {run.event} are printed, {len(roots)} are right")
        return 1
    for event, (t, slope) in zip(printed, roots):
        compare(wrong, f"instant of {run.event} = 0", event["t"], event["uncertainty"], t, 1e-9 / min(1, abs(slope)))
        if (event["kind"] == "rising") != (slope * (run.span[1] - run.span[0]) > 0):
            wrong.append(f"{run.event} = 0 at {t!r} is printed as {event['kind']}")
    return len(roots)
