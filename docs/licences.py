"""The program's dependencies: every pinned package with its license, from the package's own metadata."""

from __future__ import annotations

import re
from contextlib import suppress
from importlib import metadata
from pathlib import Path

import tables

PINNED = Path(__file__).resolve().parents[1] / "requirements.txt"
PIN = re.compile(r"^([A-Za-z0-9_.-]+)==([^\s;]+)", re.MULTILINE)
LICENCE_CLASS = "License :: "
UNSAID = "not said"
BUNDLED = re.compile(r"^(?:[\w.-]+\.libs|_soundfile_data|[\w.-]+/\.dylibs)/(lib[\w+.-]*)\.(?:so|dylib)")
VERSION = re.compile(r"([-_.](?:[0-9a-f]{8}|x86_64|arm64|aarch64|\d[\w.]*))*$")
FFMPEG = ("avcodec", "avdevice", "avfilter", "avformat", "avutil", "swresample", "swscale")
COPYLEFT = {
    **dict.fromkeys(FFMPEG, "LGPL-3.0-or-later, as it says itself"),
    **dict.fromkeys(("x264", "x265"), "GPL-2.0-or-later"),
    **dict.fromkeys(("gmp", "hogweed", "nettle", "unistring"), "LGPL-3.0-or-later or GPL-2.0-or-later"),
    **dict.fromkeys(("asound", "gnutls", "sndfile"), "LGPL-2.1-or-later"),
    "mp3lame": "LGPL-2.0-or-later",
    **dict.fromkeys(("gfortran", "quadmath"), "GPL-3.0-or-later with GCC's runtime exception"),
}
"""Libraries inside wheels whose licenses ask for something of who passes them on, as the projects state."""
PERMISSIVE = {
    *("SvtAv1Enc", "Xau", "avif", "brotlicommon", "brotlidec", "dav1d", "drm", "freetype", "harfbuzz", "jpeg", "lcms2"),
    *("lzma", "opencore-amrnb", "opencore-amrwb", "openjp2", "opus", "png16", "scipy_openblas", "scipy_openblas64"),
    *(
        "sharpyuv",
        "tiff",
        "vpl",
        "vpx",
        "webp",
        "webpdemux",
        "webpmux",
        "xcb",
        "xcb-shape",
        "xcb-shm",
        "xcb-xfixes",
        "zstd",
    ),
}
"""The others: BSD, MIT, Apache, zlib, ISC and their like."""
LONGEST = 60
"""Characters; a longer license field holds the whole text."""


def licences_table() -> str:
    """Return a Markdown table of packages, versions, licenses and summaries."""
    rows = []
    for name, version in PIN.findall(PINNED.read_text(encoding="utf-8")):
        try:
            about = metadata.metadata(name)
        except metadata.PackageNotFoundError:  # pinned for another system
            rows.append((name, version, "see the package", "needed on other systems only"))
        else:
            rows.append((name, version, licence_of(about), about.get("Summary") or ""))
    return tables.table(("Package", "Version", "Licence", "In its own words"), rows)


def bundled() -> dict[str, list[str]]:
    """Return the libraries of other projects inside the wheels of pinned packages, as installed here, by package."""
    found = {}
    for name, _ in PIN.findall(PINNED.read_text(encoding="utf-8")):
        with suppress(metadata.PackageNotFoundError):
            inside = (BUNDLED.match(file.as_posix()) for file in metadata.files(name) or ())
            names = {VERSION.sub("", match[1]).removeprefix("lib").rstrip("_") for match in inside if match}
            if names:
                found[name] = sorted(names, key=str.lower)
    return found


def bundled_table() -> str:
    """Return a Markdown table of packages with the libraries in their wheels, those first that ask for something."""
    rows = []
    for package, names in bundled().items():
        asking: dict[str, list[str]] = {}
        for name in names:
            if name in COPYLEFT:
                asking.setdefault(COPYLEFT[name], []).append(name)
        told = "; ".join(f"{', '.join(members)}: {licence}" for licence, members in asking.items())
        rows.append((package, told or "none", ", ".join(name for name in names if name not in COPYLEFT)))
    return tables.table(("Package", "Copyleft", "Others: BSD, MIT, Apache and their like"), rows)


def licence_of(about: metadata.PackageMetadata) -> str:
    """Return the license in a package's metadata, from whichever of its three fields has it."""
    stated = about.get("License-Expression") or about.get("License") or ""
    if stated and len(stated) <= LONGEST and "\n" not in stated:
        return stated
    classes = [text.split(" :: ")[-1] for text in about.get_all("Classifier") or () if text.startswith(LICENCE_CLASS)]
    return ", ".join(classes) or stated.strip().split("\n")[0] or UNSAID
