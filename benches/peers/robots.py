#!/usr/bin/env python3
"""Compares ten robots with Pinocchio and MuJoCo: what an import keeps, whether the equations agree, and what a call costs.

    pip install numpy==2.4.6 pin==4.1.0 mujoco==4.0.0
    pip install --no-deps --target headers -r benches/peers/headers.txt
    python3 benches/peers/robots.py target/release/tripos --headers headers/cmeel.prefix/include [--rounds 31] [--only ur_like,delta]

The descriptions are those of tests/data/robots. Writes the tables to standard output and to benches/peers/results/robots.md.

- Agreement: the mass matrix, the bias force and the force of gravity of the tree (the robot without its loops) at random states, as
  functions in Python that `tripos emit` writes, beside Pinocchio's and MuJoCo's own reading of the same file. The largest difference
  of an entry, divided by the largest entry.
- With loops: the accelerations of the closed robot at random states, beside those of Lagrange's multipliers with MuJoCo's mass matrix,
  bias and constraint Jacobian. The derivative of the Jacobian is a difference quotient: 1e-8 is its error.
- Times are those of the processor, so that other programs count less. `derive` is the time of `tripos evaluate` to the mass matrix,
  the forcing and their values at one state; `write C` that of `tripos emit` of accelerations, inverse dynamics and rates.
- Times of a call: emitted C compiled with `cc -O3 -march=native`, and Pinocchio's `rnea` and `aba` in a loop in C++ compiled with
  `c++ -O3 -march=native -DNDEBUG`, at 128 states in turn, interleaved, medians. Pinocchio computes the tree: its loops and its mimic
  joints are open. Tripos computes the closed robot with its losses and drives, in as few speeds as it has freedoms.
"""

import argparse
import importlib
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin

import build
from measure import Peer, interleaved, repeats
from tables import duration, table

ROBOTS = {
    "ur_like.urdf": "arm like a UR",
    "panda_like.urdf": "arm like a Panda, gripper",
    "scara.urdf": "SCARA",
    "leg_fourbar.xml": "humanoid leg, four-bar",
    "delta.xml": "Delta",
    "stewart.xml": "Stewart platform",
    "cassie_leg.xml": "leg like Cassie's",
    "hexapod.urdf": "hexapod",
    "double_wishbone.xml": "car, double wishbones",
    "hand.urdf": "hand, mimic joints",
}
FLOATING = {"hexapod.urdf"}
DATA = build.ROOT / "tests/data/robots"
STATES, COMPARED = 128, 10
CLOSED = ("equality",)
OTHER = ("tendon", "sensor", "actuator", "keyframe")


def main():
    arguments = asked()
    with tempfile.TemporaryDirectory() as place:
        rows = [Robot(name, Path(place), arguments).row() for name in arguments.only]
    text = "\n".join(report(rows, arguments)) + "\n"
    print(text)
    if arguments.only == list(ROBOTS):
        (build.HERE / "results/robots.md").write_text(text)


def asked():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tripos", type=Path, help="the command, built with --release")
    parser.add_argument("--headers", type=Path, help="folder of the headers of Pinocchio, Boost and Eigen")
    parser.add_argument("--rounds", type=int, default=31, help="samples of each time")
    names = lambda text: [next(name for name in ROBOTS if name.startswith(word)) for word in text.split(",")]
    parser.add_argument("--only", type=names, default=list(ROBOTS), help="some of the robots")
    arguments = parser.parse_args()
    arguments.tripos = arguments.tripos.resolve()
    return arguments


def without(text, names):
    return re.sub(rf"<({'|'.join(names)})>.*?</\1>", "", text, flags=re.S)


def named(joint):
    return re.sub(r"[^A-Za-z0-9]", "_", joint)


