"""Hulls that the reader cannot read alone, corrected as a person would: every station comes right."""

from __future__ import annotations

from pathlib import Path

import pytest
from person import GOOD, corrected, corrections_of
from real_hull import real_hull

from hullform.picture.reading import read_picture
from hullform.picture.sheet.sheet import prepare_sheet
from hullform.review_file import new_review, write_review
from hullform.ship import read_ship

# More than one correction for two stations would be drawing the body plan anew.
MOST_CORRECTIONS_OF_STATIONS = 0.5


@pytest.mark.parametrize("name", ["dtmb5415", "oural"])
def test_every_station_of_a_hard_hull_comes_right(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hull = real_hull(name, tmp_path)
    ship = read_ship(hull.toml)
    sheet = prepare_sheet(ship)
    alone = hull.misfits(corrected(ship, sheet, ()).body_plan)
    corrections = corrections_of(hull, ship, sheet)
    assert len(corrections) <= MOST_CORRECTIONS_OF_STATIONS * len(hull.stations)
    # the review file says the same as the list, and the picture is read with it
    write_review(new_review(ship).model_copy(update={"corrections": tuple(corrections)}), ship)
    reading = read_picture(ship)
    misfits = hull.misfits(reading.body_plan)
    with capsys.disabled():
        kinds = ", ".join(f"{[c.kind for c in corrections].count(k)} {k}" for k in ("deck", "mark", "drawn"))
        wrong = sum(misfit > GOOD for misfit in alone)
        print(f"\n{name}: {wrong} of {len(alone)} stations wrong; {kinds}: worst RMS {max(misfits):.2f} % of B/2")
    # A line of two to three pixels at 830 px for B/2 is drawn by hand to 1 px, 0.12 %; between 15 points a curve with
    # corners departs by as much again.
    assert max(misfits) <= GOOD
    assert reading.unheeded == ()
