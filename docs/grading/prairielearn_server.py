"""`server.py` of a PrairieLearn question: one text box named `equations` holds the submission.

Put tripos_grade.py, model.toml and, if there is one, rubric.toml into the folder of the question or of serverFilesCourse,
and the command `tripos` into the image that grades.
"""

import os

from tripos_grade import marks_of_text

HERE = os.path.dirname(os.path.abspath(__file__))
BOX = "equations"


def grade(data):
    """Sets score, partial scores and feedback of a question from its submitted text."""
    rubric = os.path.join(HERE, "rubric.toml")
    found = marks_of_text(
        os.path.join(HERE, "model.toml"),
        data["submitted_answers"].get(BOX) or "",
        rubric=rubric if os.path.exists(rubric) else None,
    )
    if "error" in found:
        data["format_errors"][BOX] = found["error"]
        return
    score = found["points"] / found["of"] if found["of"] else 0.0
    lines = [f"{entry['id']}: {entry['feedback'] or entry['outcome']}" for entry in found["entries"]]
    data["score"] = score
    data["partial_scores"][BOX] = {"score": score, "weight": 1}
    data["feedback"][BOX] = "\n".join(lines)
