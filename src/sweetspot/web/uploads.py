"""Files that a page hands in, piece by piece, into a folder of this server's own.

A name of ours stands for each file, never a path. Room on the disk is kept for what was announced; what gets no byte
for a minute, or was not used for an hour, is thrown away, and everything is when the server ends. Nothing leaves this
machine. What long work makes of files lies beside them, and can be taken away.
"""

from __future__ import annotations

import secrets
import shutil
import tempfile
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Request
from fastapi.responses import FileResponse
from pydantic import BaseModel, ConfigDict, Field

from sweetspot.calibration.outline.outline_file import ENDINGS as OUTLINES
from sweetspot.calibration.outline.outline_file import HEIF
from sweetspot.calibration.recording import OF_PHONES, SOUND_FILES
from sweetspot.errors import InputError
from sweetspot.web.errors import FieldError, FullDiskError
from sweetspot.web.limits import LARGEST_PIECE

LARGEST_FILE = 2_000_000_000
"""Bytes of one file."""
MOST_FILES, MOST_OF_ONE = 200, 100
"""Files that lie here at once, and of one sender."""
FORGOTTEN = 3600.0
"""s after which an unused file is thrown away."""
ABANDONED = 60.0
"""s after which a file of which not all has come is thrown away where no more comes."""
SPARE = 500_000_000
"""Bytes of the disk that are never filled."""
ENDINGS = (".gz", ".parquet", ".toml", ".json", *OUTLINES, *HEIF, *SOUND_FILES, *OF_PHONES)
UploadKey = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{16}$")]
TAKEN_AWAY = "tables"
"""Folder, among what is made of files, of what people may take away."""
GONE = "that file is not here any more; hand it in again"


