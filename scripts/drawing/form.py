"""What the drawn hulls must keep: the displacement that is given, and coefficients in the range of such ships.

Ranges, for the container ship, the tanker, the bulk carrier and the ferry (Cb 0.691, 0.836, 0.793, 0.552):

- midship coefficient: 1 / (1 + (1 - Cb)^3.5) gives 0.984, 0.998, 0.996 and 0.943, 1.006 - 0.0056 Cb^-3.56 (Kerlen)
  0.985, 0.995, 0.993 and 0.959;
- waterplane coefficient: (1 + 2 Cb) / 3 (U sections) gives 0.794, 0.891, 0.862 and 0.701, 0.55 + 0.45 Cb (Kristensen
  and Lützen 2012) 0.861, 0.926, 0.907 and 0.798; counter and transom abaft the aft perpendicular add 0.01 to 0.02;
- LCB in per cent of LPP: 8.80 - 38.9 Fn gives -0.9 for the container ship at 24 knots and -2.4 for the ferry at 23,
  -13.5 + 19.4 Cp (tankers and bulk carriers) +2.8 for the tanker and +1.9 for the bulk carrier; single ships lie up to
  a per cent or so on either side.

Sources: H. Schneekluth and V. Bertram, Ship Design for Efficiency and Economy, 2nd ed. 1998, chapters 1 and 2; the
waterplane formulas were found in print, those for the midship section and LCB are recalled (confidence: medium).
"""

from __future__ import annotations

from drawing.moulded import Moulded

DISPLACEMENT_TOLERANCE = 0.003
LENGTH_TOLERANCE_M = 2e-3  # a section by formula begins where it is 0.1 % of the breadth wide

RANGES = {
    "scim-containership": {"midship": (0.975, 0.992), "waterplane": (0.79, 0.87), "lcb_percent": (-2.5, 0.0)},
    "ds-tanker": {"midship": (0.990, 0.998), "waterplane": (0.88, 0.935), "lcb_percent": (1.5, 3.5)},
    "handymax-bulk-carrier": {"midship": (0.990, 0.998), "waterplane": (0.87, 0.94), "lcb_percent": (1.0, 3.5)},
    "fast-ropax": {"midship": (0.90, 0.97), "waterplane": (0.71, 0.82), "lcb_percent": (-4.0, -1.0)},
    "wigley": {"midship": (0.66666, 0.66667), "waterplane": (0.66666, 0.66667), "lcb_percent": (-1e-6, 1e-6)},
}


def faults(outline: Moulded) -> list[str]:
    """Return what a hull form fails to keep, one sentence each; none for the ships as they are."""
    main = outline.particulars
    found = outline.coefficients()
    midships = main.aft_perpendicular_m + 0.5 * main.length_between_perpendiculars_m
    forward = main.aft_perpendicular_m + main.length_between_perpendiculars_m
    half_breadth, top = outline.deck_edge(midships)
    exact = {
        "half-breadth amidships": (half_breadth, 0.5 * main.breadth_m),
        "depth amidships": (top, main.depth_m),
        "keel amidships": (outline.curves(midships)[0][0, 1], 0.0),
        "half-breadth at the stem head": (outline.deck_edge(main.length_overall_m)[0], 0.0),
        "design waterline's half-breadth at the forward perpendicular": (
            outline.half_breadth_at(forward, main.draught_m),
            0.0,
        ),
    }
    report = [
        f"{what} is {is_:g} m, not {must:g} m"
        for what, (is_, must) in exact.items()
        if abs(is_ - must) > LENGTH_TOLERANCE_M
    ]
    ratio = found["displacement_t"] / main.displacement_t - 1.0
    if abs(ratio) > DISPLACEMENT_TOLERANCE:
        report.append(f"the displacement is {found['displacement_t']:.0f} t, {100 * ratio:+.2f} % off")
    for name, (low, high) in RANGES[outline.name].items():
        if not low <= found[name] <= high:
            report.append(f"{name} is {found[name]:.4f}, outside {low:g} to {high:g}")
    return report