class Robot:
    """A robot with what is measured of it."""

    def __init__(self, name, place, arguments):
        self.name, self.stem = name, Path(name).stem
        self.place, self.arguments = place / self.stem, arguments
        self.place.mkdir()
        self.text = (DATA / name).read_text()
        self.is_mjcf = name.endswith(".xml")
        build.say(name)

    def tripos(self, *words):
        """Standard output of the command, and its time of the processor, s."""
        used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
        begin = used()
        words = [str(self.arguments.tripos), *map(str, words)]
        done = subprocess.run(words, cwd=self.place, capture_output=True, text=True)
        if done.returncode:
            raise SystemExit(f"{' '.join(words)}\n{done.stdout}{done.stderr}")
        return done.stdout, used() - begin

    def best_time(self, *words):
        """Shortest time of up to three calls of the command, s; one call if it takes more than 5 s."""
        build.say(f"{self.stem}: {words[0]}")
        times = [self.tripos(*words)[1]]
        while len(times) < 3 and sum(times) < 5:
            times.append(self.tripos(*words)[1])
        return min(times)

    def imported(self, folder, text, *more):
        (self.place / f"{folder}{Path(self.name).suffix}").write_text(text)
        floating = ["--floating"] if self.name in FLOATING else []
        return self.tripos("new", folder, "--from", f"{folder}{Path(self.name).suffix}", *floating, *more)[0]

    def python(self, folder, functions):
        """The module of emitted Python functions of a model."""
        build.say(f"{self.stem}: functions of {folder} in Python")
        out = self.place / f"{folder}_python"
        model = f"{folder}/model.toml"
        self.tripos("emit", model, "--language", "python", "--formulation", "kane", "--functions", functions, "--out", out)
        sys.path.insert(0, str(out))
        try:
            module = importlib.import_module(next(out.glob("*_kane.py")).stem)
        finally:
            sys.path.pop(0)
        for known in ("tripos_arrays", module.__name__):
            sys.modules.pop(known, None)
        return module

    def row(self):
        answer = self.imported("robot", self.text)
        omissions = [line for line in answer.splitlines() if line.startswith("left out")]
        left_out = sum(int((re.search(r"\((\d+) times\)$", line) or [0, 1])[1]) for line in omissions)
        model = (self.place / "robot/model.toml").read_text()
        tree = self.imported("tree", without(self.text, [*CLOSED, *OTHER]), "--as-written") and self.python("tree", "mass_matrix,forcing")
        closing = len(re.findall(r"body_at = ", model))
        bodies = PinTree(self)
        row = {
            "name": self.name,
            "joints": bodies.moving,
            "loops": closing,
            "couplings": len(re.findall(r"^\w+_follows = ", model, re.M)),
            "left_out": left_out,
            "pin": self.agreement(tree, bodies.equations),
            "mujoco": self.agreement(tree, MujocoTree(self).equations),
        }
        functions = "accelerations,inverse_dynamics,coordinate_rates"
        out = self.place / "c"
        emit = ["emit", "robot/model.toml", "--language", "c", "--formulation", "kane", "--functions", functions, "--out", out]
        row["emit"] = self.best_time(*emit)
        header = next(out.glob("*_kane.h"))
        for key, function in (("forward", "accelerations"), ("inverse", "inverse_dynamics")):
            found = re.search(rf"// ([^\n]*operations[^\n]*)\n(?://[^\n]*\n)*void \w+_{function}\(", header.read_text())
            row[f"{key} count"] = self.counts(found[1])
        closed = self.python("robot", f"{functions},constraints,constraint_slopes" if closing else functions)
        row["freedoms"] = len(closed.VARIABLES)
        states = self.states(closed, closing)
        row["derive"] = self.derivation_time(closed, states[0])
        if closing:
            row["closed"] = self.closed_agreement(closed)
        row |= self.times(header, states, bodies)
        return row

    @staticmethod
    def counts(text):
        """Operations, and sines, cosines and other functions."""
        numbers = [int(word) for word in re.findall(r"(\d+) (?:operation|sine|other)", text)]
        return f"{numbers[0]} + {sum(numbers[1:])}"

    @staticmethod
    def values(module, off=()):
        """Default values of the parameters; inputs, and parameters whose names begin with one of `off`, are 0."""
        is_off = [name.startswith(off) or name in module.INPUTS for name in module.PARAMETERS]
        return np.where(is_off, 0.0, np.array(module.DEFAULTS, float))

    def agreement(self, module, equations):
        """Largest relative differences of the mass matrix, the bias and the gravity force at random states."""
        # Neither program counts losses and springs among these.
        p = self.values(module, ("c_", "f_", "k_"))
        random, worst = np.random.default_rng(11), np.zeros(3)
        for _ in range(COMPARED):
            q, u, theirs = equations(random, module)
            own = [
                np.array(module.mass_matrix(p, q, u)),
                -np.array(module.forcing(p, q, u)),
                -np.array(module.forcing(p, q, 0 * u)),
            ]
            own[0] = own[0] if own[0].ndim == 2 else own[0].reshape(len(u), len(u))
            for at, (mine, other) in enumerate(zip(own, theirs)):
                worst[at] = max(worst[at], np.abs(mine - other).max() / max(np.abs(other).max(), 1e-300))
        return worst

    def states(self, module, closing):
        """Coordinates, speeds and accelerations of speeds at random states, with closed loops."""
        random, p = np.random.default_rng(5), self.values(module)
        n, count = len(module.COORDINATES), len(module.VARIABLES)
        start = {}
        scene = (self.place / "robot/scenes/first.toml").read_text() + (self.place / "robot/model.toml").read_text()
        for found in re.finditer(r"^(q_\w+) = (-?[0-9.e-]+)$", scene, re.M):
            start.setdefault(found[1], float(found[2]))
        middle = np.array([start.get(name, 0.0) for name in module.COORDINATES])
        result = []
        while len(result) < STATES:
            q = middle + random.normal(size=n) * (0.05 if closing else 0.5)
            quaternions(q, module.COORDINATES)
            u = random.normal(size=count)
            for _ in range(50 if closing else 0):
                residual = np.array(module.constraints(p, q, u)).ravel()
                if np.abs(residual).max() < 1e-14:
                    break
                slopes = np.array(module.constraint_slopes(p, q, u)).reshape(len(residual), -1)[:, :n]
                q = q - np.linalg.lstsq(slopes, residual, rcond=1e-9)[0]
                quaternions(q, module.COORDINATES)
            if not closing or np.abs(module.constraints(p, q, u)).max() < 1e-12:
                result.append((q, u, random.normal(size=count)))
        return result

    def closed_agreement(self, module):
        """Largest relative difference of the accelerations with loops from those of Lagrange's multipliers."""
        # MuJoCo's dry friction is a constraint, and is left out on both sides.
        p = self.values(module, ("f_",))
        closed, random, worst = MujocoLoops(self), np.random.default_rng(13), 0.0
        for _ in range(COMPARED):
            coordinates, speeds, rates = closed.state(random)
            q = np.array([coordinates[name] for name in module.COORDINATES])
            u = np.array([speeds[name] for name in module.VARIABLES])
            theirs = np.array([rates[name] for name in module.VARIABLES])
            worst = max(worst, np.abs(np.array(module.accelerations(p, q, u)) - theirs).max() / np.abs(theirs).max())
        return worst

    def derivation_time(self, module, state):
        """Time of the command that derives the mass matrix and the forcing, and evaluates them at one state, s."""
        q, u, _ = state
        values = [*zip(module.COORDINATES, q), *zip(module.VARIABLES, u)]
        (self.place / "state.toml").write_text("[state]\n" + "".join(f"{name} = {float(value)!r}\n" for name, value in values))
        return self.best_time("evaluate", "robot/model.toml", "--by", "kane", "--at", "state.toml", "--json")

    def times(self, header, states, bodies):
        source = header.with_suffix(".c")
        text = header.read_text()
        size = lambda word: re.search(rf"\b{header.stem.upper()}_{word} = (\d+)", text)[1]
        program = self.place / "robots-c"
        defines = [f"-DNAME={header.stem}", f"-DCOORDINATES={size('COORDINATES')}", f"-DSPEEDS={size('VARIABLES')}"]
        defines.append(f"-DPARAMETERS={size('PARAMETERS')}")
        flags = build.C_FLAGS
        build.call([build.compiler(), *flags, *defines, "-c", build.WORKERS / "robots.c", "-o", f"{program}-loops.o"])
        build.say(f"{self.stem}: {source.name}")
        build.call([build.compiler(), *flags, "-w", "-c", source, "-o", f"{program}.o"])
        build.call([build.compiler(), f"{program}-loops.o", f"{program}.o", "-o", program, "-lm"])
        write_rows(self.place / "states", (np.concatenate(state) for state in states))
        peers = {"C": Peer("C", [program, self.place / "states"])}
        worker = pinocchio_worker(self.arguments)
        if worker:
            chain, of_tree = bodies.written(self.place)
            peers["Pinocchio"] = Peer("Pinocchio", [worker, chain, of_tree])
            bodies.must_compute(peers["Pinocchio"])
        askings = {}
        for row, peer in peers.items():
            for work in ("forward", "inverse"):
                passes = repeats(peer.ask(f"{work} 20")[0] * STATES)
                askings[row, work] = lambda peer=peer, work=work, passes=passes: peer.ask(f"{work} {passes}")[0]
        samples = interleaved(askings, self.arguments.rounds)
        for peer in peers.values():
            peer.close()
        return samples


