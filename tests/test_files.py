import os
import stat
import subprocess
import sys

import pytest

from iconstudio.files import remove_abandoned, write_atomically


def test_a_file_is_made_and_replaced(tmp_path):
    path = tmp_path / "file"
    for data in (b"one", b"", b"three"):
        write_atomically(path, data)
        assert path.read_bytes() == data
    assert list(tmp_path.iterdir()) == [path]


def test_a_failure_leaves_all_as_it_was(tmp_path, monkeypatch):
    path = tmp_path / "file"
    write_atomically(path, b"before")

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(OSError, match="No space"):
        write_atomically(path, b"after")
    assert path.read_bytes() == b"before"
    assert list(tmp_path.iterdir()) == [path]


def test_a_folder_that_is_not_there(tmp_path):
    with pytest.raises(FileNotFoundError):
        write_atomically(tmp_path / "none" / "file", b"")


@pytest.mark.skipif(os.name != "posix", reason="needs POSIX permissions")
def test_the_users_mask_is_respected(tmp_path):
    before = os.umask(0o027)
    try:
        write_atomically(tmp_path / "file", b"")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "file").stat().st_mode) == 0o640


def test_what_a_killed_program_left_is_removed_however_young(tmp_path):
    dead = subprocess.Popen([sys.executable, "-c", ""])
    dead.wait()
    other = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    (tmp_path / "ab").mkdir()
    left = [tmp_path / "ab" / f".{dead.pid}-01.part", tmp_path / f".{dead.pid}-02.part"]
    left.append(tmp_path / ".0123456789abcdef.part")
    kept = [tmp_path / "ab" / f".{other.pid}-03.part", tmp_path / "ab" / "cdef", tmp_path / ".part"]
    for file in (*left, *kept):
        file.touch()
    try:
        remove_abandoned(tmp_path)
    finally:
        other.communicate(b"\n")
    assert not any(file.exists() for file in left)
    assert all(file.exists() for file in kept)
