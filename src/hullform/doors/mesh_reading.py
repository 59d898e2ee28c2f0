"""A mesh as a body plan: cut across into stations, after a look at what is wrong with it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from hullform.body_plan import BodyPlan, Half, Station, TracedCurve
from hullform.doors.cutting import cut
from hullform.doors.half_sections import HalfSection, Sizes, half_section
from hullform.doors.mesh_size import require_in_place, sides_of
from hullform.doors.points import enough_points
from hullform.doors.surface import Surface, edges_of, load_surface
from hullform.errors import BodyPlanError
from hullform.hull.drawn import station_places
from hullform.ship import Ship
from hullform.ship_body_plan import MeshSource

Array = NDArray[np.float64]

# Cuts among which the stations are found, beside those through rows of vertices, and the fewest stations.
CUTS, FEWEST = 161, 25
# Vertices in a plane across the ship that make a row, where a surface may have a crease.
_ROW = 16
# By how much the area of a cut may be off the curve through the stations: by this share of itself, but no less than the
# second and no more than the third of the largest.
_OFF_THE_AREA, _LEAST_OFF, _OFF_THE_CURVE = 2e-3, 2e-4, 8e-4
# Of the length: so far from the ends of the mesh the first and the last cut may lie, the nearest that has a section.
_FROM_THE_END = (1e-5, 1e-4, 1e-3, 3e-3)
# Places along the ship are told to the millimetre.
_DECIMALS = 3
# Of the breadth: `Sizes`.
_CENTRE, _SEAM, _BRIDGE = 1e-6, 1e-4, 0.1
# Of the largest section: what is left out, and by how much the two sides may differ, without a word.
_APART, _UNLIKE = 0.002, 0.005


@dataclass(frozen=True)
class Flaws:
    """What is wrong with the triangles of a mesh.

    Attributes:
        edges: of all triangles.
        open: edges of one triangle only.
        crowded: edges of three or more.
        wound_against: edges whose two triangles are wound against each other.
        inside_out: whether the normals of a closed mesh point inwards.
    """

    edges: int
    open: int
    crowded: int
    wound_against: int
    inside_out: bool


def flaws_of(surface: Surface) -> Flaws:
    """Count what is wrong with a surface; cutting it needs no winding and bridges holes."""
    edges, count, upwards = edges_of(surface.faces)
    corners = surface.vertices[surface.faces]
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    closed = not (count != 2).any()
    return Flaws(
        edges=len(edges),
        open=int((count == 1).sum()),
        crowded=int((count > 2).sum()),
        wound_against=int(((count == 2) & (upwards != 1)).sum()),
        inside_out=bool(closed and volume < 0),
    )


def read_mesh(ship: Ship, source: MeshSource) -> BodyPlan:
    """Cut a ship's mesh into stations; `docs/ship-file.md` says where its axes lie.

    Args:
        ship: whose particulars the mesh is held against.
        source: [body_plan] of her ship.toml.

    Raises:
        BodyPlanError: no mesh, one of another size or elsewhere, off the centre plane, a hole too wide to be bridged.
    """
    surface, main = load_surface(source), ship.particulars
    doubts = list(require_in_place(surface, source, main))
    notes = [f"{source.file.name}: {len(surface.faces)} triangles", *_notes_of(source, flaws_of(surface))]
    sides = sides_of(surface, main.breadth_m)
    breadth = main.breadth_m
    sizes = Sizes(_CENTRE * breadth, _SEAM * breadth, _BRIDGE * breadth, main.draught_m)

    def at(x_m: float) -> list[HalfSection]:
        chains = cut(surface, x_m)
        return [half_section(chains, side, sizes, source.up_to_m) for side in sides]

    if source.stations_m:
        found = {x: at(x) for x in source.stations_m}
    else:
        first, last = np.clip(surface.bounds[:, 0], 0.0, main.length_overall_m)
        found = _cut_where_it_changes(at, float(first), float(last), _rows(surface), main.draught_m)
    _require_whole(source, found, sizes)
    midships = main.aft_perpendicular_m + main.length_between_perpendiculars_m / 2
    stations = tuple(
        _station(x, "aft" if x < midships else "fore", halves[0]) for x, halves in found.items() if halves[0].curves
    )
    if not stations:
        raise BodyPlanError(
            f"{source.file}: no section of the mesh reaches the centre plane, y = 0; export a hull of one body, or "
            "write origin_y_m in [body_plan] where her centre plane lies elsewhere"
        )
    bare = [f"{x:.4g}" for x, halves in found.items() if not halves[0].curves]
    if bare:
        doubts.append(f"{source.file.name}: there is no section at x = {', '.join(bare)} m; check the mesh there")
    if len(sides) == 1:
        notes.append("the mesh is of one side; the other is taken for its mirror image")
    notes += _notes_of_holes(found)
    doubts += _doubts_of_sections(source, stations, found)
    try:
        return BodyPlan(stations, "mesh", notes=tuple(notes), doubts=tuple(doubts))
    except BodyPlanError as error:
        raise BodyPlanError(f"{source.file}: {error}") from None


def _cut_where_it_changes(
    at: Callable[[float], list[HalfSection]], first_m: float, last_m: float, rows_m: Array, draught_m: float
) -> dict[float, list[HalfSection]]:
    """Cut between two places in many, rows of vertices among them, and keep what a curve cannot do without.

    The curve is a monotone cubic, as between the stations of a hull; the areas are those below draught and deck.
    """
    insets = [round(share * (last_m - first_m), _DECIMALS) for share in _FROM_THE_END]
    ends = [
        next((x for x in near if at(x)[0].curves), near[-1])
        for near in ([round(end + sign * d, _DECIMALS) for d in insets] for end, sign in ((first_m, 1), (last_m, -1)))
    ]
    rows = rows_m[(rows_m > ends[0]) & (rows_m < ends[1])]
    x = np.unique(np.round(np.append(ends[0] + station_places(ends[1] - ends[0], CUTS), rows), _DECIMALS))
    halves = [at(place) for place in x.tolist()]
    areas = np.array([_areas(section, draught_m) for section in halves])
    areas = areas[:, areas.max(axis=0) > 0]
    limit = np.clip(_OFF_THE_AREA * areas, *(share * areas.max(axis=0) for share in (_LEAST_OFF, _OFF_THE_CURVE)))
    kept = np.zeros(len(x), dtype=bool)
    kept[np.linspace(0, len(x) - 1, FEWEST).round().astype(int)] = True
    while True:
        over = (np.abs(areas - PchipInterpolator(x[kept], areas[kept])(x)) / limit).max(axis=1, initial=0.0)
        part = np.cumsum(kept)
        # of every part between two stations that has one, the cut that is the furthest off
        worst = [int(np.argmax(np.where(part == number, over, 0.0))) for number in np.unique(part[over > 1])]
        if not worst:
            return {float(x[i]): halves[i] for i in np.flatnonzero(kept)}
        kept[worst] = True


def _rows(surface: Surface) -> Array:
    """x in m of the planes across the ship in which there are many vertices: where it was lofted, or its frames."""
    x, count = np.unique(np.round(surface.vertices[np.unique(surface.faces), 0], _DECIMALS), return_counts=True)
    return np.asarray(x[count >= _ROW])


def _areas(halves: Sequence[HalfSection], draught_m: float) -> tuple[float, float]:
    """Of one side, in m2: the whole of it, and below a draught."""
    if not halves[0].curves:
        return 0.0, 0.0
    section = Station(0.0, "aft", tuple(TracedCurve(curve[:, 0], curve[:, 1]) for curve in halves[0].curves))
    return section.area_below(np.inf) / 2, section.area_below(draught_m) / 2


def _station(x_m: float, half: Half, section: HalfSection) -> Station:
    curves = (enough_points(curve) for curve in section.curves)
    return Station(x_m, half, tuple(TracedCurve(curve[:, 0], curve[:, 1]) for curve in curves), name=f"{x_m:.2f}")


def _require_whole(source: MeshSource, found: dict[float, list[HalfSection]], sizes: Sizes) -> None:
    """Refuse sections that no straight line closes, or of more contours than a hull has."""
    for x, halves in found.items():
        for section in halves:
            if section.open_at_m is not None:
                raise BodyPlanError(
                    f"{source.file}: the section at x = {x:.4g} m ends in the air at z = {section.open_at_m:.3g} m, "
                    f"at a hole wider than {sizes.bridge:.3g} m or at an inner deck or bulkhead; close the hole, or "
                    "export the outer shell alone"
                )
            curves = section.curves
            if len(curves) == 2 and curves[0][-1, 1] > curves[1][0, 1]:
                raise BodyPlanError(
                    f"{source.file}: the section at x = {x:.4g} m has one contour within another, from z = "
                    f"{curves[1][0, 1]:.3g} to {curves[1][-1, 1]:.3g} m; export the outer shell alone, without decks "
                    "and tanks"
                )
            if len(curves) > 2:
                raise BodyPlanError(
                    f"{source.file}: the section at x = {x:.4g} m has {len(curves)} contours one above the other, and "
                    "a hull has one, or two at a bulb; export the outer shell alone, without decks and tanks"
                )


def _notes_of(source: MeshSource, flaws: Flaws) -> list[str]:
    notes = []
    if flaws.wound_against:
        notes.append(
            f"{flaws.wound_against} of {flaws.edges} edges have triangles that are wound against each other (flipped "
            "normals); the sections do not depend on the winding"
        )
    if flaws.inside_out:
        notes.append("the normals of the mesh point inwards; the sections do not depend on them")
    if flaws.open:
        notes.append(f"the mesh is open along {flaws.open} of {flaws.edges} edges")
    if flaws.crowded:
        notes.append(f"{flaws.crowded} edges have three triangles or more: the mesh holds more than a shell")
    return notes


def _notes_of_holes(found: dict[float, list[HalfSection]]) -> list[str]:
    holes = [(x, z, width) for x, halves in found.items() for section in halves for z, width in section.bridged]
    if not holes:
        return []
    x, z, width = max(holes, key=lambda hole: hole[2])
    stations = len({x for x, *_ in holes})
    return [
        f"a hole was closed by straight lines in {stations} of {len(found)} sections, the widest of {width:.3g} m at "
        f"x = {x:.4g} m, z = {z:.3g} m"
    ]


def _doubts_of_sections(
    source: MeshSource, stations: Sequence[Station], found: dict[float, list[HalfSection]]
) -> list[str]:
    doubts = []
    largest = max(station.area_below(np.inf) for station in stations)
    apart = [(2 * halves[0].apart_m2, x) for x, halves in found.items() if 2 * halves[0].apart_m2 > _APART * largest]
    if apart:
        area, x = max(apart)
        doubts.append(
            f"{source.file.name}: {len(apart)} sections have a part clear of the centre plane, which was left out: up "
            f"to {100 * area / largest:.1f} % of the largest section, at x = {x:.4g} m; export the hull without "
            "appendages"
        )
    both = [(x, *(_areas([half], np.inf)[0] for half in halves)) for x, halves in found.items() if len(halves) == 2]
    unlike = [(abs(one - other), x) for x, one, other in both if abs(one - other) > _UNLIKE * largest / 2]
    if unlike:
        difference, x = max(unlike)
        doubts.append(
            f"{source.file.name}: the two sides differ in {len(unlike)} sections, by up to "
            f"{200 * difference / largest:.1f} % of the largest, at x = {x:.4g} m; the port side was taken for both"
        )
    return doubts
