# SPDX-License-Identifier: MIT
"""Four panels of a comparison: frame time, utilisation, imbalance, and what is not computation."""

PANELS = [("frame time, ms", [("frame_ms", 1, "")]), ("utilisation, %", [("utilisation", 100, "")]),
          ("imbalance: busiest over mean", [("imbalance", 1, "")]),
          ("share, %", [("waiting", 100, "processors waiting"), ("communication", 100, "communication on the path")])]


def plot(path, rows, title):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    path.parent.mkdir(parents=True, exist_ok=True)
    figure, panels = pyplot.subplots(2, 2, figsize=(max(8, 1.6 * len(rows)), 6.4))
    for axes, (label, bars) in zip(panels.flat, PANELS):
        panel(axes, rows, label, bars)
    figure.suptitle(title, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def panel(axes, rows, label, bars):
    width = 0.8 / len(bars)
    for i, (name, scale, legend) in enumerate(bars):
        places = [place + width * (i - (len(bars) - 1) / 2) for place in range(len(rows))]
        drawn = axes.bar(places, [scale * row.figures[name] for row in rows], width, label=legend or None, color=f"C{i}")
        axes.bar_label(drawn, labels=[shown(bar.get_height()) for bar in drawn], fontsize=7)
    axes.set_xticks(range(len(rows)), [row.machine for row in rows], fontsize=8, rotation=20 if len(rows) > 4 else 0)
    axes.set_ylabel(label, fontsize=8)
    axes.margins(y=0.12)
    axes.grid(axis="y", alpha=0.3)
    axes.set_axisbelow(True)
    if len(bars) > 1:
        axes.legend(fontsize=7, loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2, frameon=False)


def shown(value):
    return f"{value:,.0f}" if value >= 1000 else f"{round(value, 2):.3g}"
