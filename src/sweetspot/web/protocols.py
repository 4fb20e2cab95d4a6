"""One connection, as uvicorn speaks HTTP and WebSocket: without endless patience, and calm about what is malformed."""

from __future__ import annotations

import asyncio

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

REQUEST_TIME = 5.0
"""s that a request may take to arrive, from its first byte (the first one: from the connection) to its last."""
NO_TEXT = 1007
"""Code with which a line is closed whose text is no UTF-8."""
COME = (h11.DONE, h11.MUST_CLOSE, h11.CLOSED, h11.ERROR, h11.SWITCHED_PROTOCOL)


class TimedProtocol(H11Protocol):
    """HTTP/1.1 whose connection is closed when a request is begun and not brought to its end.

    How long an answer takes is no concern of it, nor is a connection that rests between two requests: uvicorn closes
    that by itself.
    """

    _limit: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin to wait for the first request."""
        super().connection_made(transport)
        self._begin()

    def data_received(self, data: bytes) -> None:
        """Take a piece of a request."""
        super().data_received(data)
        if self.conn.their_state in COME or self.transport.get_protocol() is not self:
            self._end()
        elif self._limit is None:
            self._begin()

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        """Hand the connection to the socket, which has limits of its own."""
        super().handle_websocket_upgrade(event)
        self._end()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the limit."""
        self._end()
        super().connection_lost(exc)

    def _begin(self) -> None:
        self._limit = self.loop.call_later(REQUEST_TIME, self._give_up)

    def _end(self) -> None:
        if self._limit is not None:
            self._limit.cancel()
            self._limit = None

    def _give_up(self) -> None:
        self._limit = None
        self.transport.close()


class CheckedSocketProtocol(WebSocketsSansIOProtocol):
    """A WebSocket on which a text that is no UTF-8 is its sender's fault: the line is closed, and nothing is logged."""

    def send_receive_event_to_app(self) -> None:
        """Hand a message on, if it is one."""
        if self.curr_msg_data_type == "text" and not _is_text(b"".join(self.frames)):
            self.frames = []
            self.conn.fail(NO_TEXT, "a text must be UTF-8")
            self.handle_parser_exception()
            return
        super().send_receive_event_to_app()


def _is_text(data: bytes) -> bool:
    try:
        data.decode()
    except UnicodeDecodeError:
        return False
    return True
