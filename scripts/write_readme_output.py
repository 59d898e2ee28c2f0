"""Run the README's commands and Python anew and write what they print into it. Run after figures have changed."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
FILES = re.compile(r"<!-- file: (?P<name>\S+) -->\n```\w+\n(?P<text>.*?)```", re.DOTALL)
CONSOLE = re.compile(r"```console\n\$ (?P<command>[^\n]*)\n.*?```", re.DOTALL)
PYTHON = re.compile(r"(?P<code>```python\n(?P<text>.*?)```\n)```text\n.*?```", re.DOTALL)


def main() -> None:
    text = README.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        room = Path(folder)
        shutil.copytree(ROOT / "bodyplans", room / "bodyplans", ignore=shutil.ignore_patterns("results"))
        for file in FILES.finditer(text):
            (room / file["name"]).write_text(file["text"], encoding="utf-8")

        def printed(*command: str) -> str:
            path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
            ran = subprocess.run(
                command, cwd=room, env={**os.environ, "PATH": path}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
            )
            if ran.returncode not in (0, 3):
                raise SystemExit(f"{' '.join(command)}:\n{ran.stdout.decode()}")
            return ran.stdout.decode("utf-8")

        text = CONSOLE.sub(
            lambda shown: f"```console\n$ {shown['command']}\n{printed(*shown['command'].split())}```", text
        )
        text = PYTHON.sub(
            lambda shown: f"{shown['code']}```text\n{printed(sys.executable, '-c', shown['text'])}```", text
        )
    README.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
