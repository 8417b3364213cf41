"""Compares a generated module over JAX with itself over NumPy: jax_arrays.py MODULE."""

import importlib
import sys

import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)
model = importlib.import_module(sys.argv[1])
draw = np.random.default_rng(1)
p = np.array(model.DEFAULTS, dtype=float)
p = np.where(np.isnan(p), 1.3, p)
q = draw.uniform(0.1, 1.4, (len(model.COORDINATES), 5))
u = draw.uniform(-1, 1, (len(model.VARIABLES), 5))
expected = model.accelerations(p, q, u)
size = 1 + abs(expected).max()


def own(q, u):
    return model.accelerations(p, q, u, xp=jnp)


assert abs(jax.jit(own)(q, u) - expected).max() < 1e-11 * size
assert abs(jax.vmap(own, in_axes=1, out_axes=1)(q, u) - expected).max() < 1e-11 * size
slopes = jax.jacfwd(lambda q: own(q, u[:, 0]))(jnp.array(q[:, 0]))
count = len(model.COORDINATES)
stated = model.jacobian(p, q[:, 0], u[:, 0])[count:, :count]
assert abs(slopes - stated).max() < 1e-9 * (1 + abs(stated).max())
