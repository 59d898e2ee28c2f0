"""The families of hulls, their proportions drawn at random within the range of such ships."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from generator.hulls import Barge, Bulb, ChineHull, Knuckle, Midship, Rise, Run, Sheer, WaterlineHull, WigleyHull
from generator.sections import Dimensions, Hull

Random = np.random.Generator


def container(random: Random, with_bulb: bool = False, with_knuckle: bool = False) -> WaterlineHull:
    """A container ship: flare forward, skeg and counter aft, a transom above the waterline; or a ferry."""
    breadth = random.uniform(24.0, 48.0)
    depth = breadth * random.uniform(0.52, 0.66)
    draught = depth * random.uniform(0.58, 0.70)
    length = breadth * random.uniform(6.0, 8.0)
    sheer = Sheer(depth, length, 0.0, depth * random.choice([0.0, random.uniform(0.08, 0.22)]))
    top = depth + sheer.fore_m
    midship = Midship(breadth / 2, depth * random.uniform(0.12, 0.22))
    stem = length * random.uniform(0.955, 0.97)
    aft = Run(
        Rise(length * random.uniform(0.50, 0.58), length * random.uniform(0.30, 0.38), 0.0, depth),
        Rise(length * random.uniform(0.05, 0.08), -0.10 * length, draught * random.uniform(0.35, 0.5), 1.02 * draught),
        Rise(random.uniform(1.5, 1.8), random.uniform(2.8, 3.8), 0.0, depth),
        Rise(random.uniform(1.7, 2.3), random.uniform(0.45, 0.65), 0.0, draught * 1.05),
    )
    fore = Run(
        Rise(length * random.uniform(0.50, 0.56), length * random.uniform(0.62, 0.70), 0.0, top),
        Rise(stem - 0.03 * length, length * 1.005, 0.0 if with_bulb else 0.25 * draught, top),
        Rise(random.uniform(1.6, 1.9), random.uniform(2.2, 2.9), 0.4 * draught, top),
        Rise(random.uniform(1.5, 1.9), random.uniform(0.55, 0.75), 0.3 * draught, top),
    )
    bulb = None
    if with_bulb:
        height = draught * random.uniform(0.30, 0.40)
        bulb = Bulb(
            breadth * random.uniform(0.055, 0.09),
            height,
            height * random.uniform(1.05, 1.25),
            0.88 * length,
            length * random.uniform(0.985, 0.998),
        )
    knuckle = Knuckle(draught + (depth - draught) * random.uniform(0.2, 0.5), 0.15) if with_knuckle else None
    return WaterlineHull(Dimensions(length, breadth, depth, draught), sheer, midship, aft, fore, bulb, knuckle)


def bulb(random: Random) -> WaterlineHull:
    """A container ship with a bulb: half-breadths that are not monotone, two curves ahead of the stem."""
    return container(random, with_bulb=True)


def ferry(random: Random) -> WaterlineHull:
    """A ferry: flare up to a knuckle, nearly upright above it."""
    return container(random, with_knuckle=True)


def tanker(random: Random) -> WaterlineHull:
    """A tanker: a long parallel body, full ends, upright sides."""
    breadth = random.uniform(28.0, 60.0)
    depth = breadth * random.uniform(0.46, 0.56)
    draught = depth * random.uniform(0.66, 0.76)
    length = breadth * random.uniform(5.3, 6.2)
    sheer = Sheer(depth, length, 0.0, depth * random.choice([0.0, random.uniform(0.03, 0.1)]))
    midship = Midship(breadth / 2, depth * random.uniform(0.08, 0.14))
    aft = Run(
        Rise(length * random.uniform(0.40, 0.46), length * random.uniform(0.26, 0.32), 0.0, depth),
        Rise(length * random.uniform(0.04, 0.06), -0.06 * length, 0.5 * draught, 1.05 * draught),
        Rise(random.uniform(1.8, 2.2), random.uniform(2.6, 3.4), 0.0, depth),
        Rise(random.uniform(1.5, 2.0), random.uniform(0.5, 0.65), 0.0, draught),
    )
    fore = Run(
        Rise(length * random.uniform(0.66, 0.70), length * random.uniform(0.74, 0.80), 0.0, depth),
        Rise(length * random.uniform(0.955, 0.97), length * 1.002, 0.1 * draught, depth + sheer.fore_m),
        Rise(random.uniform(2.0, 2.4), random.uniform(2.5, 3.2), 0.0, depth),
        Rise(random.uniform(0.9, 1.2), random.uniform(0.5, 0.6), 0.0, draught),
    )
    return WaterlineHull(Dimensions(length, breadth, depth, draught), sheer, midship, aft, fore)


def frigate(random: Random) -> WaterlineHull:
    """A fine naval hull: rise of floor, a cut-up stern with a transom in the water, V sections and flare forward."""
    breadth = random.uniform(10.0, 19.0)
    depth = breadth * random.uniform(0.60, 0.72)
    draught = depth * random.uniform(0.42, 0.52)
    length = breadth * random.uniform(7.5, 9.5)
    sheer = Sheer(depth, length, 0.0, depth * random.uniform(0.12, 0.3))
    top = depth + sheer.fore_m
    midship = Midship(breadth / 2, breadth * random.uniform(0.20, 0.28), np.radians(random.uniform(7.0, 16.0)))
    aft = Run(
        Rise(length * random.uniform(0.48, 0.54), length * random.uniform(0.34, 0.40), 0.0, depth),
        Rise(length * random.uniform(0.20, 0.30), -0.35 * length, -0.2 * draught, 1.1 * draught),
        Rise(random.uniform(1.9, 2.3), random.uniform(2.2, 2.8), 0.0, depth),
        Rise(random.uniform(1.0, 1.3), random.uniform(0.6, 0.8), 0.0, depth),
    )
    fore = Run(
        Rise(length * random.uniform(0.42, 0.48), length * random.uniform(0.50, 0.56), 0.0, top),
        Rise(length * random.uniform(0.90, 0.94), length * 1.004, 0.0, top),
        Rise(random.uniform(1.4, 1.7), random.uniform(1.9, 2.4), 0.0, top),
        Rise(random.uniform(1.2, 1.6), random.uniform(0.7, 0.85), 0.0, top),
    )
    return WaterlineHull(Dimensions(length, breadth, depth, draught), sheer, midship, aft, fore)


def wigley(random: Random) -> WigleyHull:
    """Wigley's form and its relatives: every section starts at the one keel point."""
    breadth = random.uniform(8.0, 20.0)
    draught = breadth * random.uniform(0.5, 0.8)
    depth = draught * random.choice([1.0, random.uniform(1.1, 1.35)])
    length = breadth * 10.0
    powers = random.uniform(1.8, 2.6), random.uniform(1.8, 3.2)
    return WigleyHull(Dimensions(length, breadth, depth, draught), Sheer(depth, length), *powers)


