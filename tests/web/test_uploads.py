"""Files come piece by piece under names of ours, are refused when they are too large or of no kind, and go away."""

from __future__ import annotations

import errno
import shutil
import socket
import time
from collections import namedtuple
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from sweetspot.errors import InputError
from sweetspot.web import silence
from sweetspot.web import uploads as module
from sweetspot.web.errors import FullDiskError
from sweetspot.web.limits import LARGEST_PIECE
from sweetspot.web.uploads import NewFile, Uploads


@pytest.fixture
def uploads() -> Iterator[Uploads]:
    made = Uploads()
    yield made
    made.close()


def test_pieces_make_a_file_and_nothing_is_left(uploads: Uploads) -> None:
    key = uploads.begin(NewFile(name="../../etc/balls.CSV.gz", size=6))
    assert uploads.add(key, 0, b"abc") == 3
    with pytest.raises(InputError, match="begins at 3"):
        uploads.add(key, 0, b"abc")
    with pytest.raises(InputError, match="3 of 6"):
        uploads.path_of(key)
    with pytest.raises(InputError, match="ends at 6"):
        uploads.add(key, 3, b"abcd")
    uploads.add(key, 3, b"def")
    path, name = uploads.path_of(key)
    assert path.read_bytes() == b"abcdef" and name == "balls.CSV.gz" and path.name == f"{key}.csv.gz"
    uploads.close()
    assert not path.parent.exists()
    with pytest.raises(InputError, match="not here any more"):
        uploads.path_of(key)


def test_what_nobody_uses_is_thrown_away(uploads: Uploads, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "FORGOTTEN", 0.0)
    key = uploads.begin(NewFile(name="a.wav", size=1))
    uploads.add(key, 0, b"a")
    time.sleep(0.001)
    uploads.begin(NewFile(name="b.wav", size=1))
    with pytest.raises(InputError, match="not here any more"):
        uploads.path_of(key)


def test_the_server_takes_pieces_and_no_more(client: httpx.Client) -> None:
    for name, size, words in (("a.exe", 5, "ends in none"), ("a.csv", 10**13, "less"), ("", 5, "")):
        response = client.post("/api/v1/uploads", json={"name": name, "size": size})
        assert response.status_code == 422 and words in response.text
    told = client.post("/api/v1/uploads", json={"name": "a.csv", "size": LARGEST_PIECE + 1}).json()
    place = f"/api/v1/uploads/{told['upload']}"
    assert client.post(f"{place}/0", content=b"x" * (LARGEST_PIECE + 1)).status_code == 413
    assert client.post(f"{place}/0", content=b"x" * LARGEST_PIECE).json() == {"taken": LARGEST_PIECE}
    assert client.post("/api/v1/uploads/nobody/0", content=b"x").status_code == 422
    assert client.post("/api/v1/bat", content=b"x" * 100_000).status_code == 413


def test_room_is_kept_for_what_was_announced(uploads: Uploads, monkeypatch: pytest.MonkeyPatch) -> None:
    """Derived: each file alone would fit on the disk, both together would not."""
    usage = namedtuple("usage", "total used free")
    monkeypatch.setattr(shutil, "disk_usage", lambda _: usage(0, 0, module.SPARE + 150))
    key = uploads.begin(NewFile(name="a.wav", size=100))
    with pytest.raises(FullDiskError, match="not enough room"):
        uploads.begin(NewFile(name="b.wav", size=100))
    uploads.add(key, 0, b"x" * 100)  # now it lies on the disk, whose free space would say so
    uploads.begin(NewFile(name="b.wav", size=100))


def test_announcements_without_a_byte_keep_nobody_out(uploads: Uploads, monkeypatch: pytest.MonkeyPatch) -> None:
    for _ in range(module.MOST_OF_ONE):
        uploads.begin(NewFile(name="a.wav", size=1), "one")
    with pytest.raises(InputError, match="wait, or hand in fewer"):
        uploads.begin(NewFile(name="a.wav", size=1), "one")
    whole = uploads.begin(NewFile(name="a.wav", size=1), "another")
    uploads.add(whole, 0, b"a")
    monkeypatch.setattr(module, "ABANDONED", 0.0)
    time.sleep(0.001)
    uploads.begin(NewFile(name="a.wav", size=1), "one")
    assert uploads.path_of(whole)[0].read_bytes() == b"a"


def test_a_disk_that_is_full_is_told(uploads: Uploads, monkeypatch: pytest.MonkeyPatch) -> None:
    """And what was half written of a piece is written over when it comes again."""
    key = uploads.begin(NewFile(name="a.wav", size=6))
    uploads.add(key, 0, b"abc")
    with monkeypatch.context() as patched:
        patched.setattr(Path, "open", full)
        with pytest.raises(FullDiskError, match="no space left"):
            uploads.add(key, 3, b"def")
    uploads.add(key, 3, b"def")
    assert uploads.path_of(key)[0].read_bytes() == b"abcdef"


def full(*_: object) -> object:
    raise OSError(errno.ENOSPC, "No space left on device")


def test_no_room_is_507(client: httpx.Client, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "SPARE", 10**18)
    response = client.post("/api/v1/uploads", json={"name": "a.csv", "size": 5})
    assert response.status_code == 507 and "room" in response.json()["error"]["message"]


def test_half_a_request_is_not_waited_for_and_a_slow_one_is(server: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Silence ends a connection; a piece that takes longer than that in all, byte by byte, arrives."""
    monkeypatch.setattr(silence, "LONGEST_SILENCE", 0.6)
    host, port = server.removeprefix("http://").split(":")
    told = httpx.post(f"{server}/api/v1/uploads", json={"name": "a.csv", "size": 4}).json()["upload"]
    head = f"POST /api/v1/uploads/{told}/0 HTTP/1.1\r\nHost: {host}:{port}\r\nContent-Length: 4\r\n\r\n".encode()
    with socket.create_connection((host, int(port)), timeout=30) as slow:
        slow.sendall(head)
        for letter in b"abcd":
            time.sleep(0.3)
            slow.sendall(bytes([letter]))
        assert b"200 OK" in slow.recv(4096)
    for half in (b"", head[:20], head, head + b"a"):
        with socket.create_connection((host, int(port)), timeout=30) as silent:
            silent.sendall(half)
            answer = silent.recv(4096)
            assert not answer or b"400" in answer
