"""A web server on the loopback interface that behaves as a test wants it."""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer


@dataclass
class Site:
    """What the server has, and how it behaves."""

    files: dict[str, bytes]
    honours_range: bool = True
    tag: str = '"first"'
    cuts_after: int | None = None
    """Bytes of a body, after which the connection ends."""
    states: Callable[[int], int] = lambda size: size
    """What the server says of a body's length."""
    redirects: dict[str, str] = field(default_factory=dict)
    begins_at: int | None = None
    """Where a part begins instead of where it was asked to."""
    gate: threading.Event | None = None
    """Waited for in the middle of a body."""
    reached: threading.Event = field(default_factory=threading.Event)
    """Set in the middle of a body."""
    asked: list[tuple[str, str | None]] = field(default_factory=list)
    """Path and range of each request."""
    address: str = ""


@contextmanager
def served(site: Site) -> Iterator[Site]:
    """Serve until the block ends."""

    class Handler(BaseHTTPRequestHandler):
        def log_message(self, *arguments: object) -> None:
            """Say nothing."""

        def do_GET(self) -> None:
            _answer(self, site)

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    site.address = f"http://127.0.0.1:{server.server_port}"
    try:
        yield site
    finally:
        if site.gate is not None:
            site.gate.set()
        server.shutdown()
        server.server_close()
        thread.join()


def _answer(handler: BaseHTTPRequestHandler, site: Site) -> None:
    asked = handler.headers.get("Range")
    site.asked.append((handler.path, asked))
    if handler.path in site.redirects:
        handler.send_response(302)
        handler.send_header("Location", site.redirects[handler.path])
        handler.end_headers()
        return
    body = site.files.get(handler.path)
    if body is None:
        handler.send_error(404)
        return
    same = handler.headers.get("If-Range") in {None, site.tag}
    wanted = re.fullmatch(r"bytes=(\d+)-", asked or "")
    begin = 0
    if wanted and site.honours_range and same:
        begin = int(wanted[1])
        if begin >= len(body):
            handler.send_error(416)
            return
        told = begin if site.begins_at is None else site.begins_at
        handler.send_response(206)
        handler.send_header("Content-Range", f"bytes {told}-{len(body) - 1}/{len(body)}")
    else:
        handler.send_response(200)
    rest = body[begin:]
    handler.send_header("Content-Length", str(site.states(len(rest))))
    handler.send_header("ETag", site.tag)
    handler.end_headers()
    _send(handler, site, rest if site.cuts_after is None else rest[: site.cuts_after])


def _send(handler: BaseHTTPRequestHandler, site: Site, body: bytes) -> None:
    try:
        half = len(body) // 2
        handler.wfile.write(body[:half])
        handler.wfile.flush()
        site.reached.set()
        if site.gate is not None:
            site.gate.wait(60.0)
        handler.wfile.write(body[half:])
    except OSError:
        pass  # the client has gone