def quaternions(q, names):
    """Gives the length 1 to the Euler parameters among the coordinates: the first four of a ball, the last four of a free body."""
    for last, first in ((7, 4), (4, 1)):
        for name in names:
            stem = name.removesuffix(f"_{last}")
            if stem != name and f"{stem}_{last + 1}" not in names:
                places = [names.index(f"{stem}_{k}") for k in range(first, last + 1)]
                q[places] /= np.linalg.norm(q[places])


class PinTree:
    """The tree of a robot as Pinocchio reads it, in the variables of Tripos."""

    def __init__(self, robot):
        self.robot = robot
        text = without(robot.text, [*CLOSED, *OTHER])
        self.references = {}
        if robot.is_mjcf:
            self.model, self.references = of_mujoco(mujoco.MjModel.from_xml_string(text))
        elif robot.name in FLOATING:
            self.model = pin.buildModelFromXML(text, pin.JointModelFreeFlyer())
        else:
            self.model = pin.buildModelFromXML(text)
        self.data = self.model.createData()
        self.moving = self.model.njoints - 1
        self.mimic = mimics(text)
        root = re.search(r'<robot[^>]*>.*?<link name="([^"]+)"', text, re.S)
        self.names = {"root_joint": named(f"{root[1]}_free")} if root else {}

    def joints(self):
        for name, joint in list(zip(self.model.names, self.model.joints))[1:]:
            yield self.names.get(name, named(name)), name, joint

    def equations(self, random, module):
        """Coordinates and speeds of Tripos at a random state, and Pinocchio's mass matrix, bias and gravity force there."""
        model, data = self.model, self.data
        v = random.normal(size=model.nv)
        q = pin.integrate(model, pin.neutral(model), random.normal(size=model.nv) * 0.5)
        for name, (leader, factor, offset) in self.mimic.items():
            at, of = model.joints[model.getJointId(name)], model.joints[model.getJointId(leader)]
            q[at.idx_q], v[at.idx_v] = factor * q[of.idx_q] + offset, factor * v[of.idx_v]
        coordinates, speeds = {}, {}
        # Pinocchio's v = T u, and T' u.
        columns, drift = {}, np.zeros(model.nv)
        unit = np.eye(model.nv)
        for own, name, joint in self.joints():
            x, i = q[joint.idx_q : joint.idx_q + joint.nq], joint.idx_v
            u = v[i : i + joint.nv]
            if joint.nv == 1:
                angle = x[0] if joint.nq == 1 else np.arctan2(x[1], x[0])
                coordinates[f"q_{own}"] = angle + self.references.get(name, 0.0)
                speeds[f"u_{own}"] = u[0]
                columns.setdefault(f"u_{own}", np.zeros(model.nv))
                if name not in self.mimic:
                    columns[f"u_{own}"] += unit[i]
            elif joint.nv == 3:
                coordinates |= {f"q_{own}_{k + 1}": value for k, value in enumerate([x[3], *x[:3]])}
                speeds |= {f"u_{own}_{k + 1}": value for k, value in enumerate(u)}
                columns |= {f"u_{own}_{k + 1}": unit[i + k] for k in range(3)}
            else:
                turn = pin.Quaternion(x[6], x[3], x[4], x[5]).toRotationMatrix()
                coordinates |= {f"q_{own}_{k + 1}": value for k, value in enumerate([*x[:3], x[6], *x[3:6]])}
                speeds |= {f"u_{own}_{k + 1}": value for k, value in enumerate([*(turn @ u[:3]), *u[3:]])}
                columns |= {f"u_{own}_{k + 1}": unit[:, i : i + 3] @ turn.T[:, k] for k in range(3)}
                columns |= {f"u_{own}_{k + 4}": unit[i + 3 + k] for k in range(3)}
                drift[i : i + 3] = -np.cross(u[3:], u[:3])
        for name, (leader, factor, _) in self.mimic.items():
            columns[f"u_{named(leader)}"] = columns[f"u_{named(leader)}"] + factor * unit[model.joints[model.getJointId(name)].idx_v]
        T = np.array([columns[name] for name in module.VARIABLES]).T
        mass = np.array(pin.crba(model, data, q))
        mass = np.triu(mass) + np.triu(mass, 1).T
        bias = np.array(pin.nonLinearEffects(model, data, q, v))
        gravity = np.array(pin.computeGeneralizedGravity(model, data, q))
        own = (np.array([coordinates[name] for name in module.COORDINATES]), np.array([speeds[name] for name in module.VARIABLES]))
        return *own, (T.T @ mass @ T, T.T @ (bias + mass @ drift), T.T @ gravity)

    def written(self, place):
        """The files of the tree and of states for the worker in C++."""
        model, data = self.model, self.data
        lines = [model.gravity.linear]
        pin.computeJointJacobians(model, data, pin.neutral(model))
        for at in range(1, model.njoints):
            joint, inertia, where = model.joints[at], model.inertias[at], model.jointPlacements[at]
            column = np.array(pin.getJointJacobian(model, data, at, pin.ReferenceFrame.LOCAL))[:, joint.idx_v]
            kind = {6: "F", 3: "S"}.get(joint.nv, "P" if np.abs(column[:3]).max() > 0.5 else "R")
            axis = np.round(column[:3] if kind == "P" else column[3:], 15) if joint.nv == 1 else np.zeros(3)
            I = inertia.inertia
            moments = [I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[1, 2], I[2, 0]]
            numbers = [*axis, *where.translation, *where.rotation.ravel(), inertia.mass, *inertia.lever, *moments]
            lines.append([model.parents[at], kind, *numbers, model.armature[joint.idx_v]])
        random = np.random.default_rng(3)
        self.kept, rows = [], []
        for _ in range(STATES):
            q = pin.integrate(model, pin.neutral(model), random.normal(size=model.nv) * 0.5)
            v, a = random.normal(size=model.nv), random.normal(size=model.nv)
            self.kept.append((q, v, a))
            # A turn is an angle there, also where Pinocchio has its cosine and its sine.
            x = []
            for _, _, joint in self.joints():
                part = q[joint.idx_q : joint.idx_q + joint.nq]
                x += [np.arctan2(part[1], part[0])] if joint.nv == 1 and joint.nq == 2 else list(part)
            rows.append([*x, *v, *a])
        write_rows(place / "chain", lines)
        write_rows(place / "tree_states", rows)
        return place / "chain", place / "tree_states"

    def must_compute(self, peer):
        """The worker computes what Pinocchio computes of its own reading of the file."""
        own = []
        for q, v, a in self.kept[:4]:
            own += [*pin.aba(self.model, self.data, q, v, np.zeros(self.model.nv)), *pin.rnea(self.model, self.data, q, v, a)]
        theirs = peer.ask("values 4")
        if np.abs(np.array(own) - theirs).max() > 1e-8 * np.abs(own).max():
            raise SystemExit(f"{self.robot.name}: the worker in C++ computes other numbers than Pinocchio")


