"""Which pictures are read: for tests with seeds that no tuning has seen, for development with others."""

from __future__ import annotations

from generator.families import FAMILIES
from generator.levels import LEVELS
from generator.pictures import Recipe

TEST_SEED, DEVELOPMENT_SEED = 90000, 1000
WIDTHS_PX = (1200, 1600, 2000, 3000)
LARGE_PX = 4400  # above the width at which the reader makes a picture smaller
_ROUNDS = 3


def suite(first_seed: int) -> tuple[Recipe, ...]:
    """Return the recipes: every level at every width three times, families in turn, and four large pictures."""
    families = list(FAMILIES)
    recipes = []
    for round_ in range(_ROUNDS):
        for n, level in enumerate(LEVELS):
            for m, width in enumerate(WIDTHS_PX):
                # two rounds bring every family to every level; the third starts one further
                family = families[(3 * m + 4 * round_ + round_ // 2 + n) % len(families)]
                recipes.append(Recipe(family, level, width, first_seed + len(recipes)))
    large = (("container", "grid"), ("tanker", "scan"), ("frigate", "clean"), ("bulb", "busy"))
    recipes += [Recipe(f, level, LARGE_PX, first_seed + len(recipes) + k) for k, (f, level) in enumerate(large)]
    return tuple(recipes)


def sample(recipes: tuple[Recipe, ...]) -> tuple[Recipe, ...]:
    """Return 24 recipes of a suite: every level at 2000 px, at 1200 or 1600 px, and two at 3000 px."""
    levels, widths = len(LEVELS), len(WIDTHS_PX)
    places = [(0, n, 2) for n in range(levels)] + [(1, n, n % 2) for n in range(levels)] + [(2, 0, 3), (2, 4, 3)]
    return tuple(recipes[(round_ * levels + n) * widths + m] for round_, n, m in places)
