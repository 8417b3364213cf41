"""The disk and the chain for SymPy's KanesMethod, from frames, points and bodies.

Each returns the symbols, M and f of M u' = f; what turns q, q' and the parameters into the values of the symbols; and what turns
q, q' and u' into q''. The disk's speeds are those of models/disk: with q' the equations are longer.
"""

import math

import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics.models import n_link_pendulum_on_cart


def disk(share=sm.Rational(1, 2)):
    """`share`: the axial moment of inertia over M R^2."""
    q, u = me.dynamicsymbols("q1:6"), me.dynamicsymbols("u1:6")
    M, R, g = sm.symbols("M R g", positive=True)
    A = me.ReferenceFrame("A")
    H = A.orientnew("H", "Axis", (q[0], A.z))
    B = H.orientnew("B", "Axis", (sm.pi / 2 - q[1], H.x))
    C = B.orientnew("C", "Axis", (q[2] - sm.pi / 2, B.z))
    rates = [x.diff() for x in q]
    definitions = [-rates[1], rates[0] * sm.cos(q[1]), rates[0] * sm.sin(q[1]) + rates[2], rates[3], rates[4]]
    B.set_ang_vel(A, u[0] * B.x + u[1] * B.y + u[1] * sm.tan(q[1]) * B.z)
    C.set_ang_vel(A, u[0] * B.x + u[1] * B.y + u[2] * B.z)
    O, P = me.Point("O"), me.Point("P")
    O.set_vel(A, 0)
    P.set_pos(O, q[3] * A.x + q[4] * A.y)
    P.set_vel(A, u[3] * A.x + u[4] * A.y)
    centre = P.locatenew("Cstar", R * B.y)
    centre.v2pt_theory(P, A, B)
    inertia = me.inertia(B, M * R**2 / 4, M * R**2 / 4, share * M * R**2)
    body = me.RigidBody("disk", centre, C, M, (inertia, centre))
    kane = me.KanesMethod(A, q, u, kd_eqs=[d - s for d, s in zip(definitions, u)])
    kane.kanes_equations([body], [(centre, -M * g * A.z)])

    def numbers(x, v, p):
        speeds = [-v[1], v[0] * math.cos(x[1]), v[0] * math.sin(x[1]) + v[2], v[3], v[4]]
        return [*x, *speeds, *p]

    def accelerations(x, v, rates):
        s, c = math.sin(x[1]), math.cos(x[1])
        first = (rates[1] + v[0] * v[1] * s) / c
        return [first, -rates[0], rates[2] - first * s - v[0] * v[1] * c, *rates[3:]]

    return [*q, *u, M, R, g], kane.mass_matrix, kane.forcing, numbers, accelerations


def chain(links):
    kane = n_link_pendulum_on_cart(links, cart_force=True, joint_torques=False)
    m, l = sm.symbols(f"m:{links + 1}"), sm.symbols(f"l:{links}")
    g, force = sm.Symbol("g"), me.dynamicsymbols("F")
    symbols = [*kane.q, *kane.u, *m, *l, g, force]
    return symbols, kane.mass_matrix, kane.forcing, lambda x, v, p: [*x, *v, *p], lambda x, v, rates: rates
