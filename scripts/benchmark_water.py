"""Time and error of the added mass of 14 motions: panels, strips and Capytaine on a half-submerged spheroid."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib.util import find_spec
from time import perf_counter

from floating_bodies import SpheroidFlow, UniformMotions, spheroid_panels, spheroid_sections

from hullvib import wet

LENGTH, BREADTH = 160.0, 20.0
LENGTH_OVER_BREADTH = LENGTH / BREADTH
MOTIONS = UniformMotions(LENGTH, 12)
FINENESS = ((32, 8), (44, 11), (64, 16))
SHOWN = (0, 2, 4)  # elastic modes whose errors are shown


def added_masses() -> Iterator[tuple[str, Callable[[], wet.AddedMass]]]:
    """Every way to the added mass, by its name; each call begins anew, since a flow keeps its equations."""
    for lengthwise, girthwise in FINENESS:
        panels = spheroid_panels(LENGTH, BREADTH, lengthwise, girthwise)
        name = f"hullvib panels, {2 * len(panels)} of the whole body"
        yield name, lambda panels=panels: wet.PanelFlow(panels, neutral_axis_m=0.0).added_mass(MOTIONS)
    if find_spec("capytaine"):
        from hullvib.wet.capytaine_flow import CapytaineFlow

        same = spheroid_panels(LENGTH, BREADTH, *FINENESS[1])
        yield f"Capytaine, direct, {2 * len(same)}", lambda: CapytaineFlow(same, neutral_axis_m=0.0).added_mass(MOTIONS)
    sections = spheroid_sections(LENGTH, BREADTH, 45)
    for method, name in (("panels", "sections by panels"), ("lewis", "Lewis sections")):
        yield (
            f"hullvib strips, 45 {name}",
            lambda method=method: wet.StripFlow(sections, method).added_mass(MOTIONS),
        )


def water_table(rounds: int = 5) -> str:
    """A markdown table: errors against the exact series in %, and the best time of the rounds in ms."""
    exact = SpheroidFlow(LENGTH, BREADTH).added_mass(MOTIONS).matrix.diagonal()[2:]
    rows = ["| method | error of mode 1, % | mode 3 | mode 5 | time, ms |", "|---|---|---|---|---|"]
    for name, call in added_masses():
        times = []
        for _ in range(rounds):
            start = perf_counter()
            found = call().matrix
            times.append(perf_counter() - start)
        errors = 100 * (found.diagonal()[2:] / exact - 1)
        shown = " | ".join(f"{errors[mode]:+.2f}" for mode in SHOWN)
        rows.append(f"| {name} | {shown} | {1e3 * min(times):.3g} |")
    return "\n".join(rows)
