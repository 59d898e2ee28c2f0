"""How numbers are written for a person: three significant figures; all digits are in results.json."""

from __future__ import annotations

import math

FIGURES = 3
# Below and above these powers of ten a number is written with a power of ten.
SMALLEST_PLAIN_POWER = -3
LARGEST_PLAIN_POWER = 8
# From this power on digits stand in groups of three.
GROUPED_POWER = 4
# Per cents of a numerical error below this are round-off: digits would pretend to a meaning.
ROUND_OFF_PERCENT = 1e-7

THIN_SPACE = "\u202f"
MINUS = "\u2212"
NO_VALUE = "–"
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def significant(value: float, figures: int = FIGURES) -> str:
    """A number to so many significant figures, e.g. 74 700, 0.912, −1.30, 5.21 × 10¹³; '–' where it is not finite."""
    if not math.isfinite(value):
        return NO_VALUE
    if value == 0:
        return "0"
    mantissa, _, power_text = f"{abs(value):.{figures - 1}e}".partition("e")
    power = int(power_text)
    sign = MINUS if value < 0 else ""
    if not SMALLEST_PLAIN_POWER <= power < LARGEST_PLAIN_POWER:
        return f"{sign}{mantissa} × 10{str(power).translate(_SUPERSCRIPTS)}"
    rounded = float(f"{mantissa}e{power}")
    plain = f"{rounded:.{max(figures - 1 - power, 0)}f}"
    return sign + (_grouped(plain) if power >= GROUPED_POWER else plain)


def signed(value: float, figures: int = FIGURES) -> str:
    """As `significant`, with a plus sign where the number is positive: for differences."""
    return f"+{significant(value, figures)}" if value > 0 else significant(value, figures)


def short(value: float, figures: int = FIGURES) -> str:
    """As `significant`, without closing zeros behind the point: for limits, which are round numbers."""
    text = significant(value, figures)
    return text.rstrip("0").rstrip(".") if "." in text and "×" not in text else text


def as_given(value: float) -> str:
    """A number as a person wrote it in ship.toml, digits in groups of three."""
    plain = f"{value:.10g}"
    if "e" in plain:
        mantissa, _, power = plain.partition("e")
        return f"{mantissa} × 10{str(int(power)).translate(_SUPERSCRIPTS)}"
    whole, point, decimals = plain.partition(".")
    return (_grouped(whole) if len(whole) > GROUPED_POWER else whole) + point + decimals


def per_cent(value: float, reference: float) -> str:
    """The signed difference of a value from a reference in per cent of the reference, without the sign '%'."""
    if reference == 0 or not math.isfinite(value / reference):
        return NO_VALUE
    difference = 100 * (value / reference - 1)
    return "0" if abs(difference) < ROUND_OFF_PERCENT else signed(difference)


def _grouped(digits: str) -> str:
    return f"{int(digits):,}".replace(",", THIN_SPACE)
