"""Files that appear whole or not at all."""

from pathlib import Path

import pytest

from polhode.errors import InvalidInput
from polhode.formats.paths import write_together, write_whole


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_file_takes_its_place_when_all_is_written(tmp_path):
    path = tmp_path / "motion.csv"
    path.write_text("earlier")
    with write_whole(path) as draft:
        assert draft.name == path.name and draft.is_relative_to(tmp_path)
        draft.write_text("later")
        assert path.read_text() == "earlier"
    assert path.read_text() == "later" and names(tmp_path) == ["motion.csv"]


def test_what_fails_leaves_the_file_as_it_was(tmp_path):
    path = tmp_path / "motion.csv"
    path.write_text("earlier")
    with pytest.raises(ZeroDivisionError), write_whole(path) as draft:
        draft.write_text("half")
        raise ZeroDivisionError
    assert path.read_text() == "earlier" and names(tmp_path) == ["motion.csv"]


def is_store(path):
    return (path / "mark").is_file()


def test_stores_are_replaced_and_other_folders_are_not(tmp_path):
    for text in ("first", "second"):
        with write_whole(tmp_path / "store", is_store) as draft:
            draft.mkdir()
            (draft / "mark").write_text(text)
    assert (tmp_path / "store" / "mark").read_text() == "second" and names(tmp_path) == ["store"]
    (tmp_path / "photos").mkdir()
    for known, words in ((None, "is a folder, where a file has to go"), (is_store, "is a folder, but not the store")):
        with pytest.raises(InvalidInput, match=f"photos: {words}"), write_whole(tmp_path / "photos", known):
            pytest.fail("nothing may be written")
    assert names(tmp_path) == ["photos", "store"]


@pytest.mark.parametrize("where", ["missing/motion.csv", "file/motion.csv"])
def test_a_missing_folder_is_one_error(tmp_path, where):
    (tmp_path / "file").touch()
    with pytest.raises(InvalidInput, match=r"motion\.csv: cannot be written, as .* is not a folder"):
        with write_whole(tmp_path / where):
            pytest.fail("nothing may be written")
    assert names(tmp_path) == ["file"]


def test_folders_that_nobody_may_write_to():
    with pytest.raises(InvalidInput, match="cannot be written"), write_whole("/proc/motion.csv"):
        pytest.fail("nothing may be written")
    assert not Path("/proc/motion.csv").exists()


def test_devices_stay_what_they_are():
    with pytest.raises(InvalidInput, match="not a file that could be replaced"), write_whole("/dev/null"):
        pytest.fail("nothing may be written")
    assert Path("/dev/null").is_char_device()


def test_what_the_system_refuses_within_is_one_error_too(tmp_path):
    with pytest.raises(InvalidInput, match=r"motion\.csv: cannot be written \(No space left on device\)"):
        with write_whole(tmp_path / "motion.csv"), Path("/dev/full").open("w") as full:
            full.write("x" * 100_000)
    assert names(tmp_path) == []


def test_files_together_take_their_places_and_others_stay(tmp_path):
    folder = tmp_path / "new" / "report"
    with write_together(folder) as draft:
        (draft / "a").write_text("first")
    (folder / "photo").write_text("mine")
    with write_together(folder) as draft:
        (draft / "a").write_text("second")
        (draft / "b").write_text("second")
        assert (folder / "a").read_text() == "first"
    assert {p.name: p.read_text() for p in folder.iterdir()} == {"a": "second", "b": "second", "photo": "mine"}


def test_what_fails_together_leaves_neither_files_nor_folders(tmp_path):
    with pytest.raises(ZeroDivisionError), write_together(tmp_path / "new" / "report") as draft:
        (draft / "a").write_text("half")
        raise ZeroDivisionError
    assert names(tmp_path) == []
    (tmp_path / "there" / "b").mkdir(parents=True)
    with pytest.raises(InvalidInput, match="b: is a folder, where a file has to go"):
        with write_together(tmp_path / "there") as draft:
            (draft / "a").write_text("new")
            (draft / "b").write_text("new")
    assert names(tmp_path / "there") == ["b"]
    (tmp_path / "file").touch()
    with pytest.raises(InvalidInput, match="file: is a file, where a folder is needed"):
        with write_together(tmp_path / "file"):
            pytest.fail("nothing may be written")
