"""Links of pages to files beside `docs`: on GitHub they are files, on the site pages."""

PAGES = {
    "../CONTRIBUTING.md": "contributing.md",
    "../CHANGELOG.md": "changelog.md",
    "../CODE_OF_CONDUCT.md": "conduct.md",
    "../SECURITY.md": "security.md",
}


def to_pages(app, name, source):
    """Turn them to the pages that show these files."""
    up = "../" * name.count("/")
    for path, page in PAGES.items():
        source[0] = source[0].replace(f"]({up}{path}", f"]({up}{page}")


def setup(app):
    """Read every page so."""
    app.connect("source-read", to_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
