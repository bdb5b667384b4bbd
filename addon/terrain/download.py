"""Fetching a public grid over HTTP: it goes on where it stopped, and is checked; without Blender."""

from __future__ import annotations

import hashlib
import http.client
import re
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from io import RawIOBase
from pathlib import Path
from urllib.error import HTTPError, URLError
from urllib.parse import urlsplit
from urllib.request import (
    HTTPDefaultErrorHandler,
    HTTPErrorProcessor,
    HTTPHandler,
    HTTPRedirectHandler,
    HTTPSHandler,
    OpenerDirector,
    ProxyHandler,
    Request,
)

BLOCK_BYTES = 1 << 16

TIMEOUT_SECONDS = 30.0
"""Without a byte, after which a server counts as gone."""

Told = Callable[[int], None]
"""Takes how many bytes of the file are there; may raise to end the download."""


class DownloadError(OSError):
    """A file cannot be fetched; the text says from where, what was found and what can be done."""


@dataclass(frozen=True)
class Wanted:
    """A file to be fetched."""

    address: str
    most_bytes: int
    """How long it may be, or has to be."""
    is_exact: bool = True
    """Whether it has to be just so long."""
    sha256: str | None = None


def fetch(wanted: Wanted, path: Path, told: Told) -> None:
    """Fetch a file, or the rest of one; nothing is named ``path`` before it is whole and checked.

    What is there of it stays beside it as ``path.part``, so that another call can go on.

    Raises:
        DownloadError: naming the address, what was found and a way out.
        OSError: the folder cannot be written.
    """
    check_address(wanted.address)
    path.parent.mkdir(parents=True, exist_ok=True)
    part, mark = _part(path), _mark(path)
    begun = part.stat().st_size if part.is_file() else 0
    if wanted.is_exact and begun == wanted.most_bytes:
        told(begun)  # ended between the last byte and the check
    else:
        try:
            _receive(wanted, part, mark, told)
        except (TimeoutError, URLError, http.client.HTTPException, ConnectionError) as error:
            raise _failed(wanted, _reason(error)) from error
    _check(wanted, path)
    part.replace(path)
    mark.unlink(missing_ok=True)


def discard(path: Path) -> None:
    """Remove what is there of a file that was begun."""
    for left in (_part(path), _mark(path)):
        left.unlink(missing_ok=True)


def check_address(address: str) -> None:
    """Refuse what is no web address.

    Raises:
        DownloadError: saying what one looks like.
    """
    with suppress(ValueError):
        parts = urlsplit(address)
        if (
            parts.scheme in {"http", "https"}
            and parts.hostname
            and address.isprintable()
            and " " not in address
        ):
            return
    raise DownloadError(f"{address[:120]!r} is no address: expected one that begins with https:// or http://")


def _receive(wanted: Wanted, part: Path, mark: Path, told: Told) -> None:
    """Ask for what is missing, and write it."""
    begun = part.stat().st_size if part.is_file() else 0
    known = mark.read_text(encoding="utf-8") if mark.is_file() else ""
    request = Request(wanted.address, headers={"Accept-Encoding": "identity", "User-Agent": "Haptic Terrain"})
    # Half of one file and half of another would be found out only by a checksum.
    if begun and (known or wanted.sha256):
        request.add_header("Range", f"bytes={begun}-")
        if known:
            request.add_header("If-Range", known)
    try:
        response = _opener().open(request, timeout=TIMEOUT_SECONDS)
    except HTTPError as error:
        with error:
            if error.code == http.HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE:
                part.unlink(missing_ok=True)  # another call begins anew
            raise _failed(wanted, f"the server answered {error.code} {error.reason}") from error
    with response:
        goes_on = response.status == http.HTTPStatus.PARTIAL_CONTENT and _begins_at(response, begun)
        if response.status == http.HTTPStatus.PARTIAL_CONTENT and not goes_on:
            raise _failed(wanted, "the server sent another part than was asked for")
        written = begun if goes_on else 0
        _check_length(wanted, response, written)
        mark.write_text(_validator(response), encoding="utf-8")
        # Unbuffered: what a call wrote that was given up is there before the next one looks.
        with part.open("ab" if goes_on else "wb", buffering=0) as file:
            _write(wanted, response, file, written, told)


