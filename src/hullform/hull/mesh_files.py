"""The hull as a mesh file."""

from __future__ import annotations

import os
from pathlib import Path

from hullform.errors import OutputError
from hullform.files import whole_file
from hullform.hull.loft import Hull

MESH_SUFFIXES = (".stl", ".obj", ".ply", ".glb")


def export_mesh(hull: Hull, path: str | os.PathLike[str]) -> Path:
    """Write the hull's closed mesh as STL, OBJ, PLY or GLB, by the suffix of the path, and return the path.

    The file appears whole or not at all. Raises OutputError for another suffix or where it cannot be written.
    """
    target = Path(path)
    suffix = target.suffix.lower()
    if suffix not in MESH_SUFFIXES:
        raise OutputError(
            f"{target}: a mesh file ends in one of {', '.join(MESH_SUFFIXES)}, not in '{target.suffix}'; rename it"
        )
    exported = hull.mesh().export(file_type=suffix[1:])
    with whole_file(target) as aside:
        aside.write_bytes(exported.encode() if isinstance(exported, str) else bytes(exported))
    return target
