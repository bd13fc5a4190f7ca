#!/usr/bin/env python3
"""No name of a source's anonymous namespace hides one that a header declares.

With OBRYS_UNITY the compiler reads sources one behind the other: a name that one of them has for itself is then seen by
those behind it. Where a header declares the same name in a namespace around it, these mean another thing than their text
says, and no compiler complains. (In the header's own namespace the two would be ambiguous, or overloads.)

usage: hidden_names.py SRC
"""
import collections
import pathlib
import re
import sys

# With the sources' style every declaration of a namespace begins in the first column.
NAMESPACE = re.compile(r"(?:inline )?namespace ?([\w:]*) ?\{")
TYPE = re.compile(r"(?:struct|class|union|enum(?: class)?) (?:\[\[\w+\]\] )?(\w+)\b(?! ?[(<&*]| \w+[ ({=;])")
ALIAS = re.compile(r"using (\w+) =")
FUNCTION = re.compile(r"(?:\[\[[^\]]*\]\] )?[\w:<>,&*\[\] .]*?[\w>&*\]] ?\b(\w+)\(")
VARIABLE = re.compile(r"(?:inline |static )?(?:constexpr|const|constinit) [\w:<>,&* ]*?[ *&>](\w+)(?: ?=|\{|\[|;)")
NO_NAME = {"if", "for", "while", "switch", "return", "static_assert", "operator", "TEST", "TEST_F", "TEST_P"}
Declared = collections.namedtuple("Declared", "namespace name place")


def named(text):
    """What a declaration declares; nothing of what declares none."""
    for kind in ALIAS, TYPE, VARIABLE, FUNCTION:
        if match := kind.match(text):
            return match.group(1)
    return None


def declarations(text, place):
    """Of a file; an anonymous namespace is '' at the end of the tuple of names."""
    around = []
    lines = text.split("\n")
    for n, line in enumerate(lines):
        if match := NAMESPACE.match(line):
            around.append(match.group(1).split("::"))
        elif line.startswith("}  // namespace") or line == "} // namespace":
            around.pop()
        elif (line[:1].isalpha() or line.startswith("[[")) and not line.endswith(":"):
            name = named(" ".join(lines[n:n + 3]))
            if name and name not in NO_NAME:
                yield Declared(tuple(p for names in around for p in names), name, f"{place}:{n + 1}")


def hides(own, other):
    inside = own.namespace[:-1]
    return len(other.namespace) < len(inside) and inside[:len(other.namespace)] == other.namespace


def complaints(src):
    shared, owned = collections.defaultdict(list), []
    for path in sorted([*src.rglob("*.hpp"), *src.rglob("*.cpp")]):
        for d in declarations(path.read_text(encoding="utf-8"), path.relative_to(src)):
            if path.suffix == ".hpp" and "" not in d.namespace:
                shared[d.name].append(d)
            elif path.suffix == ".cpp" and d.namespace[-1:] == ("",):
                owned.append(d)
    for own in owned:
        for other in shared[own.name]:
            if hides(own, other):
                yield f"{own.place}: {own.name} hides that of {other.place} in the sources behind it: another name"
                break


def main():
    src = pathlib.Path(sys.argv[1])
    found = list(complaints(src))
    print("\n".join([*found, f"{len(found)} complaints"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
