"""Serves the review page on this machine until it is interrupted."""

from __future__ import annotations

import secrets
import socket
import threading
import webbrowser
from collections.abc import Callable

import uvicorn

from hullform.errors import OutputError
from hullform.review.desk import Desk
from hullform.review.guard import TOKEN_QUERY
from hullform.review.server import review_app
from hullform.ship import Ship

ADDRESS = "127.0.0.1"
PATIENCE_S = 2  # for a reading that is under way when the server is told to end


class _Server(uvicorn.Server):
    """Calls back once it answers."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._ready()


def serve_review(ship: Ship, port: int, open_browser: bool, say: Callable[[str], None]) -> None:
    """Serve the page of a ship's review; returns, or raises KeyboardInterrupt, when it is told to end.

    Args:
        ship: with a picture.
        port: of 127.0.0.1; 0 takes a free one.
        open_browser: whether to open the page in the person's browser.
        say: told the page's address.

    Raises:
        PictureError: the picture cannot be read.
        ReviewError: the review that lies there is damaged, or was made of another picture.
        OutputError: the port is taken.
    """
    desk = Desk(ship)
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as listening:
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listening.bind((ADDRESS, port))
        except (OSError, OverflowError) as error:
            raise OutputError(
                f"port {port} of {ADDRESS} cannot be used ({error}); choose another with --port, or leave --port out"
            ) from None
        token = secrets.token_urlsafe(24)
        address = f"http://{ADDRESS}:{listening.getsockname()[1]}/?{TOKEN_QUERY}={token}"

        def ready() -> None:
            say(address)
            if open_browser:
                # a text browser would hold the server up
                threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()

        config = uvicorn.Config(
            review_app(desk, token),
            log_level="warning",
            access_log=False,
            timeout_graceful_shutdown=PATIENCE_S,
            lifespan="off",
        )
        _Server(config, ready).run(sockets=[listening])
