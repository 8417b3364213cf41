from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

class TriposError(Exception):
    help: str | None
    places: list[dict[str, Any]]

class InputError(TriposError): ...
class RequestError(TriposError): ...
class StoppedError(TriposError): ...

class Model:
    title: str
    text: str
    @staticmethod
    def read(path: str) -> Model: ...
    @staticmethod
    def parse(text: str) -> Model: ...
    def parameter_list(self) -> list[tuple[str, str, float | None, str, bool]]: ...
    def coordinate_list(self) -> list[tuple[str, str, str]]: ...
    def speed_list(self) -> list[tuple[str, str, str]]: ...
    file: str
    def value(
        self,
        name: str,
        equations: str,
        parameters: dict[str, float],
        q: ArrayLike,
        u: ArrayLike,
        u_dot: ArrayLike | None = None,
        /,
    ) -> Array: ...
    def regressor(
        self, parameters: dict[str, float], q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, /
    ) -> Array: ...
    def base_parameters(self, parameters: dict[str, float], /) -> list[tuple[str, float | None]]: ...

class Scene:
    @staticmethod
    def read(path: str) -> Scene: ...
    @staticmethod
    def parse(model: Model, text: str) -> Scene: ...
    def copy(self) -> Scene: ...
    def mechanism(self) -> Model: ...
    span: tuple[float, float]
    def set(self, name: str, value: float) -> None: ...
    def run(
        self, settings: dict[str, Any] | None = None, report: Callable[[float], None] | None = None
    ) -> Run: ...
    def slopes(
        self, names: list[str], settings: dict[str, Any] | None = None
    ) -> tuple[dict[str, dict[str, float]], list[str]]: ...
    def gradient_of(
        self, of: str, settings: dict[str, Any] | None = None
    ) -> tuple[float, dict[str, float], list[str]]: ...
    def run_sampled(
        self,
        inputs: list[str],
        instants: list[float],
        make: Callable[[], Callable[[float, dict[str, float]], Any]],
        settings: dict[str, Any] | None = None,
        report: Callable[[float], None] | None = None,
    ) -> SampledRun: ...

class Run:
    names: list[str]
    t: Array
    values: Array
    end: dict[str, float]
    errors: dict[str, float] | None
    digits: dict[str, float] | None
    events: list[tuple[str, float]]
    warnings: list[str]
    notes: list[str]
    ending: str
    drift: dict[str, float]
    is_trusted: bool
    work: tuple[int, int, int]

class SampledRun:
    names: list[str]
    t: Array
    values: Array
    end: dict[str, float]
    errors: dict[str, float] | None
    digits: dict[str, float] | None
    is_trusted: bool
    decision_times: Array
    decisions: Array
    events: list[tuple[str, float]]
    warnings: list[str]
    ending: str

def command(words: list[str]) -> tuple[int, str, str]: ...
