"""Holds a JSON document to a JSON schema: the keywords that the schemas of these tests use, and no other ones."""
import re

TYPES = {
    "object": lambda v: isinstance(v, dict),
    "array": lambda v: isinstance(v, list),
    "string": lambda v: isinstance(v, str),
    "boolean": lambda v: isinstance(v, bool),
    "integer": lambda v: isinstance(v, int) and not isinstance(v, bool),
    "number": lambda v: isinstance(v, (int, float)) and not isinstance(v, bool),
}
KNOWN = {"$comment", "$ref", "definitions", "type", "enum", "pattern", "minLength", "minimum", "required", "properties",
         "additionalProperties", "items", "minItems", "uniqueItems"}


def _of_object(schema, value, where, root):
    properties, others = schema.get("properties", {}), schema.get("additionalProperties", True)
    for name in schema.get("required", []):
        if name not in value:
            yield f"{where}: no {name}"
    for name, part in value.items():
        rule = properties.get(name, others)
        if rule is False:
            yield f"{where}: {name} is no property here"
        elif rule is not True:
            yield from faults(rule, part, f"{where}/{name}", root)


def _of_array(schema, value, where, root):
    if len(value) < schema.get("minItems", 0):
        yield f"{where}: too few"
    if schema.get("uniqueItems") and any(a == b for i, a in enumerate(value) for b in value[:i]):
        yield f"{where}: one stands there twice"
    for i, part in enumerate(value):
        yield from faults(schema.get("items", {}), part, f"{where}/{i}", root)


def faults(schema, value, where="", root=None):
    """What of `value` is not as the schema has it, each with its place."""
    root = schema if root is None else root
    if set(schema) - KNOWN - {"$schema"}:
        raise ValueError(f"{where}: keywords {set(schema) - KNOWN} are not known to this checker")
    if "$ref" in schema:
        yield from faults(root["definitions"][schema["$ref"].rsplit("/", 1)[1]], value, where, root)
        return
    if "type" in schema and not TYPES[schema["type"]](value):
        yield f"{where}: is no {schema['type']}"
        return
    if "enum" in schema and value not in schema["enum"]:
        yield f"{where}: {value!r} is none of {schema['enum']}"
    if "pattern" in schema and not re.search(schema["pattern"], value):
        yield f"{where}: {value!r} is not like {schema['pattern']}"
    if len(value) < schema.get("minLength", 0) if isinstance(value, str) else False:
        yield f"{where}: is empty"
    if "minimum" in schema and value < schema["minimum"]:
        yield f"{where}: {value} is less than {schema['minimum']}"
    if isinstance(value, dict):
        yield from _of_object(schema, value, where, root)
    if isinstance(value, list):
        yield from _of_array(schema, value, where, root)
