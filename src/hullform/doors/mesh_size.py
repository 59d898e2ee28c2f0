"""Does a mesh lie in the ship? Its size and place against her particulars, and what to write where it does not."""

from __future__ import annotations

import itertools

from hullform.doors.surface import Surface, axis_vector
from hullform.errors import BodyPlanError
from hullform.ship import Particulars
from hullform.ship_body_plan import METRES_PER, MeshSource, Unit

# Of the length and the breadth: a mesh that is as far off is another ship, or in another unit or turned.
_OTHER_LENGTH, _OTHER_BREADTH = 0.1, 0.25
# Of the length: beyond it a mesh that stops short, or of the breadth one that is broader, is worth a word.
_WORTH_A_WORD = 0.01
# Of the length: a mesh may reach beyond the ship's ends by as much.
_BEYOND = 0.005
# Of the depth: a mesh whose height is as far off may lie on its side; one that is higher carries deckhouses.
_OTHER_DEPTH = 0.5
# Of the depth: how far below the base line, and how high above it, the lowest point of a hull may lie.
_BELOW_BASE, _ABOVE_BASE = 0.2, 0.15
# Of the breadth: the centre plane is known no better.
_OFF_CENTRE = 0.01


def sides_of(surface: Surface, breadth_m: float) -> tuple[int, ...]:
    """Which sides of the centre plane a mesh shows: 1 for y >= 0 and -1 for the other."""
    (_, least, _), (_, greatest, _) = surface.bounds
    near = _OFF_CENTRE * breadth_m
    return (1,) if least > -near else (-1,) if greatest < near else (1, -1)


def require_in_place(surface: Surface, source: MeshSource, main: Particulars) -> tuple[str, ...]:
    """Hold a mesh against the ship; returns doubts.

    Raises:
        BodyPlanError: it is of another size, or lies elsewhere; says what to write in [body_plan].
    """
    (x0, y0, z0), (x1, y1, z1) = ((float(v) for v in row) for row in surface.bounds)
    length, breadth, depth = main.length_overall_m, main.breadth_m, main.depth_m
    if abs((x1 - x0) / length - 1) > _OTHER_LENGTH or not _near(y1 - y0, breadth):
        raise BodyPlanError(
            f"{source.file}: as [body_plan] has it the mesh is {x1 - x0:.4g} m long, {y1 - y0:.4g} m broad and "
            f"{z1 - z0:.4g} m high, the ship {length:g} by {breadth:g} by {depth:g} m; "
            f"{_remedy(surface, source, main)}"
        )
    if abs((z1 - z0) / depth - 1) > _OTHER_DEPTH and (remedy := _better_by_height(surface, source, main)):
        raise BodyPlanError(
            f"{source.file}: as [body_plan] has it the mesh is {y1 - y0:.4g} m broad and {z1 - z0:.4g} m high, the "
            f"ship {breadth:g} by {depth:g} m; {remedy}"
        )
    if x1 - x0 > (1 + 2 * _BEYOND) * length:
        raise BodyPlanError(
            f"{source.file}: the mesh is {x1 - x0:.4g} m long, the ship {length:g} m: correct length_overall_m, or "
            "leave rudders and fenders out of the mesh"
        )
    if x0 < -_BEYOND * length or x1 > (1 + _BEYOND) * length:
        raise BodyPlanError(
            f"{source.file}: the mesh lies from x = {x0:.4g} to {x1:.4g} m, the ship from 0 to {length:g} m; x runs "
            "from the aft end of the length overall: write the place of the mesh's origin there, origin_x_m = "
            f"{source.origin_x_m - x0:.4g} for a mesh that begins at the aft end"
        )
    one_side = y1 - y0 < (1 + _OTHER_BREADTH) * breadth / 2
    plane = min(y0, y1, key=abs) if one_side else (y0 + y1) / 2
    if abs(plane) > _OFF_CENTRE * breadth:
        raise BodyPlanError(
            f"{source.file}: the mesh lies from y = {y0:.4g} to {y1:.4g} m, off the centre plane; write origin_y_m = "
            f"{source.origin_y_m - plane:.4g} for a mesh of {'one side' if one_side else 'both sides'}"
        )
    if not -_BELOW_BASE * depth <= z0 <= _ABOVE_BASE * depth:
        raise BodyPlanError(
            f"{source.file}: the lowest point of the mesh lies at z = {z0:.4g} m, and the base line at 0; write the "
            f"height of the mesh's origin above it, origin_z_m = {source.origin_z_m - z0:.4g} for a keel on the base "
            f'line; where she lies on her back, write up = "{_turned(source.up)}" first'
        )
    return _doubts(source, (x0, x1), (2 if one_side else 1) * (y1 - y0), z1, main)


