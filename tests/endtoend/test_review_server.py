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
from typing import Any

import cv2
import numpy as np
import pytest
from review_page import served

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
JSON = {"content-type": "application/json"}


@pytest.fixture(scope="module")
def ship(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("ship")
    shutil.copytree(BODYPLANS / "wigley", folder / "wigley", ignore=shutil.ignore_patterns("results"))
    return folder / "wigley" / "ship.toml"


@pytest.fixture(scope="module")
def address(ship: Path) -> Iterator[tuple[str, int]]:
    with served(ship) as url:
        host, port = url.removeprefix("http://").rstrip("/").split(":")
        yield host, int(port)


def ask(
    address: tuple[str, int], method: str, path: str, body: Any = None, headers: dict[str, str] | None = None
) -> tuple[int, bytes, dict[str, str]]:
    connection = http.client.HTTPConnection(*address, timeout=60)
    connection.request(method, path, None if body is None else json.dumps(body), headers or {})
    answer = connection.getresponse()
    content = answer.read()
    connection.close()
    return answer.status, content, {name.lower(): value for name, value in answer.getheaders()}


def token(address: tuple[str, int]) -> str:
    found = re.search(rb'name="review-token" content="([^"]+)"', ask(address, "GET", "/")[1])
    assert found is not None
    return found.group(1).decode()


def test_page_and_modules_are_served_with_a_policy(address: tuple[str, int]) -> None:
    status, page, headers = ask(address, "GET", "/")
    assert status == 200
    assert "default-src 'self'" in headers["content-security-policy"]
    for name in re.findall(rb'(?:src|href)="(/static/[^"]+)"', page):
        assert ask(address, "GET", name.decode())[0] == 200
    assert ask(address, "GET", "/static/../server.py")[0] == 404
    status, picture, headers = ask(address, "GET", "/picture")
    assert (status, headers["content-type"]) == (200, "image/png")
    assert picture == (BODYPLANS / "wigley" / "bodyplan.png").read_bytes()


@pytest.mark.parametrize("path", ["/", "/picture", "/api/opening", "/static/main.js"])
def test_another_host_name_is_refused(address: tuple[str, int], path: str) -> None:
    status, content, _ = ask(address, "GET", path, headers={"host": f"ship.example:{address[1]}"})
    assert status == 403
    assert b"this machine alone" in content


def test_writing_needs_the_token_of_this_run_and_no_other_origin(address: tuple[str, int], ship: Path) -> None:
    review = json.loads(ask(address, "GET", "/api/opening")[1])["review"]
    assert ask(address, "PUT", "/api/review", review, JSON)[0] == 403
    assert ask(address, "POST", "/api/save", review, JSON | {"x-review-token": "guessed"})[0] == 403
    good = JSON | {"x-review-token": token(address)}
    assert ask(address, "POST", "/api/save", review, good | {"origin": "http://ship.example"})[0] == 403
    assert not ship.with_name("ship.review.json").exists()
    own = f"http://{address[0]}:{address[1]}"
    assert ask(address, "PUT", "/api/review", review, good | {"origin": own})[0] == 200


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ([], b"sent no review"),
        ({"schema": 1}, b"picture: Field required"),
        ({"schema": 1, "picture": {"file": "bodyplan.png", "sha256": "0" * 64}}, b"made of another picture"),
    ],
)
def test_what_is_no_review_is_refused_with_the_reason(address: tuple[str, int], body: Any, words: bytes) -> None:
    status, content, _ = ask(address, "PUT", "/api/review", body, {"x-review-token": token(address)})
    assert status == 422
    assert words in content


def test_strip_along_a_curve_has_its_line_in_the_middle(address: tuple[str, int]) -> None:
    status, content, _ = ask(address, "GET", "/api/strip?half=aft&station_m=25&curve=0")
    assert status == 200
    strip = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert strip is not None
    # rows are half a pixel apart; crossings with the grid darken others, but never most of a row
    darkest = int(np.argmin(np.median(strip, axis=1)))
    assert abs(darkest - strip.shape[0] // 2) <= 2
    status, content, _ = ask(address, "GET", "/api/strip?half=aft&station_m=26&curve=0")
    assert (status, b"has no curve" in content) == (422, True)


def test_interrupt_ends_it_well_and_a_taken_port_is_told(ship: Path, address: tuple[str, int]) -> None:
    command = [sys.executable, "-m", "hullform.cli", "review", str(ship), "--no-browser"]
    taken = subprocess.run([*command, "--port", str(address[1])], capture_output=True, text=True, timeout=60)
    assert taken.returncode == 1
    assert f"port {address[1]} of 127.0.0.1 cannot be used" in taken.stderr
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert "http://127.0.0.1:" in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=20)
    assert process.returncode == 0
    assert told == "review ended\n"
