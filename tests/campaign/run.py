"""Random cases against an independent program: the measured rate of wrong answers.

    run.py BINARY [--count N] [--seed S] [--kind mechanisms|publications|runs|expansions] [--hostile PART] [--saved FOLDER]
           [--write FILE] [--only NUMBER]

Each case is drawn from the seed, its kind and its number alone, so that one case can be repeated with `--only`. The
table gives what became of the cases of each kind. Inputs of wrong answers, panics and time-outs are kept in the folder
`--saved`. Exit status 1 if an answer is wrong without a warning.
"""
import argparse, os, random, shutil, sys, tempfile, time, warnings
import numpy as np
import expansions, mechanisms, publications, runs
from program import Program
from verdict import OUTCOMES, Outcome, Tally

KINDS = {"mechanisms": mechanisms, "publications": publications, "runs": runs, "expansions": expansions}
KEPT = {"wrong", "panic", "time-out"}
BEGIN, END = "<!-- campaign -->", "<!-- end of campaign -->"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binary", help="the program under test")
    parser.add_argument("--count", type=int, default=60, help="number of cases of all kinds together")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", choices=KINDS, action="append", help="this kind alone; may be given several times")
    parser.add_argument("--hostile", type=float, default=0.2, help="part of the cases with extreme numbers")
    parser.add_argument("--saved", default=os.path.join(tempfile.gettempdir(), "campaign"),
                        help="folder of kept inputs")
    parser.add_argument("--write", help="renew the paragraph between the two marks of this file")
    parser.add_argument("--only", type=int, help="the case of this number alone, kept whatever becomes of it")
    parser.add_argument("--seconds", type=float, default=60, help="longest time of one call of the program")
    parser.add_argument("--minutes", type=float, help="begin no case after this time")
    return parser.parse_args()


def one_case(kind, seed, number, hostile, program, folder):
    """The outcome of a case; failures of this program itself are unjudged cases, and say so."""
    source = random.Random(f"{kind} {seed} {number}")
    extreme = source.random() < hostile
    try:
        return KINDS[kind].judge(source, program, folder, extreme)
    except Exception as error:
        if os.environ.get("CAMPAIGN_DEBUG"):
            raise
        return Outcome("unjudged", f"the campaign failed: {type(error).__name__}: {error}")


def main():
    options = arguments()
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    program = Program(options.binary, options.seconds)
    kinds = options.kind or list(KINDS)
    tallies, begun = {kind: Tally() for kind in kinds}, time.time()
    numbers = [options.only] if options.only is not None else range(options.count)
    for number in numbers:
        if options.minutes and time.time() - begun > 60 * options.minutes:
            break
        kind = kinds[number % len(kinds)]
        folder = tempfile.mkdtemp(prefix="campaign_case_")
        outcome = one_case(kind, options.seed, number, options.hostile, program, folder)
        saved = None
        if outcome.outcome in KEPT or options.only is not None:
            saved = os.path.join(options.saved, f"{kind}_{options.seed}_{number}")
            shutil.rmtree(saved, ignore_errors=True)
            shutil.copytree(folder, saved)
            print(f"{outcome.outcome}: {saved}\n  {outcome.reason[:1000]}", flush=True)
        shutil.rmtree(folder, ignore_errors=True)
        tallies[kind].add(outcome, saved)
    print(table(tallies))
    print(f"{program.calls} calls of the program, {time.time() - begun:.0f} s")
    if options.write:
        renew(options.write, paragraph(tallies))
    return 1 if any(t.counts["wrong"] for t in tallies.values()) else 0


def table(tallies):
    """Text of what became of the cases."""
    lines = ["", f"{'kind':14}{'cases':>7}{'right':>7}{'refused':>9}{'undecided':>11}{'wrong':>7}{'panic':>7}"
             f"{'time-out':>10}{'unjudged':>10}{'numbers':>9}{'rate below (95 %)':>20}"]
    for kind, t in tallies.items():
        counts = {outcome: t.counts[outcome] for outcome in OUTCOMES}
        lines.append(f"{kind:14}{t.total:7}{counts['right']:7}{counts['refused']:9}{counts['undecided']:11}"
                     f"{counts['wrong']:7}{counts['panic']:7}{counts['time-out']:10}{counts['unjudged']:10}"
                     f"{t.numbers:9}{t.bound():20.2%}")
    for kind, t in tallies.items():
        for outcome in ("refused", "undecided", "time-out", "unjudged", "right"):
            for reason, count in t.common(outcome):
                lines.append(f"  {kind}, {outcome}, {count}: {reason}")
    for kind, t in tallies.items():
        for outcome, saved, reason in t.saved:
            lines.append(f"  {kind}, {outcome}: {saved}: {reason[:200]}")
    return "\n".join(lines)


def paragraph(tallies):
    """The sentence of the README."""
    total = sum(t.total for t in tallies.values())
    counts = {o: sum(t.counts[o] for t in tallies.values()) for o in OUTCOMES}
    compared = sum(t.numbers for t in tallies.values())
    judged = Tally()
    judged.counts.update(right=counts["right"], wrong=counts["wrong"])
    return (f"Of {total} random cases, Tripos answered {counts['right'] + counts['wrong']} whose truth an independent "
            f"program knows, with {compared} numbers and verdicts. Wrong answers without a warning: {counts['wrong']} "
            f"(a rate below {judged.bound():.1%} at 95 % confidence). Refused with a reason: {counts['refused']}. "
            f"Undecided: {counts['undecided']}. Panics: {counts['panic']}. Time-outs: {counts['time-out']}. The truth "
            f"of {counts['unjudged']} cases is not known.")


def renew(path, text):
    """The file with another paragraph between the two marks."""
    with open(path) as file:
        before, _, rest = file.read().partition(BEGIN)
    if END not in rest:
        raise SystemExit(f"{path} does not have the marks {BEGIN} and {END}")
    import textwrap
    body = textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False)
    with open(path, "w") as file:
        file.write(f"{before}{BEGIN}\n{body}\n{END}{rest.partition(END)[2]}")


if __name__ == "__main__":
    sys.exit(main())
