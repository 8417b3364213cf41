"""Marks for a submission, by `tripos grade`: for graders that are written in Python.

A submission is a publication file (docs/publication.md). It is only read, never run.
"""

import json
import os
import subprocess
import tempfile

PROGRAM = os.environ.get("TRIPOS", "tripos")
"""The command; the environment variable TRIPOS names another one."""


def marks(model, submission, rubric=None, level=None, seconds=30):
    """Marks of the submission file: a dictionary with `points`, `of` and `entries`, or with `error` in words.

    `level` is "hint", "place" or "term". A grading that takes longer than `seconds` is an error.
    """
    command = [PROGRAM, "grade", str(model), str(submission), "--json"]
    command += ["--rubric", str(rubric)] if rubric else []
    command += ["--level", level] if level else []
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return {"error": f"the submission took longer than {seconds} s"}
    if done.returncode not in (0, 1):
        return {"error": done.stderr.strip()}
    return json.loads(done.stdout)["submissions"][0]


def marks_of_text(model, text, **options):
    """Marks of a submission that is given as text; options as in `marks`."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "submission.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return marks(model, path, **options)
