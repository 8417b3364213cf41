"""Reference values of the robots in this folder, by Pinocchio (URDF) and MuJoCo (MJCF), in the names of Tripos.

    pip install pin mujoco && python3 reference.py      writes NAME.json beside each description

Each state has the coordinates and generalized speeds, the kinetic energy T (J), the weight's potential (J, up to a
constant of the robot), and, unless a joint has several coordinates in Pinocchio, the mass matrix M and the bias h of
M u' + h = tau. Loops of MJCF files are left out: the states are those of the tree. NAME.motion.json has the
coordinates 0.1 s after a release at rest, with the loops closed by MuJoCo's stiffest equality. NAME.loops.json has the
accelerations of a URDF file whose loops and couplings are in NAME.KIND.toml: those of Lagrange's multipliers with
Pinocchio's mass matrix, bias and Jacobians, at a state with closed loops, with the damping of the joints.
"""

import json, re, sys, tomllib
from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin

HERE = Path(__file__).parent
STATES = 2


def named(joint):
    return re.sub(r"[^A-Za-z0-9]", "_", joint)


def write(path, states, tool):
    path.write_text(json.dumps({"tool": tool, "states": states}) + "\n")


def urdf(path):
    text = path.read_text()
    is_floating = path.stem == "hexapod"
    model = pin.buildModelFromXML(text, pin.JointModelFreeFlyer()) if is_floating else pin.buildModelFromXML(text)
    data, random = model.createData(), np.random.default_rng(7)
    root = re.search(r'<robot[^>]*>.*?<link name="([^"]+)"', text, re.S).group(1)
    mimic = {}
    for block in re.findall(r"<joint .*?</joint>", text, re.S):
        found = re.search(r"<mimic ([^>]*)/>", block)
        if found:
            get = dict(re.findall(r'(\w+)="([^"]*)"', found.group(1)))
            values = (get["joint"], float(get.get("multiplier", 1)), float(get.get("offset", 0)))
            mimic[re.search(r'name="([^"]+)"', block).group(1)] = values
    states = []
    for _ in range(STATES):
        v = random.normal(size=model.nv)
        q = pin.integrate(model, pin.neutral(model), random.normal(size=model.nv) * 0.7)
        for name, (leader, factor, offset) in mimic.items():
            at, of = model.joints[model.getJointId(name)], model.joints[model.getJointId(leader)]
            q[at.idx_q] = factor * q[of.idx_q] + offset
            v[at.idx_v] = factor * v[of.idx_v]
        coordinates, speeds, order, simple = {}, {}, [], True
        for name, joint in list(zip(model.names, model.joints))[1:]:
            n, x, u = named(name), q[joint.idx_q : joint.idx_q + joint.nq], v[joint.idx_v : joint.idx_v + joint.nv]
            if joint.nv == 1:
                coordinates[f"q_{n}"] = float(x[0] if joint.nq == 1 else np.arctan2(x[1], x[0]))
                speeds[f"u_{n}"] = float(u[0])
                if name not in mimic:
                    order.append((f"u_{n}", joint.idx_v))
            elif joint.nv == 6:
                simple, n = False, named(f"{root}_free") if name == "root_joint" else n
                turn = pin.Quaternion(x[6], x[3], x[4], x[5])
                values = [*x[:3], x[6], *x[3:6]]
                coordinates |= {f"q_{n}_{k + 1}": float(value) for k, value in enumerate(values)}
                rates = [*(turn.toRotationMatrix() @ u[:3]), *u[3:]]
                speeds |= {f"u_{n}_{k + 1}": float(value) for k, value in enumerate(rates)}
            else:
                simple = False
                cosine, sine = x[2], x[3]
                values = [x[0], x[1], np.arctan2(sine, cosine)]
                rates = [cosine * u[0] - sine * u[1], sine * u[0] + cosine * u[1], u[2]]
                coordinates |= {f"q_{n}_{k + 1}": float(value) for k, value in enumerate(values)}
                speeds |= {f"u_{n}_{k + 1}": float(value) for k, value in enumerate(rates)}
        state = {
            "coordinates": coordinates,
            "speeds": speeds,
            "kinetic_energy": float(pin.computeKineticEnergy(model, data, q, v)),
            "potential_energy": float(pin.computePotentialEnergy(model, data, q)),
        }
        if simple:
            mass = np.array(pin.crba(model, data, q))
            mass = np.triu(mass) + np.triu(mass, 1).T
            bias = np.array(pin.nonLinearEffects(model, data, q, v))
            columns = np.zeros((model.nv, len(order)))
            for column, (_, at) in enumerate(order):
                columns[at, column] = 1
            for name, (leader, factor, _) in mimic.items():
                at, of = model.joints[model.getJointId(name)], model.joints[model.getJointId(leader)]
                columns[at.idx_v] = factor * columns[of.idx_v]
            state["order"] = [name for name, _ in order]
            state["mass_matrix"] = (columns.T @ mass @ columns).tolist()
            state["bias"] = (columns.T @ bias).tolist()
        states.append(state)
    write(path.with_suffix(".json"), states, f"pinocchio {pin.__version__}")


