"""Objects that notebooks display."""

from __future__ import annotations

import base64
import html
import os
import pathlib
import re
from typing import Union


class Document(str):
    """A text that is also the content of a file."""

    def __repr__(self) -> str:
        # Notebooks keep this text beside what they show.
        return f"<tripos.{type(self).__name__}: {len(self)} characters>"

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the text to a file."""
        pathlib.Path(path).write_text(self, encoding="utf-8")


class Picture(Document):
    """A picture as the text of an SVG file; notebooks show it."""

    def _repr_html_(self) -> str:
        # As an image, the picture is shown in a notebook that the reader has not run.
        data = base64.b64encode(self.encode("utf-8")).decode("ascii")
        return f'<img src="data:image/svg+xml;base64,{data}">'

    def _repr_svg_(self) -> str:
        return str(self)


class Page(Document):
    """A page of HTML without other files; notebooks show it in a frame."""

    #: Height of the frame in a notebook, pixels.
    height = 600

    def _repr_html_(self) -> str:
        page = html.escape(self, quote=True)
        return f'<iframe srcdoc="{page}" width="100%" height="{self.height}" style="border:0"></iframe>'


class Markdown(Document):
    """A document in the Markdown of GitHub; notebooks show it."""

    def _repr_markdown_(self) -> str:
        """The document with formulas between dollar signs, as notebooks take them.

        >>> Markdown("mass $`m`$\\n\\n```math\\nM = m\\n```\\n")._repr_markdown_()
        'mass $m$\\n\\n$$\\nM = m\\n$$\\n'
        """
        blocks = re.sub(r"```math\n(.*?)\n```", r"$$\n\1\n$$", self, flags=re.DOTALL)
        return re.sub(r"\$`(.*?)`\$", r"$\1$", blocks)
