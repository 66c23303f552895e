"""The list of all error messages, tests/messages.md, against the package."""

import runpy

from paths import ROOT

LIST = runpy.run_path(str(ROOT / "tools" / "print_messages.py"))


def test_messages_are_sentences_without_an_end():
    """A further sentence, the remedy, may follow; a final point is left out, as in Python."""
    messages = [line[2:] for line in LIST["page"]().splitlines() if line[:2] == "- "]
    assert len(messages) > 400
    assert [text for text in messages if text.endswith((".", "!", ";", ","))] == []
    assert [text for text in messages if "  " in text or text != text.strip()] == []
