"""No two files define a type of one name in one namespace.

Where both are linked into one program, the linker takes the functions of either for both, and says nothing.
Run as: one_definition_test.py SOURCE, the folder of the project.
"""

import collections
import pathlib
import re
import sys
import unittest

SOURCE = pathlib.Path()
ROOMS = ("analysis", "synthesis", "problems", "app")

# What has no braces of its own for the scan: comments, literals, parameters of templates.
NO_CODE = re.compile(r"//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'")
TEMPLATE = re.compile(r"template\s*<[^<>]*(?:<[^<>]*>[^<>]*)*>")
SCOPE = re.compile(r"\bnamespace\s*(?P<room>[\w:]*)\s*{"
                   r"|\b(?:struct|class|enum class|union)\s+(?P<type>[\w:<>, ]+?)\s*(?:final\s*)?(?:(?<!:):(?!:)[^;{}()]*)?{|[{}]")


def types_of(text):
    """The types defined in namespaces, with these; what unnamed namespaces hold is each file's own."""
    text = TEMPLATE.sub("", NO_CODE.sub("", text))
    scopes = []
    for found in SCOPE.finditer(text):
        if found[0] == "}":
            if scopes:
                scopes.pop()
        elif found["room"] is not None:
            scopes.append(found["room"] or "unnamed")
        else:
            if found["type"] and None not in scopes and "unnamed" not in scopes:
                yield "::".join([*scopes, found["type"]])
            scopes.append(None)


class OneDefinition(unittest.TestCase):
    def test_scan(self):
        text = """namespace a::b { namespace { struct Own {}; } template <class T, int n = 2> struct Two { struct In {}; };
                  class One final : public Two<int> {}; struct Two<double>::In {}; enum class Three : int { x };
                  void f() { struct Local {}; } struct Only; }"""
        self.assertEqual(list(types_of(text)), ["a::b::Two", "a::b::One", "a::b::Two<double>::In", "a::b::Three"])

    def test_every_type_has_one_file(self):
        files = collections.defaultdict(set)
        for room in ROOMS:
            for file in (SOURCE / room).rglob("*.?pp"):
                for name in types_of(file.read_text()):
                    files[name].add(str(file.relative_to(SOURCE)))
        self.assertGreater(len(files), 500)
        self.assertEqual({name: held for name, held in files.items() if len(held) > 1}, {})


if __name__ == "__main__":
    SOURCE = pathlib.Path(sys.argv[1])
    unittest.main(argv=sys.argv[:1])
