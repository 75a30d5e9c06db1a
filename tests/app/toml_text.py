"""Tables read from JSON as text in TOML."""

import json


def toml_value(value):
    """`value`, read from JSON, as TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml_value(v)}" for key, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    return json.dumps(value)


def toml_of(tables):
    """The file that says what `tables`, read from JSON, say."""
    return "".join(f"{key} = {toml_value(value)}\n" for key, value in tables.items())
