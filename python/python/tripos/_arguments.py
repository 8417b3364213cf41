"""Arguments of models and scenes: arrays, values by name, settings, and names of equations."""

from __future__ import annotations

import numbers
import os
from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _tripos

Array = NDArray[np.float64]
MaskedArray = np.ma.MaskedArray
Path = Union[str, "os.PathLike[str]"]
#: Values of parameters and inputs by name.
Given = Optional[Mapping[str, float]]
#: Tables of a state: `{"state": {…}, "guess": {…}, "parameters": {…}}`, with numbers or formulas in quotes.
State = Mapping[str, Mapping[str, Union[float, str]]]
#: Kind of each setting of a run.
SETTINGS: dict[str, type] = {
    **dict.fromkeys(("by", "method", "project", "solve"), str),
    **dict.fromkeys(("step", "max_step", "rtol", "atol", "until"), float),
    **dict.fromkeys(("step_limit", "samples"), int),
}


def values_of(parameters: Given, values: dict[str, float]) -> dict[str, float]:
    """Values of parameters and inputs from the mapping `parameters` and from keywords."""
    if parameters is None:
        return values
    if not isinstance(parameters, Mapping):
        advice = "give a parameter of this name as parameters={'parameters': …}"
        raise _tripos.RequestError(f"`parameters` is {parameters!r}, not a mapping of values by name; {advice}")
    twice = [name for name in parameters if name in values]
    if twice:
        raise _tripos.RequestError(f"`{twice[0]}` is given twice: in `parameters` and as a keyword")
    return {**parameters, **values}


def equations_name(given: str) -> str:
    """Name of equations; other values are refused."""
    if not isinstance(given, str):
        advice = "give a parameter of this name as parameters={'equations': …}"
        raise _tripos.RequestError(f"`equations` is {given!r}, not the name of equations such as \"kane\"; {advice}")
    return given


def refuse_masks(arrays: Sequence[ArrayLike]) -> None:
    """Refuses arrays of q, u and u_dot with masked numbers, whose values nobody means."""
    for array in arrays:
        if isinstance(array, MaskedArray):
            refuse_mask(("q", "u", "u_dot")[[array is other for other in arrays].index(True)], array)


def refuse_mask(name: str, array: ArrayLike) -> None:
    """Refuses an array with masked numbers."""
    if np.ma.is_masked(array):
        raise _tripos.RequestError(f"{name} has masked numbers; fill them first: {name}.filled(numpy.nan)")


def real_array(name: str, given: ArrayLike) -> Array:
    """An array or list of real numbers as an array of doubles; others are refused."""
    if type(given) is np.ndarray and given.dtype == np.float64:
        return given
    refuse_mask(name, given)
    try:
        array = np.asarray(given)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"its numbers are of the type {array.dtype}")
        return array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise _tripos.RequestError(f"{name} is no array of real numbers: {error}") from error


def plain(value: Any) -> Any:
    """Numbers and arrays of NumPy as those of Python; other values as they are.

    >>> plain(np.int64(3)), plain(np.array([1.0, 2.0]))
    (3, [1.0, 2.0])
    """
    return value.tolist() if isinstance(value, (np.generic, np.ndarray)) else value


def checked(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Settings of a run with values of the right kinds; those that are None are left out."""
    return {name: setting_of(name, plain(value)) for name, value in settings.items() if value is not None}


def setting_of(name: str, value: Any) -> Any:
    """Value of a setting, if it is of the right kind. The run itself refuses unknown names."""
    kind = SETTINGS.get(name)
    if kind is str and not isinstance(value, str):
        raise _tripos.RequestError(f"the setting `{name}` is {value!r}; give a name in quotes")
    if kind is float and (isinstance(value, bool) or not isinstance(value, numbers.Real)):
        raise _tripos.RequestError(f"the setting `{name}` is {value!r}; give a number")
    if kind is int and (isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 1 << 63):
        raise _tripos.RequestError(f"the setting `{name}` is {value!r}; give a positive whole number")
    return value


def instants_of(given: ArrayLike) -> list[float]:
    """Instants of a controller as a list of numbers."""
    times = real_array("instants", given)
    if times.ndim != 1:
        raise _tripos.RequestError(f"instants has the shape {times.shape}; give (N,)")
    return [float(t) for t in times]


def distinct_names(names: Sequence[str]) -> list[str]:
    """Names as a list; a text in place of the list, and names that occur twice, are refused."""
    if isinstance(names, str):
        raise _tripos.RequestError(f"the names are the text {names!r}; give a list: [{names!r}]")
    chosen = list(names)
    twice = [name for name in chosen if chosen.count(name) > 1]
    if twice:
        raise _tripos.RequestError(f"the name `{twice[0]}` is given twice; give each number of the objective once")
    return chosen
