"""Where propeller and engine meet the natural frequencies of the hull girder: hits, and shaft speeds to avoid.

A source of order o excites at o N / 60 Hz when the shaft turns at N rpm: o = k Z for the k-th harmonic of the blade
rate of Z blades, o = i for the i-th order of an engine on the shaft. It hits mode n where o N / 60 lies in the band of
f_n,

    f_n (1 - u_n) (1 - b) .. f_n (1 + u_n) (1 + b),

b what is kept clear of a frequency that is known and u_n the model's own uncertainty of it. Hits are declared for modes
1 to 5; above them decks, deckhouse and double bottom vibrate on their own, and no beam speaks for them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.errors import ArgumentError

Array = NDArray[np.float64]

KEEP_CLEAR = 0.05
"""Half the band that is kept clear of a known natural frequency, over it."""
BLADE_HARMONICS = 3
HIGHEST_MODE = 5
"""The last mode for which hits are declared."""
SURE_MODES = 3
"""Modes above this one are beam modes by courtesy: their hits are flagged."""


@dataclass(frozen=True)
class Source:
    """Something that excites in step with the shaft.

    Attributes:
        name: for people.
        order: cycles a revolution of the shaft.
        acts: 'force' at the propeller, 'moment' at the engine.
    """

    name: str
    order: float
    acts: Literal["force", "moment"]

    def frequency_hz(self, speed_rpm: float) -> float:
        """What it excites with at a shaft speed."""
        return self.order * speed_rpm / 60.0


@dataclass(frozen=True)
class Hit:
    """A source that meets a mode within the shaft's speed range.

    Attributes:
        mode: from 1.
        source: what meets it.
        critical_rpm: where the source has the mode's natural frequency; it may lie outside the range that the band
            reaches into.
        avoid_rpm: lowest and highest shaft speed at which the source lies in the mode's band, within the range.
        flagged: whether the mode is above those that a beam describes well.
    """

    mode: int
    source: Source
    critical_rpm: float
    avoid_rpm: tuple[float, float]
    flagged: bool

    def holds(self, speed_rpm: float) -> bool:
        """Whether a shaft speed is among those to avoid."""
        return self.avoid_rpm[0] <= speed_rpm <= self.avoid_rpm[1]


def sources(
    propeller_blades: int | None = None, engine_orders: Sequence[float] = (), harmonics: int = BLADE_HARMONICS
) -> tuple[Source, ...]:
    """Blade rate with its harmonics, and engine orders, by rising order of each.

    Raises:
        ArgumentError: fewer than two blades, or an order that is not above 0.
    """
    if propeller_blades is not None and propeller_blades < 2:
        raise ArgumentError(f"propeller_blades is {propeller_blades}; a propeller has two blades or more.")
    if any(not (np.isfinite(order) and order > 0.0) for order in engine_orders):
        raise ArgumentError(f"engine orders are {list(engine_orders)}; give finite numbers above 0.")
    blades = [
        Source("blade rate" if k == 1 else f"{k} × blade rate", k * propeller_blades, "force")
        for k in range(1, harmonics + 1)
        if propeller_blades is not None
    ]
    return (*blades, *(Source(f"engine order {order:g}", order, "moment") for order in sorted(engine_orders)))


def frequency_bands(
    frequencies_hz: ArrayLike, uncertainty: ArrayLike = 0.0, keep_clear: float = KEEP_CLEAR
) -> tuple[Array, Array]:
    """Lower and upper edge of what to keep clear of, each (modes,) in Hz.

    Args:
        frequencies_hz: natural frequencies, (modes,).
        uncertainty: u_n, the model's own, over the frequency; (modes,) or one for all.
        keep_clear: b.

    Raises:
        ArgumentError: a frequency that is not above 0, or shares outside 0 .. 1.
    """
    found = np.asarray(frequencies_hz, dtype=np.float64)
    spread = np.broadcast_to(np.asarray(uncertainty, dtype=np.float64), found.shape)
    if not (np.isfinite(found).all() and (found > 0.0).all()):
        raise ArgumentError(f"natural frequencies are {found.tolist()} Hz; give finite numbers above 0.")
    if not (((spread >= 0.0) & (spread < 1.0)).all() and 0.0 <= keep_clear < 1.0):
        raise ArgumentError("uncertainty and keep_clear are shares of the frequency; give 0 or more, below 1.")
    return found * (1.0 - spread) * (1.0 - keep_clear), found * (1.0 + spread) * (1.0 + keep_clear)


def find_hits(
    frequencies_hz: ArrayLike,
    bands_hz: tuple[Array, Array],
    excited_by: Iterable[Source],
    shaft_speed_rpm: tuple[float, float],
) -> tuple[Hit, ...]:
    """Every source that enters the band of one of modes 1 to 5 within the shaft's speed range, by mode and order.

    Args:
        frequencies_hz: natural frequencies, (modes,), lowest first.
        bands_hz: of `frequency_bands`.
        excited_by: the sources.
        shaft_speed_rpm: lowest and highest shaft speed.

    Raises:
        ArgumentError: the range is none.
    """
    slowest, fastest = shaft_speed_rpm
    if not 0.0 <= slowest < fastest:
        raise ArgumentError(f"the shaft's speed range is {slowest:g} to {fastest:g} rpm; give the lower speed first.")
    frequencies = np.asarray(frequencies_hz, dtype=np.float64)[:HIGHEST_MODE]
    found = []
    for mode, (frequency, low, high) in enumerate(zip(frequencies, *bands_hz, strict=False), 1):
        for source in excited_by:
            from_rpm, to_rpm = (max(slowest, 60.0 * low / source.order), min(fastest, 60.0 * high / source.order))
            if from_rpm <= to_rpm:
                critical = 60.0 * float(frequency) / source.order
                found.append(Hit(mode, source, critical, (float(from_rpm), float(to_rpm)), mode > SURE_MODES))
    return tuple(found)


def speeds_to_avoid(hits: Iterable[Hit]) -> tuple[tuple[float, float], ...]:
    """The shaft speeds of all hits together, in rpm: intervals apart from each other, the slowest first."""
    joined: list[tuple[float, float]] = []
    for low, high in sorted(hit.avoid_rpm for hit in hits):
        if joined and low <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(high, joined[-1][1]))
        else:
            joined.append((low, high))
    return tuple(joined)


def margins(frequencies_hz: ArrayLike, excited_by: Sequence[Source], speed_rpm: float) -> Array:
    """How far each source lies above (+) or below (-) each natural frequency, over it: (sources, modes)."""
    exciting = np.array([source.frequency_hz(speed_rpm) for source in excited_by])
    return np.asarray(exciting[:, None] / np.asarray(frequencies_hz, dtype=np.float64) - 1.0, dtype=np.float64)


def beam_limit_hz(bands_hz: tuple[Array, Array]) -> float:
    """The frequency above which no beam speaks for the ship: the upper edge of the band of the last mode, 5 at most."""
    return float(bands_hz[1][:HIGHEST_MODE].max())
