"""What the figures say, in plain words that are put together from the figures themselves."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from hullform.body_plan import Source
from hullform.in_service import HARDLY_EXCITED, Response, Springing
from hullform.outcome import ConditionRun, Run
from hullform.rounding import significant
from hullvib import springing
from hullvib.distortion import Shift
from hullvib.fields import UniformModeSeries
from hullvib.uniform_beam import frequency_parameters

# Correlations smaller than this in size say nothing worth a sentence.
HARDLY_CORRELATED = 0.1
# A shift of less than this share of the length is not to be seen in the figure.
HARDLY_SHIFTED = 0.005


@dataclass(frozen=True)
class WordsOfForm:
    """How the page speaks of where a ship's form comes from.

    Attributes:
        heading: of the section on it.
        account: what was done, in a sentence; its picture stands in its place where there is one.
        stations: what her stations are.
        verb: how a figure of the hull came about.
    """

    heading: str
    account: str
    stations: str
    verb: str


_FORMS: dict[Source, WordsOfForm] = {
    "picture": WordsOfForm("The picture", "", "traced from the picture", "as read"),
    "offsets": WordsOfForm(
        "The table of offsets", "Her stations stand in {file}, point by point.", "as the table has them", "as read"
    ),
    "mesh": WordsOfForm(
        "The mesh",
        "Her stations are cut from the surface in {file}, closer together at the ends and where the areas change fast.",
        "cut from the mesh",
        "as read",
    ),
    "particulars": WordsOfForm(
        "The form",
        "There is no drawing of her: sectional areas of a given fullness and centre of buoyancy, and a rectellipse of "
        "that area at every station, stand for one.",
        "made of the particulars",
        "as formed",
    ),
}


def words_of_form(run: Run) -> WordsOfForm:
    """How to speak of where a run's form comes from."""
    words, file = _FORMS[run.body_plan.source], run.ship.body_plan.file
    return words if file is None else replace(words, account=words.account.format(file=file.name))


def reading_of_mode(condition: ConditionRun, index: int) -> str:
    """A few sentences on one Euler-Bernoulli mode: what it is made of, where its nodes went, why it is where it is."""
    parts = (_composition, _rigid_body, _nodes, _energy, _rise)
    return " ".join(part(condition, index) for part in parts)


def proven_error(condition: ConditionRun, modes: int) -> float | None:
    """Largest relative width of the proven bounds of the first Euler-Bernoulli frequencies; None without bounds."""
    if isinstance(condition.bracket, str):
        return None
    return float(condition.bracket.relative_width[:modes].max())


def ceiling(value: float) -> str:
    """A positive bound rounded up to one figure, for 'below'."""
    unit = 10.0 ** math.floor(math.log10(value))
    return significant(math.ceil(value / unit) * unit, 1)


def load_words(response: Response) -> str:
    """The amplitude of the load of a forced response."""
    if response.load.force_n:
        return f"{significant(response.load.force_n / 1e3)} kN"
    return f"{significant(response.load.moment_n_m / 1e6)} MN m"


def participation_words(share: float) -> str:
    """How well a source excites a mode from where it stands."""
    return f"{significant(share, 2)}, hardly" if share < HARDLY_EXCITED else significant(share, 2)


def springing_rows(found: Springing) -> list[tuple[float, float, list[list[springing.ExcitingWave]]]]:
    """Heading, speed and the waves of each order, a row a heading and speed."""
    return [
        (heading, speed, [
            [met.wave for met in found.waves
             if (met.heading_deg, met.speed_knots, met.wave.order) == (heading, speed, order)]
            for order in springing.ORDERS
        ])
        for heading in found.given.headings_deg
        for speed in found.given.speeds_knots
    ]  # fmt: skip


