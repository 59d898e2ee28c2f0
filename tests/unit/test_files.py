"""Files and folders appear whole or not at all."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from hullform.errors import OutputError
from hullform.files import PROGRAM, RESULTS_NAME, check_replaceable, whole_file, whole_folder


def ours(folder: Path) -> Path:
    folder.mkdir()
    (folder / RESULTS_NAME).write_text(json.dumps({"schema": 1, "provenance": {"program": PROGRAM}}))
    return folder


def test_a_file_replaces_the_old_one_only_when_it_is_whole(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("old")
    with pytest.raises(ZeroDivisionError), whole_file(path) as aside:
        aside.write_text(f"half {1 / 0}")
    assert path.read_text() == "old"
    with whole_file(path) as aside:
        aside.write_text("new")
    assert path.read_text() == "new"
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]


def test_a_folder_replaces_the_old_one_only_when_it_is_whole(tmp_path: Path) -> None:
    folder = ours(tmp_path / "results")
    with pytest.raises(ZeroDivisionError), whole_folder(folder) as aside:
        (aside / f"half {1 / 0}").touch()
    assert [p.name for p in folder.iterdir()] == [RESULTS_NAME]
    with whole_folder(folder) as aside:
        (aside / "new").touch()
    assert [p.name for p in folder.iterdir()] == ["new"]
    assert [p.name for p in tmp_path.iterdir()] == ["results"]


def test_a_place_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="choose another place"), whole_file(tmp_path / "none" / "a.txt"):
        pass
    (tmp_path / "file").touch()
    with pytest.raises(OutputError, match="choose another place"), whole_folder(tmp_path / "file" / "results"):
        pass


def test_only_our_own_results_are_replaced_without_force(tmp_path: Path) -> None:
    check_replaceable(tmp_path / "new", (), force=False)
    check_replaceable(ours(tmp_path / "ours"), (), force=False)
    (tmp_path / "empty").mkdir()
    check_replaceable(tmp_path / "empty", (), force=False)
    other = tmp_path / "other"
    other.mkdir()
    (other / "thesis.doc").touch()
    with pytest.raises(OutputError, match="which no run wrote"):
        check_replaceable(other, (), force=False)
    check_replaceable(other, (), force=True)
    with pytest.raises(OutputError, match="is a file"):
        check_replaceable(other / "thesis.doc", (), force=True)


def test_a_folder_that_holds_an_input_is_never_replaced(tmp_path: Path) -> None:
    ship = tmp_path / "ship.toml"
    ship.touch()
    with pytest.raises(OutputError, match=r"holds ship\.toml, which this run reads"):
        check_replaceable(tmp_path, (ship,), force=True)
    with pytest.raises(OutputError, match=r"holds ship\.toml"):
        check_replaceable(tmp_path.parent, (ship,), force=True)


def test_a_file_that_no_run_wrote_is_kept(tmp_path: Path) -> None:
    folder = ours(tmp_path / "results")
    (folder / "girder-loaded.json").touch()
    check_replaceable(folder, (), force=False)
    (folder / "notes.txt").touch()
    with pytest.raises(OutputError, match=r"holds notes\.txt, which no run wrote"):
        check_replaceable(folder, (), force=False)


def test_a_folder_under_version_control_is_never_replaced(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    with pytest.raises(OutputError, match="under version control"):
        check_replaceable(tmp_path, (), force=True)


def test_old_results_survive_an_interrupt_between_the_two_renames(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = ours(tmp_path / "results")
    rename = Path.replace

    def interrupted(self: Path, target: Path) -> Path:
        if target == folder and not self.name.endswith("-old"):
            raise KeyboardInterrupt
        return rename(self, target)

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt), whole_folder(folder):
        pass
    assert (folder / RESULTS_NAME).exists()
    assert [path.name for path in tmp_path.iterdir()] == ["results"]