class NewFile(BaseModel):
    """The announcement of a file."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: Annotated[str, Field(min_length=1, max_length=200)]
    size: int = Field(ge=1, le=LARGEST_FILE, description="bytes")


class AnnouncedFile(BaseModel):
    """The key of a file that was announced, and the most bytes of one piece of it."""

    upload: UploadKey
    piece: int = LARGEST_PIECE


@dataclass
class _File:
    name: str
    path: Path
    size: int
    of: tuple[str, ...] = ()
    sender: str = ""
    taken: int = 0
    used: float = field(default_factory=time.monotonic)

    @property
    def patience(self) -> float:
        """How long it may be left alone, s."""
        return FORGOTTEN if self.taken == self.size else ABANDONED


class Uploads:
    """Every file that was handed in."""

    def __init__(self) -> None:
        self._files: dict[str, _File] = {}
        self._lock = threading.Lock()
        self._folder: Path | None = None

    def begin(self, new: NewFile, sender: str = "") -> str:
        """Keep room for a file; return the key under which its pieces, and then it, are known."""
        suffixes = Path(new.name.lower()).suffixes
        ending = "".join(suffixes[-2:] if suffixes[-1:] == [".gz"] else suffixes[-1:])
        if not ending.endswith(ENDINGS):
            raise FieldError("name", f"{new.name[:60]!r} ends in none of {', '.join(ENDINGS)}")
        with self._lock:
            self._forget()
            of_one = sum(file.sender == sender for file in self._files.values())
            if len(self._files) >= MOST_FILES or of_one >= MOST_OF_ONE:
                raise InputError(f"{min(len(self._files), of_one)} files lie here already; wait, or hand in fewer")
            folder = self._made()
            announced = sum(file.size - file.taken for file in self._files.values())
            if shutil.disk_usage(folder).free - announced - new.size < SPARE:
                raise FullDiskError("size", "there is not enough room on this machine's disk for that file")
            key = secrets.token_urlsafe(12)
            safe = "".join(letter if letter.isalnum() or letter in "._-" else "_" for letter in ending)[-20:]
            self._files[key] = _File(Path(new.name).name, folder / f"{key}{safe}", new.size, sender=sender)
        return key

    def begin_folder(self, of: tuple[str, ...]) -> str:
        """Make a folder for what is made of some files, which are kept as long as it; return its key."""
        with self._lock:
            self._forget()
            key = secrets.token_urlsafe(12)
            path = self._made() / key
            path.mkdir()
            self._files[key] = _File(key, path, 0, of)
        return key

    def add(self, key: str, offset: int, piece: bytes) -> int:
        """Add a piece where the last one ended; return how many bytes are here."""
        upload = self._found(key)
        if offset != upload.taken or upload.taken + len(piece) > upload.size:
            raise FieldError("offset", f"the next piece begins at {upload.taken} and the file ends at {upload.size}")
        try:
            with upload.path.open("r+b" if upload.taken else "wb") as file:
                file.seek(upload.taken)  # over what a full disk left of a piece
                file.write(piece)
        except OSError as error:
            reason = (error.strerror or str(error)).lower()
            raise FullDiskError("size", f"this machine could not keep that file: {reason}") from None
        upload.taken += len(piece)
        return upload.taken

    def path_of(self, key: str) -> tuple[Path, str]:
        """Return the path of a whole file, and its name at the sender."""
        upload = self._found(key)
        if upload.path.is_dir():
            raise FieldError("upload", GONE)
        if upload.taken != upload.size:
            raise FieldError("upload", f"only {upload.taken} of {upload.size} bytes of that file have come")
        return upload.path, upload.name

    def folder_of(self, key: str) -> Path:
        """Return the folder of what was made of some files."""
        upload = self._found(key)
        for file in upload.of:
            if file in self._files:
                self._files[file].used = upload.used
        if not upload.path.is_dir():
            raise FieldError("upload", GONE)
        return upload.path

    def close(self) -> None:
        """Throw everything away."""
        with self._lock:
            if self._folder is not None:
                shutil.rmtree(self._folder, ignore_errors=True)
            self._files, self._folder = {}, None

    def _found(self, key: str) -> _File:
        upload = self._files.get(key)
        if upload is None:
            raise FieldError("upload", GONE)
        upload.used = time.monotonic()
        return upload

    def _made(self) -> Path:
        self._folder = self._folder or Path(tempfile.mkdtemp(prefix="sweetspot-"))
        return self._folder

    def _forget(self) -> None:
        for key in [key for key, file in self._files.items() if time.monotonic() - file.used > file.patience]:
            path = self._files.pop(key).path
            if path.is_dir():
                shutil.rmtree(path, ignore_errors=True)
            else:
                path.unlink(missing_ok=True)


UPLOADS = Uploads()
"""Those of this process's server."""


def upload_routes(api: APIRouter) -> None:
    """Add the routes by which files come."""

    @api.post("/uploads", tags=["files"])
    def begin(new: NewFile, request: Request) -> AnnouncedFile:
        """Announce a file; pieces of it follow."""
        return AnnouncedFile(upload=UPLOADS.begin(new, request.client.host if request.client else ""))

    @api.post("/uploads/{key}/{offset}", tags=["files"])
    async def add(key: str, offset: int, request: Request) -> dict[str, int]:
        """Take a piece of a file, as it is, from a place on."""
        return {"taken": UPLOADS.add(key, offset, await request.body())}

    table = {"content": {"application/octet-stream": {}}, "description": "The file."}

    @api.get("/uploads/{key}/{name}", tags=["files"], response_class=FileResponse, responses={200: table})
    def take_away(key: str, name: str) -> FileResponse:
        """Return one of the tables that were made of files."""
        folder = UPLOADS.folder_of(key) / TAKEN_AWAY
        names = [path.name for path in folder.iterdir()] if folder.is_dir() else []
        if name not in names:
            raise FieldError("name", f"there is no file {name[:60]!r}; there are {', '.join(sorted(names)) or 'none'}")
        return FileResponse(folder / name, filename=name, media_type="application/octet-stream")