def mjcf(path):
    text = re.sub(r"<(equality|tendon|sensor|actuator|keyframe)>.*?</\1>", "", path.read_text(), flags=re.S)
    model = mujoco.MjModel.from_xml_string(text)
    data, random = mujoco.MjData(model), np.random.default_rng(7)
    states = []
    for _ in range(STATES):
        velocity = random.normal(size=model.nv)
        data.qpos[:] = model.qpos0
        mujoco.mj_integratePos(model, data.qpos, random.normal(size=model.nv) * 0.5, 1)
        data.qvel[:] = velocity
        mujoco.mj_forward(model, data)
        mass = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass)
        coordinates, speeds, order = {}, {}, []
        for at in range(model.njnt):
            joint = model.joint(at)
            n, count = named(joint.name), {0: (7, 6), 1: (4, 3), 2: (1, 1), 3: (1, 1)}[int(joint.type[0])]
            q = data.qpos[joint.qposadr[0] :][: count[0]]
            u = data.qvel[joint.dofadr[0] :][: count[1]]
            label = (lambda k: "") if count[0] == 1 else (lambda k: f"_{k + 1}")
            coordinates |= {f"q_{n}{label(k)}": float(value) for k, value in enumerate(q)}
            speeds |= {f"u_{n}{label(k)}": float(value) for k, value in enumerate(u)}
            order += [f"u_{n}{label(k)}" for k in range(count[1])]
        weight = -sum(model.body_mass[b] * model.opt.gravity @ data.xipos[b] for b in range(model.nbody))
        states.append(
            {
                "coordinates": coordinates,
                "speeds": speeds,
                "kinetic_energy": float(velocity @ mass @ velocity / 2),
                "potential_energy": float(weight),
                "order": order,
                "mass_matrix": mass.tolist(),
                "bias": data.qfrc_bias.tolist(),
            }
        )
    write(path.with_suffix(".json"), states, f"mujoco {mujoco.__version__}")


def motion(path):
    text = re.sub(r"<(tendon|sensor|actuator|keyframe)>.*?</\1>", "", path.read_text(), flags=re.S)
    ends = []
    for step in (1e-5, 5e-6):
        model = mujoco.MjModel.from_xml_string(text)
        model.opt.timestep, model.opt.integrator = step, mujoco.mjtIntegrator.mjINT_RK4
        model.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
        model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT
        model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_FRICTIONLOSS
        model.eq_solref[:] = [2 * step, 1]
        model.eq_solimp[:] = [0.9999, 0.9999, 0.001, 0.5, 2]
        data = mujoco.MjData(model)
        for _ in range(round(0.1 / step)):
            mujoco.mj_step(model, data)
        ends.append(data.qpos.copy())
    joints = [model.joint(at) for at in range(model.njnt) if model.jnt_type[at] in (2, 3)]
    values = {f"q_{named(joint.name)}": float(ends[1][joint.qposadr[0]]) for joint in joints}
    difference = float(np.abs(ends[1] - ends[0]).max())
    out = {"tool": f"mujoco {mujoco.__version__}", "time": 0.1, "step_halved": difference, "coordinates": values}
    path.with_suffix(".motion.json").write_text(json.dumps(out) + "\n")


