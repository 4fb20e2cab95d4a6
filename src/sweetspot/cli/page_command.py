"""`sweetspot app`: the page, served from this machine; `sweetspot prepare`: nothing waits for it later."""

from __future__ import annotations

import sys
from typing import Annotated

from cyclopts import Parameter

from sweetspot.errors import InputError

PORT = 8765
HIGHEST_PORT = 65535


def app(
    *,
    host: Annotated[str, Parameter(help="Address to listen on; 127.0.0.1 is this machine only.")] = "127.0.0.1",
    port: Annotated[int, Parameter(help="Port to listen on; 0 takes a free one.")] = PORT,
    browser: Annotated[bool, Parameter(help="Open the page in a browser.")] = True,
    allow_host: Annotated[
        tuple[str, ...], Parameter(help="Name under which browsers may ask for it, besides localhost.")
    ] = (),
) -> None:
    """Open the laboratory in a browser: see a bat, move a slider, understand. Ends with Ctrl-C."""
    from sweetspot.web.run_server import listening, serve

    if not 0 <= port <= HIGHEST_PORT:
        raise InputError(f"--port was given as {port}; allowed is 0 (a free one) to {HIGHEST_PORT}")
    sockets = listening(host, port)
    address = f"http://{'localhost' if host in ('0.0.0.0', '::') else host}:{sockets.getsockname()[1]}/"
    print(f"sweetspot: the page is at {address} (Ctrl-C ends it)", file=sys.stderr)
    if host not in ("127.0.0.1", "localhost", "::1"):
        print("sweetspot: everyone who reaches this machine can use the page", file=sys.stderr)
    serve(sockets, names=allow_host, open_page=address if browser else None)


def prepare() -> None:
    """Compile the solver for this machine and work out the page's first pictures, once, so that nothing waits later."""
    from sweetspot.web.answers import prepare_all

    prepare_all(lambda words: print(f"sweetspot: {words}", file=sys.stderr))
    from sweetspot.answers.report import report_of
    from sweetspot.catalog.standard_hit import standard_analysis
    from sweetspot.uncertainty.sources import sources_of

    analysis = standard_analysis("r161-ash")
    report_of(analysis, sources_of(analysis.bat, analysis.conditions), drawn=True, draws=4)  # compiles what draws need
