"""The socket: one browser's questions and answers, the latest question of each view first and only."""

from __future__ import annotations

import asyncio
import json
from contextlib import suppress
from typing import Literal

from fastapi import WebSocket, WebSocketDisconnect
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sweetspot.errors import SweetspotError
from sweetspot.web.answers import AnswerPool, TooSlowError, state_of
from sweetspot.web.errors import Fault, FieldError, fault
from sweetspot.web.limits import LARGEST_BODY, MOST_SOCKETS

TRY_AGAIN_LATER = 1013


class SocketQuestion(BaseModel):
    """One message of a browser: which view's answer it wants, with which controls."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    id: int = Field(ge=0, le=2**53)
    view: str = Field(max_length=60)
    state: dict[str, object]


class SocketStatus(BaseModel):
    """A message to a browser that is no answer: the kernels are still being loaded, or what is wrong."""

    id: int | None
    view: str = ""
    status: Literal["", "preparing"] = ""
    error: Fault | None = None
    again: bool = Field(False, description="the answer is still being worked out, and there when asked for again")


class Sockets:
    """Every open socket of this server; their number is limited, and they know nothing of each other."""

    def __init__(self, answers: AnswerPool) -> None:
        self._answers = answers
        self._open = 0

    async def serve(self, socket: WebSocket) -> None:
        """Answer one browser until it goes away."""
        await socket.accept()
        if self._open >= MOST_SOCKETS:
            await socket.close(TRY_AGAIN_LATER, f"all {MOST_SOCKETS} places are taken; try again later")
            return
        self._open += 1
        try:
            await _Conversation(socket, self._answers).run()
        finally:
            self._open -= 1


class _Conversation:
    """One socket. A question replaces the one of the same view that still waits; that one gets no answer."""

    def __init__(self, socket: WebSocket, answers: AnswerPool) -> None:
        self._socket, self._answers = socket, answers
        self._waiting: dict[str, SocketQuestion] = {}
        self._arrived = asyncio.Event()

    async def run(self) -> None:
        worker = asyncio.create_task(self._answer())
        try:
            while True:
                message = await self._socket.receive()
                if message["type"] == "websocket.disconnect":
                    break
                await self._take(message.get("text"))
        except (WebSocketDisconnect, RuntimeError):  # gone while we were speaking
            pass
        finally:
            worker.cancel()
            with suppress(asyncio.CancelledError):
                await worker

    async def _take(self, text: str | None) -> None:
        try:
            if text is None or len(text) > LARGEST_BODY:
                raise FieldError("", f"a message is JSON text of at most {LARGEST_BODY} letters")
            question = SocketQuestion.model_validate_json(text)
        except (SweetspotError, ValidationError) as error:
            await self._say(SocketStatus(id=_id_in(text), error=fault(error)))
            return
        self._waiting.pop(question.view, None)
        self._waiting[question.view] = question
        self._arrived.set()

    async def _answer(self) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                await self._arrived.wait()
                while self._waiting:
                    question = self._waiting.pop(next(iter(self._waiting)))
                    await self._reply(question)
                self._arrived.clear()

    async def _reply(self, question: SocketQuestion) -> None:
        number, view = question.id, question.view
        if not self._answers.prepared:
            await self._say(SocketStatus(id=number, view=view, status="preparing"))
        try:
            answer = await self._answers.json(view, state_of(view, question.state))
        except SweetspotError as error:
            again = isinstance(error, TooSlowError)
            await self._say(SocketStatus(id=number, view=view, error=fault(error), again=again))
        except Exception:  # a fault of ours must not end the conversation
            _log_fault(view)
            message = "this could not be computed; the fault is the program's. Other settings should work"
            await self._say(SocketStatus(id=number, view=view, error=Fault(field="", message=message)))
        else:
            head = json.dumps({"id": number, "view": view})
            await self._socket.send_text(f'{head[:-1]}, "answer": {answer.decode()}}}')

    async def _say(self, message: SocketStatus) -> None:
        await self._socket.send_text(message.model_dump_json(exclude_defaults=True))


def _id_in(text: str | None) -> int | None:
    """Return the id of a message that is otherwise wrong, when it can be found."""
    try:
        table = json.loads(text or "")
    except (ValueError, RecursionError):
        return None
    number = table.get("id") if isinstance(table, dict) else None
    return number if isinstance(number, int) and 0 <= number <= 2**53 else None


def _log_fault(view: str) -> None:
    import logging

    logging.getLogger("sweetspot.web").exception("view %s", view)
