import errno
import os
import socket
import stat
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest

from iconstudio.files import (
    read_bytes,
    reason_of,
    remove_abandoned,
    with_names,
    write_atomically,
    write_bytes,
)
from iconstudio.model import IconstudioError

posix = pytest.mark.skipif(os.name != "posix", reason="needs POSIX files")


def no_files(folder):
    """What has a name and is no file: a folder, a pipe, a device that never ends, a link to it."""
    (folder / "folder").mkdir()
    os.mkfifo(folder / "pipe")
    (folder / "link").symlink_to(folder / "pipe")
    some = {name: folder / name for name in ("folder", "pipe", "link", "socket")}
    return some | {"device": Path("/dev/zero"), "null": Path("/dev/null")}


def test_a_file_is_read_up_to_a_bound(tmp_path):
    path = tmp_path / "file"
    for data in (b"", b"12", b"123"):
        path.write_bytes(data)
        assert read_bytes(path, 3) == data
    path.write_bytes(b"1234")
    with pytest.raises(IconstudioError, match="more than 3 bytes"):
        read_bytes(path, 3)


@posix
@pytest.mark.timeout(20)
def test_what_is_no_file_is_refused_at_once(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # the name of a socket must be short
    with closing(socket.socket(socket.AF_UNIX)) as end:
        end.bind("socket")
        for name, path in no_files(tmp_path).items():
            kind = "folder" if name == "folder" else "a device, a pipe or a socket"
            before = path.stat()
            with pytest.raises(IconstudioError, match=kind):
                read_bytes(path, 100)
            with pytest.raises(OSError, match=kind):
                write_atomically(path, b"data")
            assert path.stat().st_ino == before.st_ino


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="needs Linux")
def test_a_file_that_grows_while_it_is_read_stays_within_the_bound():
    assert Path("/proc/self/status").stat().st_size == 0
    with pytest.raises(IconstudioError, match="more than 10 bytes"):
        read_bytes(Path("/proc/self/status"), 10)


@pytest.mark.parametrize("name", ["a\0b", "\ud800", "x" * 5000, "file/x", "none"])
def test_names_of_no_file(tmp_path, name):
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(IconstudioError, match=r"\.$"):
        read_bytes(tmp_path / name, 10)


@posix
def test_links_are_written_through_and_permissions_kept(tmp_path):
    (tmp_path / "far").mkdir()
    target, link = tmp_path / "far" / "target", tmp_path / "link"
    (tmp_path / "between").symlink_to(Path("far") / "target")
    link.symlink_to("between")
    write_atomically(link, b"new")  # the target need not be there yet
    assert target.read_bytes() == b"new"
    target.chmod(0o751)
    write_atomically(link, b"newer")
    assert link.is_symlink()
    assert target.read_bytes() == b"newer"
    assert stat.S_IMODE(target.stat().st_mode) == 0o751
    assert list((tmp_path / "far").iterdir()) == [target]


@posix
@pytest.mark.skipif(hasattr(os, "geteuid") and os.geteuid() == 0, reason="root may write all")
def test_what_is_write_protected_stays(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"mine")
    path.chmod(0o444)
    with pytest.raises(PermissionError):
        write_atomically(path, b"new")
    assert path.read_bytes() == b"mine"


@posix
def test_links_in_a_circle(tmp_path):
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    with pytest.raises(OSError, match="symbolic links"):
        write_atomically(tmp_path / "a", b"")
    with pytest.raises(IconstudioError, match="The links on the way there lead in a circle"):
        read_bytes(tmp_path / "a", 10)


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


@posix
def test_why_a_file_cannot_be_written_is_told_in_our_own_words(tmp_path):
    (tmp_path / "file").touch()
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    for name, said in {
        "none/file": "there is no such folder",
        "file/file": "a part of its path is a file, not a folder",
        "": "it is a folder",
        "a": "the links on the way there lead in a circle",
        "x" * 300: "its name is too long",
    }.items():
        with pytest.raises(IconstudioError, match=f"cannot be written: {said}."):
            write_bytes(tmp_path / name, b"")


def test_what_is_rare_is_told_as_the_system_says_it():
    assert reason_of(OSError(errno.EILSEQ, "Invalid byte sequence")) == "Invalid byte sequence"
    assert reason_of(OSError("nothing known")) == "nothing known"


@pytest.mark.parametrize(
    ("said", "shown"),
    [
        ("Saved “/home/ann/my icons/cat 1.svg”.", "Saved “cat 1.svg”."),
        (r"Saved “C:\Users\ann\cat.svg”.", "Saved “cat.svg”."),
        (
            "“/a/b.png” is there already, and “/c/d.e.png”.",
            "“b.png” is there already, and “d.e.png”.",
        ),
        ("5 icons in “/home/ann/icons”.", "5 icons in “/home/ann/icons”."),
        ("“icons/cat.svg” is missing in the file.", "“icons/cat.svg” is missing in the file."),
        ("Nothing of a file.", "Nothing of a file."),
    ],
)
def test_files_are_called_by_their_names_where_that_will_do(said, shown):
    assert with_names(said) == shown


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="needs Linux")
def test_a_folder_that_takes_no_files_is_told_as_such():
    with pytest.raises(IconstudioError, match="that folder takes no files"):
        write_bytes(Path("/proc/picture.png"), b"")