def _near(breadth_m: float, given_m: float) -> bool:
    """Whether a mesh is about as broad as the ship or as one side of her."""
    return any(abs(breadth_m / wanted - 1) <= _OTHER_BREADTH for wanted in (given_m, given_m / 2))


def _remedy(surface: Surface, source: MeshSource, main: Particulars) -> str:
    """What to write, if another unit or other axes make the mesh the ship."""
    fitting = _fitting(surface, source, main)
    if not fitting:
        return "it is another ship, or only a part of this one: check length_overall_m and breadth_m"
    return _to_write(min(fitting, key=lambda fit: fit[0]), source)


def _better_by_height(surface: Surface, source: MeshSource, main: Particulars) -> str:
    """What to write, if other axes give the mesh the ship's length, breadth and depth too; else nothing."""
    fitting = [fit for fit in _fitting(surface, source, main) if fit[0] < _OTHER_BREADTH]
    return _to_write(min(fitting, key=lambda fit: fit[0]), source) if fitting else ""


def _fitting(surface: Surface, source: MeshSource, main: Particulars) -> list[tuple[float, Unit, str, str]]:
    """How far the height is off, in each unit and axes (ahead, up) in which the mesh is as long and broad as she is."""
    back = {"forward": axis_vector(source.forward), "up": axis_vector(source.up)}
    extent = surface.bounds[1] - surface.bounds[0]
    named = {"forward": extent[0], "port": extent[1], "up": extent[2]}
    raw = {"xyz"[int(abs(vector).argmax())]: named[name] / METRES_PER[source.unit] for name, vector in back.items()}
    (third,) = set("xyz") - set(raw)
    raw[third] = named["port"] / METRES_PER[source.unit]
    units: list[Unit] = [source.unit, *(unit for unit in METRES_PER if unit != source.unit)]
    fitting = []
    for unit, (ahead, across, upright) in itertools.product(units, itertools.permutations("xyz")):
        long, broad, high = (METRES_PER[unit] * raw[axis] for axis in (ahead, across, upright))
        if abs(long / main.length_overall_m - 1) <= _OTHER_LENGTH and _near(broad, main.breadth_m):
            fitting.append((abs(high / main.depth_m - 1), unit, ahead, upright))
    return fitting


def _to_write(fit: tuple[float, Unit, str, str], source: MeshSource) -> str:
    _, unit, ahead, upright = fit
    written = [f'unit = "{unit}"'] if unit != source.unit else []
    if (ahead, upright) != (source.forward[1], source.up[1]):
        forward = source.forward if ahead == source.forward[1] else f"+{ahead}"
        up = source.up if upright == source.up[1] else f"+{upright}"
        written.append(f'forward = "{forward}" and up = "{up}" (or "-", where they point the other way)')
    return f"write {', '.join(written)} in [body_plan]"


def _turned(axis: str) -> str:
    return {"+": "-", "-": "+"}[axis[0]] + axis[1]


def _doubts(
    source: MeshSource, ends_m: tuple[float, float], breadth_m: float, top_m: float, main: Particulars
) -> tuple[str, ...]:
    name, length = source.file.name, main.length_overall_m
    found = []
    if ends_m[0] > _WORTH_A_WORD * length or ends_m[1] < (1 - _WORTH_A_WORD) * length:
        found.append(
            f"{name}: the mesh lies from x = {ends_m[0]:.4g} to {ends_m[1]:.4g} m, short of the ship's 0 to "
            f"{length:g} m by more than {100 * _WORTH_A_WORD:g} %; check origin_x_m and length_overall_m"
        )
    if abs(breadth_m / main.breadth_m - 1) > _WORTH_A_WORD:
        found.append(
            f"{name}: the mesh is {breadth_m:.4g} m broad, {100 * (breadth_m / main.breadth_m - 1):+.1f} % off "
            f"breadth_m, limit {100 * _WORTH_A_WORD:g} %; check unit and breadth_m"
        )
    if source.up_to_m is None and top_m > (1 + _OTHER_DEPTH) * main.depth_m:
        found.append(
            f"{name}: the mesh reaches z = {top_m:.4g} m, {top_m / main.depth_m:.2g} times the depth of "
            f"{main.depth_m:g} m; leave out deckhouses and funnel: write up_to_m = {main.depth_m:g}, or as high as her "
            "sheer goes"
        )
    if top_m < main.draught_m * (1 - _WORTH_A_WORD):
        found.append(
            f"{name}: the mesh ends at z = {top_m:.4g} m, below the design draught of {main.draught_m:g} m; export "
            "the hull up to her deck, or check origin_z_m"
        )
    return tuple(found)
