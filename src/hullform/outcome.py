"""What a run found out: frozen types for results.json and the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hullform.at_rest import AtRest
from hullform.body_plan import BodyPlan
from hullform.checks import Check
from hullform.empirical_figures import EmpiricalFigures
from hullform.hull.hydrostatics import Hydrostatics
from hullform.hull.loft import Hull
from hullform.in_service import InService
from hullform.in_water import InWater
from hullform.loading.distributions import Distribution
from hullform.loading.structure import Structure
from hullform.loading.weights import LightShip
from hullform.ship import Ship
from hullform.ship_weights import ConditionInput
from hullvib import distortion
from hullvib.bounds import Bracket
from hullvib.girder import Girder
from hullvib.modes import Modes

if TYPE_CHECKING:
    from hullform.picture.reading import PictureReading

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Distortion:
    """How a condition's modes differ from the uniform beam's, and which part of the ship makes them.

    Attributes:
        weights: (modes, functions) of the uniform modes in each mode, the largest of a row 1.
        diagonal_dominance: (modes,) |a_jj| over the sum of the others.
        nondimensional: (modes,) omega / sqrt(EI_mid / (m_mean LOA^4)).
        nodes, antinodes: positions, the uniform beam's, and the shift, one a mode.
        energy: shares of kinetic and strain energy of the aft fifth, the middle and the fore tenth.
        correlation: of m(x) with phi_j^2 and of EI(x) with phi_j''^2 along the ship.
    """

    weights: Array
    diagonal_dominance: Array
    nondimensional: Array
    nodes: tuple[distortion.Shift, ...]
    antinodes: tuple[distortion.Shift, ...]
    energy: distortion.EnergySplit
    correlation: distortion.SpatialCorrelation


@dataclass(frozen=True, eq=False)
class ConditionRun:
    """One loading condition, from its weights to its modes.

    Attributes:
        condition: what ship.toml says of it.
        items: its weights along the ship.
        girder: m(x) and EI(x).
        floating: hydrostatics on even keel, at the mean of given draughts or else at the draught of its mass (at the
            depth, where it would sink).
        at_rest: her waterline, shear force and bending moment in still water.
        checks: what holds and what does not.
        solutions: dry modes, by name: of the Euler-Bernoulli girder 'stodola_ritz', 'ritz', 'ritz_elastic_only' (the
            paper's basis) and 'finite_element'; with shear deflection 'shear'; with rotary inertia too 'timoshenko'.
        in_water: wet modes, at her own draughts.
        bracket: proven bounds of the Euler-Bernoulli frequencies, or in words why there are none.
        convergence_rad_s: number of Ritz functions to the first frequencies, with the rigid-body functions.
        elastic_only_convergence_rad_s: the same in the paper's basis.
        distortion: how the modes differ from the uniform beam's.
        empirical: in-water formulas.
    """

    condition: ConditionInput
    items: tuple[Distribution, ...]
    girder: Girder
    floating: Hydrostatics
    at_rest: AtRest
    checks: tuple[Check, ...]
    solutions: Mapping[str, Modes]
    in_water: InWater
    bracket: Bracket | str
    convergence_rad_s: Mapping[int, Array]
    elastic_only_convergence_rad_s: Mapping[int, Array]
    distortion: Distortion
    empirical: EmpiricalFigures

    @property
    def mass_kg(self) -> float:
        """All weights together."""
        return self.girder.total_mass

    @property
    def modes(self) -> Modes:
        """The headline: in water, with shear deflection."""
        return self.in_water.shear.modes

    @property
    def dry_modes(self) -> Modes:
        """The same girder dry, with shear deflection."""
        return self.solutions["shear"]

    @property
    def euler_modes(self) -> Modes:
        """The Euler-Bernoulli girder by plain Ritz, whose weights of uniform modes the distortion speaks of."""
        return self.solutions["ritz"]


@dataclass(frozen=True, eq=False)
class Run:
    """Everything that a run found out, for results.json and the report.

    Attributes:
        ship: the ship.toml.
        body_plan: the stations, whatever they come from.
        reading: the picture as read; None where they come from something else.
        hull: lofted from them.
        at_draught: hydrostatics at the design draught.
        structure: section properties along the ship.
        light: steel, machinery and their estimates.
        checks: of the hull and the light ship; those of the conditions are theirs.
        conditions: by name, in the order of ship.toml.
        in_service: the same, held against propeller, engine and waves.
        seconds: by stage, for provenance alone.
    """

    ship: Ship
    body_plan: BodyPlan
    reading: PictureReading | None
    hull: Hull
    at_draught: Hydrostatics
    structure: Structure
    light: LightShip
    checks: tuple[Check, ...]
    conditions: Mapping[str, ConditionRun]
    in_service: Mapping[str, InService]
    seconds: Mapping[str, float]

    @property
    def doubts(self) -> tuple[str, ...]:
        """Everything a person should look at; a run with doubts ends with exit code 3."""
        failed = [check.doubt for check in self.checks if not check.ok]
        for name, condition in self.conditions.items():
            failed += [f"{name}: {check.doubt}" for check in condition.checks if not check.ok]
        return (*self.body_plan.doubts, *self.hull.doubts, *failed)
