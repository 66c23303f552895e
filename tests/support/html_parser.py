"""HTML as a strict reader takes it."""

import re
from html.parser import HTMLParser

VOID = {"meta", "br", "hr", "img", "input", "link"}


def fetching_nothing(text):
    """Read a page of which nothing is fetched, sent or run from an attribute."""
    page = Reader(text)
    for tag, names in page.tags:
        assert tag not in ("img", "link", "iframe", "object", "base")
        assert not [
            name
            for name in names
            if re.fullmatch("src|srcset|action|data|style|on.*", name)
        ]
        assert names.get("href", "#").startswith("#"), tag
    assert not re.search(r"url\((?!#)|@import", text)
    return page


class Reader(HTMLParser):
    """All tags, attributes and texts of a page; tags must be closed in their order."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.texts, self.styles, self.scripts = [], [], [], [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        inner = self.open[-1] if self.open else ""
        {"style": self.styles, "script": self.scripts}.get(inner, self.texts).append(
            data
        )
