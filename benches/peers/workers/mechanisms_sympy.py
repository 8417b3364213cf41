"""Mechanisms of model files by SymPy's KanesMethod with its configuration and velocity constraints, `mechanisms_sympy.py SECONDS FOLDER`: a worker
of run.py.

Frames, points, bodies and forces as its handbook makes them; speeds are the rates of the coordinates, those independent that the file says.
What takes longer than so many seconds is given up, and answered by NaN.
"""

import math
import signal
import sys
import time
from pathlib import Path

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from derivation_counts import counted
from model_tables import Tables, component, value


class Late(Exception):
    """It took too long."""


class Mechanism:
    def __init__(self, path):
        self.tables = tables = Tables(path)
        self.q = [me.dynamicsymbols(name) for name in tables.coordinates]
        self.u = [me.dynamicsymbols(f"u_{name}") for name in tables.coordinates]
        self.p = [sm.Symbol(f"p_{name}") for name in tables.parameters]
        self.rates = {x.diff(): u for x, u in zip(self.q, self.u)}
        names = dict(zip(tables.parameters, self.p)) | dict(zip(tables.coordinates, self.q))
        self.names = names | {"sin": sm.sin, "cos": sm.cos, "sqrt": sm.sqrt, "pi": sm.pi}
        self.ground, self.origin = me.ReferenceFrame(tables.ground), me.Point(tables.origin)
        self.origin.set_vel(self.ground, 0)
        self.frames, self.points = {tables.ground: self.ground}, {tables.origin: self.origin}
        for name, (parent, axis, formula) in tables.frames.items():
            self.turn(name, self.frames[parent], axis, sm.sympify(self.value(formula)))
        waiting = dict(tables.points)
        while waiting:
            for name in [name for name, (base, *_) in waiting.items() if base in self.points]:
                self.place(name, *waiting.pop(name))

    def value(self, formula):
        return value(formula, self.names)

    def turn(self, name, parent, axis, angle):
        frame = self.frames[name] = me.ReferenceFrame(name)
        along = axes(parent)[axis - 1]
        frame.orient_axis(parent, along, angle)
        frame.set_ang_vel(parent, me.msubs(angle.diff(me.dynamicsymbols._t), self.rates) * along)

    def place(self, name, base, frame, position):
        frame, base = self.frames[frame], self.points[base]
        arm = self.vector(position, frame)
        point = self.points[name] = base.locatenew(name, arm)
        if arm.free_dynamicsymbols(frame):
            moved = me.msubs(arm.dt(frame), self.rates)
            point.set_vel(self.ground, base.vel(self.ground) + frame.ang_vel_in(self.ground).cross(arm) + moved)
        else:
            point.v2pt_theory(base, self.ground, frame)

    def vector(self, components, frame):
        return sum((self.value(x) * axis for x, axis in zip(components, axes(frame))), me.Vector(0))

    def parts(self):
        for name, (frame, centre, mass, basis, entries) in self.tables.bodies.items():
            inertia = me.inertia(self.frames[basis], *map(self.value, entries))
            centre = self.points[centre]
            yield me.RigidBody(name, centre, self.frames[frame], self.value(mass), (inertia, centre))

    def loads(self, bodies):
        g = self.vector(self.tables.gravity, self.ground)
        loads = [(body.masscenter, body.mass * g) for body in bodies if g != 0]
        for on, moment in self.tables.torques:
            loads.append((self.frames[self.tables.bodies[on][0]], self.vector(moment, self.ground)))
        for one in self.tables.springs:
            at, to = self.points[one["at"]], self.points[one["against_at"]]
            arm = at.pos_from(to)
            length = arm.magnitude()
            loads.append((at, -self.value(one["stiffness"]) * (length - self.value(one["free_length"])) / length * arm))
        return loads

    def loops(self):
        found = []
        for left, right in self.tables.equations:
            if at := component(left):
                found.append(self.points[at[0]].pos_from(self.origin).dot(axes(self.ground)[at[1]]) - self.value(right.strip()))
            else:
                found.append(self.value(left.strip()) - self.value(right.strip()))
        for one, other in self.tables.closed:
            apart = self.points[one].pos_from(self.points[other])
            found += [apart.dot(axis) for axis in axes(self.ground)[:2]]
        return found

    def slips(self):
        found = []
        for name, at, frame in self.tables.rolling:
            home, centre, *_ = self.tables.bodies[name]
            centre, turning = self.points[centre], self.frames[home].ang_vel_in(self.ground)
            slip = centre.vel(self.ground) + turning.cross(self.points[at].pos_from(centre))
            found += [slip.dot(axis) for axis in axes(self.frames[frame])[:2]]
        return found

    def kane(self):
        loops, free = self.loops(), self.tables.independent
        moving = [me.msubs(x.diff(me.dynamicsymbols._t), self.rates) for x in loops] + self.slips()
        chosen = lambda symbols, wanted: [x for x, name in zip(symbols, self.tables.coordinates) if (name in free) == wanted]
        # As many coordinates depend on the others as loops are closed, of those whose speeds depend.
        tied = [x for x, u in zip(self.q, self.u) if u in chosen(self.u, False)][: len(loops)]
        more = {}
        if loops:
            more = {"q_dependent": tied, "configuration_constraints": loops}
        if moving:
            more |= {"u_dependent": chosen(self.u, False), "velocity_constraints": moving}
        definitions = [u - rate for rate, u in self.rates.items()]
        q_ind = [x for x in self.q if x not in more.get("q_dependent", [])]
        method = me.KanesMethod(self.ground, q_ind=q_ind, u_ind=chosen(self.u, True), kd_eqs=definitions, **more)
        bodies = list(self.parts())
        method.kanes_equations(bodies, self.loads(bodies))
        return method, method.mass_matrix, method.forcing


def axes(frame):
    return frame.x, frame.y, frame.z


def accelerations(m, method, M, f, state):
    """q'', in the order of the file."""
    symbols = [*m.q, *m.u, *m.p]
    rates = {x: u for x, u in m.rates.items()}
    entries = sm.lambdify(symbols, [me.msubs(M, rates), me.msubs(f, rates)], cse=True)
    M, f = (np.array(x, float) for x in entries(*state))
    found = dict(zip(method.u, np.linalg.solve(M, f).ravel()))
    return [found[u] for u in m.u]


def within(seconds, work):
    """What `work` gives; None if it takes longer."""

    def stop(*_):
        raise Late

    signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        return work()
    except Late:
        return None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def made(path):
    m = Mechanism(path)
    return m, *m.kane()


def main():
    limit, folder = float(sys.argv[1]), Path(sys.argv[2])
    for line in sys.stdin:
        match line.split():
            case ["derive", problem, _]:
                sm.core.cache.clear_cache()
                begin = time.perf_counter()
                derived = within(limit, lambda: made(folder / problem / "model.toml"))
                answer = [time.perf_counter() - begin if derived else math.nan]
            case ["count"]:
                m, _, M, f = derived
                answer = within(limit, lambda: counted(sm, M.tolist(), list(f), symmetric=not m.tables.closes)) or [math.nan] * 2
            case ["solve"]:
                p, y = [[float(x) for x in line.split()] for line in (folder / problem / "states").open()][:2]
                answer = accelerations(*derived, [*y, *p])
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(repr(float(x)) for x in answer), flush=True)


main()
