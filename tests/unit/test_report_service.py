"""What the report and the terminal say of a made-up ship in service: propeller, engine, waves, ships as they are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from report_ship import SHIP, made_up_run

from hullform.in_service import in_service as hold_in_service
from hullform.outcome import Run
from hullform.report.page import draw_pictures, render
from hullform.rounding import signed, significant
from hullform.ship import read_ship
from hullform.terminal import summary
from hullvib.real_ships import ratios

SERVICE = """
[excitation]
propeller_blades = 5
shaft_speed_rpm = [30.0, 104.0]
service_rpm = 100.0
cylinders = 6
engine_orders = [1, 2]
engine_x_m = 50.0
m1v_nm = 4.0e5
rated_power_kw = 30000.0
damping = 0.015
[operation]
speeds_knots = [1.0, 24.0]
headings_deg = [180.0, 0.0]
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Run]:
    with made_up_run(tmp_path_factory.mktemp("ship")) as run:
        yield run


@pytest.fixture(scope="module")
def page(run: Run) -> str:
    return render(run, draw_pictures(run), "<html><script>1 < 2</script></html>")


@pytest.fixture(scope="module")
def in_service(run: Run, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """The same ship with an engine, a propeller and a sea."""
    path = tmp_path_factory.mktemp("service") / "ship.toml"
    path.write_text(SHIP + SERVICE, encoding="utf-8")
    ship = read_ship(path)
    held = {name: hold_in_service(ship, condition.modes) for name, condition in run.conditions.items()}
    return replace(run, ship=ship, in_service=held)


def test_without_excitation_and_operation_the_report_says_so(page: str) -> None:
    section = page[page.index('id="service"') : page.index('id="methods"')]
    assert "ship.toml has no <code>[excitation]</code>" in section
    assert "ship.toml has no <code>[operation]</code>" in section


def test_every_hit_stands_in_the_report_with_its_speeds(in_service: Run) -> None:
    pictures = draw_pictures(in_service)
    names = {"resonance-loaded", "response-loaded", "resonance-light-ship", "response-light-ship", "springing"}
    assert names <= set(pictures)
    page = render(in_service, pictures, "")
    for name, service in in_service.in_service.items():
        found = service.resonances
        assert found is not None
        assert found.hits
        part = page[page.index(f'id="figure-resonance-{name}"') : page.index(f'id="figure-response-{name}"')]
        for hit, response in zip(found.hits, found.responses, strict=True):
            low, high = (significant(rpm) for rpm in hit.avoid_rpm)
            star = " *" if hit.flagged else ""
            row = part.index(f'<th scope="row">{hit.mode}{star}</th><td class="words">{hit.source.name}</td>')
            cells = part[row : part.index("</tr>", row)]
            assert f"<td>{low}–{high}</td>" in cells
            assert ("<strong>hit</strong>" in cells) == hit.holds(100.0)
            assert significant(1e3 * response.motion.peak_velocity_m_s[0]) in cells
        for low, high in found.avoid_rpm:
            assert f"{significant(low)} to {significant(high)} rpm" in part
        margins = part[part.index("Margins at the service speed, 100 rpm") :]
        assert margins.count("<strong>") == sum(hit.holds(100.0) for hit in found.hits)
        assert found.margins is not None
        for margin in found.margins.ravel():
            assert f"{signed(100 * margin)}<" in margins
    assert "give <code>m2v_nm</code>" in page
    assert "no verdict on habitability" in page
    assert "Outside beam theory at the service speed: blade rate, 8.33 Hz" in " ".join(page.split())
    # 4e5 N m over 30 MW: 13.3 N m/kW
    assert '<td>13.3</td><td class="words">not relevant</td>' in page


def test_axes_of_the_service_figures_have_units(in_service: Run) -> None:
    pictures = draw_pictures(in_service)
    for name, labels in (
        ("resonance-loaded", ("shaft speed, rpm", "frequency, Hz", "outside beam theory", "service 100 rpm")),
        (
            "response-loaded",
            (
                "peak velocity, mm/s",
                "x from the aft end, m",
                "loads as given",
                "of 1 kN at the propeller",
                "of 1 MN m at the engine",
            ),
        ),
        ("springing", ("wave length, m", "wave period, s", "speed, knots", "head seas, 180°", "following seas, 0°")),
    ):
        text = pictures[name].content.decode("utf-8")
        for label in labels:
            assert label in text


def test_the_waves_that_she_overtakes_are_marked(in_service: Run) -> None:
    page = render(in_service, draw_pictures(in_service), "")
    table = page[page.index('id="figure-springing"') : page.index('id="methods"')]
    found = in_service.in_service["loaded"].springing
    assert found is not None
    for met in found.waves:
        cell = f"{significant(met.wave.length_m)} ({significant(met.wave.length_m / 262.0, 2)}), "
        cell += f"{significant(met.wave.period_s)} s{'†' if met.wave.overtaken else ''}"
        assert cell in table


def test_ships_as_they_are_stand_beside_her(run: Run, page: str) -> None:
    section = page[page.index('id="ships-as-they-are"') : page.index('id="service"')]
    for condition in run.conditions.values():
        for ratio in ratios(condition.modes.angular_frequencies):
            assert f"<td>{significant(ratio)}</td>" in section
    assert "1.7–2.15" in section
    dry = next(iter(run.conditions.values())).modes.medium == "dry"
    assert ("are <strong>dry</strong>" if dry else "A ratio outside is a doubt") in section


def test_the_terminal_tells_what_to_avoid(in_service: Run, run: Run) -> None:
    text = summary(in_service)
    found = in_service.in_service["loaded"].resonances
    assert found is not None
    low, high = found.avoid_rpm[0]
    assert f"  loaded: {significant(low)}-{significant(high)}" in text
    assert "at the service speed, 100: " in text
    for hit in found.hits:
        words = f"{hit.source.name} hits mode {hit.mode}{'*' if hit.flagged else ''}, "
        assert (words in text.split("  light-ship:")[0].split("shaft speeds")[1]) == hit.holds(100.0)
    assert "shaft speeds" not in summary(run)
    assert "ships in water: 1.7-2.15, 2.8-3.2" in summary(run)
