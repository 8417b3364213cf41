"""Bars that show the progress of long work, if the package tqdm is installed."""

from __future__ import annotations

import importlib.util
from typing import Any, Optional


def bar(**settings: Any) -> Optional[Any]:
    """A bar of tqdm with these settings; None if tqdm is not installed."""
    if importlib.util.find_spec("tqdm") is None:
        return None
    from tqdm.auto import tqdm

    return tqdm(**settings)


class RunBar:
    """Bar of the time that a run has reached, from `begin` to `end`, s."""

    def __init__(self, begin: float, end: float) -> None:
        self._begin = begin
        form = "{desc}: {percentage:3.0f}%|{bar}| {n:.4g} s of {total:.4g} s [{elapsed}<{remaining}]"
        self._bar = bar(total=abs(end - begin), desc="run", bar_format=form)

    def __enter__(self) -> RunBar:
        return self

    def __exit__(self, *exception: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def show(self, t: float) -> None:
        """Shows that the run has reached the time t, s. If t has gone back, the second run has begun."""
        if self._bar is None:
            return
        done = min(abs(t - self._begin), self._bar.total)
        if done < self._bar.n:
            self._bar.reset()
            self._bar.set_description_str("second run, for the digits")
        self._bar.update(done - self._bar.n)

    def finish(self, t: float) -> None:
        """Shows a full bar after a run that ended at the time t, s."""
        if self._bar is None:
            return
        self._bar.total = self._bar.n = abs(t - self._begin)
        self._bar.refresh()
