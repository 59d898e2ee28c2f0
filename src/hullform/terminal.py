"""The answer on a terminal: every condition's first frequencies, to three significant figures."""

from __future__ import annotations

from hullform.in_service import HARDLY_EXCITED, Resonances
from hullform.outcome import Run
from hullform.rounding import short, significant
from hullvib.model_spread import ratio_uncertainty
from hullvib.real_ships import RATIO_LIMITS, ratios
from hullvib.resonance import SURE_MODES

SHOWN = 3
NOT_DRAWN = ("No drawing: her hull is a form made of these main particulars.",)


def summary(run: Run) -> str:
    """A table of conditions with mass, even-keel draught and the first modes; a star marks those in doubt.

    Frequencies are the headline, in water and with shear deflection, with what the model leaves open of them; the last
    column is the same girder's, dry.
    """
    of_ship = run.ship.particulars
    lines = [
        f"{of_ship.name}: LOA {of_ship.length_overall_m:g} m, LPP {of_ship.length_between_perpendiculars_m:g} m, "
        f"B {of_ship.breadth_m:g} m, D {of_ship.depth_m:g} m, T {of_ship.draught_m:g} m",
        *NOT_DRAWN * (run.body_plan.source == "particulars"),
        f"Vertical bending in {_water(run)} at rest, girder with shear deflection; the last column is dry.",
        "",
        f"{'condition':<14}{'mass, t':>9}{'draught, m':>12}{'mode':>6}{'nodes':>7}"
        f"{'Hz':>10}{'± %':>6}{'cycles/min':>12}{'rad/s':>10}{'dry, Hz':>11}",
    ]
    for name, condition in run.conditions.items():
        modes, dry = condition.modes, condition.dry_modes
        star = "" if all(check.ok for check in (*run.checks, *condition.checks)) else " *"
        first = f"{name + star:<14}{condition.mass_kg / 1e3:>9.0f}{condition.floating.draught_m:>12.2f}"
        for mode in range(SHOWN):
            lines.append(
                f"{first if mode == 0 else '':<35}{mode + 1:>6}{modes.node_counts[mode]:>7}"
                f"{significant(modes.frequencies_hz[mode]):>10}"
                f"{100 * run.in_service[name].uncertainty[mode]:>6.0f}"
                f"{significant(modes.cycles_per_minute[mode]):>12}"
                f"{significant(modes.angular_frequencies[mode]):>10}"
                f"{significant(dry.frequencies_hz[mode]):>11}"
            )
    starred = any(" *" in line for line in lines)
    lines += ["", *_ratios(run)]
    lines += _shaft_speeds(run)
    if starred:
        lines += ["", "* something is wrong with the ship or the condition: see the doubts"]
    return "\n".join(lines)


def _water(run: Run) -> str:
    depth = run.ship.water.depth_m
    return "deep water" if depth is None else f"water {depth:g} m deep (so without the check by strips)"


def _ratios(run: Run) -> list[str]:
    """Frequencies over the first one's, beside those of ships as they are."""
    limits = ", ".join(f"{low:g}-{high:g}" for low, high in RATIO_LIMITS)
    own = []
    for name, condition in run.conditions.items():
        found = zip(ratios(condition.modes.angular_frequencies), ratio_uncertainty(condition.modes)[1:], strict=False)
        own.append(f"{name} {', '.join(f'{significant(ratio)} ± {100 * known:.0f} %' for ratio, known in found)}")
    medium = next(iter(run.conditions.values())).modes.medium
    return [
        f"3-node and 4-node over 2-node frequency, ships in water: {limits}",
        f"  {medium}: {'; '.join(own)}",
    ]


def _shaft_speeds(run: Run) -> list[str]:
    """The shaft speeds to avoid, and what hits a mode at the service speed; a star marks modes 4 and 5."""
    lines = []
    for name, service in run.in_service.items():
        found = service.resonances
        if found is not None:
            spans = ", ".join(f"{significant(low)}-{significant(high)}" for low, high in found.avoid_rpm)
            lines.append(f"  {name}: {spans or 'none'}{_at_service_speed(found)}")
    medium = next(iter(run.in_service.values())).modes.medium
    head = f"shaft speeds to avoid, rpm, by {medium} modes 1 to {SURE_MODES} (a star: a mode above them, less sure)"
    return [head, *lines] if lines else []


def _at_service_speed(found: Resonances) -> str:
    speed = found.given.service_rpm
    if speed is None:
        return ""
    hits = [
        f"{hit.source.name} hits mode {hit.mode}{'*' if hit.flagged else ''}, {_beside(found.margin_of(hit) or 0.0)}"
        f"{' and hardly excites it from there' if found.participation_of(hit) < HARDLY_EXCITED else ''}"
        for hit in found.hits
        if hit.holds(speed)
    ]
    return f"; at the service speed, {short(speed)}: {', '.join(hits) or 'no hit'}"


def _beside(margin: float) -> str:
    """How far an exciting frequency lies from a natural one."""
    return f"{significant(100 * abs(margin), 2)} % {'above' if margin > 0 else 'below'} it"
