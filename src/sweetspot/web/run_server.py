"""Running the server."""

from __future__ import annotations

import gc
import socket
import threading
import webbrowser
from collections.abc import Iterable
from contextlib import suppress

import uvicorn

from sweetspot.errors import InputError
from sweetspot.web.limits import LARGEST_BODY

HEARTBEAT = 20.0
"""s between the pings that find sockets whose browser is gone."""


def listening(host: str, port: int) -> socket.socket:
    """Return a socket that listens at an address; a taken port or a wrong address is an `InputError`."""
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        opened = socket.socket(family, kind, protocol)
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            opened.bind(address)
            opened.listen(128)
        except OSError:
            opened.close()
            raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"cannot listen on {host} port {port}: {reason}; give another --port or --host") from None
    return opened


def serve(opened: socket.socket, *, names: Iterable[str] = (), open_page: str | None = None) -> None:
    """Serve the page on a listening socket until interrupted.

    Parameters
    ----------
    names : host names, besides localhost and number addresses, under which browsers may ask.
    open_page : address to open in a browser, which waits until the server answers; None: leave that to people.
    """
    if open_page is not None:  # both take seconds, side by side: the socket listens already
        threading.Thread(target=webbrowser.open, args=[open_page], daemon=True, name="browser").start()
    gc.disable()  # what modules make stays: looking through it for waste takes a tenth of the start
    server = server_for(names=names)
    gc.enable()
    with suppress(KeyboardInterrupt):
        server.run(sockets=[opened])


def server_for(*, names: Iterable[str] = ()) -> uvicorn.Server:
    """Return a server for the application with this project's limits."""
    from sweetspot.web.server import create_app
    from sweetspot.web.silence import PatientProtocol

    return uvicorn.Server(
        uvicorn.Config(
            create_app(names=names),
            http=PatientProtocol,
            ws="websockets-sansio",
            log_level="warning",
            access_log=False,
            server_header=False,
            proxy_headers=False,
            ws_max_size=LARGEST_BODY,
            ws_max_queue=8,
            ws_ping_interval=HEARTBEAT,
            ws_per_message_deflate=False,
            limit_concurrency=1000,
            timeout_graceful_shutdown=2,
        )
    )
