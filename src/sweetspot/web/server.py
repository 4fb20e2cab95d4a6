"""The server: the page, its API and its socket as one application."""

from __future__ import annotations

import threading
from collections.abc import AsyncIterator, Callable, Iterable, Mapping
from contextlib import asynccontextmanager
from html import escape
from typing import Any

from fastapi import APIRouter, FastAPI, Request, Response, WebSocket
from fastapi.exceptions import RequestValidationError
from fastapi.responses import HTMLResponse, JSONResponse
from starlette.exceptions import HTTPException
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect

from sweetspot import __version__
from sweetspot.errors import SweetspotError
from sweetspot.web.answers import AnswerPool, TooSlowError, answer_json
from sweetspot.web.bring import bring_routes
from sweetspot.web.catalogue import catalogue_routes
from sweetspot.web.errors import Fault, FullDiskError, Refusal, fault
from sweetspot.web.files import File, shells, static_files
from sweetspot.web.jobs import Jobs, LongWork, job_routes
from sweetspot.web.limits import EMBEDDED_POLICY, Guard
from sweetspot.web.recipes import BALL_FILE
from sweetspot.web.socket import Sockets
from sweetspot.web.uploads import UPLOADS, upload_routes
from sweetspot.web.view import View
from sweetspot.web.views import VIEWS

LOCAL_NAMES = ("localhost", "testserver")
API = "/api/v1"
NOT_FOUND = 404
PACKED_FROM, PACKED_AT = 1000, 3
"""Bytes from which an answer is packed for those who can unpack it, and how thoroughly: 30 kB take 0.3 ms."""
ASKED_AGAIN = "no-cache"
"""Of a page itself: a browser that has it asks whether it is still the same."""
KEPT_FOR = 20
"""s that a browser uses a file of the page again without asking: a view in a second tab asks for one file, not for 90.
An upgrade takes longer, so that no page of one version gets files of another."""
REFUSALS = {
    400: "The message is not JSON.",
    403: "Asked by a page of another server.",
    413: "The message is too large.",
    421: "The server is not called that.",
    422: "A control has a value that does not work.",
    507: "There is no room on this machine's disk.",
}
"""The status codes with which every route may answer a `Refusal`, and why."""
LAST_WORK = 10.0
"""s that a server which ends waits for what it was still preparing."""
_BROKEN = "this question breaks the program; the fault is not yours. Please report it with the question"
_NO_PAGE = "there is no page {}"
_LOST = (
    '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>sweetspot: no such page</title>'
    '<link rel="stylesheet" href="/static/theme.css"><main class="api"><h1>Not here</h1><p>{}.</p>'
    '<p><a href="/">To the laboratory</a></p></main></html>'
)


def create_app(*, names: Iterable[str] = ()) -> FastAPI:
    """Return the application.

    Parameters
    ----------
    names : host names, besides localhost and number addresses, under which browsers may ask for it.
    """
    answers, jobs = AnswerPool(), Jobs()

    @asynccontextmanager
    async def life(_: FastAPI) -> AsyncIterator[None]:
        preparing = threading.Thread(target=answers.prepare, daemon=True, name="prepare")
        preparing.start()
        yield
        answers.close()
        jobs.close()
        UPLOADS.close()
        preparing.join(LAST_WORK)  # cut off inside the compiler it would end the process with a fault of its own

    app = FastAPI(
        title="sweetspot",
        version=__version__,
        description="Every view of the page as one request: its controls in, its numbers out, SI with units in names.",
        docs_url=None,
        redoc_url=None,
        openapi_url=f"{API}/openapi.json",
        lifespan=life,
    )
    app.state.answers = answers
    app.add_middleware(GZipMiddleware, minimum_size=PACKED_FROM, compresslevel=PACKED_AT)
    app.add_middleware(Guard, names=(*LOCAL_NAMES, *names))
    app.add_exception_handler(RequestValidationError, _invalid)
    app.add_exception_handler(HTTPException, _refused)
    app.add_exception_handler(SweetspotError, _wrong)
    app.add_exception_handler(ClientDisconnect, _gone)
    app.add_exception_handler(Exception, _broken)
    refusal = {"application/json": {"schema": {"$ref": f"#/components/schemas/{Refusal.__name__}"}}}
    api = APIRouter(
        prefix=API, responses={code: {"description": words, "content": refusal} for code, words in REFUSALS.items()}
    )
    catalogue_routes(api)
    for view in VIEWS.values():
        _view_route(api, view, answers)
        _job_routes(api, view, jobs)
    job_routes(api, jobs)
    upload_routes(api)
    bring_routes(api)
    app.include_router(api)
    sockets = Sockets(answers)

    @app.websocket("/ws")
    async def socket(connection: WebSocket) -> None:
        await sockets.serve(connection)

    _page_routes(app)
    return app