def of_mujoco(compiled):
    """Pinocchio's model of the bodies that MuJoCo compiled, since Pinocchio's own reader of MJCF keeps one body on the ground alone;
    and the reference values of the joints."""
    model, references = pin.Model(), {}
    model.gravity.linear = np.array(compiled.opt.gravity)
    rotation = lambda quaternion: pin.Quaternion(*map(float, quaternion)).toRotationMatrix()
    aligned = {0: (pin.JointModelRX, pin.JointModelRY, pin.JointModelRZ), 1: (pin.JointModelPX, pin.JointModelPY, pin.JointModelPZ)}
    # Joint that moves each body, and the pose of the body's axes in those of the joint.
    places, armatures = {0: (0, pin.SE3.Identity())}, []
    for body in range(1, compiled.nbody):
        joint, pose = places[int(compiled.body_parentid[body])]
        pose = pose * pin.SE3(rotation(compiled.body_quat[body]), np.array(compiled.body_pos[body]))
        first = int(compiled.body_jntadr[body])
        for at in range(first, first + int(compiled.body_jntnum[body])):
            one = compiled.joint(at)
            kind, position = int(one.type[0]), pin.SE3(np.eye(3), np.array(one.pos, float))
            if kind == 0:
                made, pose, position = pin.JointModelFreeFlyer(), pin.SE3.Identity(), pin.SE3.Identity()
            elif kind == 1:
                made = pin.JointModelSpherical()
            else:
                axis, slides = np.array(one.axis, float), kind == 2
                unit = [k for k in range(3) if axis[k] == 1.0]
                oblique = pin.JointModelPrismaticUnaligned if slides else pin.JointModelRevoluteUnaligned
                made = aligned[int(slides)][unit[0]]() if unit else oblique(axis)
                references[one.name] = float(compiled.qpos0[one.qposadr[0]])
            joint = model.addJoint(joint, made, pose * position, one.name)
            pose = position.inverse()
            armatures += [float(compiled.dof_armature[one.dofadr[0]])] * model.joints[joint].nv
        places[body] = (joint, pose)
        turn = rotation(compiled.body_iquat[body])
        tensor = turn @ np.diag(compiled.body_inertia[body]) @ turn.T
        if joint:
            inertia = pin.Inertia(float(compiled.body_mass[body]), np.array(compiled.body_ipos[body]), tensor)
            model.appendBodyToJoint(joint, inertia, pose)
    model.armature = np.array(armatures)
    return model, references