def _write(
    wanted: Wanted, response: http.client.HTTPResponse, file: RawIOBase, written: int, told: Told
) -> None:
    # What is there is taken at once, however slowly it comes: a person may want to cancel.
    while piece := response.read1(BLOCK_BYTES):
        told(written)  # before anything is written: another call may have begun meanwhile
        if written + len(piece) > wanted.most_bytes:
            raise _failed(wanted, f"the file is longer than {wanted.most_bytes:,} bytes")
        file.write(piece)
        written += len(piece)
        told(written)


def _check(wanted: Wanted, path: Path) -> None:
    """Refuse what is too short (to be continued) or another file (to be begun anew)."""
    part = _part(path)
    size = part.stat().st_size
    if wanted.is_exact and size < wanted.most_bytes:
        raise _failed(wanted, f"the connection ended after {size:,} of {wanted.most_bytes:,} bytes")
    if wanted.sha256 is None:
        return
    with part.open("rb") as file:
        found = hashlib.file_digest(file, "sha256").hexdigest()
    if found != wanted.sha256:
        discard(path)
        raise _failed(wanted, f"it is another file: its SHA-256 is {found}, and not {wanted.sha256}")


def _check_length(wanted: Wanted, response: http.client.HTTPResponse, written: int) -> None:
    stated = response.headers.get("Content-Length", "")
    if not stated.isdecimal():
        return
    whole = written + int(stated)
    if whole > wanted.most_bytes or (wanted.is_exact and whole != wanted.most_bytes):
        expected = f"{'' if wanted.is_exact else 'at most '}{wanted.most_bytes:,}"
        raise _failed(wanted, f"the server has a file of {whole:,} bytes, expected {expected}")


def _begins_at(response: http.client.HTTPResponse, begun: int) -> bool:
    found = re.match(r"bytes (\d+)-", response.headers.get("Content-Range", ""))
    return found is not None and int(found[1]) == begun


def _validator(response: http.client.HTTPResponse) -> str:
    """By what the server knows this state of the file again; weak ones do not count."""
    tag = response.headers.get("ETag", "")
    return tag if tag.startswith('"') else response.headers.get("Last-Modified", "")


def _part(path: Path) -> Path:
    return path.with_name(f"{path.name}.part")


def _mark(path: Path) -> Path:
    return path.with_name(f"{path.name}.part.state")


def _failed(wanted: Wanted, reason: str) -> DownloadError:
    return DownloadError(
        f"{wanted.address} was not fetched: {reason}. "
        "Try again (what is there is kept), or change the address."
    )


def _reason(error: Exception) -> str:
    reason = error.reason if isinstance(error, URLError) else error
    if isinstance(reason, TimeoutError):
        return f"the server was silent for {TIMEOUT_SECONDS:g} s"
    return str(reason) or type(reason).__name__


class _Redirects(HTTPRedirectHandler):
    """Follow to web addresses only, and never from a safe one to an unsafe one."""

    def redirect_request(
        self,
        req: Request,
        fp: object,
        code: int,
        msg: str,
        headers: http.client.HTTPMessage,
        newurl: str,
    ) -> Request | None:
        """Refuse what a server has no business to send a person to."""
        if not newurl.startswith(("https://", "http://")[: 1 if req.type == "https" else 2]):
            raise URLError(f"the server redirects to {newurl[:120]}")
        return super().redirect_request(req, fp, code, msg, headers, newurl)  # type: ignore[arg-type]


def _opener() -> OpenerDirector:
    """HTTP and HTTPS through the system's proxies: no files of this machine, no FTP."""
    opener = OpenerDirector()
    for handler in (
        ProxyHandler,
        HTTPHandler,
        HTTPSHandler,
        _Redirects,
        HTTPErrorProcessor,
        HTTPDefaultErrorHandler,
    ):
        opener.add_handler(handler())
    return opener
