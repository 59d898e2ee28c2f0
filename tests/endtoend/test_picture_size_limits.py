"""The largest picture that is accepted: read right, within bounded memory."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "bodyplans" / "scim-containership"
LARGEST_PEAK_MB = 1500.0
# the high-water mark of the process itself: that of getrusage may be its parent's
READ = """
import sys
from pathlib import Path
from hullform.picture.reading import read_picture
from hullform.ship import read_ship
reading = read_picture(read_ship(Path(sys.argv[1])))
peak = next(line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM"))
print(int(peak.split()[1]) / 1024, len(reading.body_plan.stations), len(reading.body_plan.doubts))
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the peak of memory is read from /proc")
def test_sixty_megapixels_in_colour_fit_in_memory(tmp_path: Path) -> None:
    grey = cv2.imread(str(FOLDER / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)
    scale = (59.9e6 / grey.size) ** 0.5
    large = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_CUBIC)
    # uncompressed: written in no time
    (tmp_path / "bodyplan.png").write_bytes(cv2.imencode(".bmp", np.dstack([large] * 3))[1].tobytes())
    del large
    shutil.copy(FOLDER / "ship.toml", tmp_path)
    done = subprocess.run(
        [sys.executable, "-c", READ, str(tmp_path / "ship.toml")], capture_output=True, text=True, check=True
    )
    (tmp_path / "bodyplan.png").unlink()
    peak_mb, stations, doubts = (float(word) for word in done.stdout.split())
    assert peak_mb <= LARGEST_PEAK_MB
    assert (stations, doubts) == (29, 0)
