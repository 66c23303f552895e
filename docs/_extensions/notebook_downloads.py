"""Under each page of cells a link to the notebook that was run, to open in Jupyter."""


def add_link(app, name, source):
    """End a page of cells with its notebook, which MyST-NB keeps."""
    if "\nfile_format: mystnb\n" in source[0]:
        notebook = f"{name.rpartition('/')[2]}.ipynb"
        source[0] += f"\n\nThis page as a notebook: {{nb-download}}`{notebook}`\n"


def setup(app):
    """Read every page so."""
    app.connect("source-read", add_link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