def loops(path):
    """Accelerations with the loops of each file NAME.KIND.toml; all joints of the robot have one coordinate."""
    model = pin.buildModelFromXML(path.read_text())
    data, size = model.createData(), model.nv
    damping = np.zeros(size)
    for block in re.findall(r"<joint .*?</joint>", path.read_text(), re.S):
        found = re.search(r'damping="([^"]*)"', block)
        if found:
            damping[model.joints[model.getJointId(re.search(r'name="([^"]+)"', block).group(1))].idx_v] = found.group(1)
    local = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    at = lambda name: model.joints[model.getJointId(name)]
    results = {}
    for file in sorted(path.parent.glob(f"{path.stem}.*.toml")):
        stated = tomllib.loads(file.read_text())
        angles = np.zeros(size)
        for name, value in stated["assembly"].items():
            angles[at(name).idx_v] = value
        angles += np.random.default_rng(7).normal(size=size) * 0.02
        velocity = np.random.default_rng(8).normal(size=size)

        def configuration(angles):
            q = pin.neutral(model)
            return pin.integrate(model, q, angles)

        def rows(angles, velocity):
            """Residual, Jacobian and the acceleration of the residual at zero joint accelerations."""
            q = configuration(angles)
            pin.forwardKinematics(model, data, q, velocity, np.zeros(size))
            pin.computeJointJacobians(model, data, q)
            pin.updateFramePlacements(model, data)
            residual, jacobian, drift = [], [], []
            for loop in stated["loops"].values():
                ends = []
                for end in (loop["first"], loop["second"]):
                    frame = model.getFrameId(end["link"])
                    pose = data.oMf[frame]
                    arm = pose.rotation @ np.array(end.get("xyz", [0, 0, 0]), float)
                    J = pin.getFrameJacobian(model, data, frame, local)
                    a = pin.getFrameClassicalAcceleration(model, data, frame, local)
                    turning = pin.getFrameVelocity(model, data, frame, local).angular
                    rotation = pose.rotation @ pin.rpy.rpyToMatrix(*np.array(end.get("rpy", [0, 0, 0]), float))
                    ends.append(
                        {
                            "point": pose.translation + arm,
                            "J": J[:3] - pin.skew(arm) @ J[3:],
                            "a": a.linear + np.cross(a.angular, arm) + np.cross(turning, np.cross(turning, arm)),
                            "rotation": rotation,
                            "turns": J[3:],
                            "omega": turning,
                            "alpha": a.angular,
                        }
                    )
                one, two = ends
                residual += list(one["point"] - two["point"])
                jacobian += list(one["J"] - two["J"])
                drift += list(one["a"] - two["a"])
                if loop["kind"] == "connect":
                    continue
                turn = one["rotation"] @ two["rotation"].T
                error = pin.log3(turn)
                across = np.eye(3)
                if loop["kind"] == "hinge":
                    axis = np.array(loop["axis"], float) / np.linalg.norm(loop["axis"])
                    across = (one["rotation"] @ np.linalg.svd(axis[None])[2][1:].T).T
                    error = np.cross(two["rotation"] @ axis, one["rotation"] @ axis)
                relative = one["omega"] - two["omega"]
                residual += list(across @ error)
                jacobian += list(across @ (one["turns"] - two["turns"]))
                moving = np.cross(one["omega"], across) if loop["kind"] == "hinge" else np.zeros((3, 3))
                drift += list(across @ (one["alpha"] - two["alpha"]) + moving @ relative)
            for coupling in stated["couplings"].values():
                follower, leader = at(coupling["joint"]).idx_v, at(coupling["follows"]).idx_v
                row = np.zeros(size)
                row[follower], row[leader] = 1, -coupling["multiplier"]
                residual.append(row @ angles - coupling["offset"])
                jacobian.append(row)
                drift.append(0)
            return np.array(residual), np.array(jacobian), np.array(drift)

        for _ in range(30):
            residual, jacobian, _ = rows(angles, velocity)
            angles = angles - np.linalg.lstsq(jacobian, residual, rcond=1e-9)[0]
        residual, jacobian, _ = rows(angles, velocity)
        velocity = velocity - np.linalg.lstsq(jacobian, jacobian @ velocity, rcond=1e-9)[0]
        residual, jacobian, drift = rows(angles, velocity)
        assert np.abs(residual).max() < 1e-14 and np.abs(jacobian @ velocity).max() < 1e-13, residual
        q = configuration(angles)
        mass = np.array(pin.crba(model, data, q))
        mass = np.triu(mass) + np.triu(mass, 1).T
        load = -np.array(pin.nonLinearEffects(model, data, q, velocity)) - damping * velocity
        # Accelerations in the null space of the Jacobian: redundant rows do no harm.
        particular = np.linalg.lstsq(jacobian, -drift, rcond=1e-9)[0]
        _, singular, right = np.linalg.svd(jacobian)
        free = right[(singular > 1e-9 * singular[0]).sum() :].T
        acceleration = particular + free @ np.linalg.solve(free.T @ mass @ free, free.T @ (load - mass @ particular))
        named_values = lambda prefix, values: {
            f"{prefix}_{named(name)}": float(values[joint.idx_v]) for name, joint in list(zip(model.names, model.joints))[1:]
        }
        results[file.name] = {
            "coordinates": named_values("q", angles),
            "rates": named_values("q", velocity),
            "accelerations": named_values("u", acceleration),
        }
    path.with_suffix(".loops.json").write_text(json.dumps({"tool": f"pinocchio {pin.__version__}", "files": results}) + "\n")


if __name__ == "__main__":
    for path in sorted(HERE.glob("*.urdf")):
        urdf(path)
    for path in sorted(HERE.glob("*.xml")):
        mjcf(path)
    for name in ("leg_fourbar", "delta"):
        motion(HERE / f"{name}.xml")
    loops(HERE / "leg_fourbar_tree.urdf")
