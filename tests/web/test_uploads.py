"""Files come piece by piece under names of ours, are refused when they are too large or of no kind, and go away."""

from __future__ import annotations

import time
from collections.abc import Iterator

import httpx
import pytest

from sweetspot.errors import InputError
from sweetspot.web import uploads as module
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
    time.sleep(0.001)
    uploads.begin(NewFile(name="b.wav", size=1))
    with pytest.raises(InputError, match="not here any more"):
        uploads.add(key, 0, b"a")


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
