"""Sections and panels: what they enclose, how they are cut, what is refused."""

import numpy as np
import pytest
from floating_bodies import SEMICIRCLE, prism_sections, rectangle, spheroid_panels, spheroid_sections

from hullvib.errors import ArgumentError
from hullvib.wet import Panels, Sections
from hullvib.wet.influence import influence, panel_integrals
from hullvib.wet.panels import MOST_PANELS, graded_places


def test_a_box_encloses_its_volume_and_is_closed():
    panels = Panels.from_sections(prism_sections(rectangle(12.0, 4.0), 80.0), 10, 8)
    # the piece at the bilge cuts its corner
    assert panels.volume_m3 == pytest.approx(80 * 12 * 4, rel=1e-3)
    assert panels.open_share < 1e-12
    assert panels.extent_m == (0.0, 80.0)
    g = panels.geometry
    # bottom, side and two ends of the half, nothing inside, nothing twice
    assert g.areas.sum() == pytest.approx(80 * (6 + 4) + 2 * 6 * 4, rel=0.01)
    outwards = np.einsum("ij,ij->i", g.normals, g.centres - [40.0, 0.0, -2.0])
    assert (outwards > 0).all()


def test_corners_of_a_section_are_kept_by_short_pieces():
    curve = prism_sections(rectangle(12.0, 4.0), 80.0).cut(10)[0]
    nearest = np.hypot(*(curve - [6.0, -4.0]).T).min()
    assert nearest < 0.15
    area = np.abs(np.trapezoid(curve[:, 0], curve[:, 1]))
    assert area == pytest.approx(24.0, rel=2e-3)


def test_a_semicircle_is_cut_evenly():
    pieces = np.hypot(*np.moveaxis(np.diff(prism_sections(SEMICIRCLE, 1.0).cut(9)[0], axis=0), -1, 0))
    assert pieces == pytest.approx(pieces.mean(), rel=0.02)


def test_sections_know_their_breadth_draught_and_area():
    sections = spheroid_sections(100.0, 20.0, 41)
    assert sections.half_breadth_m[20] == pytest.approx(10.0)
    assert sections.draught_m[20] == pytest.approx(10.0)
    assert sections.area_m2[20] == pytest.approx(np.pi * 50.0, rel=1e-4)
    assert sections.volume_m3 == pytest.approx(np.pi / 6 * 100 * 20**2 / 2, rel=2e-3)


def test_panels_of_a_spheroid_lie_just_within_it():
    panels = spheroid_panels(100.0, 20.0, 48, 12)
    assert panels.volume_m3 == pytest.approx(np.pi / 6 * 100 * 20**2 / 2, rel=5e-3)
    assert panels.volume_m3 < np.pi / 6 * 100 * 20**2 / 2


def test_sections_between_stations_are_interpolated():
    wedge = Sections([0.0, 10.0], np.stack([rectangle(2.0, 1.0), rectangle(4.0, 2.0)]))
    panels = Panels.from_sections(wedge, 20, 6)
    # breadth and draught linear between (2, 1) and (4, 2): the integral of 2 (1 + t)^2, but for the cut corners
    assert panels.volume_m3 == pytest.approx(10 * 2 * (1 + 1 + 1 / 3), rel=0.01)


