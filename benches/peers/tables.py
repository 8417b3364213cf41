"""Numbers and tables in Markdown."""

import size


def duration(seconds):
    """Three digits with the unit that suits."""
    if seconds == float("inf"):
        return "not reached"
    for unit, scale in (("s", 1), ("ms", 1e3), ("µs", 1e6), ("ns", 1e9)):
        if seconds * scale >= 0.995 or unit == "ns":
            return f"{seconds * scale:#.3g}".rstrip(".") + f" {unit}"


def ratio(value):
    if value > 0.1:
        return f"{value:.2f}"
    return f"{value:.3f}" if value > 0.01 else f"1/{1 / value:.0f}"


def quotients(ours, theirs, otherwise):
    """The ratio of the times by which two reached an error, by medians and by fastest samples; otherwise this, if one did not."""
    if ours is None or theirs is None:
        return otherwise
    ours, theirs = ours.samples, theirs.samples
    return f"{ratio(ours.median / theirs.median)} ({ratio(ours.fastest / theirs.fastest)})"


def table(head, rows):
    """The first column is text, the others are figures."""
    yield f"| {' | '.join(head)} |"
    yield "|---|" + "---:|" * (len(head) - 1)
    for row in rows:
        yield f"| {' | '.join(str(cell) for cell in row)} |"


def details(reached):
    """How each error was reached, by (row, error)."""
    rows = []
    for (name, target), r in reached.items():
        call = duration(r.samples.median / r.evaluations)
        rows.append(
            [name, f"{target:.0e}", f"{r.tolerance:.1e}", f"{r.error:.1e}", r.steps, r.evaluations, call, r.repeats]
            + [duration(r.samples.fastest), f"{100 * r.samples.spread:.1f} %"]
        )
    head = ("", "error", "tolerance", "error reached", "steps", "evaluations", "for each", "runs a sample", "fastest", "spread")
    return table(head, rows)


def aims(rows):
    """(what, against, ours, theirs, aim): what was asked for, beside what came out; nothing where speed is not measured."""
    if size.SMALL:
        return []
    cells = []
    for what, against, ours, theirs, aim in rows:
        value = ours / theirs if theirs else float("inf")
        met = "met" if value <= aim else f"missed: {value / aim:.2f} times the aim"
        cells.append((what, against, ratio(value), f"≤ {aim}", met))
    return list(table(("work", "Tripos ÷", "ratio", "aim", ""), cells)) if cells else []
