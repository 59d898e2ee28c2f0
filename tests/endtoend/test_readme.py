"""The README's code and commands do what the README shows. Numbers may differ in the last figure shown."""

from __future__ import annotations

import itertools
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
FENCED = re.compile(r"(?:<!-- file: (?P<file>\S+) -->\n)?```(?P<kind>\w+)\n(?P<text>.*?)```", re.DOTALL)
BLOCKS = [match.groupdict() for match in FENCED.finditer(README)]
CONSOLE = [block["text"] for block in BLOCKS if block["kind"] == "console"]
PYTHON = [
    (code["text"], output["text"])
    for code, output in itertools.pairwise(BLOCKS)
    if (code["kind"], output["kind"]) == ("python", "text")
]


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """A folder with what the README speaks of."""
    shutil.copytree(ROOT / "bodyplans", tmp_path / "bodyplans", ignore=shutil.ignore_patterns("results"))
    for block in BLOCKS:
        if block["file"]:
            (tmp_path / block["file"]).write_text(block["text"], encoding="utf-8")
    return tmp_path


def same(shown: str, printed: str) -> bool:
    """Word for word, numbers to one in the last of three figures."""
    pairs = list(zip(shown.split(), printed.split(), strict=False))
    if len(shown.split()) != len(printed.split()):
        return False
    number = re.compile(r"[\[(]*(-?\d+\.?\d*)[\]),;%]*")
    tiny = re.compile(r"\d(\.\d+)?e-\d+")
    for left, right in pairs:
        if tiny.fullmatch(left) and tiny.fullmatch(right):
            # a bound of round-off depends on the machine's long double
            continue
        a, b = number.fullmatch(left), number.fullmatch(right)
        if a and b:
            x, y = float(a[1]), float(b[1])
            last = 10.0 ** -len(a[1].partition(".")[2])
            if abs(x - y) > max(0.01 * abs(x), 1.01 * last):
                return False
        elif left != right:
            return False
    return True


@pytest.mark.parametrize("text", CONSOLE, ids=[text.splitlines()[0] for text in CONSOLE])
def test_commands_print_what_is_shown(room: Path, text: str) -> None:
    command, _, shown = text.partition("\n")
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    ran = subprocess.run(
        command.removeprefix("$ ").split(),
        cwd=room,
        env={**os.environ, "PATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert ran.returncode in (0, 3), ran.stdout
    assert same(shown, ran.stdout), ran.stdout


@pytest.mark.parametrize(("code", "shown"), PYTHON)
def test_python_prints_what_is_shown(room: Path, code: str, shown: str) -> None:
    ran = subprocess.run([sys.executable, "-c", code], cwd=room, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert same(shown, ran.stdout), ran.stdout


def test_the_example_ship_is_the_one_in_the_folder() -> None:
    (shown,) = [tomllib.loads(block["text"]) for block in BLOCKS if block["kind"] == "toml" and not block["file"]]
    actual = tomllib.loads((ROOT / "bodyplans/wigley/ship.toml").read_text(encoding="utf-8"))
    for table in ("body_plan", "structure", "weights"):
        assert shown[table] == actual[table]
    assert shown["ship"].items() <= actual["ship"].items()
    assert shown["conditions"][0] == actual["conditions"][0]


def test_every_command_of_the_table_exists() -> None:
    for program, command in re.findall(r"^\| `(hullform|hullvib) (\w+) ", README, re.MULTILINE):
        ran = subprocess.run([Path(sys.executable).parent / program, command, "--help"], capture_output=True, text=True)
        assert ran.returncode == 0
        assert f"{program} {command}" in ran.stdout


@pytest.mark.skipif(
    not (ROOT / ".venv/made-for").exists(), reason="scripts/test makes .venv; here another environment runs"
)
def test_the_demo_runs_from_anywhere_and_twice(tmp_path: Path) -> None:
    for _ in range(2):
        ran = subprocess.run(["sh", str(ROOT / "scripts/demo")], cwd=tmp_path, capture_output=True, text=True)
        assert ran.returncode == 0, ran.stderr
        assert "condition       mass, t" in ran.stdout
        assert "report: " in ran.stdout


def test_the_pages_that_the_readme_links_exist() -> None:
    for target in re.findall(r"\]\(([^)#:]+)\)", README):
        assert (ROOT / target).exists(), target
