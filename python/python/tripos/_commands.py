"""The commands of the program `tripos`, as functions."""

from __future__ import annotations

import json
import os
import re
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Union

from . import _tripos

#: Value of an option: True is a flag, a sequence gives the option several times, None leaves it out.
Option = Union[str, float, int, bool, None, "os.PathLike[str]", Sequence[Union[str, float, int, "os.PathLike[str]"]]]


class TriposWarning(UserWarning):
    """A warning of a command."""


class UntrustedRunWarning(TriposWarning):
    """A reason not to trust the numbers of a run."""


class CommandResult(NamedTuple):
    """Result of a command: exit status, and texts for standard output and standard error."""

    status: int
    output: str
    messages: str


def words_of(option: str, value: Option) -> list[str]:
    """Words of an option on the command line."""
    name = "--" + option.strip("_").replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [name]
    if isinstance(value, (str, int, float, os.PathLike)):
        # One word, so that a value may begin with a minus sign.
        return [f"{name}={os.fspath(value) if isinstance(value, os.PathLike) else value}"]
    return [word for entry in value for word in words_of(option, entry)]


def run_command(command: str, *arguments: Union[str, "os.PathLike[str]"], **options: Option) -> CommandResult:
    """Runs a command of the program `tripos` and returns what it prints. Nothing is raised for a failed command.

    Options have underscores for hyphens, and a final underscore where the name is a keyword of Python.

    >>> print(run_command("schema", "nothing").messages.splitlines()[0])
    error: invalid value 'nothing' for '<FORMAT>'
    """
    words = [command]
    for option, value in options.items():
        words += words_of(option, value)
    # Behind "--", an argument that begins with a minus sign is no option.
    if arguments:
        words += ["--", *(os.fspath(argument) for argument in arguments)]
    return CommandResult(*_tripos.command(words))


def text_of(command: str, *arguments: Union[str, "os.PathLike[str]"], **options: Option) -> str:
    """Text that a command prints. A failure is raised, and each warning is a Python warning."""
    result = run_command(command, *arguments, **options)
    warn_of(result.messages)
    if result.status not in (0, 1):
        raise failure(result.messages, {}, result.status)
    return result.output


def answer(
    command: str,
    *arguments: Union[str, "os.PathLike[str]"],
    warning: type[TriposWarning] = TriposWarning,
    **options: Option,
) -> Any:
    """Answer of a command as Python objects, from its JSON. A failure is raised, and each warning is a Python warning
    of the class `warning`.

    >>> import tripos
    >>> model = tripos.Model.from_text(tripos.EXAMPLE)
    >>> answer("prove", model.path)["schema"] > 0
    True
    """
    result = run_command(command, *arguments, json=True, **options)
    warn_of(result.messages, warning)
    try:
        value = json.loads(result.output)
    except ValueError:
        raise failure(result.messages, {}, result.status) from None
    if isinstance(value, dict) and "error" in value and result.status not in (0, 1):
        raise failure(result.messages, value["error"], result.status)
    return value


def warn_of(messages: str, category: type[TriposWarning] = TriposWarning) -> None:
    """Makes each warning of a command, or of several commands, a Python warning of a class. Equal ones are made once."""
    found = re.findall(r"^warning: (.*(?:\n(?!warning: |error: |note: )[ \t].*)*)", messages, flags=re.MULTILINE)
    for text in dict.fromkeys(found):
        warnings.warn(text, category, stacklevel=4)


def failure(messages: str, error: Mapping[str, Any], status: int) -> Exception:
    """Exception for a command that failed, with the attributes `help` and `places`."""
    text = messages.strip() or str(error.get("message", "the command failed"))
    places = list(error.get("places", []))
    if status == 3:
        exception: Exception = _tripos.StoppedError(text)
    elif places:
        exception = _tripos.InputError(text)
    else:
        exception = _tripos.RequestError(text)
    exception.help = error.get("help")  # type: ignore[attr-defined]
    exception.places = places  # type: ignore[attr-defined]
    return exception
