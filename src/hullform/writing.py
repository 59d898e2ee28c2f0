"""The folder of a run: results, report, hull, offsets and girders, all or nothing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from hullform.files import RESULTS_NAME, whole_folder
from hullform.offsets import write_offsets
from hullform.outcome import Run
from hullform.results import write_results
from hullvib.girder_files import write_girder


def write_run(run: Run, folder: Path, progress: Callable[[str], None] = lambda step: None) -> None:
    """Write everything of a run into a folder, which appears whole or not at all.

    Raises:
        OutputError: the folder cannot be written.
    """
    from hullform.hull.mesh_files import export_mesh
    from hullform.report.page import write_report

    with whole_folder(folder) as aside:
        progress("writing the hull, the offsets and the girders")
        export_mesh(run.hull, aside / "hull.stl")
        write_offsets(run.body_plan, aside / "offsets.csv")
        for name, condition in run.conditions.items():
            write_girder(condition.girder, aside / f"girder-{name}.json")
        write_results(run, aside / RESULTS_NAME)
        progress("drawing the report")
        write_report(run, aside)
