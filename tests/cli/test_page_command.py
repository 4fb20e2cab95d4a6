"""`sweetspot app`: starts, says where it is, and refuses what it cannot listen on."""

from __future__ import annotations

import gc
import re
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx

Run = Callable[..., tuple[int, str, str]]


def test_it_serves_until_interrupted() -> None:
    script = Path(sys.executable).parent / "sweetspot"
    words = [str(script), "app", "--port", "0", "--no-browser"]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        address = re.findall(r"http://[\d.]+:\d+", process.stderr.readline())[0]
        page = httpx.get(address, timeout=600)
        process.send_signal(signal.SIGINT)
        rest = process.communicate(timeout=600)[1]
    assert page.status_code == 200
    assert "<title>sweetspot</title>" in page.text
    assert address.startswith("http://127.0.0.1:")
    assert rest == ""
    assert process.returncode == 0


def test_wrong_addresses_are_refused(run: Run) -> None:
    for arguments, words in (
        (("--port", "99999"), "--port was given as 99999"),
        (("--host", "no.such.host.invalid"), "cannot listen on no.such.host.invalid"),
        (("--host", "192.0.2.1", "--port", "0"), "cannot listen on 192.0.2.1"),  # an address kept for documents
    ):
        code, out, err = run("app", "--no-browser", *arguments)
        assert (code, out) == (2, "")
        assert words in err


def test_a_taken_port_is_refused(run: Run) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        code, _, err = run("app", "--no-browser", "--port", str(taken.getsockname()[1]))
    assert code == 2
    assert "give another --port" in err


def test_the_browser_is_opened_once_the_server_listens(run: Run, monkeypatch: Any) -> None:
    from sweetspot.web import run_server as serve

    opened: list[str | None] = []

    def no_serving(listening: socket.socket, *, names: Any, open_page: str | None) -> None:
        opened.append(open_page)
        listening.close()

    monkeypatch.setattr(serve, "serve", no_serving)
    assert run("app", "--port", "0")[0] == 0
    code, _, err = run("app", "--port", "0", "--host", "0.0.0.0", "--no-browser")
    assert code == 0
    assert "everyone who reaches this machine" in err
    assert opened[0] is not None
    assert opened[0].startswith("http://127.0.0.1:")
    assert opened[1] is None


def test_the_browser_starts_beside_the_server(monkeypatch: Any) -> None:
    """Its first question waits on the socket that listens already."""
    from sweetspot.web import run_server

    opened: list[str] = []
    asked = threading.Event()

    def seen(address: str) -> None:
        opened.append(address)
        asked.set()

    def built(*, names: Any) -> Any:
        assert asked.wait(60)
        return SimpleNamespace(run=lambda sockets: sockets[0].close())

    monkeypatch.setattr("webbrowser.open", seen)
    monkeypatch.setattr(run_server, "server_for", built)
    listening = run_server.listening("127.0.0.1", 0)
    run_server.serve(listening, open_page="http://127.0.0.1/")
    assert opened == ["http://127.0.0.1/"]
    assert listening.fileno() == -1
    assert gc.isenabled()
