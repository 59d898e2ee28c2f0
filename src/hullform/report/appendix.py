"""The appendix in the layout of the paper's Table 2: the printed figures beside those of this run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.outcome import ConditionRun, Run
from hullform.report.published import FUNCTIONS, PublishedCondition, published_condition, published_ship

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """One mode of one block: rad/s, the Ritz columns in the order of FUNCTIONS; None where the paper prints a dash."""

    mode: int
    printed_ritz: tuple[float | None, ...]
    printed_converged: float
    printed_schlick: float
    printed_todd: float
    printed_finite_element: float
    ritz: tuple[float, ...]
    elastic_only: tuple[float, ...]
    schlick: float
    todd: float
    finite_element: float
    nondimensional: float

    @property
    def printed_ratio(self) -> float:
        """The paper's finite elements over its converged Ritz figure."""
        return self.printed_finite_element / self.printed_converged

    @property
    def own_ratio(self) -> float:
        """Our finite elements over our Ritz figure in the paper's basis."""
        return self.finite_element / self.elastic_only[-1]


@dataclass(frozen=True)
class Block:
    """One condition of Table 2."""

    published: PublishedCondition
    title: str
    lines: tuple[Line, ...]


def table_2_blocks(run: Run) -> tuple[Block, ...]:
    """The blocks of Table 2 that belong to a run; empty where she is none of the paper's ships."""
    known = published_ship(run.ship)
    if known is None:
        return ()
    blocks = []
    for condition in run.conditions.values():
        published = published_condition(known, condition.condition)
        if published is not None:
            blocks.append(Block(published, condition.condition.title, _lines(run, condition, published)))
    return tuple(blocks)


def nondimensional_unit(run: Run) -> float:
    """sqrt(E I0 / (rho L^4 A0)) in rad/s: midship I0 and steel area A0, as the paper's section 3.1.2 has it."""
    given, _, _ = run.ship.require_sections_of_a_run()
    structure, hull = run.structure, run.hull
    second_moment, area = (
        float(np.interp(hull.midships_m, structure.x_m, values))
        for values in (structure.second_moment_m4, structure.area_m2)
    )
    mass_per_length = given.density_kg_m3 * area
    return float(np.sqrt(structure.youngs_modulus_pa * second_moment / mass_per_length) / hull.length_overall_m**2)


def _lines(run: Run, condition: ConditionRun, published: PublishedCondition) -> tuple[Line, ...]:
    unit = nondimensional_unit(run)
    figures, solutions = condition.empirical.figures_rad_s, condition.solutions
    ritz = np.array([condition.convergence_rad_s[functions] for functions in FUNCTIONS])
    elastic_only = np.array([condition.elastic_only_convergence_rad_s[functions] for functions in FUNCTIONS])
    lines = []
    for index, printed in enumerate(published.modes):
        lines.append(
            Line(
                mode=index + 1,
                printed_ritz=printed.ritz,
                printed_converged=printed.converged,
                printed_schlick=printed.schlick,
                printed_todd=printed.todd,
                printed_finite_element=printed.finite_element,
                ritz=tuple(ritz[:, index].tolist()),
                elastic_only=tuple(elastic_only[:, index].tolist()),
                schlick=float(figures["schlick_hollow_box"][index]),
                todd=float(figures["todd"][index]),
                finite_element=_frequency(solutions["finite_element"].angular_frequencies, index),
                nondimensional=_frequency(condition.euler_modes.angular_frequencies, index) / unit,
            )
        )
    return tuple(lines)


def _frequency(frequencies: Array, index: int) -> float:
    return float(frequencies[index])
