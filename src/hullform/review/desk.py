"""The desk of one review: the ship, the picture made ready, and the reading that follows from what a person says."""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.errors import HullformError, PictureError
from hullform.picture.image.image_files import load_grey
from hullform.picture.reading import PictureReading, read_sheet
from hullform.picture.sheet.sheet import Sheet, prepare_sheet
from hullform.review.strip import straightened
from hullform.review.view import reading_document
from hullform.review_file import Review, checked_review, new_review, read_review, revision_of, write_review
from hullform.ship import Ship
from hullform.ship_body_plan import SAME_STATION_M

Document = dict[str, Any]

SHEETS_KEPT = 3  # calibrations that undo and redo go back to at once


class SupersededError(Exception):
    """A later state of the review asked for a reading before this one began."""


class OverwritingError(Exception):
    """The review file has changed since the page that would save read it.

    Attributes:
        revision: of the file as it lies there now.
    """

    def __init__(self, message: str, revision: str) -> None:
        super().__init__(message)
        self.revision = revision


class Desk:
    """Reads the picture as a review has it, one reading at a time; the latest that was asked for wins.

    Raises:
        PictureError: the picture cannot be read.
        ReviewError: the review that lies there is damaged, or was made of another picture.
    """

    def __init__(self, ship: Ship) -> None:
        self.ship = ship
        self._saved()  # so that a damaged review is told before a page opens
        rows, columns = load_grey(ship.picture.image_path, ship.picture.page).shape
        self.size_px = (columns, rows)
        self._sheets: OrderedDict[str, Sheet] = OrderedDict()
        self._reading: PictureReading | None = None
        self._working = threading.Lock()
        self._counting = threading.Lock()
        self._saving = threading.Lock()
        self._asked = 0

    def opening(self) -> Document:
        """What the page needs to open: the ship, the picture, the saved review, its reading or why there is none.

        Raises:
            ReviewError: the review that lies there by now is damaged, or was made of another picture.
        """
        source, main = self.ship.picture, self.ship.particulars
        with self._saving:
            saved, revision = self._saved(), revision_of(self.ship)
        document: Document = {
            "ship": {
                "name": main.name,
                "file": str(self.ship.path),
                "length_overall_m": main.length_overall_m,
                "breadth_m": main.breadth_m,
                "depth_m": main.depth_m,
                "draught_m": main.draught_m,
                "stations": {
                    "aft_side": source.aft_side,
                    "aft_stations_m": list(source.aft_stations_m),
                    "fore_stations_m": list(source.fore_stations_m),
                    "aft_station_names": list(source.aft_station_names),
                    "fore_station_names": list(source.fore_station_names),
                },
                "marks": len(source.marks),
                "calibrated": source.calibration is not None,
            },
            "picture": {"file": source.image, "width_px": self.size_px[0], "height_px": self.size_px[1]},
            "review_file": self.ship.review_path.name,
            "saved_before": self.ship.review_path.exists(),
            "review": review_document(saved),
            "revision": revision,
        }
        try:
            return document | {"reading": self.solve(document["review"]), "failure": None}
        except HullformError as error:
            return document | {"reading": None, "failure": str(error)}

    def solve(self, document: Document) -> Document:
        """Read the picture again, as a review has it.

        Args:
            document: a whole review file.

        Raises:
            ReviewError: it is no review of this picture.
            PictureError: nothing can be read with this calibration and these stations.
            SupersededError: a later one was asked for meanwhile.
        """
        with self._counting:
            self._asked += 1
            ticket = self._asked
        with self._working:
            if ticket != self._asked:
                raise SupersededError("a later change is being read")
            began = time.perf_counter()
            review = checked_review(document, self.ship)
            ship = review.applied_to(self.ship)
            sheet = self._sheet(ship)
            reading = read_sheet(sheet, ship, review.corrections)
            self._reading = reading
            view = reading_document(sheet, reading, ship)
            return view | {"seconds": time.perf_counter() - began}

    def save(self, document: Document, revision: str) -> tuple[Path, str]:
        """Write a review beside ship.toml; returns the path, and the revision that the file then has.

        Args:
            document: a whole review file.
            revision: of the file that the page went on from; only that one is written over.

        Raises:
            ReviewError: it is no review of this picture.
            OverwritingError: the file is of another revision.
            OutputError: it cannot be written.
        """
        review = checked_review(document, self.ship)
        review.applied_to(self.ship)
        with self._saving:
            found = revision_of(self.ship)
            if found != revision:
                raise OverwritingError(
                    f"{self.ship.review_path.name} was changed since this page read it, by another page or program. "
                    "Load this page again to go on from that file (what is not saved here is lost then), or save over "
                    "it",
                    found,
                )
            path = write_review(review, self.ship)
            return path, revision_of(self.ship)

    def strip(self, half: str, station_m: float, curve: int) -> bytes:
        """A PNG of the picture along a station's curve, straightened: keel left, deck right.

        Raises:
            PictureError: there is no such curve.
        """
        reading = self._reading
        if reading is not None:
            for station in reading.body_plan.stations:
                if station.half == half and abs(station.x_m - station_m) <= SAME_STATION_M:
                    return _png(straightened(reading, station, int(np.clip(curve, 0, len(station.curves) - 1))))
        raise PictureError(f"station {station_m:g} m of the {half} half has no curve")

    def _saved(self) -> Review:
        return read_review(self.ship) or new_review(self.ship)

    def _sheet(self, ship: Ship) -> Sheet:
        source = ship.picture
        given = "" if source.calibration is None else source.calibration.model_dump_json()
        key = f"{source.aft_side} {given}"
        if key not in self._sheets:
            self._sheets[key] = prepare_sheet(ship)
            while len(self._sheets) > SHEETS_KEPT:
                self._sheets.popitem(last=False)
        self._sheets.move_to_end(key)
        return self._sheets[key]


def review_document(review: Review) -> Document:
    """A review as its file has it."""
    return review.model_dump(mode="json", by_alias=True, exclude_none=True)


def _png(image: NDArray[np.uint8]) -> bytes:
    _, data = cv2.imencode(".png", image)
    return data.tobytes()
