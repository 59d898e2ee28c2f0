"""The hull in three dimensions: a view to turn with the mouse, and a still one where the browser cannot.

The surface is made anew from the hull's sections, with an edge along the design waterline and smooth shading between
the edges; hull.stl holds the mesh for other programs.
"""

from __future__ import annotations

import io
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hullform.hull.contours import ON_THE_CENTRE_LINE, Contours
from hullform.hull.loft import Hull
from hullform.report.drawing import Picture

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

# Points a side of each section: below the waterline, above it.
POINTS_BELOW = 17
POINTS_ABOVE = 9
# Fine points of a section that the drawn ones are taken from.
FINE_POINTS = 97
# Of a polyline section's points, on one side, about so many are drawn.
COLUMNS = 29

ANTIFOULING = (142, 62, 48)
TOPSIDE = (44, 68, 92)
DECK = (163, 170, 174)

# Where the eye is, seen from the hull: three quarters from forward, to port, above.
EYE = np.array([0.58, 0.72, 0.3])
LIGHT = np.array([0.35, 0.75, 0.56])
AMBIENT = 0.42
CAMERA_DISTANCE = 1.45  # lengths of the ship
STILL_WIDTH_PX = 1500
STILL_DPI = 150


@dataclass(frozen=True, eq=False)
class Patch:
    """One smooth part of the surface: a grid (rows, columns, 3) of points in m, seen from either side; its colour."""

    grid: Array
    colour: tuple[int, int, int]

    @property
    def faces(self) -> Faces:
        """Two triangles a cell, (n, 3) indices of the flattened grid, without those of no area or in the centre plane.

        In the centre plane port and starboard lie back to back, between a bulb and the stem above it: there is no hull.
        """
        rows, columns, _ = self.grid.shape
        number = np.arange(rows * columns).reshape(rows, columns)
        a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
        halves = [np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)]
        faces = np.concatenate(halves)
        corner = self.grid.reshape(-1, 3)[faces]
        twice_area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
        off_centre = np.abs(corner[..., 1]).max(axis=1) > 1e-6 * np.abs(self.grid[..., 1]).max()
        return np.asarray(faces[off_centre & (twice_area > 1e-9 * twice_area.max())])


def surface(hull: Hull, draught_m: float) -> tuple[Patch, ...]:
    """Bottom, both sides above the waterline, deck and the two ends, as patches with outward normals."""
    if isinstance(hull.sections, Contours):
        below, above = _parted_in_place(hull.sections, draught_m)
    else:
        below, above = _parted_anew(hull, draught_m)
    x = hull.x_m
    port_below, port_above = _at(x, below), _at(x, above)
    bottom = np.concatenate([_mirrored(port_below)[:, :0:-1], port_below], axis=1)
    edge = port_above[:, -1:]
    deck = np.concatenate([edge, _mirrored(edge)], axis=1)
    ends = [_at(x, np.concatenate([below, above[:, 1:]], axis=1))[end][None] for end in (0, -1)]
    aft, fore = (np.concatenate([end, _mirrored(end)], axis=0) for end in ends)
    return (
        Patch(bottom, ANTIFOULING),
        Patch(port_above, TOPSIDE),
        Patch(_mirrored(port_above)[:, ::-1], TOPSIDE),
        Patch(deck, DECK),
        Patch(aft[::-1], TOPSIDE),
        Patch(fore, TOPSIDE),
    )


def _parted_anew(hull: Hull, draught_m: float) -> tuple[Array, Array]:
    """Points (stations, k, 2) of the sections below the waterline and above it, even along either part."""
    fine = hull.section_points(FINE_POINTS)
    share = np.linspace(0.0, 1.0, FINE_POINTS)
    below, above = np.empty((len(fine), POINTS_BELOW, 2)), np.empty((len(fine), POINTS_ABOVE, 2))
    for section, low, high in zip(fine, below, above, strict=True):
        y, z = section.T
        at_water = _share_at_water(z, draught_m)
        low_share = at_water * np.linspace(0.0, 1.0, POINTS_BELOW)
        high_share = at_water + (1.0 - at_water) * np.linspace(0.0, 1.0, POINTS_ABOVE)
        low[:] = np.column_stack([np.interp(low_share, share, y), np.interp(low_share, share, z)])
        high[:] = np.column_stack([np.interp(high_share, share, y), np.interp(high_share, share, z)])
    return below, above


def _parted_in_place(sections: Contours, draught_m: float) -> tuple[Array, Array]:
    """The same of polylines, at their matched points: those beyond the waterline come together on it.

    So the edges of what there is between a bulb and the stem, which is nothing, stay where they are.
    """
    outline = sections.outline
    count = outline.shape[1]
    on = outline[..., 0] <= ON_THE_CENTRE_LINE * outline[..., 0].max()
    (edges,) = np.nonzero((on[:, 1:] != on[:, :-1]).any(axis=0))
    columns = np.unique(np.concatenate([np.linspace(0, count - 1, COLUMNS).astype(int), edges, edges + 1]))
    points = outline[:, columns]
    below, above = points.copy(), points.copy()
    for section, low, high in zip(points, below, above, strict=True):
        along = _share_at_water(section[:, 1], draught_m) * (len(columns) - 1)
        number = np.arange(len(columns))
        at_water = [np.interp(along, number, values) for values in section.T]
        low[number > along] = at_water
        high[number < along] = at_water
    return below, above