class MujocoTree:
    """The tree of a robot as MuJoCo reads it, in the variables of Tripos."""

    def __init__(self, robot):
        text = without(robot.text, [*CLOSED, *OTHER])
        if not robot.is_mjcf:
            text = re.sub(r"<(visual|collision|transmission|gazebo)\b.*?</\1>", "", text, flags=re.S)
            text = re.sub(r"<mesh[^>]*/>", "", text)
            if robot.name in FLOATING:
                root = re.search(r'<link name="([^"]+)"', text)[1]
                ends = f'<parent link="ground_"/><child link="{root}"/>'
                free = f'<link name="ground_"/><joint name="{root}_free" type="floating">{ends}</joint>'
                text = text.replace("</robot>", f"{free}</robot>")
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        self.mimic = {} if robot.is_mjcf else mimics(text)

    def equations(self, random, module):
        """Coordinates and speeds of Tripos at a random state, and MuJoCo's mass matrix, bias and gravity force there."""
        model, data = self.model, self.data
        data.qpos[:] = model.qpos0
        mujoco.mj_integratePos(model, data.qpos, random.normal(size=model.nv) * 0.5, 1)
        velocity = random.normal(size=model.nv)
        joint = lambda name: model.joint(name)
        for name, (leader, factor, offset) in self.mimic.items():
            at, of = joint(name), joint(leader)
            data.qpos[at.qposadr[0]] = factor * data.qpos[of.qposadr[0]] + offset
            velocity[at.dofadr[0]] = factor * velocity[of.dofadr[0]]
        data.qvel[:] = velocity
        mujoco.mj_forward(model, data)
        mass = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass)
        bias = data.qfrc_bias.copy()
        data.qvel[:] = 0
        mujoco.mj_forward(model, data)
        gravity = data.qfrc_bias.copy()
        coordinates, speeds, columns = {}, {}, {}
        unit = np.eye(model.nv)
        for at in range(model.njnt):
            one = model.joint(at)
            own, count = named(one.name), {0: (7, 6), 1: (4, 3)}.get(int(one.type[0]), (1, 1))
            label = (lambda k: "") if count[0] == 1 else (lambda k: f"_{k + 1}")
            for k in range(count[0]):
                coordinates[f"q_{own}{label(k)}"] = data.qpos[one.qposadr[0] + k]
            for k in range(count[1]):
                speeds[f"u_{own}{label(k)}"] = velocity[one.dofadr[0] + k]
                columns[f"u_{own}{label(k)}"] = unit[one.dofadr[0] + k] if one.name not in self.mimic else 0 * unit[0]
        for name, (leader, factor, _) in self.mimic.items():
            columns[f"u_{named(leader)}"] = columns[f"u_{named(leader)}"] + factor * unit[joint(name).dofadr[0]]
        T = np.array([columns[name] for name in module.VARIABLES]).T
        own = (np.array([coordinates[name] for name in module.COORDINATES]), np.array([speeds[name] for name in module.VARIABLES]))
        return *own, (T.T @ mass @ T, T.T @ bias, T.T @ gravity)


