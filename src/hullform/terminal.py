"""The answer on a terminal: every condition's first frequencies, to three significant figures."""

from __future__ import annotations

from hullform.outcome import Run
from hullform.rounding import significant

SHOWN = 3
NOT_DRAWN = ("No drawing: her hull is a form made of these main particulars.",)


def summary(run: Run) -> str:
    """A table of conditions with mass, even-keel draught and the first modes; a star marks those in doubt.

    Frequencies are the headline, with shear deflection; the last column is the Euler-Bernoulli girder's.
    """
    of_ship = run.ship.particulars
    lines = [
        f"{of_ship.name}: LOA {of_ship.length_overall_m:g} m, LPP {of_ship.length_between_perpendiculars_m:g} m, "
        f"B {of_ship.breadth_m:g} m, D {of_ship.depth_m:g} m, T {of_ship.draught_m:g} m",
        *NOT_DRAWN * (run.body_plan.source == "particulars"),
        "Vertical bending, dry girder with shear deflection; the water is not in these figures.",
        "",
        f"{'condition':<14}{'mass, t':>9}{'draught, m':>12}{'mode':>6}{'nodes':>7}"
        f"{'Hz':>10}{'cycles/min':>12}{'rad/s':>10}{'Euler, Hz':>11}",
    ]
    for name, condition in run.conditions.items():
        modes, euler = condition.modes, condition.solutions["stodola_ritz"]
        star = "" if all(check.ok for check in (*run.checks, *condition.checks)) else " *"
        first = f"{name + star:<14}{condition.mass_kg / 1e3:>9.0f}{condition.floating.draught_m:>12.2f}"
        for mode in range(SHOWN):
            lines.append(
                f"{first if mode == 0 else '':<35}{mode + 1:>6}{modes.node_counts[mode]:>7}"
                f"{significant(modes.frequencies_hz[mode]):>10}"
                f"{significant(modes.cycles_per_minute[mode]):>12}"
                f"{significant(modes.angular_frequencies[mode]):>10}"
                f"{significant(euler.frequencies_hz[mode]):>11}"
            )
    if any(" *" in line for line in lines):
        lines += ["", "* something is wrong with the ship or the condition: see the doubts"]
    return "\n".join(lines)