def _share_at_water(z: Array, draught_m: float) -> float:
    """How far along a section, of the whole, it comes up through the waterline, the last time if it does so again."""
    (rising,) = np.nonzero((z[:-1] < draught_m) & (z[1:] >= draught_m))
    if not len(rising):
        return 0.0 if z[-1] >= draught_m else 1.0
    last = int(rising[-1])
    return float((last + (draught_m - z[last]) / (z[last + 1] - z[last])) / (len(z) - 1))


def still_picture(hull: Hull, draught_m: float) -> Picture:
    """The hull in parallel projection from forward, shaded by the angle to the light, far faces first."""
    from matplotlib.collections import PolyCollection
    from matplotlib.figure import Figure

    toward = EYE / np.linalg.norm(EYE)
    right = np.cross([0.0, 0.0, 1.0], toward)
    right /= np.linalg.norm(right)
    up = np.cross(toward, right)
    light = LIGHT / np.linalg.norm(LIGHT)
    outlines, depths, colours = [], [], []
    for patch in surface(hull, draught_m):
        corner = patch.grid.reshape(-1, 3)[patch.faces]
        normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        seen = normal @ toward > 0
        corner, normal = corner[seen], normal[seen]
        lit = AMBIENT + (1 - AMBIENT) * np.clip(normal @ light, 0.0, 1.0)
        outlines.append(np.stack([corner @ right, corner @ up], axis=-1))
        # nothing stands on the deck, and its long triangles have no one depth: it comes last
        depths.append(np.where(patch.colour == DECK, np.inf, (corner @ toward).mean(axis=1)))
        colours.append(np.clip(lit[:, None] * np.array(patch.colour) / 255 * 1.25, 0.0, 1.0))
    order = np.argsort(np.concatenate(depths))
    triangles, colour = np.concatenate(outlines)[order], np.concatenate(colours)[order]
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    margin = 0.03 * (high - low).max()
    low, high = low - margin, high + margin
    width = STILL_WIDTH_PX / STILL_DPI
    figure = Figure(figsize=(width, width * (high[1] - low[1]) / (high[0] - low[0])))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    # an edge in the face's own colour closes the hairlines between neighbours
    axes.add_collection(PolyCollection(list(triangles), facecolors=colour, edgecolors=colour, linewidths=0.4))
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=STILL_DPI, metadata={"Software": None})
    return Picture(
        "hull",
        f"The lofted hull from forward, to the design waterline at {draught_m:g} m in red.",
        "The hull from three quarters forward and above, its underwater part in red.",
        "png",
        stream.getvalue(),
    )


def viewer_page(hull: Hull, draught_m: float) -> str:
    """A whole HTML page that shows the hull with three.js, for an inner frame; it asks nothing of any network."""
    import trimesh
    from trimesh.viewer import scene_to_html

    # three.js holds y for up
    scene = trimesh.Scene()
    visual: Any = trimesh.visual
    middle = np.array([hull.length_overall_m / 2, 0.0, hull.depth_moulded_m / 2])
    for patch in surface(hull, draught_m):
        points = (patch.grid.reshape(-1, 3) - middle)[:, [0, 2, 1]] * [1.0, 1.0, -1.0]
        mesh = trimesh.Trimesh(points, patch.faces, process=False)
        mesh.remove_unreferenced_vertices()
        material = visual.material.PBRMaterial(
            baseColorFactor=[*patch.colour, 255], metallicFactor=0.0, roughnessFactor=0.75, doubleSided=True
        )
        mesh.visual = visual.TextureVisuals(material=material)
        _ = mesh.vertex_normals
        scene.add_geometry(mesh)
    scene.camera.fov = (32.0, 20.0)
    scene.camera_transform = _camera(hull.length_overall_m)
    page = scene_to_html(scene)
    return page.replace("</body>", f"<script>{_VIEWER_ADDITIONS}</script></body>")


# Light from the sky, so that the side away from the eye's lamp is not black; a quiet ground. The wheel scrolls the
# report until the hull is clicked, then zooms. What the viewer loads late is waited for.
_VIEWER_ADDITIONS = """
scene.background = new THREE.Color(0xf3f5f7);
scene.add(new THREE.HemisphereLight(0xffffff, 0x9aa7b4, 0.55));
tracklight.intensity = 0.85;
(function wait() {
  if (!controls || !camera) { requestAnimationFrame(wait); return; }
  controls.noZoom = true;
  controls.noPan = true;
  controls.rotateSpeed = 2.2;
  window.addEventListener("pointerdown", function () { controls.noZoom = false; });
  window.addEventListener("blur", function () { controls.noZoom = true; });
  // a narrow frame needs a farther eye
  camera.position.multiplyScalar(Math.max(1, 2.2 / camera.aspect));
  controls.update();
  document.documentElement.dataset.ready = "yes";
  render();
})();
"""


def _camera(length_m: float) -> Array:
    """The camera's placement (4, 4) in three.js axes, looking at the origin from EYE."""
    back = np.array([EYE[0], EYE[2], -EYE[1]])
    back /= np.linalg.norm(back)
    right = np.cross([0.0, 1.0, 0.0], back)
    right /= np.linalg.norm(right)
    placement = np.eye(4)
    placement[:3, 0], placement[:3, 1], placement[:3, 2] = right, np.cross(back, right), back
    placement[:3, 3] = CAMERA_DISTANCE * length_m * back
    return placement


def _at(x: Array, points: Array) -> Array:
    """Points (stations, n, 3) of sections [y, z] (stations, n, 2) at x (stations,)."""
    along = np.broadcast_to(x[:, None, None], (*points.shape[:2], 1))
    return np.concatenate([along, points], axis=-1)


def _mirrored(grid: Array) -> Array:
    return grid * [1.0, -1.0, 1.0]
