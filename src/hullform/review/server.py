"""The page's server: the static page, the picture, and the few calls by which it reads and saves."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from hullform.errors import HullformError, ReviewError
from hullform.review.desk import Desk, OverwritingError, SupersededError
from hullform.review.guard import LoopbackOnly
from hullform.review.shown_picture import shown_picture

STATIC = Path(__file__).parent / "static"
TOKEN_PLACE = "{{ token }}"
REFUSED, SUPERSEDED, CHANGED_MEANWHILE = 422, 409, 412
REVISION_HEADER = "x-review-revision"


def review_app(desk: Desk, token: str) -> Starlette:
    """The application that serves the review page of one ship.

    Args:
        desk: of the ship.
        token: in the address of the page, which sends it with all that changes anything.
    """
    page = (STATIC / "index.html").read_text(encoding="utf-8").replace(TOKEN_PLACE, token)

    async def index(_: Request) -> Response:
        return HTMLResponse(page)

    async def picture(_: Request) -> Response:
        source = desk.ship.picture
        content, media_type = await run_in_threadpool(shown_picture, source.image_path, source.page)
        return Response(content, media_type=media_type)

    async def opening(_: Request) -> Response:
        return await _answer(desk.opening)

    async def solve(request: Request) -> Response:
        return await _answer(desk.solve, await _document(request))

    async def save(request: Request) -> Response:
        document, revision = await _document(request), request.headers.get(REVISION_HEADER, "")

        def saved() -> dict[str, Any]:
            path, now = desk.save(document, revision)
            return {"file": str(path), "revision": now}

        return await _answer(saved)

    async def strip(request: Request) -> Response:
        asked = request.query_params
        try:
            half, station_m, curve = asked["half"], float(asked["station_m"]), int(asked.get("curve", "0"))
        except (KeyError, ValueError):
            return JSONResponse({"message": "a strip needs half, station_m and curve"}, status_code=REFUSED)
        try:
            return Response(await run_in_threadpool(desk.strip, half, station_m, curve), media_type="image/png")
        except HullformError as error:
            return JSONResponse({"message": str(error)}, status_code=REFUSED)

    return Starlette(
        routes=[
            Route("/", index),
            Route("/picture", picture),
            Route("/api/opening", opening),
            Route("/api/review", solve, methods=["PUT"]),
            Route("/api/save", save, methods=["POST"]),
            Route("/api/strip", strip),
            Mount("/static", StaticFiles(directory=STATIC)),
        ],
        middleware=[Middleware(LoopbackOnly, token=token)],
        exception_handlers={ReviewError: _refused},
    )


async def _document(request: Request) -> dict[str, Any]:
    try:
        document = json.loads(await request.body())
    except ValueError as error:
        raise ReviewError(f"the page sent no JSON: {error}; load it again") from None
    if not isinstance(document, dict):
        raise ReviewError("the page sent no review; load it again")
    return document


async def _answer(work: Callable[..., dict[str, Any]], *arguments: Any) -> Response:
    """What the work returns, done in a thread; where the input is wrong, its message."""
    try:
        return JSONResponse(await run_in_threadpool(work, *arguments))
    except SupersededError as error:
        return JSONResponse({"message": str(error)}, status_code=SUPERSEDED)
    except OverwritingError as error:
        return JSONResponse({"message": str(error), "revision": error.revision}, status_code=CHANGED_MEANWHILE)
    except HullformError as error:
        return JSONResponse({"message": str(error)}, status_code=REFUSED)


async def _refused(_: Request, error: Exception) -> Response:
    return JSONResponse({"message": str(error)}, status_code=REFUSED)
