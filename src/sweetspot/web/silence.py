"""Connections on which half a request has come and no more of it comes: closed, however long a whole one may take."""

from __future__ import annotations

from asyncio import TimerHandle, Transport

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

LONGEST_SILENCE = 20.0
"""s without a byte of a request that has not come whole, as a slow wireless link has none for seconds."""


class PatientProtocol(H11Protocol):
    """HTTP that waits for a request as long as bytes of it come, and for none of them `LONGEST_SILENCE`."""

    _waiting: TimerHandle | None = None

    def connection_made(self, transport: Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._wait()

    def data_received(self, data: bytes) -> None:
        self._stop()
        super().data_received(data)
        if self.conn.their_state in (h11.IDLE, h11.SEND_BODY):
            self._wait()

    def connection_lost(self, exc: Exception | None) -> None:
        self._stop()
        super().connection_lost(exc)

    def _wait(self) -> None:
        self._waiting = self.loop.call_later(LONGEST_SILENCE, self._silent)

    def _stop(self) -> None:
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None

    def _silent(self) -> None:
        if self.flow.read_paused:  # it is we who do not listen
            self._wait()
        elif self.conn.their_state in (h11.IDLE, h11.SEND_BODY):
            self.transport.close()
