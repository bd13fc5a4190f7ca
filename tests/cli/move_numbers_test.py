#!/usr/bin/env python3
"""One move number everywhere: what check, its documents, run and plot call move N is the same move.

`i` of obrys run --format csv is the yardstick: each of its rows is a move with its source line and end point. All other
outputs are read back, and each number they print must be a row with the line, the kind and the end point they say.

usage: move_numbers_test.py <obrys> <examples>
"""
import base64
import csv
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

OBRYS = EXAMPLES = None

# Every kind of move, places that are not known, a subprogram, cycles, notes between the moves; rapids into the stock on purpose.
MILLED = """program = "MAIN.MPF"
control = "sinumerik-840d"
machine = "mill-generic"
[[tool]]
number = 1
kind = "end-mill"
diameter = 10.0
length = 80.0
[[tool]]
number = 2
kind = "drill"
diameter = 6.0
length = 80.0
[stock]
box = { min = [0.0, 0.0, -20.0], max = [100.0, 60.0, 0.0] }
"""
MILLED_MAIN = """N10 G17 G90 G94 G54
N20 T1 D1 M6
N30 S3000 M3 F500
N40 G0 X-10 Y30
N50 G0 Z-5
N60 G1 X20
N70 MSG("on")
N80 G2 X40 Y30 I10 J0
N90 G0 X70
N100 SUB P2
N110 G0 Z50
N120 T2 D1 M6
N130 S1000 M3
N140 G0 X80 Y15
N150 MCALL CYCLE81(10,0,2,-8)
N160 X80 Y15
N170 X90 Y15
N180 MCALL
N190 G4 F1
N200 G0 X50 Y50 Z-3
N210 G0 Z50
N220 M30
"""
MILLED_SUB = """N10 G1 G91 Y-4
N20 G0 X-3
N30 G0 Z1
N40 G90
N50 M17
"""
KINDS = {"rapid": "rapid"}  # in engagement tables all others are feed


def number(text):
    return math.nan if text in ("", "?") else float(text)


class Outputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temp = tempfile.TemporaryDirectory(prefix="obrys-moves")
        folder = pathlib.Path(cls.temp.name)
        for name, text in (("job.toml", MILLED), ("MAIN.MPF", MILLED_MAIN), ("SUB.SPF", MILLED_SUB)):
            (folder / name).write_text(text, encoding="utf-8")
        cls.milled = folder / "job.toml"
        cls.turned = EXAMPLES / "groove" / "groove_wrong.job.toml"

    @classmethod
    def tearDownClass(cls):
        cls.temp.cleanup()

    def obrys(self, *words):
        done = subprocess.run([OBRYS, *map(str, words)], cwd=self.temp.name, capture_output=True, text=True, check=False, timeout=300)
        self.assertIn(done.returncode, (0, 1, 3), done.stderr)
        return done.stdout

    def rows(self, job):
        """The moves by their numbers: (file, line, kind, end point)."""
        all_rows = list(csv.DictReader(self.obrys("run", job, "--format", "csv").splitlines()))
        self.assertEqual([int(r["i"]) for r in all_rows], list(range(len(all_rows))))
        return [(pathlib.Path(r["file"]).name, int(r["line"]), r["kind"], [number(r[c]) for c in "xyz"]) for r in all_rows]

    def same(self, rows, move, file, line, to=None, what=""):
        self.assertLess(move, len(rows), what)
        self.assertEqual((pathlib.Path(file).name, line), rows[move][:2], f"{what}: move {move}")
        for have, want in zip(to or (), rows[move][3]):
            if math.isfinite(want) and have is not None:
                self.assertAlmostEqual(have, want, 3, f"{what}: move {move}")

    def findings(self, job):
        """(number, file, line, end point) of all that check --all says in JSON."""
        found = []
        for f in json.loads(self.obrys("check", job, "--all", "--format", "json"))["findings"]:
            self.assertIn(f["first_move"], [m["move"] for m in f["moves"]])
            self.assertIn(f["move"], [m["move"] for m in f["moves"]])
            found += [(m["move"], m["where"]["file"], m["where"]["line"], [m["to_mm"].get(c) for c in "xyz"] if m.get("to_mm") else None) for m in f["moves"] if m["move"] is not None]
        return found

    def test_json_names_the_moves_of_run(self):
        for job, least in ((self.milled, 4), (self.turned, 90)):
            rows, found = self.rows(job), self.findings(job)
            self.assertGreaterEqual(len(found), least)
            for move, file, line, to in found:
                self.same(rows, move, file, line, to, f"{job.name} JSON")

    def test_run_counts_alike_in_csv_and_json(self):
        for job in (self.milled, self.turned):
            moves = json.loads(self.obrys("run", job, "--format", "json"))
            rows = self.rows(job)
            self.assertEqual([m["i"] for m in moves], list(range(len(rows))))
            for m in moves:
                self.same(rows, m["i"], m["file"], m["line"], [m["x_mm"], m["y_mm"], m["z_mm"]], "run JSON")

    def test_the_stream_counts_as_run_does(self):
        for job in (self.milled, self.turned):
            stream = [l for l in self.obrys("run", job).splitlines() if re.match(r"(rapid|linear|arc|spline|thread)\b", l)]
            rows = self.rows(job)
            self.assertEqual(len(stream), len(rows))
            for line, row in zip(stream, rows):
                self.assertEqual(line.split()[0].replace("-rapid", ""), row[2])
                for have, want in zip(map(number, line.split()[1:4]), row[3]):
                    self.assertTrue(math.isnan(have) == math.isnan(want) and (math.isnan(have) or abs(have - want) < 1e-6), (line, row))

    def test_text_sarif_and_json_name_the_same(self):
        for job in (self.milled, self.turned):
            said = sorted((m, pathlib.Path(f).name, l) for m, f, l, _ in self.findings(job))
            text, inside = [], None
            for line in self.obrys("check", job, "--all").splitlines():
                if m := re.match(r"(\S+?):(\d+):\d+: (?:error|warning):", line):
                    inside = [pathlib.Path(m[1]).name, int(m[2]), None]
                elif m := re.match(r"  (\S+?):(\d+):\d+: move (\d+):", line):
                    text.append((int(m[3]), pathlib.Path(m[1]).name, int(m[2])))
                    inside[2] = None
                elif (m := re.match(r"  move (\d+)(?::|$)", line)) and inside:
                    inside[2] = int(m[1])
                elif not line and inside:
                    if inside[2] is not None:
                        text.append((inside[2], *inside[:2]))
                    inside = None
            self.assertEqual(sorted(text), said, job.name)
            sarif = []
            for r in json.loads(self.obrys("check", job, "--all", "--format", "sarif"))["runs"][0]["results"]:
                if (move := r.get("properties", {}).get("move")) is not None:
                    place = r["locations"][0]["physicalLocation"]
                    sarif.append((move, pathlib.Path(place["artifactLocation"]["uri"]).name, place["region"]["startLine"]))
            self.assertEqual(sorted(sarif), said, job.name)

    def test_first_moves_are_those_of_the_groups(self):
        for job in (self.milled, self.turned):
            groups = json.loads(self.obrys("check", job, "--format", "json"))["findings"]
            text = self.obrys("check", job)
            results = json.loads(self.obrys("check", job, "--format", "sarif"))["runs"][0]["results"]
            first = [g["first_move"] for g in groups if g["first_move"] is not None]
            self.assertEqual([r["properties"]["first_move"] for r in results if "first_move" in r.get("properties", {})], first)
            self.assertEqual([int(n) for n in re.findall(r"^  \d+ passes.*, first move (\d+)", text, re.M)],
                             [g["first_move"] for g in groups if g["times"] > 1 and g["first_move"] is not None])

    def test_engagement_and_plot_tables(self):
        rows = self.rows(self.milled)
        self.obrys("check", self.milled, "--engagement", "e.csv", "--force")
        table = list(csv.DictReader((pathlib.Path(self.temp.name) / "e.csv").read_text(encoding="utf-8").splitlines()))
        self.assertGreater(len(table), 15)
        for r in table:
            self.same(rows, int(r["move"]), r["file"], int(r["line"]), None, "engagement")
            self.assertEqual(r["kind"] == "rapid", rows[int(r["move"])][2] == "rapid")
        for job in (self.milled, self.turned):
            rows, told = self.rows(job), 0
            for line in self.obrys("plot", job, "--interpolation", "0.01").splitlines():
                if m := re.match(r" *(\d+) +[\d.?]+ +[\d?]+ +[\d.?]+ +[\d.?]+  (\w+) +(\S+):(\d+)$", line):
                    self.same(rows, int(m[1]), m[3], int(m[4]), None, "plot")
                    self.assertEqual(m[2], rows[int(m[1])][2])
                    told += 1
            self.assertEqual(told, sum(r[2] != "rapid" for r in rows))

    def test_pages(self):
        said = {(m, pathlib.Path(f).name, l) for m, f, l, _ in self.findings(self.turned)}
        self.obrys("check", self.turned, "--html", "t.html", "--force")
        page = (pathlib.Path(self.temp.name) / "t.html").read_text(encoding="utf-8")
        data = json.loads(re.search(r"<script[^>]*>(?:const \w+ ?= ?)?(\{.*?\});?</script>", page, re.S)[1])
        for f in data["findings"]:
            for m in f["moves"]:
                self.assertIn((m, pathlib.Path(f["where"]["n"]).name, f["where"]["l"]), said)
        self.assertEqual({m for f in data["findings"] for m in f["moves"]}, {m for m, _, _ in said})
        rows = self.rows(self.milled)
        self.obrys("check", self.milled, "--html", "m.html", "--force")
        page = (pathlib.Path(self.temp.name) / "m.html").read_text(encoding="utf-8")
        arrays = {name: base64.b64decode(text) for name, text in re.findall(r'id="array-([\w-]+)">([^<]*)<', page)}
        if "number" not in arrays:
            self.skipTest("built without the page's script")
        numbers = struct.unpack(f"<{len(arrays['number']) // 4}I", arrays["number"])
        lines = struct.unpack(f"<{len(numbers)}I", arrays["line"])
        self.assertGreater(len(numbers), 15)
        for n, line in zip(numbers, lines):
            self.assertEqual(line, rows[n][1], f"page: move {n}")


if __name__ == "__main__":
    OBRYS, EXAMPLES = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
