"""Blocks of Python in the documentation run."""

import os
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.filterwarnings("ignore::tripos.UntrustedRunWarning")
@pytest.mark.parametrize("page", ["README.md", "python/README.md", "docs/python.md"])
def test_blocks_of_a_page_run(page, monkeypatch):
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), flags=re.DOTALL)
    assert blocks, "the page has no block of Python"
    names = {}
    for block in blocks:
        try:
            exec(compile(block, os.fspath(ROOT / page), "exec"), names)
        except ImportError as error:
            pytest.skip(str(error))