class MujocoLoops:
    """A robot with the loops and couplings of its MJCF file."""

    def __init__(self, robot):
        self.model = mujoco.MjModel.from_xml_string(without(robot.text, ("tendon", "sensor", "keyframe")))
        self.data = mujoco.MjData(self.model)
        flags = mujoco.mjtDisableBit
        self.model.opt.disableflags |= flags.mjDSBL_CONTACT | flags.mjDSBL_LIMIT | flags.mjDSBL_FRICTIONLOSS
        self.model.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE

    def rows(self, q, v):
        """Residuals of the loops and their Jacobian."""
        self.data.qpos[:], self.data.qvel[:] = q, v
        mujoco.mj_forward(self.model, self.data)
        count = self.data.nefc
        return self.data.efc_pos[:count].copy(), self.data.efc_J.reshape(-1, self.model.nv)[:count].copy()

    def moved(self, q, v):
        q = q.copy()
        mujoco.mj_integratePos(self.model, q, v, 1)
        return q

    def state(self, random):
        """Coordinates, speeds and accelerations by name at a random state with closed loops."""
        model, data = self.model, self.data
        q = self.moved(model.qpos0, random.normal(size=model.nv) * 0.05)
        for _ in range(60):
            residual, jacobian = self.rows(q, np.zeros(model.nv))
            q = self.moved(q, -np.linalg.lstsq(jacobian, residual, rcond=1e-9)[0])
        residual, jacobian = self.rows(q, np.zeros(model.nv))
        if np.abs(residual).max() > 1e-12:
            return self.state(random)
        v = random.normal(size=model.nv)
        v -= np.linalg.lstsq(jacobian, jacobian @ v, rcond=1e-9)[0]
        step = 1e-6
        ahead, behind = (self.rows(self.moved(q, sign * step * v), v)[1] for sign in (1, -1))
        drift = (ahead - behind) @ v / (2 * step)
        _, jacobian = self.rows(q, v)
        mass = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass)
        load = data.qfrc_passive + data.qfrc_actuator - data.qfrc_bias
        # Accelerations in the null space of the Jacobian: redundant rows do no harm.
        particular = np.linalg.lstsq(jacobian, -drift, rcond=1e-7)[0]
        _, singular, right = np.linalg.svd(jacobian)
        free = right[(singular > 1e-7 * singular[0]).sum() :].T
        rates = particular + free @ np.linalg.solve(free.T @ mass @ free, free.T @ (load - mass @ particular))
        coordinates, speeds, accelerations = {}, {}, {}
        for at in range(model.njnt):
            one = model.joint(at)
            own, count = named(one.name), {0: (7, 6), 1: (4, 3)}.get(int(one.type[0]), (1, 1))
            label = (lambda k: "") if count[0] == 1 else (lambda k: f"_{k + 1}")
            coordinates |= {f"q_{own}{label(k)}": q[one.qposadr[0] + k] for k in range(count[0])}
            speeds |= {f"u_{own}{label(k)}": v[one.dofadr[0] + k] for k in range(count[1])}
            accelerations |= {f"u_{own}{label(k)}": rates[one.dofadr[0] + k] for k in range(count[1])}
        return coordinates, speeds, accelerations


