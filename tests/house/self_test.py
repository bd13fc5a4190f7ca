#!/usr/bin/env python3
"""The house's rules can fail: each checker on a small input that breaks its rule."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HOUSE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HOUSE))
sys.path.insert(0, str(HOUSE.parent / "golden"))
import casts  # noqa: E402
import hidden_names  # noqa: E402
import own_words  # noqa: E402
import run as golden  # noqa: E402
import sizes  # noqa: E402


class InFolder(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)

    def tearDown(self):
        self.scratch.cleanup()

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def run_checker(self, script, *arguments):
        done = subprocess.run([sys.executable, str(HOUSE / script), *map(str, arguments)], capture_output=True, text=True,
                              check=False)
        return done.returncode, done.stdout


class Layers(InFolder):
    def check(self, text, layers="base: \ngeom: base\ncl: base geom\n"):
        self.write("src/base/a.hpp", "")
        self.write("src/geom/g.hpp", "")
        self.write("src/cl/c.hpp", text)
        return self.run_checker("layers.py", self.write("layers.txt", layers), self.folder / "src")

    def test_declared_use_passes(self):
        self.assertEqual(self.check('#include <vector>\n#include "geom/g.hpp"\n')[0], 0)

    def test_undeclared_use(self):
        code, out = self.check('\n  # include "geom/g.hpp"\n', "base: \ngeom: base\ncl: base\n")
        self.assertEqual(code, 1)
        self.assertIn("cl/c.hpp:2: cl includes geom/g.hpp", out)

    def test_missing_file_angled_include_and_order(self):
        self.assertIn('"geom/x.hpp" does not exist', self.check('#include "geom/x.hpp"\n')[1])
        self.assertIn("is our own", self.check("#include <geom/g.hpp>\n")[1])
        self.assertIn("base uses geom, which does not stand below", self.check("", "base: geom\ngeom: \ncl: \n")[1])
        self.assertIn("stands in no declared folder", self.check("", "base: \ngeom: base\n")[1])


class OwnWords(InFolder):
    def faults(self, run, message, program="G1 X5.\n"):
        self.write("golden/x/case.txt", f"--- run  obrys run {run} in\n--- file in\n{program}--- err\n{message}\n--- exit 1\n")
        return [f for f in own_words.check_cases(self.folder / "golden") if "messages read" not in f]

    def test_words_of_another_control(self):
        self.assertEqual(self.faults("--control fanuc", "in:1:1: error: the circle needs R [arc-radius]"), [])
        self.assertIn("'CR='", self.faults("--control fanuc", "in:1:1: error: the circle needs CR= [arc-radius]")[0])
        self.assertIn("'R0'", self.faults("--control haas", "in:1:1: error: too late [x]\n  remedy: write R0 before it")[0])
        self.assertIn("'FMAX'", self.faults("--control sinumerik-840d", "warning: FMAX is meant [x]")[0])
        self.assertIn("'G41'", self.faults("--control heidenhain-itnc530", "warning: G41 is meant [x]", "BEGIN PGM\n")[0])
        self.assertEqual(self.faults("--control heidenhain-itnc530", "warning: RL is meant (DIN/ISO: G41) [x]", "BEGIN PGM\n"), [])

    def test_what_the_program_wrote_is_its_own(self):
        self.assertEqual(self.faults("--control fanuc", "in:1:1: error: CR=5 is no word [x]", "G2 X5. CR=5\n"), [])

    def test_messages_of_the_sources(self):
        self.write("src/driver/wording.cpp", 'constexpr std::string_view circle = "by CR= or so";\n    Phrase{"fanuc", circle, "by R or so"},\n')
        self.write("src/interp/arc.cpp", 'say("by CR= " "or so");  // GOTOF\n')
        faults = own_words.check_sources(self.folder / "src")
        self.assertEqual(sorted(f.split(" of ")[1].split(":")[0] for f in faults), ["haas", "heidenhain", "linuxcnc"])
        self.write("src/interp/arc.cpp", 'say("by R or so");\n')
        self.assertEqual(own_words.check_sources(self.folder / "src"), [])


class Casts(InFolder):
    def test_names_that_round_to_an_integer(self):
        self.write("src/a/x.cpp", "int a = int(std::lround(v));\n// lround(v)\nauto b = std::stoi(s), c = round(v);\n")
        self.write("src/a/x_test.cpp", "long a = std::lround(v);\n")
        code, out = self.run_checker("casts.py", self.folder / "src")
        self.assertEqual(code, 1)
        self.assertEqual([line.split(": ")[0] for line in out.splitlines()[:-1]], ["a/x.cpp:1", "a/x.cpp:3"])

    def test_objects_that_cast(self):
        lines = ("build/src/shop/libobrys_shop.a:toa.cpp.o:                 U __ubsan_handle_float_cast_overflow\n"
                 "build/src/shop/libobrys_shop.a:tool.cpp.o:                 U __ubsan_handle_add_overflow\n"
                 "build/src/geom/libobrys_geom.a:unity_0_cxx.cxx.o:           U __ubsan_handle_float_cast_overflow_abort\n"
                 "build/src/base/libobrys_base.a:text.cpp.o:                  U __ubsan_handle_add_overflow_abort\n")
        self.assertEqual(casts.casting(lines), {"build/src/shop/libobrys_shop.a", "build/src/geom/libobrys_geom.a"})

    def test_sections_of_casts(self):
        listing = ("RELOCATION RECORDS FOR [.text._ZN3one]:\nOFFSET TYPE VALUE\n00 R_X86_64_PLT32 memcpy-0x4\n\n"
                   "RELOCATION RECORDS FOR [.text._ZN3two]:\n0a R_X86_64_PLT32 __ubsan_handle_float_cast_overflow_abort-0x4\n")
        self.assertEqual(casts.sections(listing), [".text._ZN3two"])

    def test_places_of_casts(self):
        listing = ("unity_0_cxx.cxx.o:     file format elf64-x86-64\n0000 <f(double)>:\nf(double):\n/a/src/shop/toa.cpp:7\n"
                   "   4:\tcall 9 <x>\n\t\t\t5: R_X86_64_PLT32\t__ubsan_handle_add_overflow-0x4\n"
                   "/a/src/shop/tool.cpp:12 (discriminator 3)\n"
                   "   a:\tcall f <x>\n\t\t\tb: R_X86_64_PLT32\t__ubsan_handle_float_cast_overflow_abort-0x4\n"
                   "page.cpp.o:     file format elf64-x86-64\n\t\t\tb: R_X86_64_PLT32\t__ubsan_handle_float_cast_overflow-0x4\n")
        self.assertEqual(casts.places(listing), {"/a/src/shop/tool.cpp:12", "page.cpp.o"})
        self.write("src/shop/tool.cpp", "")
        self.assertEqual(casts.in_source("/a/src/shop/tool.cpp:12", self.folder / "src"), "shop/tool.cpp:12")
        self.assertEqual(casts.in_source("/usr/include/x.h:12", self.folder / "src"), "/usr/include/x.h:12")


class HiddenNames(InFolder):
    def found(self, header, source):
        self.write("a/a.hpp", header)
        self.write("a/b/b.cpp", source)
        return list(hidden_names.complaints(self.folder))

    def test_a_name_of_a_namespace_around_is_hidden(self):
        for kind in ("double longest(int a);", "constexpr int longest = 3;", "struct longest {\n    int a;\n};",
                     "using longest = int;", "template <class T>\nT longest(T a);", "[[nodiscard]] std::vector<int> longest(int a);"):
            found = self.found(f"namespace obrys::a {{\n{kind}\n}}  // namespace obrys::a\n",
                               "namespace obrys::a::b {\nnamespace {\nconst int longest = 2;\n}  // namespace\n}  // namespace obrys::a::b\n")
            self.assertEqual(len(found), 1, kind)
            self.assertTrue(found[0].startswith("a/b/b.cpp:3: longest hides that of a/a.hpp:"), found)

    def test_names_that_hide_nothing(self):
        header = "namespace obrys::c {\ndouble longest(int a);\n}  // namespace obrys::c\n"
        source = "namespace obrys::a::b {\nnamespace {\nint longest(int) {\n    return 0;\n}\n}  // namespace\n}  // namespace obrys::a::b\n"
        self.assertEqual(self.found(header, source), [])
        self.assertEqual(self.found(header.replace("::c", "::a::b"), source), [])
        self.assertEqual(self.found(header.replace("::c", "::a"), source.replace("namespace {", "namespace detail {")), [])
        self.assertEqual(self.found(header.replace("::c", "::a").replace("longest", "shortest"), source), [])


class Sizes(InFolder):
    def test_functions_are_found(self):
        text = ("namespace a {\nstruct S : B<int> {\n  S(int x) : x_{x}, y_(f({1})) {\n  }\n  bool operator()(int) const noexcept {\n"
                "    if (x) { }\n  }\n  int x_{1};\n};\nconst std::array t{S{1}, S{2}};\n// f() {\nauto v = [](int) { return 1; };\n"
                "template <class T>\n[[nodiscard]] auto long_one(T t = {})\n    -> int {\n  return '{' + \"{\"[0];\n}\n}\n")
        found = [(first, last, name) for first, last, name in sizes.functions(text) if name != "?"]
        self.assertEqual([f[:2] for f in found], [(3, 4), (5, 7), (13, 17)])

    def test_limits(self):
        body = "int f() {\n" + "    g();\n" * 80 + "}\n"
        self.write("src/a/a.cpp", body)
        code, out = self.run_checker("sizes.py", self.folder / "src")
        self.assertEqual(code, 1)
        self.assertIn("a/a.cpp:1 f: 82 lines, over 80", out)
        self.write("src/a/a.cpp", "// sizes: table\n" + body)
        self.assertIn("over 80", self.run_checker("sizes.py", self.folder / "src")[1])
        self.write("src/a/a.cpp", body.replace("{\n", "{  // sizes: table\n", 1))
        self.assertEqual(self.run_checker("sizes.py", self.folder / "src")[0], 0)
        self.write("src/a/b.cpp", "\n" * 351)
        self.assertIn("a/b.cpp: 351 lines, over 350", self.run_checker("sizes.py", self.folder / "src")[1])


class Codes(InFolder):
    HEADER = 'string_view gouge = "gouge";\nstring_view axis_limit = "axis-limit";\nCode{codes::gouge, x},\nCode{codes::axis_limit, x},\n'

    def check(self, page, case, pending=""):
        self.write("src/base/codes.hpp", self.HEADER)
        self.write("docs/diagnostics.md", page)
        self.write("tests/golden/a.txt", case)
        self.write("tests/house/codes_pending.txt", pending)
        return self.run_checker("codes.py", self.folder)

    def test_all_well(self):
        page, case = "## `gouge`\n| `axis-limit` | x |\n", '--- out\nx [gouge]\n--- err\n"code": "axis-limit"\n'
        self.assertEqual(self.check(page, case), (0, "2 codes, 2 documented, 2 produced, 0 pending\n"))
        self.assertIn("gouge: pending, but no longer missing", self.check(page, case, "gouge")[1])

    def test_gaps(self):
        out = self.check("## `gouge`\n## `gone`\n", "--- in\n[gouge]\n--- out\n", "axis-limit")[1]
        self.assertIn("axis-limit: not documented", out)
        self.assertIn("gone: documented, but no such code", out)
        self.assertIn("gouge: no golden case produces it", out)
        self.assertNotIn("axis-limit: no golden", out)


class Paths(InFolder):
    def test_machine_path(self):
        self.write("a.md", "see " + "/" + "work/shared\nfine: src/work/a, and/or, <temp>/work/x\n")
        code, out = self.run_checker("paths.py", self.folder)
        self.assertEqual(code, 1)
        self.assertIn("a.md:1:", out)
        self.assertIn("1 complaints", out)


class Golden(InFolder):
    CASE = "--- run  obrys in\n--- in\nhello\n--- out\nhello\n--- exit 0\n"

    def case(self, text, program="#!/bin/sh\ncat \"$@\"\n"):
        tool = self.write("obrys", program)
        tool.chmod(0o755)
        case = self.write("case.txt", text)
        done = subprocess.run([sys.executable, str(HOUSE.parent / "golden/run.py"), "--obrys", str(tool), str(case)],
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout

    def test_holds_and_fails(self):
        self.assertEqual(self.case(self.CASE)[0], 0)
        self.assertEqual(self.case(self.CASE.replace("out\nhello", "out\nhallo"))[0], 1)
        self.assertEqual(self.case(self.CASE.replace("exit 0", "exit 1"))[0], 1)
        self.assertEqual(self.case(self.CASE, "#!/bin/sh\ncat $1; echo x >&2\n")[0], 1)

    def test_paths_are_hidden(self):
        text = "--- run  obrys\n--- out\nat <case>\n--- exit 3\n"
        self.assertEqual(self.case(text, "#!/bin/sh\necho at $PWD; exit 3\n")[0], 0)

    def test_environment(self):
        text = "--- run  obrys\n--- env OBRYS_MODULES=here\n--- out\nhere\n--- exit 0\n"
        self.assertEqual(self.case(text, '#!/bin/sh\necho "$OBRYS_MODULES"\n')[0], 0)
        self.assertIn("NAME=value", self.case("--- run  obrys\n--- env x\n--- exit 0\n")[1])

    def test_bad_case(self):
        self.assertIn("exactly one", self.case("--- in\nx\n")[1])
        self.assertIn("unknown flag lf", self.case("--- run  obrys in\n--- in lf\nx\n")[1])

    def test_flags(self):
        self.assertEqual(golden.content_bytes("é\nb\n", ["crlf", "cp1252"]), b"\xe9\r\nb\r\n")
        self.assertEqual(golden.content_bytes("a\n", ["bom", "no-newline"]), b"\xef\xbb\xbfa")
        self.assertEqual(golden.content_bytes("0041 ff\n", ["hex"]), b"\x00A\xff")
        self.assertEqual(golden.content_bytes("x{{ab}*3}\n", ["repeat"]), b"xababab\n")


if __name__ == "__main__":
    unittest.main()
