"""A page as one HTML file: nothing is fetched.

Style and script are in the file, and its Content-Security-Policy allows these alone.
"""

from base64 import b64encode
from hashlib import sha256
from importlib import resources

from .text import safe


def document(title: str, body: str, style: str, script: str = "", head: str = "") -> str:
    """Return a page; `style` and `script` name files of the package, beside `page.css`."""
    styles = _asset("page.css") + _asset(style)
    policy = f"default-src 'none'; style-src {_hash(styles)}"
    ending = ""
    if script:
        code = _asset(script)
        policy += f"; script-src {_hash(code)}"
        ending = f"<script>{code}</script>"
    return "\n".join(
        [
            "<!DOCTYPE html>",
            '<html lang="en"><head><meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"{head}<title>{safe(title)}</title>",
            f"<style>{styles}</style></head><body>",
            f"{body}{ending}</body></html>",
            "",
        ]
    )


def _asset(name: str) -> str:
    return (resources.files("clpt_control") / "data" / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"