def mimics(text):
    """Joints of a URDF file that follow others: leader, factor and offset by name."""
    found = {}
    for block in re.findall(r"<joint .*?</joint>", text, re.S):
        mimic = re.search(r"<mimic ([^>]*)/>", block)
        if mimic:
            get = dict(re.findall(r'(\w+)="([^"]*)"', mimic[1]))
            equation = (get["joint"], float(get.get("multiplier", 1)), float(get.get("offset", 0)))
            found[re.search(r'name="([^"]+)"', block)[1]] = equation
    return found


def write_rows(path, rows):
    written = lambda word: repr(float(word)) if isinstance(word, float) else str(word)
    path.write_text("".join(" ".join(map(written, row)) + "\n" for row in rows))


def pinocchio_worker(arguments):
    """The program around Pinocchio's headers, compiled if its source is newer; none without headers."""
    if not arguments.headers:
        return None
    program, source = build.PLACE / "robots-pinocchio", build.WORKERS / "robots.cpp"
    if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
        build.PLACE.mkdir(parents=True, exist_ok=True)
        includes = ["-isystem", arguments.headers, "-isystem", arguments.headers / "eigen3"]
        build.say("robots.cpp -> robots-pinocchio")
        build.call([build.compiler_plus(), *build.CPP_FLAGS, "-w", *includes, source, "-o", program])
    return program