def _view_route(api: APIRouter, view: View, answers: AnswerPool) -> None:
    def route(path: str, name: str, asked: Callable[[Any], Any], aside: str) -> None:
        async def endpoint(state: Any) -> Response:
            return Response(await answers.json(view.name, state, aside), media_type="application/json")

        endpoint.__annotations__["state"] = view.state
        endpoint.__doc__ = asked.__doc__
        unfinished = "This takes long and is still being worked out: ask again after the seconds of Retry-After."
        seconds = {"retry-after": {"description": "s", "schema": {"type": "integer"}}}
        api.post(
            path,
            name=name,
            response_class=JSONResponse,
            response_model=dict[str, object] | None if aside else dict[str, object],  # there may be nothing to add
            responses={503: {"model": Refusal, "description": unfinished, "headers": seconds}},
            tags=["views"],
        )(endpoint)

    route(f"/{view.name}", view.title, view.answer, "")
    for name, asked in view.asides.items():
        route(f"/{view.name}/{name}", f"{view.title}: {name}", asked, name)
    if view.recipe is None:
        return
    recipe = view.recipe

    def lines(state: Any) -> dict[str, str]:
        answer_json(view.name, state)  # what has no answer, such as a name that is in no catalogue, has no lines
        ball_text = getattr(state, "ball_toml", None)
        return recipe(state) | ({BALL_FILE: ball_text} if ball_text else {})

    lines.__annotations__["state"] = view.state
    lines.__doc__ = "Return the lines that give the same numbers without the page, and the bat's file."
    api.post(f"/{view.name}/recipe", name=f"{view.title}: recipe", tags=["views"])(lines)


def _job_routes(api: APIRouter, view: View, jobs: Jobs) -> None:
    def route(name: str, asked: LongWork) -> None:
        def endpoint(state: Any, request: Request) -> dict[str, str]:
            client = request.client.host if request.client else ""
            return {"job": jobs.start(client, asked.work, *asked.arguments(state))}

        endpoint.__annotations__["state"] = view.state
        endpoint.__doc__ = asked.work.__doc__
        api.post(f"/{view.name}/{name}", name=f"{view.title}: {name}", tags=["long work"])(endpoint)

    for name, asked in view.jobs.items():
        route(name, asked)


def _page_routes(app: FastAPI) -> None:
    files = static_files()
    pages = {**shells(files["index.html"]), "docs": files["docs.html"]}

    def hand_out(path: str, find: Callable[[str], File | None], cache_control: str = ASKED_AGAIN) -> None:
        @app.api_route(path, methods=["GET", "HEAD"], include_in_schema=False)
        async def handed(request: Request) -> Response:
            return _handed(find(request.path_params.get("name", "")), request, cache_control)

    hand_out("/", pages.get)
    hand_out("/static/{name:path}", files.get, f"max-age={KEPT_FOR}")
    hand_out("/{name}", pages.get)

    @app.api_route("/embed/{name}", methods=["GET", "HEAD"], include_in_schema=False)
    async def embedded(name: str, request: Request) -> Response:
        response = _handed(pages.get(name) if name in VIEWS else None, request)
        response.headers["content-security-policy"] = EMBEDDED_POLICY
        return response


def _handed(file: File | None, request: Request, cache_control: str = ASKED_AGAIN) -> Response:
    if file is None:
        raise HTTPException(NOT_FOUND)
    headers = {"etag": file.tag, "cache-control": cache_control, "vary": "accept-encoding"}
    if request.headers.get("if-none-match") == file.tag:
        return Response(status_code=304, headers=headers)
    if "gzip" in request.headers.get("accept-encoding", ""):
        return Response(file.packed, media_type=file.media_type, headers={**headers, "content-encoding": "gzip"})
    return Response(file.content, media_type=file.media_type, headers=headers)


def _refusal(error: Fault, code: int, headers: Mapping[str, str] | None = None) -> JSONResponse:
    return JSONResponse({"error": error.plain()}, code, headers)


async def _invalid(_: Request, error: Exception) -> JSONResponse:
    assert isinstance(error, RequestValidationError)
    return _refusal(fault(error), 422)


async def _refused(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    words = _NO_PAGE.format(request.url.path[:80]) if error.status_code == NOT_FOUND else str(error.detail)
    if error.status_code == NOT_FOUND and "text/html" in request.headers.get("accept", ""):
        return HTMLResponse(_LOST.format(escape(words)), NOT_FOUND)
    return _refusal(Fault(field="", message=words), error.status_code, error.headers)


async def _wrong(_: Request, error: Exception) -> JSONResponse:
    assert isinstance(error, SweetspotError)
    if isinstance(error, TooSlowError):
        return _refusal(fault(error).model_copy(update={"again": True}), 503, {"retry-after": "1"})
    return _refusal(fault(error), 507 if isinstance(error, FullDiskError) else 422)


async def _gone(_: Request, error: Exception) -> Response:  # noqa: ARG001 - nobody is left to read it
    return Response(status_code=400)


async def _broken(_: Request, error: Exception) -> JSONResponse:  # noqa: ARG001 - the server logs it
    return _refusal(Fault(field="", message=_BROKEN), 500)
