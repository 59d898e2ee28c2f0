"""The sheet of paper in a photograph: what lies round it is not part of the drawing."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

SEARCH_WIDTH_PX = 400
LINE_WINDOW_PX = 9  # closes the lines of the drawing at that width
LEAST_STEP = 0.1  # of the brightness, between neighbours of a pixel at that width: a lamp's light fades more slowly
LEAST_SHARE, MOST_SHARE = 0.35, 0.985  # of the picture that a sheet covers
LEAST_SOLID = 0.95  # of its convex hull that a sheet fills: less is a shadow across it
DARKEST_TABLE = 0.8  # of the brightness of the paper beside it: lighter, it is the paper itself
EDGE_SHARE = 0.008  # of the picture's width: the edge of the sheet and its shadow


def beyond_paper(grey: NDArray[np.uint8]) -> NDArray[np.bool_] | None:
    """(rows, columns) what is not paper, or None where the paper fills the picture or cannot be told.

    Paper is the largest area whose brightness changes slowly, without a dent: under a lamp its far corner may be as
    dark as a table, but only at its edge does the brightness change at once. What lies round it must be darker.
    """
    height, width = grey.shape
    small = cv2.resize(
        grey, (SEARCH_WIDTH_PX, max(1, round(height * SEARCH_WIDTH_PX / width))), interpolation=cv2.INTER_AREA
    )
    even = cv2.morphologyEx(cv2.medianBlur(small, 3), cv2.MORPH_CLOSE, np.ones((LINE_WINDOW_PX,) * 2, np.uint8))
    lightest, darkest = (operation(even, np.ones((3, 3), np.uint8)) for operation in (cv2.dilate, cv2.erode))
    steady = (np.asarray(darkest, np.float64) > (1 - LEAST_STEP) * np.asarray(lightest, np.float64)).astype(np.uint8)
    _, labels, statistics, _ = cv2.connectedComponentsWithStats(steady, connectivity=4)
    if len(statistics) < 2:
        return None
    largest = 1 + int(np.argmax(statistics[1:, cv2.CC_STAT_AREA]))
    outlines, _ = cv2.findContours((labels == largest).astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    outline = max(outlines, key=cv2.contourArea)
    hull = cv2.convexHull(outline)
    # figures that stand close together leave holes in the sheet
    sheet, whole = (cv2.fillPoly(np.zeros_like(steady), [polygon], 1) for polygon in (outline, hull))
    covered = int(whole.sum())
    if not LEAST_SHARE * sheet.size < covered < MOST_SHARE * sheet.size or int(sheet.sum()) < LEAST_SOLID * covered:
        return None
    reach = np.ones((2 * LINE_WINDOW_PX + 1,) * 2, np.uint8)
    inside = (whole - cv2.erode(whole, reach, borderValue=1)).astype(bool)
    outside = (cv2.dilate(whole, reach) - whole).astype(bool)
    if not outside.any() or np.median(even[outside]) > DARKEST_TABLE * np.median(even[inside]):
        return None
    corners = (hull[:, 0].astype(np.float64) + 0.5) * (width / SEARCH_WIDTH_PX) - 0.5
    paper = cv2.fillConvexPoly(np.zeros(grey.shape, np.uint8), np.round(corners).astype(np.int32), 1)
    edge = 2 * round(EDGE_SHARE * width) + 1
    return np.asarray(cv2.erode(paper, np.ones((edge, edge), np.uint8), borderValue=1) == 0)
