"""Wet modes: closed forms, limits, what is reported and what is refused."""

import numpy as np
import pytest
from floating_bodies import (
    SpheroidFlow,
    prism_sections,
    rectangle,
    spheroid_panels,
    spheroid_sections,
    uniform_girder,
)

from hullvib import (
    FiniteElements,
    Girder,
    Ritz,
    StodolaRitz,
    TimoshenkoElements,
    TimoshenkoRitz,
    mac,
    orthogonality,
    solve,
    wet,
)
from hullvib.errors import ArgumentError, SolutionError

LENGTH, BREADTH, DRAUGHT = 200.0, 20.0, 8.0
MASS, WATER = 160e3, 90e3  # kg/m
GIRDER = uniform_girder(LENGTH, MASS, 2e13, 8e10)
SHEAR = StodolaRitz(12, shear=True)


def strips(added=WATER, lengthwise="none"):
    return wet.StripFlow(prism_sections(rectangle(BREADTH, DRAUGHT), LENGTH, 21), np.full(21, added), lengthwise)


def spheroid_flow(**options):
    return wet.PanelFlow(spheroid_panels(LENGTH, BREADTH, 24, 6), **{"neutral_axis_m": 0.0, **options})


@pytest.mark.parametrize("method", [StodolaRitz(12), SHEAR], ids=["euler", "shear"])
def test_water_spread_as_the_mass_is(method):
    """The shapes stay and the frequencies are those of the added mass and, with it, of the buoyancy's springs."""
    dry = solve(GIRDER, method).angular_frequencies
    found = wet.solve(GIRDER, strips(), method)
    springs = 1025.0 * 9.81 * BREADTH
    exact = np.sqrt((dry**2 * MASS + springs) / (MASS + WATER))
    np.testing.assert_allclose(found.modes.angular_frequencies, exact, rtol=1e-9)
    np.testing.assert_allclose(found.mac_dry, np.eye(5), atol=1e-9)
    np.testing.assert_allclose(found.generalised_added_mass / found.generalised_mass, WATER / MASS, rtol=1e-7)
    np.testing.assert_allclose(found.effective_factors(strips()), 1.0, rtol=1e-7)
    np.testing.assert_allclose(found.hydrostatic_stiffness_share, springs / (dry**2 * MASS + springs), rtol=1e-7)
    heave = np.sqrt(springs / (MASS + WATER))
    assert found.heave.angular_frequency == pytest.approx(heave, rel=1e-9)
    assert found.pitch.angular_frequency == pytest.approx(heave, rel=1e-9)
    assert found.heave.share == pytest.approx(1.0)


@pytest.mark.parametrize(
    "method",
    [StodolaRitz(12), SHEAR, Ritz(12), FiniteElements(80), TimoshenkoRitz(16), TimoshenkoElements(80)],
    ids=lambda method: type(method).__name__,
)
def test_no_water_gives_the_dry_modes(method):
    girder = Girder(
        [0, 50, 50, 200], [5e4, 3e5, 2e5, 4e4], [1e13, 3e13, 4e13, 1e13],
        shear_rigidity=[6e10, 9e10, 9e10, 5e10], rotary_inertia=[1e7, 1e7, 2e7, 1e7],
    )  # fmt: skip
    found = wet.solve(girder, strips(1e-9), method, hydrostatics=False)
    dry = solve(girder, method, 5)
    np.testing.assert_allclose(found.modes.angular_frequencies, dry.angular_frequencies, rtol=1e-8)
    np.testing.assert_allclose(found.frequency_ratios, 1.0, rtol=1e-8)
    assert found.modes.theory == dry.theory
    assert found.heave.angular_frequency < 1e-3 * dry.angular_frequencies[0]
    x = np.linspace(0.0, 200.0, 37)
    for name in ("shape", "rotation", "moment", "shear"):
        own, theirs = getattr(found.modes, name)(x), getattr(dry, name)(x)
        assert np.abs(own - theirs).max(axis=1) == pytest.approx(0.0, abs=1e-5 * np.abs(theirs).max())


def test_every_method_finds_the_same_wet_frequencies():
    girder = Girder([0, 60, 60, 200], [5e4, 3e5, 2e5, 4e4], [1e13, 3e13, 4e13, 1e13])
    flow = spheroid_flow()
    sharp = wet.solve(girder, flow, StodolaRitz(16), functions=16).modes.angular_frequencies
    elements = wet.solve(girder, flow, FiniteElements(120), functions=16).modes.angular_frequencies
    np.testing.assert_allclose(elements[:4], sharp[:4], rtol=1e-5)
    # the paper's basis is not complete alone; heave and pitch are added here whatever the dry basis had
    paper = wet.solve(girder, flow, Ritz(24, rigid_body=False), functions=24).modes.angular_frequencies
    np.testing.assert_allclose(paper[:3], sharp[:3], rtol=2e-3)


