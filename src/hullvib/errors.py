"""The errors of hullvib, one tree.

HullvibError
├── GirderError            a girder that cannot be built
│   └── GirderFileError    a girder file that cannot be read or written
├── ModeFileError          a file of modes that cannot be written
├── ArgumentError          a number given to a method, a formula or a query that makes no sense
└── SolutionError          a girder that is right, for which the method finds no answer
    └── NotProven          a frequency that is found, but not proven to lie within bounds
"""


class HullvibError(Exception):
    """Base of everything that hullvib raises on purpose."""


class GirderError(HullvibError):
    """The girder's data contradict themselves or physics; the message names the value and the remedy."""


class GirderFileError(GirderError):
    """A girder file is unreadable; the message names the file and the line or the key."""


class ModeFileError(HullvibError):
    """A file of modes cannot be written; the message names the file and the reason."""


class ArgumentError(HullvibError):
    """An argument lies outside its range; the message names it and the range."""


class SolutionError(HullvibError):
    """The method has no answer for this girder; the message says why and what to try."""


class NotProven(SolutionError):
    """Two-sided bounds cannot be proven for this girder; the message says why."""
