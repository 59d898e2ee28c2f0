"""The report of a made-up ship: what stands in it, and that it asks for nothing from outside."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from report_ship import made_up_run, plain_sections

from hullform import checks, rest_checks, wet_checks
from hullform.hull import Hull
from hullform.loading.structure import structure_of
from hullform.outcome import Run
from hullform.report.page import CHECK_LABELS, draw_pictures, failed_checks, render, write_report
from hullform.report.wording import reading_of_mode
from hullform.rounding import per_cent, significant
from hullform.ship_structure import StructureInput
from hullvib.bounds import Bracket


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Run]:
    with made_up_run(tmp_path_factory.mktemp("ship")) as run:
        yield run


@pytest.fixture(scope="module")
def page(run: Run) -> str:
    return render(run, draw_pictures(run), "<html><script>1 < 2</script></html>")


def test_report_and_figures_are_written(run: Run, tmp_path: Path) -> None:
    write_report(run, tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {"report.html", "figures"}
    names = {path.name for path in (tmp_path / "figures").iterdir()}
    assert names == {
        "overlay.jpg", "body-plan-fit.svg", "sectional-areas.svg", "hull.png", "mass.svg", "structure.svg",
        "midship-section.svg",
        "modes-loaded.svg", "modes-light-ship.svg",
        "added-mass-loaded.svg", "added-mass-light-ship.svg", "modes-with-shear.svg", "convergence.svg",
            "still-water-loaded.svg", "still-water-light-ship.svg",
    }  # fmt: skip
    # the limit that the design sets for a page that is mailed about
    assert (tmp_path / "report.html").stat().st_size < 8e6


def test_stations_have_the_names_and_errors_of_their_models(run: Run, page: str) -> None:
    assert "Each station is replaced by a super-ellipse" in page
    assert page.count(">super-ellipse</td>") == 10
    traced = Hull.from_body_plan(plain_sections(), run.ship.particulars, sections="traced")
    text = render(replace(run, hull=traced), draw_pictures(replace(run, hull=traced)), "")
    assert "(spline: 10)" in text
    assert text.count(">spline</td>") == 10
    worst = max(fit.model.largest_deviation_m for fit in traced.fits if fit.model is not None)
    assert f"<td>{significant(round(100 * worst / 32.2, 3))}</td>" in text


def test_a_ship_that_does_not_float_right_has_a_banner_and_one_that_does_has_none(run: Run) -> None:
    banner = 'role="alert"'
    light = run.conditions["light-ship"]
    sound = replace(light, checks=tuple(replace(check, limits=(-math.inf, math.inf)) for check in light.checks))
    sinking = replace(
        light, checks=(checks.Check("floats", "mass over displacement", 120.0, (0.0, 101.0), "%", "lighten her"),)
    )
    pictures = draw_pictures(run)
    assert banner not in render(replace(run, checks=(), conditions={"light-ship": sound}), pictures, "")
    text = render(replace(run, checks=(), conditions={"light-ship": sinking}), pictures, "")
    assert text.count(banner) == 1
    assert "Light-ship: something is wrong." in text
    assert "lighten her" in text


def test_this_ship_fails_her_checks_and_says_so_in_words(run: Run, page: str) -> None:
    assert failed_checks(run.conditions["loaded"].checks)
    assert 'class="fails"' in page
    assert ">fails</span>" in page
    in_doubt = [run.checks, *(condition.checks for condition in run.conditions.values())]
    assert page.count('role="alert"') == sum(bool(failed_checks(checks)) for checks in in_doubt)


def test_what_is_wrong_with_the_ship_stands_over_every_condition(run: Run, page: str) -> None:
    assert "displacement read at the design draught" in failed_checks(run.checks)[0].title
    assert page.index("The ship, in every condition: something is wrong.") < page.index('class="headline"')


def test_first_screen_has_each_frequency_to_three_figures(run: Run, page: str) -> None:
    start = page[page.index('class="headline"') : page.index('id="picture"')]
    for condition in run.conditions.values():
        for mode in range(3):
            assert f"<b>{significant(condition.modes.frequencies_hz[mode])} Hz</b>" in start
            assert f"{significant(condition.modes.cycles_per_minute[mode])} cycles/min" in start


def test_first_screen_is_of_the_girder_in_water_with_shear_and_sets_the_dry_one_beside_it(run: Run, page: str) -> None:
    start = " ".join(page[page.index('id="summary"') : page.index('id="picture"')].split())
    assert "girder with shear deflection, <strong>in water</strong>" in start
    for condition in run.conditions.values():
        assert (condition.modes.medium, condition.modes.theory) == ("wet", "shear-flexible")
        assert (condition.dry_modes.medium, condition.dry_modes.theory) == ("dry", "shear-flexible")
        for mode in range(3):
            dry, hz = condition.dry_modes.frequencies_hz[mode], condition.modes.frequencies_hz[mode]
            assert f"dry {significant(dry)} Hz · wet over dry {significant(hz / dry)}" in start


def test_wet_modes_are_tabled_with_what_the_water_does(run: Run, page: str) -> None:
    table = page[page.index('id="in-water"') :]
    table = table[: table.index("</table>")]
    for condition in run.conditions.values():
        water = condition.in_water
        for mode in range(3):
            hz = condition.modes.frequencies_hz[mode]
            share = water.shear.generalised_added_mass[mode] / water.shear.generalised_mass[mode]
            strips = per_cent(water.strips_shear.modes.frequencies_hz[mode], hz)
            assert (
                f"<td>{significant(water.euler.modes.frequencies_hz[mode])}</td>\n<td><strong>{significant(hz)}</strong>"
                in table
            )
            assert f"<td>{significant(share)}</td>\n<td>{significant(water.effective_factors[mode])}</td>" in table
            assert f"<td>{strips}</td></tr>" in table


def test_empirical_formulas_are_held_against_the_wet_figures(run: Run, page: str) -> None:
    section = page[page.index('id="empirical"') : page.index('id="table-2"')]
    for condition in run.conditions.values():
        water = condition.in_water.shear
        assert f"<td>{significant(1 + water.generalised_added_mass[0] / water.generalised_mass[0])}</td>" in section
        todd = 1.2 + 32.2 / (3 * condition.floating.draught_m)
        assert f"<td>{significant(todd)}</td>" in section
        kumai, wet = condition.empirical.figures_rad_s["kumai"], condition.modes.angular_frequencies
        for mode in range(3):
            assert f"<td>{significant(kumai[mode] / (2 * np.pi))} ({per_cent(kumai[mode], wet[mode])})</td>" in section
            assert f"<td><strong>{significant(wet[mode] / (2 * np.pi))}</strong></td>" in section


def test_three_beams_stand_side_by_side(run: Run, page: str) -> None:
    table = page[page.index('id="three-beams"') :]
    table = table[: table.index("</table>")]
    # 0.35 of the depth of 19.5 m
    assert "r = 0.35 D = 6.82 m" in table
    for condition in run.conditions.values():
        euler, timoshenko = (condition.solutions[name].frequencies_hz for name in ("stodola_ritz", "timoshenko"))
        for mode in range(3):
            shear = condition.dry_modes.frequencies_hz[mode]
            row = (
                f"<td>{significant(euler[mode])}</td>\n<td><strong>{significant(shear)}</strong></td>"
                f"<td>{per_cent(shear, euler[mode])}</td><td>{significant(timoshenko[mode])}</td>\n"
                f"<td>{per_cent(timoshenko[mode], shear)}</td>"
            )
            assert row in table


def test_the_modes_section_is_of_the_euler_bernoulli_girder(run: Run, page: str) -> None:
    section = page[page.index("What shapes the modes") : page.index('id="convergence"')]
    for condition in run.conditions.values():
        hz = condition.euler_modes.frequencies_hz[2]
        assert significant(hz) != significant(condition.modes.frequencies_hz[2])
        assert f"<td>{significant(hz)}</td>" in section


def test_the_numerical_error_is_the_width_of_the_bracket(run: Run) -> None:
    loaded, light = run.conditions.values()
    lower, upper = np.array([1.0, 2.0, 3.0]), np.array([1.0, 2.0, 3.0]) * (1 + np.array([2e-9, 3.2e-8, 1e-9]))
    proven = replace(loaded, bracket=Bracket(lower, upper, 16.0, "counted by hand"))
    pictures = draw_pictures(run)
    text = render(replace(run, conditions={"loaded": proven}), pictures, "")
    start = text[: text.index('id="picture"')]
    # 3.2e-8, rounded up
    assert "below 4 × 10⁻⁸ of the" in start
    assert "Proof: counted by hand." in text
    unproven = replace(light, bracket="EI vanishes at x = 0 & so on")
    text = render(replace(run, conditions={"loaded": proven, "light-ship": unproven}), pictures, "")
    assert "is not proven in every condition" in text[: text.index('id="picture"')]
    assert "Nothing is proven: EI vanishes at x = 0 &amp; so on" in text
    assert "below 4 × 10⁻⁸ of the" in text


def test_shear_area_is_told_bare_and_scaled(run: Run, page: str) -> None:
    structure = run.structure
    bare, scaled = structure.midship_shell_shear_area_m2, structure.midship_shear_area_m2
    section = " ".join(page[page.index('id="girder"') : page.index('id="modes"')].split())
    assert f"bare, {significant(bare)} m² at midships" in section
    assert f"the same factor {significant(structure.shear_factor)}: {significant(scaled)} m²" in section
    # G = E / 2.6
    assert "ν = 0.3, so G = E / (2 (1 + ν)) = 7.92 × 10¹⁰ N/m²" in section
    given, *_ = run.ship.require_sections_of_a_run()
    own = run.ship.model_copy(update={"structure": given.model_copy(update={"midship_shear_area_m2": 1.25})})
    text = " ".join(render(replace(run, ship=own), draw_pictures(run), "").split())
    assert "to reach the given 1.25 m²" in text


def test_the_midship_section_is_drawn_and_listed_with_its_thicknesses(run: Run, page: str) -> None:
    assert "side, 16 mm" in page
    given = StructureInput.model_validate(
        {
            "inner_bottom": {"height_m": 1.8, "thickness_m": 0.0145},
            "hatches": [{"breadth_m": 12.0}],
            "stiffener_share": 0.25,
            "transverse_bulkheads": [{"x_m": [100.0, 150.0]}],
        }
    )
    plated = replace(
        run, ship=run.ship.model_copy(update={"structure": given}), structure=structure_of(run.hull, given)
    )
    pictures = draw_pictures(plated)
    drawing = pictures["midship-section"].content.decode("utf-8")
    for label in ("inner bottom, 14.5 mm", "deck, 16 mm", "hatch opening, 12 m", "neutral axis, z = "):
        assert label in drawing
    section = " ".join(render(plated, pictures, "").split('id="girder"')[1].split('id="modes"')[0].split())
    row = '<th scope="row" class="words">inner bottom</th><td>14.5</td>'
    assert row in section
    assert "<td>25</td> <td>100</td>" in section
    steel = 7850 * plated.structure.steel_volume_m3 / 1000
    assert f"As modelled the steel weighs {significant(steel)} t, transverse bulkheads included" in section
    assert "end plates and transverse bulkheads at their place" in section
    assert "mm thick all round" not in section


def test_every_check_has_a_label_of_its_own() -> None:
    source = "".join(inspect.getsource(module) for module in (checks, rest_checks, wet_checks))
    ids = set(re.findall(r'(?:within|deviation|Check|_against_ships)\(\s*"([a-z-]+)"', source))
    assert len(ids) > 8
    assert ids == set(CHECK_LABELS)


def test_text_of_the_user_is_escaped(page: str) -> None:
    assert "loaded &lt;fully&gt;" in page
    assert "<fully>" not in page
    assert "look &amp; see" in page


def test_appendix_has_the_printed_figures(page: str, run: Run) -> None:
    assert 'id="table-2"' in page
    assert "SCIM Containership (Loaded)" in page
    assert "<td>22.62</td>" in page
    other = replace(
        run, ship=run.ship.model_copy(update={"particulars": run.ship.particulars.model_copy(update={"name": "other"})})
    )
    assert 'id="table-2"' not in render(other, draw_pictures(run), "")


class _Outline(HTMLParser):
    """Ids, links within the page, addresses, and elements left open."""

    VOID = frozenset({"meta", "link", "img", "br"})

    def __init__(self) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.targets: list[str] = []
        self.addresses: list[str] = []
        self.open: list[str] = []
        self.images_without_words = 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = dict(attributes)
        if given.get("id"):
            self.ids.append(str(given["id"]))
        href = given.get("href") or given.get("xlink:href") or ""
        if href.startswith("#"):
            self.targets.append(href[1:])
        self.addresses += [value for key in ("src", "href", "data") if (value := given.get(key))]
        self.images_without_words += tag == "img" and not given.get("alt")
        self.images_without_words += tag == "svg" and not given.get("aria-label")
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attributes)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_page_is_whole_and_asks_for_nothing_outside(page: str) -> None:
    outline = _Outline()
    outline.feed(page)
    assert outline.open == []
    assert len(outline.ids) == len(set(outline.ids))
    assert set(outline.targets) <= set(outline.ids)
    assert outline.images_without_words == 0
    assert [address for address in outline.addresses if not address.startswith(("#", "data:"))] == []
    assert not re.search(r"url\((?!#)|@import", page)


def test_viewer_cannot_end_its_script(page: str) -> None:
    held = re.search(r'<script type="application/json" id="hull-page">(.*?)</script>', page, re.DOTALL)
    assert held is not None
    assert "<" not in held[1]
    assert "\\u003cscript>1 \\u003c 2" in held[1]


def test_plain_words_follow_the_figures(run: Run) -> None:
    condition = run.conditions["light-ship"]
    weights = np.zeros((5, 12))
    weights[0, 0], weights[0, 2] = 0.4, 1.0
    strange = replace(condition, distortion=replace(condition.distortion, weights=weights))
    assert "mode 3, not 1, has the largest weight" in reading_of_mode(strange, 0)
    weights[0, 2] = 0.1
    dominance = np.full(5, 4.0)
    plain = replace(condition.distortion, weights=weights, diagonal_dominance=dominance)
    words = reading_of_mode(replace(condition, distortion=plain), 0)
    assert "outweighs all others together 4.0 times" in words
    heavy = replace(plain, correlation=replace(plain.correlation, mass=np.full(5, 0.5), rigidity=np.full(5, -0.5)))
    words = reading_of_mode(replace(condition, distortion=heavy), 0)
    assert "heavy where the uniform mode moves most" in words
    assert "soft where that mode bends most" in words


def test_figures_are_the_same_bytes_for_the_same_run(run: Run) -> None:
    first, second = draw_pictures(run), draw_pictures(run)
    assert {name: picture.content for name, picture in first.items()} == {
        name: picture.content for name, picture in second.items()
    }
