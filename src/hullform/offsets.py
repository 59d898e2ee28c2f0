"""offsets.csv: the stations' curves as a table, one row a point, from keel to deck."""

from __future__ import annotations

import csv
from pathlib import Path

from hullform.body_plan import BodyPlan
from hullform.files import whole_file

COLUMNS = ("station_x_m", "half", "curve", "point", "half_breadth_m", "height_m", "source", "confidence")


def write_offsets(body_plan: BodyPlan, path: Path) -> None:
    """Write every curve of every station, lengths in metres to a tenth of a millimetre.

    Raises:
        OutputError: the file cannot be written.
    """
    with whole_file(path) as aside, aside.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream)
        table.writerow(COLUMNS)
        for station in body_plan.stations:
            for number, curve in enumerate(station.curves):
                for index, (half_breadth, height) in enumerate(curve.points):
                    table.writerow(
                        [
                            f"{station.x_m:.4f}",
                            station.half,
                            number,
                            index,
                            f"{half_breadth:.4f}",
                            f"{height:.4f}",
                            body_plan.source,
                            f"{curve.confidence:.3f}",
                        ]
                    )
