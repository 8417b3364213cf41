"""Reactions between bodies that joints connect, from the Newton–Euler equations of all bodies at once."""
import numpy as np
from mechanism import Unknown
from oracle import inertia


class Reactions:
    """Forces and torques of the joints at a solved state; `None` where equilibrium does not determine one."""
    def __init__(self, eq):
        i, self.eq = eq.i, eq
        self.i, self.bodies = i, list(i.m.bodies)
        rows = {name: 6 * k for k, name in enumerate(self.bodies)}
        right = np.zeros(6 * len(self.bodies))
        for name in self.bodies:
            force, moment = self.missing(name)
            right[rows[name]:rows[name] + 3], right[rows[name] + 3:rows[name] + 6] = force, moment
        columns, self.meaning = [], []
        for joint in i.m.joints.values():
            place = (i.place_on(joint.body, joint.entry.get("body_at")) if joint.closes else i.joint_point(joint)).v
            for wrench in self.transmitted(joint, place):
                column = np.zeros(len(right))
                for name, sign in ((joint.body, 1.0), (joint.to, -1.0)):
                    if name:
                        arm = place - i.centre(name).v
                        column[rows[name]:rows[name] + 3] += sign * wrench[:3]
                        column[rows[name] + 3:rows[name] + 6] += sign * (wrench[3:] + np.cross(arm, wrench[:3]))
                columns.append(column)
                self.meaning.append((joint, wrench))
        self.matrix = np.array(columns).T.reshape(len(right), len(columns))
        self.values, _, rank, _ = np.linalg.lstsq(self.matrix, right, rcond=1e-11)
        u, s, vt = np.linalg.svd(self.matrix)
        self.idle = vt[int((s > 1e-10 * s.max(initial=1e-300)).sum()):]
        self.open = np.abs(self.matrix @ self.values - right).max(initial=0)
        self.scale = np.abs(right).max(initial=0) + np.abs(self.values).max(initial=0)

    def missing(self, name):
        """What the joints must transmit to a body: m a − forces, and dH/dt − moments about its mass centre."""
        i, eq, n = self.i, self.eq, self.i.n
        body, centre = i.m.bodies[name], i.centre(name).v
        motion, turning = i.moving(i.m.centre_of(name)), i.turning(i.m.frame_of(name))
        tensor, w = inertia(i, name, body), turning.value
        if "added_mass" in body:
            raise Unknown("reactions with added mass")
        force = float(i.constant(body.get("mass", 0))) * (motion.jacobian[:, :n] @ eq.accelerations + motion.bias)
        moment = tensor @ (turning.jacobian[:, :n] @ eq.accelerations + turning.bias) + np.cross(w, tensor @ w)
        for load in eq.wrenches:
            if load.on == name and load.force is not None:
                force = force - load.force
                moment = moment - np.cross(load.place - centre, load.force)
            elif load.on in (name, i.m.frame_of(name)):
                moment = moment - load.torque
        return force, moment

    def transmitted(self, joint, place):
        """Wrenches at a place that do no work in the motions that a joint permits: rows of six."""
        if joint.closes:
            return self.transmitted_closing(joint)
        i = self.i
        moves = i.material_jacobian(joint.body, place)
        turns = i.turning(i.m.frame_of(joint.body)).jacobian
        index = [i.m.coordinates.index(c) for c in joint.coordinates]
        twists = np.concatenate([moves[:, index], turns[:, index]]).T
        if not len(index):
            return np.eye(6)
        _, s, vt = np.linalg.svd(twists)
        return vt[int((s > 1e-12 * s[0]).sum()):]

    def transmitted_closing(self, joint):
        axes = self.i.joint_axes(joint).v
        own = self.i.joint_axes(joint, "body_turned", joint.body).v
        kind, permitted = joint.kind, []
        if kind == "ball":
            permitted = [np.r_[0, 0, 0, e] for e in np.eye(3)]
        elif kind == "universal":
            first, second = joint.entry.get("axes", [1, 2])
            permitted = [np.r_[0, 0, 0, axes[:, first - 1]], np.r_[0, 0, 0, own[:, second - 1]]]
        elif kind == "planar":
            e = np.delete(np.arange(3), joint.axis - 1)
            permitted = [np.r_[0, 0, 0, axes[:, joint.axis - 1]], *(np.r_[axes[:, k], 0, 0, 0] for k in e)]
        else:
            if kind in ("pin", "cylinder"):
                permitted.append(np.r_[0, 0, 0, axes[:, joint.axis - 1]])
            if kind in ("slider", "cylinder"):
                permitted.append(np.r_[axes[:, joint.axis - 1], 0, 0, 0])
        _, s, vt = np.linalg.svd(np.array(permitted).reshape(-1, 6))
        return vt[int((s > 1e-12).sum()):]

    def component(self, kind, giver, taker, axis):
        """Component along an inertial axis of the force or torque of a joint; torque about the joint's point."""
        row = np.zeros(len(self.meaning))
        for k, (joint, wrench) in enumerate(self.meaning):
            ends = (joint.to, joint.body)
            if ends == (giver, taker) or ends == (taker, giver):
                sign = 1.0 if taker == joint.body else -1.0
                row[k] = sign * wrench[axis if kind == "force" else axis + 3]
        if self.open > 1e-7 * (1 + self.scale) or np.abs(self.idle @ row).max(initial=0) > 1e-9:
            return None
        return float(row @ self.values)