def _composition(condition: ConditionRun, index: int) -> str:
    weights, dominance = condition.distortion.weights[index], float(condition.distortion.diagonal_dominance[index])
    largest = int(np.abs(weights).argmax())
    if largest != index:
        return f"The uniform beam's mode {largest + 1}, not {index + 1}, has the largest weight in it."
    others = np.abs(np.delete(weights, index))
    second = int(np.abs(np.where(np.arange(weights.size) == index, 0.0, weights)).argmax())
    share = significant(100 * float(others.max()), 2)
    if dominance > 1:
        return (
            f"Of the elastic modes of the uniform beam its mode {index + 1} outweighs all others together "
            f"{significant(dominance, 2)} times; next comes mode {second + 1} with {share} % of that weight."
        )
    return (
        f"The uniform beam's mode {index + 1} has the largest weight in it, but less than all others together "
        f"(ratio {significant(dominance, 2)}); next comes mode {second + 1} with {share} % of that weight."
    )


def _rigid_body(condition: ConditionRun, index: int) -> str:
    modes = condition.euler_modes
    if not isinstance(modes.field, UniformModeSeries):
        return ""
    heave, pitch = np.abs(modes.scale[index] * modes.field.rigid[index])
    return (
        f"On top comes rigid-body motion, of which a uniform beam has none: a heave of {significant(heave, 2)} and a "
        f"pitch of {significant(pitch, 2)} at the ends, where the largest amplitude of the mode is 1."
    )


def _nodes(condition: ConditionRun, index: int) -> str:
    nodes = condition.distortion.nodes[index]
    shift = nodes.shift
    if shift is None:
        return f"It has {nodes.positions.size} nodes where the uniform beam's mode has {nodes.uniform_positions.size}."
    length = condition.girder.length
    farthest = int(np.abs(shift).argmax())
    if abs(shift[farthest]) < HARDLY_SHIFTED * length:
        return "Its nodes stand where the uniform beam's do."
    return f"{_which(nodes, farthest)} has moved farthest, {_moved(float(shift[farthest]), length)}."


def _which(nodes: Shift, index: int) -> str:
    if index == 0:
        return "The aftermost node"
    if index == nodes.positions.size - 1:
        return "The foremost node"
    return f"Node {index + 1} from aft"


def _moved(shift_m: float, length_m: float) -> str:
    way = "forward" if shift_m > 0 else "aft"
    return f"{significant(abs(shift_m))} m ({significant(100 * abs(shift_m) / length_m, 2)} % of the length) {way}"


def _energy(condition: ConditionRun, index: int) -> str:
    split = condition.distortion.energy
    length = condition.girder.length
    aft, fore = split.bounds_m[1] / length, 1 - split.bounds_m[-2] / length
    kinetic, strain = (float(shares[index, 0] + shares[index, -1]) for shares in (split.kinetic, split.strain))
    return (
        f"The aftermost {significant(100 * float(aft), 2)} % and the foremost {significant(100 * float(fore), 2)} % of "
        f"the length have {significant(100 * kinetic, 2)} % of its kinetic and {significant(100 * strain, 2)} % of its "
        "strain energy."
    )


def _rise(condition: ConditionRun, index: int) -> str:
    ratio = float(condition.distortion.nondimensional[index] / frequency_parameters(index + 1)[index] ** 2)
    mass = float(condition.distortion.correlation.mass[index])
    rigidity = float(condition.distortion.correlation.rigidity[index])
    return (
        f"Its frequency is {significant(ratio)} times that of a uniform beam of her mass and her rigidity at half "
        f"length. Against mass and stiffness spread evenly she is {_mass_words(mass)}, and {_rigidity_words(rigidity)}."
    )


def _mass_words(correlation: float) -> str:
    if abs(correlation) < HARDLY_CORRELATED:
        return f"neither light nor heavy where the uniform mode moves most (correlation {significant(correlation, 2)})"
    kind, effect = ("light", "raise") if correlation < 0 else ("heavy", "lower")
    size = significant(correlation, 2)
    return f"{kind} where the uniform mode moves most (correlation {size}), which tends to {effect} it"


def _rigidity_words(correlation: float) -> str:
    if abs(correlation) < HARDLY_CORRELATED:
        return f"neither stiff nor soft where that mode bends most ({significant(correlation, 2)})"
    kind, effect = ("stiff", "raise") if correlation > 0 else ("soft", "lower")
    return f"{kind} where that mode bends most ({significant(correlation, 2)}), which tends to {effect} it"
