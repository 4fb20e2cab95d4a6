"""Limits of the server: who may ask, and how much; and the headers that keep a browser to this page."""

from __future__ import annotations

import ipaddress
import json
from collections.abc import Awaitable, Callable, Iterable, Mapping, MutableMapping
from typing import Any
from urllib.parse import urlsplit

LARGEST_BODY = 64 * 1024
"""Bytes of a request or of one message on a socket."""
LARGEST_PIECE = 4 * 1024 * 1024
"""Bytes of one piece of a file that is handed in; see `web.uploads`."""
PIECES = "/api/v1/uploads/"
"""Path of the pieces of files; everything else is a message."""
LONGEST_QUERY = 32 * 1024
MOST_SOCKETS = 200

_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors "
)
EMBEDDED_POLICY = _POLICY + "*"
"""Of the pictures that other pages may show: they have no controls and nothing that only their owner may do."""
SECURITY_HEADERS = (
    ("content-security-policy", _POLICY + "'none'"),
    ("permissions-policy", "camera=(), microphone=(self), geolocation=(), usb=(), payment=()"),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cross-origin-resource-policy", "same-origin"),
)

OF_DOCUMENTS = frozenset({b"content-security-policy", b"permissions-policy", b"cross-origin-opener-policy"})
"""Headers that browsers read of documents alone; with sixty modules they would be a seventh of a first visit."""
NO_DOCUMENTS = (b"text/javascript", b"text/css")

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]


FOREIGN = ("cross-site", "same-site")
"""What browsers say in Sec-Fetch-Site of what a page of another server asks for."""


def opens_page(scope: Scope, headers: Mapping[str, str]) -> bool:
    """Return whether a request follows a link to a page, or shows it in a frame, which pages of others may do."""
    return scope.get("method") in ("GET", "HEAD") and headers.get("sec-fetch-mode") == "navigate"


NO_HOST = frozenset("@#/?\\")
"""Letters that no Host header has: in an address they end or begin its name."""


def host_allowed(host: str, names: Iterable[str]) -> bool:
    """Return whether a Host header names this server: a number address, or one of the allowed names.

    A name that someone else's server resolves to this machine (DNS rebinding) is neither. Starlette's
    `TrustedHostMiddleware` cannot serve: it knows no number addresses, and does not say what to do.

    >>> [host_allowed(host, ["localhost"]) for host in ("localhost:8000", "127.0.0.1", "[::1]:80", "evil.example")]
    [True, True, True, False]
    >>> [host_allowed(host, []) for host in ("evil.example@127.0.0.1", "127.0.0.1#evil.example", "127.0.0.1/x")]
    [False, False, False]
    """
    name = _name(host)
    if name is None:
        return False
    if name in names:
        return True
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def origin_allowed(origin: str | None, host: str) -> bool:
    """Return whether a request's Origin is this very page; a program that is no browser sends none.

    >>> origin_allowed("http://127.0.0.1:8000", "127.0.0.1:8000"), origin_allowed("https://evil.example", "127.0.0.1")
    (True, False)
    """
    if origin is None:
        return True
    try:
        parts = urlsplit(origin)
    except ValueError:
        return False
    return parts.scheme in ("http", "https") and parts.netloc.lower() == host.lower()


def _name(host: str) -> str | None:
    """Return the name in a Host header, which is only that and a port; None where it holds what else addresses do."""
    if NO_HOST.intersection(host):
        return None
    try:
        return urlsplit(f"//{host}").hostname
    except ValueError:
        return None


class Guard:
    """Middleware before everything else: checks Host, Origin and size, and adds the security headers."""

    def __init__(self, app: App, *, names: Iterable[str]) -> None:
        self._app = app
        self._names = frozenset(name.lower() for name in names)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = {name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]}
        refusal = self._refusal(scope, headers)
        if refusal is None and scope["type"] == "http":
            body = _Body(receive, _with_headers(send), _most(scope))
            await self._app(scope, body.receive, body.send)
        elif refusal is None:
            await self._app(scope, receive, _with_headers(send))
        elif scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008, "reason": refusal[1]})
        else:
            await _refuse(_with_headers(send), *refusal)

    def _refusal(self, scope: Scope, headers: dict[str, str]) -> tuple[int, str] | None:
        host = headers.get("host", "")
        if not host_allowed(host, self._names):
            return 421, f"this server is not called {host[:80]!r}; start it with --allow-host to add a name"
        foreign = headers.get("sec-fetch-site") in FOREIGN and not opens_page(scope, headers)
        if foreign or not origin_allowed(headers.get("origin"), host):
            return 403, "pages of other servers may not use this one"
        if len(scope.get("query_string", b"")) > LONGEST_QUERY:
            return 414, f"the address is too long; allowed are {LONGEST_QUERY} bytes after the question mark"
        length = headers.get("content-length", "0")
        if not length.isdecimal() or int(length[:20]) > _most(scope):
            return _too_large(_most(scope))
        return None


def _most(scope: Scope) -> int:
    """Return the limit of a request's size in bytes."""
    return LARGEST_PIECE if str(scope.get("path", "")).startswith(PIECES) else LARGEST_BODY


def _too_large(most: int) -> tuple[int, str]:
    return 413, f"the message is too large; allowed are {most} bytes"


class TooLargeError(Exception):
    """A body without an honest length has grown beyond the limit."""


class _Body:
    """A request's body, ended where it grows beyond the limit whatever its announced length: the answer is 413.

    What the application says of the body that broke off is not sent.
    """

    def __init__(self, receive: Receive, send: Send, most: int) -> None:
        self._receive, self._send, self._most = receive, send, most
        self._taken = 0

    async def receive(self) -> Message:
        message = await self._receive()
        self._taken += len(message.get("body", b""))
        if self._taken > self._most:
            raise TooLargeError
        return message

    async def send(self, message: Message) -> None:
        if self._taken <= self._most:
            await self._send(message)
        elif message["type"] == "http.response.start":
            await _refuse(self._send, *_too_large(self._most))


def _with_headers(send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            given = dict(message["headers"])
            part = given.get(b"content-type", b"").startswith(NO_DOCUMENTS)
            present = {*given, *(OF_DOCUMENTS if part else ())}
            extra = [(name.encode(), value.encode()) for name, value in SECURITY_HEADERS]
            message["headers"] = [*message["headers"], *(pair for pair in extra if pair[0] not in present)]
        await send(message)

    return sending


async def _refuse(send: Send, status: int, message: str) -> None:
    body = json.dumps({"error": {"field": "", "message": message}}).encode()
    headers = [(b"content-type", b"application/json"), (b"content-length", str(len(body)).encode())]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