def report(rows, arguments):
    yield "## Ten robots"
    yield ""
    yield "### Import and agreement"
    yield ""
    cells = []
    for row in rows:
        digits = lambda values: " ".join(f"{value:.0e}" for value in values)
        numbers = [row[key] for key in ("joints", "loops", "couplings", "freedoms", "left_out")]
        closed = f"{row['closed']:.0e}" if "closed" in row else "–"
        cells.append([ROBOTS[row["name"]], *numbers, digits(row["pin"]), digits(row["mujoco"]), closed])
    head = ("robot", "joints", "loops", "couplings", "freedoms", "left out")
    head = (*head, "Pinocchio: M, bias, gravity", "MuJoCo: M, bias, gravity", "with loops")
    yield from table(head, cells)
    yield ""
    yield "### Derivation and calls"
    yield ""
    cells = []
    nanoseconds = lambda sample: f"{1e9 * sample.median:.0f} ({1e9 * sample.fastest:.0f})" if sample else "–"
    for row in rows:
        cells.append([ROBOTS[row["name"]], duration(row["derive"]), duration(row["emit"]), row["inverse count"], row["forward count"]])
        cells[-1] += [nanoseconds(row.get((of, work))) for work in ("inverse", "forward") for of in ("C", "Pinocchio")]
    head = ("robot", "derive", "write C", "inverse: operations + functions", "accelerations: operations + functions")
    yield from table((*head, "inverse, C, ns", "`rnea`, ns", "accelerations, C, ns", "`aba`, ns"), cells)
    yield ""
    packages = {"pin": pin.__version__, "mujoco": mujoco.__version__, "numpy": np.__version__}
    for key, value in build.machine(packages).items():
        yield f"- {key}: {value.removesuffix('; no Eigen')}"
    yield f"- headers of Pinocchio in C++: {', '.join(build.HEADERS.read_text().splitlines()[1:])}"
    yield f"- {arguments.rounds} rounds; medians, and the fastest in brackets"


if __name__ == "__main__":
    main()
