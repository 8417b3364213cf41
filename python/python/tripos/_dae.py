"""Equations of motion as implicit systems, for solvers of differential-algebraic equations."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _tripos
from ._arguments import Array, real_array


class Dae:
    """Equations of motion as an implicit system F(t, y, y') = 0."""

    def __init__(self, value: Callable[[str, Array, Array], Array], coordinates: int, variables: int) -> None:
        """Makes the system from a function of (name of a quantity, q, u), and from the lengths of q and u."""
        self._of, self._coordinates, self._variables = value, coordinates, variables
        unknowns = len(self._of("forcing", np.zeros(coordinates), np.zeros(variables)))
        #: True for each number of the state whose rate occurs; False for reactions.
        self.is_differential: NDArray[np.bool_] = np.arange(self._coordinates + unknowns) < (
            self._coordinates + self._variables
        )

    def __call__(self, t: float, y: ArrayLike, y_dot: ArrayLike) -> Array:
        """Residual F(t, y, y'), which is zero for a motion."""
        state, rates = real_array("y", y), real_array("y_dot", y_dot)
        if state.shape != self.is_differential.shape or rates.shape != state.shape:
            shapes = f"{state.shape} and {rates.shape}; give ({len(self.is_differential)},)"
            raise _tripos.RequestError(f"y and y' have the shapes {shapes}")
        n = self._coordinates
        q, u = state[:n], state[n : n + self._variables]
        unknowns = np.concatenate([rates[n : n + self._variables], state[n + self._variables :]])
        kinematic = rates[:n] - self._of("coordinate_rates", q, u)
        return np.concatenate([kinematic, self._of("mass_matrix", q, u) @ unknowns - self._of("forcing", q, u)])