def test_more_dry_modes_lower_the_wet_frequencies_and_twelve_suffice():
    x = np.linspace(0.0, LENGTH, 41)
    girder = Girder(x, 5e4 + 2e5 * np.sin(np.pi * x / LENGTH) ** 2, 1e12 + 3e13 * np.sin(np.pi * x / LENGTH),
                    shear_rigidity=np.full(41, 5e10))  # fmt: skip
    flow = spheroid_flow()
    ladder = [
        wet.solve(girder, flow, StodolaRitz(24, shear=True), functions=n).modes.angular_frequencies for n in (8, 12, 24)
    ]
    assert (np.diff(ladder, axis=0) <= 1e-9).all()
    # a girder that is soft and light at her ends, where the water is not; on ships 12 leave 1e-5
    np.testing.assert_allclose(ladder[1][:4], ladder[2][:4], rtol=1e-3)
    np.testing.assert_allclose(ladder[1][:2], ladder[2][:2], rtol=1e-4)


def test_wet_modes_are_orthogonal_in_ship_and_water():
    found = wet.solve(GIRDER, spheroid_flow(), SHEAR)
    field = found.modes.field
    a = found.coefficients
    water = a @ found.added_mass.matrix @ a.T
    x, weights = np.polynomial.legendre.leggauss(60)
    ship = (field.evaluate(0.5 * (x + 1), 0) * (0.5 * weights * MASS * LENGTH)) @ field.evaluate(0.5 * (x + 1), 0).T
    whole = (ship + water) / np.sqrt(np.outer(found.modes.modal_mass, found.modes.modal_mass))
    np.testing.assert_allclose(whole, np.eye(5), atol=1e-6)


def test_the_normalisations_hold_in_water():
    modes = wet.solve(GIRDER, spheroid_flow()).modes
    x = np.linspace(0.0, LENGTH, 2001)
    assert np.abs(modes.shape(x)).max(axis=1) == pytest.approx(1.0, rel=1e-5)
    assert (modes.shape([0.0]) > 0).all()
    paper = modes.normalised("paper")
    assert np.trapezoid(paper.shape(x) ** 2, x, axis=1) == pytest.approx(LENGTH, rel=1e-4)
    assert modes.normalised("unit-modal-mass").modal_mass == pytest.approx(1.0)
    assert modes.medium == "wet"
    assert modes.node_counts.tolist() == [2, 3, 4, 5, 6]


def test_forces_along_the_hull_do_the_work_of_the_added_mass():
    """Sliding sections (the girder in the waterline hardly moves them lengthwise): sum of f w dx is a_nn."""
    flow = wet.StripFlow(spheroid_sections(LENGTH, BREADTH, 61))
    found = wet.solve(GIRDER, flow)
    edges = found.added_mass.edges_m
    shapes = found.modes.shape(0.5 * (edges[1:] + edges[:-1]))
    work = (found.force_kg_per_m * shapes * np.diff(edges)).sum(axis=1)
    np.testing.assert_allclose(work, found.generalised_added_mass, rtol=1e-2)
    along = found.added_mass_per_length()
    assert np.isnan(along).any(axis=1).all()
    middle = int(np.abs(edges - LENGTH / 2).argmin())
    # amidships the two-node mode has its greatest motion: J m of the section there, J between 0.7 and 1
    section = flow.section_kg_per_m.max()
    assert 0.7 * section < along[0, middle] < section


def test_panels_force_along_the_hull_adds_up():
    found = wet.solve(GIRDER, spheroid_flow())
    along = found.added_mass_per_length()[:3]
    # a ship that is the same fore and aft
    np.testing.assert_allclose(along, along[:, ::-1], rtol=1e-3)
    assert (along[~np.isnan(along)] > 0.0).all()
    heave = found.added_mass.force_kg_per_m[0] @ np.diff(found.added_mass.edges_m)
    assert heave == pytest.approx(found.added_mass.matrix[0, 0], rel=1e-3)


def test_heave_and_pitch_are_told_from_elastic_modes_that_are_near():
    """A limp girder, whose two-node mode lies 2 per cent above heave."""
    limp = uniform_girder(LENGTH, MASS, 2e10)
    found = wet.solve(limp, strips(), modes=3)
    springs = np.sqrt(1025.0 * 9.81 * BREADTH / (MASS + WATER))
    assert found.heave.angular_frequency == pytest.approx(springs, rel=1e-9)
    assert found.modes.angular_frequencies[0] == pytest.approx(springs, rel=0.02)
    assert found.modes.node_counts.tolist() == [2, 3, 4]


@pytest.mark.parametrize(("outside", "pitch_is_slower"), [(False, True), (True, False)])
def test_pitch_is_told_from_heave_whichever_is_slower(outside, pitch_is_slower):
    """A waterline that is broad amid stiffens heave, one that is broad at the ends pitch."""
    broad = (np.abs(np.linspace(-1, 1, 41)) > 0.5) == outside
    sections = wet.Sections(
        np.linspace(0, LENGTH, 41), np.stack([rectangle(b, DRAUGHT) for b in np.where(broad, BREADTH, 0.2)])
    )
    found = wet.solve(GIRDER, wet.StripFlow(sections, np.full(41, WATER), "none"))
    assert (found.pitch.angular_frequency < found.heave.angular_frequency) == pitch_is_slower
    assert found.modes.node_counts.tolist() == [2, 3, 4, 5, 6]


