"""The errors of hullvib, one tree.

HullvibError
├── GirderError            a girder that cannot be built
│   └── GirderFileError    a girder file that cannot be read or written
├── ArgumentError          a number given to a method, a formula or a query that makes no sense
└── SolutionError          a girder that is right, for which the method finds no answer
"""


class HullvibError(Exception):
    """Base of everything that hullvib raises on purpose."""


class GirderError(HullvibError):
    """The girder's data contradict themselves or physics; the message names the value and the remedy."""


class GirderFileError(GirderError):
    """A girder file is unreadable; the message names the file and the line or the key."""


class ArgumentError(HullvibError):
    """An argument lies outside its range; the message names it and the range."""


class SolutionError(HullvibError):
    """The method has no answer for this girder; the message says why and what to try."""
