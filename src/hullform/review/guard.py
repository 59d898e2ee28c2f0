"""Who may talk to the page's server: the browser that opened the address which this run printed.

Every program of this machine can reach 127.0.0.1, those of its other users too, so the address holds a token: it is
asked for in exchange for the page, which then carries it in a cookie. A page of another origin cannot read what is
served here, but it could send, and the browser would add the cookie; so what changes anything must bring the token in a
header, too. A name that is made to point at 127.0.0.1 would turn its origin into ours, so the Host is checked as well.
"""

from __future__ import annotations

import hmac

from starlette.datastructures import Headers
from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

TOKEN_HEADER = "x-review-token"
TOKEN_QUERY = "token"
COOKIE = "hullform-review"
OPEN_TO_ALL = "/static/"  # the page's own modules, the same for every ship
LOOPBACK_HOSTS = frozenset({"127.0.0.1", "localhost", "[::1]"})
READING_METHODS = frozenset({"GET", "HEAD"})
NOT_YOURS = "open the whole address that 'hullform review' printed: the token in it lets you in"
POLICY = {
    "content-security-policy": "default-src 'self'; img-src 'self' data:; "
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'",
    "cross-origin-resource-policy": "same-origin",
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cache-control": "no-store",
}


class LoopbackOnly:
    """Refuses requests to another host name, without this run's token, and writing ones without it in their header."""

    def __init__(self, app: ASGIApp, token: str) -> None:
        self.app = app
        self.token = token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        answer = self._instead(Request(scope))

        async def send_with_policy(message: Message) -> None:
            if message["type"] == "http.response.start":
                own = {name for name, _ in message["headers"]}
                extra = [(name.encode(), value.encode()) for name, value in POLICY.items() if name.encode() not in own]
                message["headers"] = [*message["headers"], *extra]
            await send(message)

        await (self.app if answer is None else answer)(scope, receive, send_with_policy)

    def _instead(self, request: Request) -> Response | None:
        """What is answered instead of the application: a refusal, or the page's own address and the cookie for it."""
        refused = self._refusal(request.method, request.headers)
        if refused is not None:
            return JSONResponse({"message": refused}, status_code=403)
        if request.url.path.startswith(OPEN_TO_ALL) or request.method not in READING_METHODS:
            return None
        # cookies are shared by all ports of a host, and another review may be open
        cookie = f"{COOKIE}-{request.url.port}"
        if request.url.path == "/" and self._is_token(request.query_params.get(TOKEN_QUERY, "")):
            # without the token the address may be seen by those who look over a shoulder
            page = RedirectResponse("/", status_code=303)
            page.set_cookie(cookie, self.token, httponly=True, samesite="lax")
            return page
        if self._is_token(request.cookies.get(cookie, "")):
            return None
        if request.url.path == "/":
            return PlainTextResponse(f"{NOT_YOURS}\n", status_code=403)
        return JSONResponse({"message": NOT_YOURS}, status_code=403)

    def _is_token(self, given: str) -> bool:
        return hmac.compare_digest(given.encode(), self.token.encode())

    def _refusal(self, method: str, headers: Headers) -> str | None:
        host = headers.get("host", "").lower()
        name = host if host.endswith("]") else host.rpartition(":")[0] or host
        if name not in LOOPBACK_HOSTS:
            return "this page is served to this machine alone; open the address that 'hullform review' printed"
        if method in READING_METHODS:
            return None
        origin = headers.get("origin")
        if origin is not None and origin.lower() != f"http://{host}":
            return "a page of another origin may not change this review"
        if not self._is_token(headers.get(TOKEN_HEADER, "")):
            return "this page is of an earlier run; open the address that 'hullform review' printed"
        return None
