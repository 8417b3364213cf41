"""Draws docs/figures/lengths.svg of docs/figures/lengths.csv: `growth_figure.py DATA FIGURE`."""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  the backend comes first
from matplotlib.lines import Line2D  # noqa: E402

# Okabe and Ito's colours, told apart by everyone.
COLOURS = {"absolute": "#0072B2", "relative": "#D55E00", "arm": "#009E73"}
NAMES = {"absolute": "links, angles from one frame", "relative": "links, angles from the link before", "arm": "arms, full inertias"}
PANELS = (
    ("derivation_s", 1.0, "derivation of the accelerations / s"),
    ("operations", 1.0, "operations of the accelerations"),
    ("state_ns", 1.0, "time of a state / ns"),
)


def curves(path, column):
    """(family, tool) to its points; of the other tools the least."""
    points = defaultdict(dict)
    for row in csv.DictReader(open(path)):
        if not row[column]:
            continue
        tool = "Tripos" if row["tool"].startswith("Tripos") else "CasADi"
        n, value = int(row["n"]), float(row[column])
        of = points[row["family"], tool]
        of[n] = min(value, of.get(n, value))
    return points


def main():
    data, figure = sys.argv[1:]
    plt.rcParams.update({"svg.hashsalt": "growth", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    whole, axes = plt.subplots(1, len(PANELS), figsize=(9.6, 3.4))
    for axis, (column, scale, title) in zip(axes, PANELS):
        for (family, tool), points in curves(data, column).items():
            ns = sorted(points)
            ours = tool == "Tripos"
            style = {"linestyle": "-" if ours else "--", "marker": "o" if ours else "s", "markerfacecolor": None if ours else "white"}
            axis.plot(ns, [scale * points[n] for n in ns], color=COLOURS[family], markersize=4, linewidth=1.4, **style)
        axis.set(xscale="log", yscale="log", xlabel="n", title=title)
        axis.set_xticks([2, 5, 10, 20, 40], labels=["2", "5", "10", "20", "40"])
        axis.minorticks_off()
        axis.grid(alpha=0.3, linewidth=0.5)
        axis.title.set_fontsize(9)
    handles = [Line2D([], [], color=COLOURS[family], label=NAMES[family]) for family in COLOURS]
    handles += [
        Line2D([], [], color="#444444", marker="o", markersize=4, label="Tripos, Kane's method"),
        Line2D([], [], color="#444444", marker="s", markersize=4, markerfacecolor="white", linestyle="--", label="CasADi at its best"),
    ]
    whole.legend(handles=handles, loc="lower center", ncols=5, frameon=False, fontsize=8)
    whole.tight_layout(rect=(0, 0.08, 1, 1))
    whole.savefig(figure, metadata={"Date": None})


main()
