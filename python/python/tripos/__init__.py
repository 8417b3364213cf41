"""Mechanisms as equations of motion: derived, proved, run and checked.

>>> import tripos
>>> model = tripos.Model.from_text(tripos.EXAMPLE)
>>> float(model.accelerations([0.5], [0.0])[0].round(6))
-4.703165
>>> model.mass_matrix([0.5], [0.0], l=2.0).tolist()
[[4.0]]
"""

from ._commands import CommandResult, TriposWarning, UntrustedRunWarning, answer, run_command
from ._display import Markdown, Page, Picture
from ._dae import Dae
from ._model import EXAMPLE, Model
from ._mechanism import Mechanism
from ._scene import Run, SampledRun, Scene
from ._sweep import SweepRequest, SweepTable, run_block, sweep, sweep_frame
from ._tripos import InputError, RequestError, StoppedError, TriposError

__all__ = [
    "CommandResult",
    "Dae",
    "EXAMPLE",
    "InputError",
    "Markdown",
    "Mechanism",
    "Model",
    "Page",
    "Picture",
    "RequestError",
    "Run",
    "SampledRun",
    "Scene",
    "StoppedError",
    "SweepRequest",
    "SweepTable",
    "TriposError",
    "TriposWarning",
    "UntrustedRunWarning",
    "answer",
    "run_block",
    "run_command",
    "sweep",
    "sweep_frame",
]
