"""The review page's server as a program on this machine meets it: whom it answers, whom not, and how it ends."""

from __future__ import annotations

import http.client
import json
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import parse_qs, urlsplit

import cv2
import numpy as np
import pytest
from review_page import served

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
JSON = {"content-type": "application/json"}


class Address(NamedTuple):
    """Where a review is served, and the token in the address that it printed."""

    host: str
    port: int
    token: str

    @property
    def cookie(self) -> dict[str, str]:
        """What the browser sends after it opened the address."""
        return {"cookie": f"hullform-review-{self.port}={self.token}"}


@pytest.fixture(scope="module")
def ship(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("ship")
    shutil.copytree(BODYPLANS / "wigley", folder / "wigley", ignore=shutil.ignore_patterns("results"))
    return folder / "wigley" / "ship.toml"


@pytest.fixture(scope="module")
def address(ship: Path) -> Iterator[Address]:
    with served(ship) as url:
        yield address_of(url)


def address_of(url: str) -> Address:
    parts = urlsplit(url)
    assert parts.hostname is not None
    assert parts.port is not None
    return Address(parts.hostname, parts.port, parse_qs(parts.query)["token"][0])


def ask(
    address: Address, method: str, path: str, body: Any = None, headers: dict[str, str] | None = None
) -> tuple[int, bytes, dict[str, str]]:
    """Ask as the browser that opened the address does; what `headers` has goes before."""
    return ask_as(address, method, path, body, address.cookie | (headers or {}))


def ask_as(
    address: Address, method: str, path: str, body: Any, headers: dict[str, str]
) -> tuple[int, bytes, dict[str, str]]:
    connection = http.client.HTTPConnection(address.host, address.port, timeout=60)
    connection.request(method, path, None if body is None else json.dumps(body), headers)
    answer = connection.getresponse()
    content = answer.read()
    connection.close()
    return answer.status, content, {name.lower(): value for name, value in answer.getheaders()}


def test_page_and_modules_are_served_with_a_policy(address: Address) -> None:
    status, page, headers = ask(address, "GET", "/")
    assert status == 200
    assert f'name="review-token" content="{address.token}"'.encode() in page
    assert "default-src 'self'" in headers["content-security-policy"]
    for name in re.findall(rb'(?:src|href)="(/static/[^"]+)"', page):
        assert ask(address, "GET", name.decode())[0] == 200
    assert ask(address, "GET", "/static/../server.py")[0] == 404
    status, picture, headers = ask(address, "GET", "/picture")
    assert (status, headers["content-type"]) == (200, "image/png")
    assert picture == (BODYPLANS / "wigley" / "bodyplan.png").read_bytes()


@pytest.mark.parametrize("path", ["/", "/picture", "/api/opening", "/static/main.js"])
def test_another_host_name_is_refused(address: Address, path: str) -> None:
    status, content, _ = ask(address, "GET", path, headers={"host": f"ship.example:{address.port}"})
    assert status == 403
    assert b"this machine alone" in content


@pytest.mark.parametrize(
    "path", ["/", "/?token=guessed", "/picture", "/api/opening", "/api/strip?half=aft&station_m=25"]
)
@pytest.mark.parametrize("cookie", ["", "guessed"])
def test_nothing_of_the_ship_is_served_without_the_token(address: Address, path: str, cookie: str) -> None:
    headers = {"cookie": f"hullform-review-{address.port}={cookie}"} if cookie else {}
    status, content, answered = ask_as(address, "GET", path, None, headers)
    assert status == 403
    assert b"open the whole address that 'hullform review' printed" in content
    assert address.token.encode() not in content
    assert "set-cookie" not in answered
    # another review's cookie is no key to this one
    other = {"cookie": f"hullform-review-{address.port + 1}={address.token}"}
    assert ask_as(address, "GET", path, None, other)[0] == 403


def test_the_printed_address_hands_out_the_page_once_it_is_opened(address: Address) -> None:
    status, _, headers = ask_as(address, "GET", f"/?token={address.token}", None, {})
    assert (status, headers["location"]) == (303, "/")
    cookie = headers["set-cookie"]
    assert "httponly" in cookie.lower()
    assert "samesite=lax" in cookie.lower()
    assert ask_as(address, "GET", "/", None, {"cookie": cookie.split(";")[0]})[0] == 200


def test_writing_needs_the_token_of_this_run_and_no_other_origin(address: Address, ship: Path) -> None:
    review = json.loads(ask(address, "GET", "/api/opening")[1])["review"]
    # the browser adds the cookie to what another page sends, so that alone must not do
    assert ask(address, "PUT", "/api/review", review, JSON)[0] == 403
    assert ask(address, "POST", "/api/save", review, JSON | {"x-review-token": "guessed"})[0] == 403
    good = JSON | {"x-review-token": address.token}
    assert ask(address, "POST", "/api/save", review, good | {"origin": "http://ship.example"})[0] == 403
    assert not ship.with_name("ship.review.json").exists()
    own = f"http://{address.host}:{address.port}"
    assert ask(address, "PUT", "/api/review", review, good | {"origin": own})[0] == 200


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ([], b"sent no review"),
        ({"schema": 1}, b"picture: Field required"),
        ({"schema": 1, "picture": {"file": "bodyplan.png", "sha256": "0" * 64}}, b"made of another picture"),
    ],
)
def test_what_is_no_review_is_refused_with_the_reason(address: Address, body: Any, words: bytes) -> None:
    status, content, _ = ask(address, "PUT", "/api/review", body, {"x-review-token": address.token})
    assert status == 422
    assert words in content