def chine(random: Random) -> ChineHull:
    """A hard-chine work boat or yacht."""
    breadth = random.uniform(4.0, 9.0)
    depth = breadth * random.uniform(0.55, 0.70)
    length = breadth * random.uniform(3.4, 4.4)
    return ChineHull(
        Dimensions(length, breadth, depth, depth * random.uniform(0.38, 0.46)),
        Sheer(depth, length, depth * random.uniform(0.0, 0.06), depth * random.uniform(0.15, 0.35)),
        0.5 * breadth * random.uniform(0.80, 0.90),
        depth * random.uniform(0.26, 0.36),
        depth * random.uniform(0.28, 0.42),
        depth * random.uniform(0.15, 0.4),
        depth * random.uniform(0.0, 0.10),
        random.uniform(1.0, 1.25),
        random.uniform(1.0, 1.5),
    )


def barge(random: Random) -> Barge:
    """A pontoon barge: raked ends, most stations one and the same rectangle."""
    breadth = random.uniform(10.0, 30.0)
    depth = breadth * random.uniform(0.22, 0.38)
    length = breadth * random.uniform(3.5, 5.5)
    return Barge(
        Dimensions(length, breadth, depth, depth * random.uniform(0.6, 0.8)),
        depth * random.uniform(0.06, 0.18),
        length * random.uniform(0.15, 0.3),
        length * random.uniform(0.15, 0.3),
        random.uniform(0.5, 0.7),
        float(random.choice([0.0, random.uniform(0.05, 0.2)])),
    )


FAMILIES: dict[str, Callable[[Random], Hull]] = {
    "container": container,
    "tanker": tanker,
    "frigate": frigate,
    "wigley": wigley,
    "chine": chine,
    "ferry": ferry,
    "barge": barge,
    "bulb": bulb,
}