def test_hydrostatics_stiffen_and_the_tail_lightens():
    flow = spheroid_flow()
    plain = wet.solve(GIRDER, flow, hydrostatics=False).modes.angular_frequencies
    stiff = wet.solve(GIRDER, flow).modes.angular_frequencies
    tail = wet.solve(GIRDER, flow, frequency_tail=True)
    assert (stiff > plain).all()
    assert (tail.modes.angular_frequencies > stiff).all()
    # the factor is 1 - 4 / (3 pi k) of the added mass: by the first mode's own figures
    k = tail.modes.angular_frequencies[0] ** 2 * BREADTH / (2 * 9.81)
    share = tail.generalised_added_mass[0] / (tail.coefficients @ tail.added_mass.matrix @ tail.coefficients.T)[0, 0]
    assert share == pytest.approx(1 - 4 / (3 * np.pi * k), rel=1e-9)
    assert share == pytest.approx(tail.tail[0], rel=1e-9)
    # and the force along the hull is what that mass is made of
    edges = tail.added_mass.edges_m
    x = np.linspace(0.0, LENGTH, 4001)
    force = tail.force_kg_per_m[0][np.clip(np.searchsorted(edges, x, side="right") - 1, 0, len(edges) - 2)]
    assert np.trapezoid(force * tail.modes.shape(x)[0], x) == pytest.approx(tail.generalised_added_mass[0], rel=0.02)


def test_a_mode_so_slow_that_it_makes_waves_has_no_tail():
    soft = uniform_girder(LENGTH, 1e5, 1e10)
    with pytest.raises(SolutionError, match=r"a mode near .* Hz makes waves.*leave it out"):
        wet.solve(soft, spheroid_flow(), frequency_tail=True)


def test_neutral_axis_may_be_a_number_a_table_or_a_function():
    heights = (-3.0, ([0.0, LENGTH], [-3.0, -3.0]), lambda x: np.full_like(x, -3.0))
    found = [wet.solve(GIRDER, spheroid_flow(neutral_axis_m=height)).modes.angular_frequencies for height in heights]
    np.testing.assert_allclose(found[1:], [found[0]] * 2, rtol=1e-12)
    assert (wet.solve(GIRDER, spheroid_flow()).modes.angular_frequencies != found[0]).all()


def test_the_record_says_how():
    record = wet.solve(GIRDER, spheroid_flow(), SHEAR).modes.method
    assert record["method"] == "wet_ritz"
    assert record["dry_method"] == "stodola_ritz"
    assert record["flow"] == "panels"
    assert record["panels"] == 2 * 144


def test_wet_modes_are_held_against_dry_ones():
    found = wet.solve(GIRDER, spheroid_flow())
    own = np.diag(found.mac_dry)
    assert (own > 0.8).all()
    assert (own < 1.0).all()
    np.testing.assert_allclose(found.mac_dry, mac(found.modes, solve(GIRDER, StodolaRitz(12))), atol=1e-9)


class TestRefusals:
    def test_orthogonality_without_the_water(self):
        with pytest.raises(ArgumentError, match="the modes are wet"):
            orthogonality(wet.solve(GIRDER, strips()).modes)

    def test_more_modes_than_functions(self):
        with pytest.raises(ArgumentError, match="6 wet modes were asked of 5"):
            wet.solve(GIRDER, strips(), modes=6, functions=5)

    def test_a_hull_longer_than_the_girder(self):
        girder = uniform_girder(100.0, MASS, 2e13)
        with pytest.raises(ArgumentError, match=r"the hull reaches from x = .* the girder from 0 to 100 m"):
            wet.solve(girder, spheroid_flow())

    def test_a_bottom_above_the_keel(self):
        with pytest.raises(ArgumentError, match="reaches down to 10 m"):
            spheroid_flow(depth_m=9.0)

    def test_a_density_of_nought(self):
        with pytest.raises(ArgumentError, match="1025 for sea water"):
            spheroid_flow(density_kg_m3=0.0)

    def test_unknown_names(self):
        sections = prism_sections(rectangle(BREADTH, DRAUGHT), LENGTH)
        with pytest.raises(ArgumentError, match="'kumai'"):
            wet.StripFlow(sections, "panels", "kumai")
        with pytest.raises(ArgumentError, match="'frank'"):
            wet.StripFlow(sections, "frank")

    def test_an_axis_that_is_nowhere(self):
        with pytest.raises(ArgumentError, match="neutral axis"):
            wet.solve(GIRDER, spheroid_flow(neutral_axis_m=float("nan")))


def test_the_exact_flow_serves_as_a_flow():
    """Any object with the three members of a Flow does."""
    found = wet.solve(GIRDER, SpheroidFlow(LENGTH, BREADTH))
    panels = wet.solve(GIRDER, spheroid_flow())
    np.testing.assert_allclose(found.modes.angular_frequencies, panels.modes.angular_frequencies, rtol=0.01)