@pytest.mark.parametrize(
    ("points", "complaint"),
    [
        ([[0, -1], [1, -1], [1, 0.5]], "rises above the waterline"),
        ([[0, -1], [1, -1], [1, -0.5]], "ends neither at the waterline"),
        ([[0.5, -1], [1, -1], [1, 0]], "does not begin at the centre line"),
        ([[0, -1], [-1, -1], [-1, 0]], "across the centre line"),
        ([[0, -1], [np.nan, -1], [1, 0]], "not finite"),
        ([[0, 0], [1, 0], [1, 0]], "no section has an area"),
    ],
)
def test_wrong_sections_are_refused(points, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        Sections([0.0, 10.0], [points, points])


def test_sections_out_of_order_are_refused():
    with pytest.raises(ArgumentError, match="x_m must increase, but 1 follows 2"):
        Sections([0.0, 2.0, 1.0], np.broadcast_to(rectangle(2.0, 1.0), (3, 3, 2)))


def test_a_section_under_water_may_close_on_the_centre_line():
    bulb = [[0.0, -3.0], [1.0, -2.0], [0.0, -1.0]]
    sections = Sections([0.0, 1.0], [bulb, bulb])
    assert sections.half_breadth_m.tolist() == [0.0, 0.0]
    assert sections.area_m2[0] == pytest.approx(2.0)


class TestPanels:
    quad = np.array([[0.0, 0, -1], [0, 1, -1], [1, 1, -1], [1, 0, -1]])

    def test_panels_that_face_inwards_are_refused(self):
        with pytest.raises(ArgumentError, match="turn the order of the corners round"):
            Panels(self.quad, [[3, 2, 1, 0]])

    def test_the_other_half_is_refused(self):
        with pytest.raises(ArgumentError, match="give the half of the hull with y >= 0"):
            Panels(self.quad * [1, -1, 1], [[3, 2, 1, 0]])

    def test_what_is_above_water_is_refused(self):
        with pytest.raises(ArgumentError, match="cut the hull at the waterline"):
            Panels(self.quad + np.array([0, 0, 2]), [[0, 1, 2, 3]])

    def test_wrong_indices_are_refused(self):
        with pytest.raises(ArgumentError, match="vertices 0 to 3"):
            Panels(self.quad, [[0, 1, 2, 4]])

    def test_triangles_are_taken(self):
        assert len(Panels(self.quad, [[0, 1, 2], [0, 2, 3]])) == 2

    def test_slivers_are_left_out(self):
        vertices = np.vstack([self.quad, self.quad[2] + [1e-9, 0, 0]])
        assert len(Panels(vertices, [[0, 1, 2, 3], [1, 2, 4, 4]])) == 1

    def test_too_many_are_refused(self):
        with pytest.raises(ArgumentError, match="500 enough"):
            Panels(self.quad, np.tile([0, 1, 2, 3], (MOST_PANELS + 1, 1)))


class TestInfluence:
    square = np.array([[[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0]]])
    up, origin = np.array([[0.0, 0, 1]]), np.zeros((1, 3))

    def test_a_square_on_itself(self):
        single, double = panel_integrals(self.square, self.up, self.origin, self.origin)
        # int 1/r over a unit square from its centre: 4 ln(1 + sqrt 2)
        assert single[0] == pytest.approx(4 * np.log(1 + np.sqrt(2)), rel=1e-13)
        assert double[0] == 0.0

    @pytest.mark.parametrize("at", [(0.2, 0.1, 0.3), (0.7, -0.2, -0.4), (1.5, 1.0, 0.05), (0.5, 0.5, 0.2)])
    def test_a_square_against_many_points(self, at):
        nodes, weights = np.polynomial.legendre.leggauss(120)
        x, y = np.meshgrid(nodes / 2, nodes / 2)
        w = np.outer(weights, weights) / 4
        r = np.sqrt((at[0] - x) ** 2 + (at[1] - y) ** 2 + at[2] ** 2)
        single, double = panel_integrals(self.square, self.up, self.origin, np.array([at]))
        assert single[0] == pytest.approx((w / r).sum(), rel=1e-8)
        assert double[0] == pytest.approx((w * at[2] / r**3).sum(), rel=1e-6)

    def test_greens_identity_within_the_double_body(self):
        """z is regular in the double body and odd about its middle: 2 pi z = int z_n / r - z d(1/r)/dn."""
        panels = spheroid_panels(20.0, 6.0, 48, 16)
        g = panels.geometry
        source, dipole = influence(panels)
        height = g.centres[:, 2]
        left = 2.0 * np.pi * height
        assert np.abs(source @ g.normals[:, 2] - dipole @ height - left).max() < 0.01 * np.abs(left).max()

    def test_images_in_the_bottom_fade(self):
        panels = spheroid_panels(20.0, 6.0, 12, 4)
        deep = influence(panels)
        for depth, share in ((1e4, 1e-6), (100.0, 1e-2)):
            shallow = influence(panels, depth)
            for one, other in zip(deep, shallow, strict=True):
                assert np.abs(one - other).max() < share * np.abs(one).max()


def test_graded_places_end_where_they_are_told_to():
    # first + (last - first) is a round-off more than last for about every seventh of these
    for first in np.random.default_rng(0).uniform(0.0, 3.0, 100):
        places = graded_places(first, 7.3, 34)
        assert (places[0], places[-1]) == (first, 7.3)
        assert (np.diff(places) > 0).all()
