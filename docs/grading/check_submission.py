"""Checks of a submission for pytest, and for the tests of an Otter notebook: `check("submission.toml")`."""

import os

from tripos_grade import marks

MODEL = os.environ.get("TRIPOS_MODEL", "model.toml")
SUBMISSION = os.environ.get("TRIPOS_SUBMISSION", "submission.toml")


def check(submission=SUBMISSION, model=MODEL):
    """Raises AssertionError with the feedback if an entry of the submission is wrong."""
    found = marks(model, submission)
    assert "error" not in found, found.get("error")
    wrong = [f"{entry['id']}: {entry['feedback']}" for entry in found["entries"] if entry["points"] < entry["of"]]
    assert not wrong, "\n".join(wrong)


def test_submission():
    """The one test that pytest collects."""
    check()
