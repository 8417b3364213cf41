"""Objects that notebooks display."""

from __future__ import annotations

import html
import os
import pathlib
from typing import Union


class Picture(str):
    """A picture as the text of an SVG file; notebooks show it."""

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the picture to a file."""
        pathlib.Path(path).write_text(self, encoding="utf-8")


class Page(str):
    """A page of HTML without other files; notebooks show it in a frame."""

    #: Height of the frame in a notebook, pixels.
    height = 600

    def _repr_html_(self) -> str:
        page = html.escape(self, quote=True)
        return f'<iframe srcdoc="{page}" width="100%" height="{self.height}" style="border:0"></iframe>'

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the page to a file."""
        pathlib.Path(path).write_text(self, encoding="utf-8")
