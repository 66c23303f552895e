"""`{thumbnail} PAGE`: the first picture of another page, such as one that its cells have drawn."""

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.docutils import SphinxDirective


class Place(nodes.General, nodes.Element):
    """Where the picture will stand: pages are read before the pictures of others are known."""


class Thumbnail(SphinxDirective):
    """A place for the first picture of the page that is named, beside this one."""

    required_arguments = 1

    def run(self) -> list:
        """Note the page; this one is built again where that one changed."""
        folder = self.env.docname.rpartition("/")[0]
        page = f"{folder}/{self.arguments[0]}".lstrip("/")
        self.env.note_dependency(self.env.doc2path(page))
        return [Place(page=page)]


class Pictures(SphinxPostTransform):
    """Puts the pictures in their places."""

    default_priority = 5

    def run(self, **_) -> None:
        """Copy the first picture of each page named; a page without one fails the build."""
        for place in list(self.document.findall(Place)):
            page = place["page"]
            found = next(self.env.get_doctree(page).findall(is_picture), None)
            if found is None:
                raise ValueError(f"{self.env.docname}: the page {page} has no picture")
            picture = found.deepcopy()
            if isinstance(picture, nodes.image):
                picture["alt"] = (
                    f"the picture of the page {self.env.titles[page].astext()}"
                )
            place.replace_self(picture)


def is_picture(node) -> bool:
    """Whether a node is an image, or HTML with one drawn in it."""
    drawn = isinstance(node, nodes.raw) and "<svg" in node.astext()
    return drawn or isinstance(node, nodes.image)


def setup(app):
    """Add the directive."""
    app.add_directive("thumbnail", Thumbnail)
    app.add_post_transform(Pictures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
