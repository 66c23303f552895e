"""The site: what Sphinx is told; `make docs` builds it from this folder into build/docs.

The finished site fetches nothing: formulas are MathML, fonts and scripts lie beside the pages.
"""

import sys
from pathlib import Path

import clpt_control

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_extensions"))

project = "clpt-control"
author = "The clpt-control developers"
copyright = author
release = version = clpt_control.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "numpydoc",
    "sphinx_copybutton",
    "sphinx_design",
    "alt_texts",
    "commands",
    "law_sections",
    "mathml",
    "notebook_downloads",
    "public_names",
    "repository_links",
    "thumbnails",
]
exclude_patterns = ["_extensions"]

# Pages: Markdown that is read on GitHub too, so links are those of the files.
myst_enable_extensions = ["amsmath", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]  # a page may begin its sections at the second level

# Notebooks: pages with `{code-cell}`; run when they changed, and an error fails the build.
nb_execution_mode = "cache"
nb_execution_cache_path = str(HERE.parent / "build" / "notebooks")
nb_execution_in_temp = True  # an empty folder for each
nb_execution_show_tb = (
    True  # names page and cell; a warning, so the other pages are built
)
nb_execution_timeout = (
    3600  # s of wall time for a cell: only a hang meets it, whatever the load
)
nb_merge_streams = True

# The interface, from docstrings.  Types stand in their words, as numpydoc has them.
autodoc_typehints = "none"
autodoc_member_order = "bysource"
add_module_names = False
default_role = "literal"  # `name` of a docstring
numpydoc_show_class_members = False
toc_object_entries_show_parents = "hide"
python_display_short_literal_types = True


def setup(app):
    """Show tables of commas as they are."""
    from pygments.lexers.special import TextLexer

    app.add_lexer("csv", TextLexer)


html_theme = "pydata_sphinx_theme"
html_title = "clpt-control"
html_math_renderer = "mathml"
html_show_sourcelink = False
html_copy_source = False
html_show_search_summary = False  # it would fetch pages, which a browser refuses a file
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["tables.js"]
html_theme_options = {
    "logo": {"text": "clpt-control"},
    "navbar_end": ["theme-switcher"],
    "header_links_before_dropdown": 7,
    "search_bar_text": "Search",
    "secondary_sidebar_items": ["page-toc"],
    "article_header_start": ["breadcrumbs"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "show_toc_level": 2,
}
html_sidebars = {"index": [], "start": []}
copybutton_exclude = ".linenos, .gp, .go"
copybutton_prompt_text = r"\$ |>>> |\.\.\. "
copybutton_prompt_is_regexp = True
