"""`clpt laws`: the table of laws."""

import typer

from .printing import Json, print_json, print_table


def laws(as_json: Json = False) -> None:
    """List the adaptive laws: promises, needs and settings.

    Example:
        clpt laws
    """
    from ..blocks.laws.table import LAWS

    if as_json:
        listed = {}
        for law in LAWS.values():
            settings = {
                key: {"default": one.default, "allowed": one.allowed, "meaning": one.meaning}
                for key, one in law.settings.items()
            }
            listed[law.name] = {
                "promise": law.promise,
                "needs": law.needs,
                "default_gain": law.gain,
                "table": f"learning.{law.table}" if settings else None,
                "settings": settings,
            }
        print_json({"laws": listed})
        return
    rows = [[law.name, law.promise, law.needs] for law in LAWS.values()]
    print_table("Laws (learning.law)", ["law", "promise", "needs"], rows)
    keys = [
        [
            f"learning.{law.table}.{key}",
            one.allowed,
            "of the scenario" if one.default is None else f"{one.default:g}",
            one.meaning,
        ]
        for law in LAWS.values()
        for key, one in law.settings.items()
    ]
    if keys:
        typer.echo("")
        print_table("Settings", ["key", "allowed", "default", "what it is"], keys)
