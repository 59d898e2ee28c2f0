"""The tree of exceptions of hullform.

HullformError                  what a user can cause and mend; the command line prints it, exit code 1
  ShipFileError                ship.toml is missing, unreadable or says something impossible
  PictureError                 the picture cannot be read as a body plan
  ReviewError                  a review file that is damaged or was made of another picture
  BodyPlanError                traced curves, a table, a mesh or particulars that make no body plan
  HullError                    a hull or a floating position that cannot be
  LoadingError                 weights or a structure that cannot be
  OutputError                  a file or folder that cannot be written
"""

from __future__ import annotations


class HullformError(Exception):
    """The input is wrong: the message names what, which value, and what to do."""


class ShipFileError(HullformError):
    """ship.toml is missing, unreadable or says something impossible."""


class PictureError(HullformError):
    """The picture cannot be read as a body plan."""


class ReviewError(HullformError):
    """A review file that is damaged or was made of another picture."""


class BodyPlanError(HullformError):
    """Traced curves, a table of offsets, a mesh or particulars that make no body plan."""


class HullError(HullformError):
    """A hull or a floating position that cannot be."""


class LoadingError(HullformError):
    """Weights or a structure that cannot be."""


class OutputError(HullformError):
    """A file or folder that cannot be written."""
