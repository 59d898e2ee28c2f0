"""Measure what docs/validation.md states, and write it. Takes about a quarter of a minute."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from draw_bodyplans import outline
from reading_accuracy import station_errors

import hullvib
from hullform import read_ship, run_ship
from hullform.outcome import Run
from hullvib.uniform_beam import frequency_parameters

ROOT = Path(__file__).parent.parent
SHIPS = ("scim-containership", "ds-tanker", "wigley")

HEAD = """# Validation

What was measured, by `python scripts/write_validation.py`; the tests hold the bounds. *Verified* means: against a
closed form, an independent method or a published figure. No ship is known to us whose m(x), EI(x), shear stiffness and
measured frequencies are all published, so nothing here says *validated against ship X*.

"""


def uniform_beam() -> Iterator[str]:
    """Frequencies of the uniform beam against the roots of cos g cosh g = 1."""
    girder = hullvib.Girder([0.0, 1.0], [1.0, 1.0], [1.0, 1.0])
    exact = frequency_parameters(5) ** 2
    yield "## Uniform beam\n\nLargest relative error of modes 1 to 5 against the roots of cos g cosh g = 1.\n"
    yield "| method | error |\n|---|---|"
    for name, method in (
        ("Ritz, 12 functions", hullvib.Ritz(12)),
        ("finite elements, 50", hullvib.FiniteElements(50)),
        ("finite elements, 100", hullvib.FiniteElements(100)),
    ):
        found = hullvib.solve(girder, method, modes=5).angular_frequencies
        yield f"| {name} | {np.abs(found / exact - 1).max():.0e} |"


def jacobi_beams() -> Iterator[str]:
    """A ship-like family with closed-form frequencies."""
    yield (
        "\n## A ship-like family with closed-form answers\n\n"
        "m = (1-x)^a (1+x)^b, EI = (1-x)^(a+2) (1+x)^(b+2) on -1..1 have\n"
        "Omega_n = 4 sqrt(n (n-1) (n+a+b+1) (n+a+b+2)), n = 2, 3, ... Relative error in % of modes 1, 2, 3;\n"
        "the last column is the paper's basis, without the rigid-body functions.\n"
    )
    yield "| a, b | finite elements, 100 | Ritz, 12 functions | elastic functions only |\n|---|---|---|---|"
    for a, b in ((0, 0), (1, 1), (2, 1)):

        def mass(x: float, a: int = a, b: int = b) -> float:
            return float((2 - 2 * x) ** a * (2 * x) ** b)

        def rigidity(x: float, a: int = a, b: int = b) -> float:
            return float((2 - 2 * x) ** (a + 2) * (2 * x) ** (b + 2))

        girder = hullvib.Girder.from_functions(1.0, mass, rigidity)
        n = np.arange(2, 5)
        exact = 4 * np.sqrt(n * (n - 1) * (n + a + b + 1) * (n + a + b + 2))
        cells = []
        for method in (hullvib.FiniteElements(100), hullvib.Ritz(12), hullvib.Ritz(12, rigid_body=False)):
            found = hullvib.solve(girder, method, modes=3).angular_frequencies
            cells.append(", ".join(f"{error:.3g}" for error in 100 * (found / exact - 1)))
        yield f"| {a}, {b} | " + " | ".join(cells) + " |"


def pictures(runs: dict[str, Run]) -> Iterator[str]:
    """Traced stations against the outlines that were drawn, and what becomes of them."""
    yield (
        "\n## From the picture\n\n"
        "Traced stations against the outlines that the pictures were drawn from: distance by arc length, the worse of\n"
        "both directions, in % of B/2; sectional area, below the draught and to the deck, in % of the largest.\n"
    )
    yield (
        "| ship | stations found | RMS median | RMS largest | area, largest error | volume to T, error % | "
        "mesh against sections, % |"
    )
    yield "|---|---|---|---|---|---|---|"
    for name, run in runs.items():
        hull = outline(name)
        errors = station_errors(hull, run.reading)
        named = len(run.ship.body_plan.aft_stations_m) + len(run.ship.body_plan.fore_stations_m)
        volume = 100 * (run.at_draught.volume_m3 / hull.volume(run.at_draught.draught_m) - 1)
        mesh = 100 * (run.hull.mesh().volume / run.hull.volume_m3 - 1)
        yield (
            f"| {name} | {len(run.body_plan.stations)} of {named} | {np.median(errors.rms_percent):.3f} | "
            f"{errors.rms_percent.max():.3f} | {np.abs(errors.area_percent).max():.2f} | {volume:+.3f} | {mesh:+.3f} |"
        )


def agreement(runs: dict[str, Run]) -> Iterator[str]:
    """Ritz against finite elements on the ships."""
    yield "\n## Ritz against finite elements on the ships\n"
    yield "Ritz with 12 functions above about 100 elements, in %, modes 1, 2, 3.\n"
    yield "| ship | condition | mode 1 | mode 2 | mode 3 |\n|---|---|---|---|---|"
    for name, run in runs.items():
        for title, condition in run.conditions.items():
            elements = condition.solutions["finite_element"].angular_frequencies[:3]
            ratio = 100 * (condition.modes.angular_frequencies[:3] / elements - 1)
            yield f"| {name} | {title} | " + " | ".join(f"{value:.4f}" for value in ratio) + " |"
    yield (
        "\nThe light tanker's third mode is the slowest to converge: her deck machinery lies out to a stem tip\n"
        "whose EI is below a hundredth of midships, where twelve smooth functions cannot follow."
    )


def main() -> None:
    runs = {name: run_ship(read_ship(ROOT / "bodyplans" / name / "ship.toml")) for name in SHIPS}
    lines = [*uniform_beam(), *jacobi_beams(), *pictures(runs), *agreement(runs)]
    (ROOT / "docs" / "validation.md").write_text(HEAD + "\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