def test_a_file_that_another_has_saved_is_not_written_over_in_silence(tmp_path: Path) -> None:
    shutil.copytree(BODYPLANS / "wigley", tmp_path / "wigley", ignore=shutil.ignore_patterns("results"))
    ship = tmp_path / "wigley" / "ship.toml"
    file = ship.with_name("ship.review.json")
    with served(ship) as url:
        here = address_of(url)
        opened = json.loads(ask(here, "GET", "/api/opening")[1])

        def save(corrections: list[dict[str, Any]], revision: str) -> tuple[int, dict[str, Any]]:
            headers = JSON | {"x-review-token": here.token, "x-review-revision": revision}
            body = opened["review"] | {"corrections": corrections}
            status, content, _ = ask(here, "POST", "/api/save", body, headers)
            return status, json.loads(content)

        first = {"id": "c1", "kind": "cut", "px": [500.0, 700.0]}
        status, saved = save([first], opened["revision"])
        assert status == 200
        assert saved["revision"] != opened["revision"]
        # a second page, opened before that
        status, refused = save([], opened["revision"])
        assert status == 412
        assert "was changed since this page read it" in refused["message"]
        assert json.loads(file.read_text(encoding="utf-8"))["corrections"] == [first]
        # a page that is opened now goes on from the file, whoever wrote it
        changed = file.read_text(encoding="utf-8").replace("500.0", "501.0")
        file.write_text(changed, encoding="utf-8")
        again = json.loads(ask(here, "GET", "/api/opening")[1])
        assert again["review"]["corrections"][0]["px"][0] == 501.0
        assert save([first], saved["revision"])[0] == 412
        assert save([first], again["revision"])[0] == 200


def test_strip_along_a_curve_has_its_line_in_the_middle(address: Address) -> None:
    status, content, _ = ask(address, "GET", "/api/strip?half=aft&station_m=25&curve=0")
    assert status == 200
    strip = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert strip is not None
    # rows are half a pixel apart; crossings with the grid darken others, but never most of a row
    darkest = int(np.argmin(np.median(strip, axis=1)))
    assert abs(darkest - strip.shape[0] // 2) <= 2
    status, content, _ = ask(address, "GET", "/api/strip?half=aft&station_m=26&curve=0")
    assert (status, b"has no curve" in content) == (422, True)


def test_interrupt_ends_it_well_and_a_taken_port_is_told(ship: Path, address: Address) -> None:
    command = [sys.executable, "-m", "hullform.cli", "review", str(ship), "--no-browser"]
    taken = subprocess.run([*command, "--port", str(address.port)], capture_output=True, text=True, timeout=60)
    assert taken.returncode == 1
    assert f"port {address.port} of 127.0.0.1 cannot be used" in taken.stderr
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert "http://127.0.0.1:" in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=20)
    assert process.returncode == 0
    assert told == "review ended\n"
