#!/usr/bin/env python3
"""Output destroys nothing and is never half there; verdicts within a scope, baselines, several inputs.

usage: output_test.py <obrys> <examples>
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

OBRYS = EXAMPLES = None

PROGRAM = """N10 G54 G90 G94 G71
N20 T1 D1 S1000 M3
N30 G0 X50 Z5
N40 SUB
N50 M30
"""
SUB = "G1 Z-5 F100\nM17\n"
ENDLESS = "N10 G0 X0\nN15 R1=0\nN20 WHILE R1>=0\nN25 R1=R1+1\nN30 G1 X1 F100\nN40 G1 X0\nN50 ENDWHILE\nN60 M30\n"


class Folder(unittest.TestCase):
    def setUp(self):
        self.temp = tempfile.TemporaryDirectory(prefix="obrys-output")
        self.path = pathlib.Path(self.temp.name)
        self.write("MAIN.MPF", PROGRAM)
        self.write("SUB.SPF", SUB)

    def tearDown(self):
        self.temp.cleanup()

    def write(self, name, text):
        (self.path / name).write_text(text, encoding="utf-8")

    def obrys(self, *words, **options):
        done = subprocess.run([OBRYS, *words], cwd=self.path, capture_output=True, text=True, check=False, timeout=120, **options)
        return done.returncode, done.stdout, done.stderr

    def names(self):
        return sorted(p.name for p in self.path.iterdir())


class Outputs(Folder):
    def assert_refused(self, name, *words):
        before = (self.path / "MAIN.MPF").read_bytes(), (self.path / "SUB.SPF").read_bytes(), self.names()
        code, _, err = self.obrys(*words)
        self.assertEqual(code, 2, (words, err))
        self.assertIn(name, err)
        self.assertEqual(before, ((self.path / "MAIN.MPF").read_bytes(), (self.path / "SUB.SPF").read_bytes(), self.names()))

    def test_no_input_is_overwritten_by_any_name(self):
        os.symlink("MAIN.MPF", self.path / "link")
        os.link(self.path / "MAIN.MPF", self.path / "hard")
        for name in ("MAIN.MPF", "./MAIN.MPF", "link", "hard", str(self.path / "MAIN.MPF"), "../" + self.path.name + "/MAIN.MPF"):
            for option in ("-o", "--html", "--svg", "--stl", "--3mf", "--gltf", "--write-baseline"):
                self.assert_refused("input", "check", "MAIN.MPF", "--force", option, name)
            self.assert_refused("input", "run", "MAIN.MPF", "--force", "-o", name)
            self.assert_refused("input", "plot", "MAIN.MPF", "--force", "-o", name)

    def test_a_called_program_is_an_input(self):
        for command in ("check", "run"):
            self.assert_refused("input", command, "MAIN.MPF", "--force", "-o", "SUB.SPF")

    def test_an_input_of_several_is_not_overwritten(self):
        self.write("OTHER.MPF", PROGRAM)
        self.assert_refused("input", "check", "MAIN.MPF", "OTHER.MPF", "--force", "-o", "OTHER.MPF")

    def test_an_input_that_cannot_be_read_is_not_overwritten(self):
        self.write("bad.toml", "program = \n")
        self.write("bad2.toml", "program = \n")
        self.write("nomachine.toml", 'program = "MAIN.MPF"\nmachine = "no-such"\n')
        self.write("mine.json", "mine")
        for words, out in ((("bad.toml", "bad2.toml"), "bad2.toml"), (("MAIN.MPF", "bad.toml"), "bad.toml"),
                           (("nomachine.toml", "bad.toml"), "MAIN.MPF"), (("nomachine.toml", "bad.toml"), "SUB.SPF")):
            for force in (("--force",), ()):
                for option in ("-o", "--write-baseline"):
                    if out == "SUB.SPF" and force:
                        continue  # nobody has read who calls it
                    before = (self.path / out).read_bytes()
                    code, _, err = self.obrys("check", *words, "--format", "json", option, out, *force)
                    self.assertEqual((code, (self.path / out).read_bytes()), (2, before), (words, option, force, err))
        code, _, err = self.obrys("check", "bad.toml", "bad2.toml", "--format", "json", "-o", "mine.json")
        self.assertEqual((code, (self.path / "mine.json").read_text()), (2, "mine"), err)
        code, _, err = self.obrys("check", "bad.toml", "bad2.toml", "--format", "json", "-o", "mine.json", "--force")
        self.assertEqual(code, 2, err)
        self.assertIn("bad2.toml", (self.path / "mine.json").read_text())

    def test_a_file_that_is_there_needs_force(self):
        self.write("report.html", "mine")
        self.assert_refused("--force", "check", "MAIN.MPF", "--html", "report.html")
        self.assertEqual((self.path / "report.html").read_text(), "mine")
        code, _, _ = self.obrys("check", "MAIN.MPF", "--html", "report.html", "--force")
        self.assertEqual(code, 3)
        self.assertIn("<html", (self.path / "report.html").read_text(encoding="utf-8"))

    def test_two_outputs_to_one_file(self):
        self.assert_refused("same file", "check", "MAIN.MPF", "--html", "a", "--svg", "./a")
        self.assert_refused("standard output", "check", "MAIN.MPF", "--svg", "-")

    def test_links_stay_links(self):
        self.write("target", "old")
        (self.path / "target").chmod(0o640)
        os.symlink("target", self.path / "link")
        os.symlink("not there yet", self.path / "dangling")
        for name in ("link", "dangling"):
            self.assertEqual(self.obrys("run", "MAIN.MPF", "--force", "-o", name)[0], 0)
            self.assertTrue((self.path / name).is_symlink())
            self.assertIn("linear", (self.path / name).read_text())
        self.assertEqual((self.path / "target").stat().st_mode & 0o777, 0o640)

    def test_hard_links_stay_links(self):
        text = "BEGIN PGM A MM\nL  X+1\nEND PGM A MM\n"
        self.write("A.H", text)
        os.link(self.path / "A.H", self.path / "other name")
        os.chmod(self.path / "A.H", 0o640)
        self.assertEqual(self.obrys("fmt", "-i", "A.H")[0], 0)
        formatted = (self.path / "A.H").read_text()
        self.assertNotEqual(formatted, text)
        self.assertEqual((self.path / "other name").read_text(), formatted)
        self.assertEqual((self.path / "A.H").stat().st_nlink, 2)
        self.assertEqual((self.path / "A.H").stat().st_mode & 0o777, 0o640)
        self.assertEqual(sorted(n for n in self.names() if n.endswith(".part")), [])

    @unittest.skipUnless(os.path.exists("/proc/self/mem"), "needs /proc")
    def test_a_window_into_the_system_is_no_empty_file(self):
        for name in ("/proc/self/mem", "/proc/self/status"):
            code, _, err = self.obrys("check", name)
            self.assertEqual(code, 2)
            self.assertIn("cannot be read", err)

    def test_devices_are_written_through(self):
        before = os.stat("/dev/null")
        self.assertEqual(self.obrys("run", "MAIN.MPF", "-o", "/dev/null")[0], 0)
        self.assertEqual(self.obrys("check", "MAIN.MPF", "--html", "/dev/null", "--svg", "/dev/null", "-o", "/dev/null")[0], 3)
        self.assertEqual(before.st_rdev, os.stat("/dev/null").st_rdev)
        self.assertEqual(self.names(), ["MAIN.MPF", "SUB.SPF"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_standard_output_is_checked_to_the_end(self):
        for words in (["check", "MAIN.MPF"], ["run", "MAIN.MPF"], ["run", "MAIN.MPF", "--quiet"], ["version"], ["--help"],
                      ["check", "MAIN.MPF", "-o", "/dev/full"], ["check", "MAIN.MPF", "--svg", "/dev/full"]):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([OBRYS, *words], cwd=self.path, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn("No space left on device", done.stderr, words)

    def test_the_cause_is_named(self):
        for target, why in (("nowhere/a.svg", "No such file or directory"), ("MAIN.MPF/a.svg", "Not a directory")):
            code, _, err = self.obrys("check", "MAIN.MPF", "--svg", target)
            self.assertEqual(code, 2)
            self.assertIn(why, err)
        os.symlink("loop", self.path / "loop")
        code, _, err = self.obrys("check", "loop")
        self.assertEqual(code, 2)
        self.assertIn("symbolic links", err)

    def test_a_signal_leaves_nothing_half_written(self):
        self.write("LOOP.MPF", ENDLESS)
        before = self.names()
        for number in (signal.SIGINT, signal.SIGTERM):
            run = subprocess.Popen([OBRYS, "run", "LOOP.MPF", "-o", "moves.txt"], cwd=self.path, stderr=subprocess.DEVNULL)
            until = time.monotonic() + 30
            while len(self.names()) == len(before) and time.monotonic() < until:
                time.sleep(0.02)
            self.assertGreater(len(self.names()), len(before))
            run.send_signal(number)
            self.assertEqual(run.wait(timeout=30), -number)
            self.assertEqual(self.names(), before)

    def test_prints_do_not_replace_what_is_there(self):
        self.write("P.H", '0 BEGIN PGM P MM\n1 FN 16: F-PRINT M.A / P.H\n2 END PGM P MM\n')
        self.write("M.A", '"hello";\nM_TRUNCATE;\n')
        text = (self.path / "P.H").read_text()
        self.obrys("check", "P.H", "--prints", ".", "--force")
        self.assertEqual((self.path / "P.H").read_text(), text)

    def test_prints_do_not_replace_another_input(self):
        self.write("P.H", '0 BEGIN PGM P MM\n1 FN 16: F-PRINT M.A / Q.H\n2 END PGM P MM\n')
        self.write("Q.H", '0 BEGIN PGM Q MM\n1 END PGM Q MM\n')
        self.write("M.A", '"hello";\nM_TRUNCATE;\n')
        text = (self.path / "Q.H").read_text()
        code, _, _ = self.obrys("check", "P.H", "Q.H", "--prints", ".", "--force")
        self.assertEqual((code, (self.path / "Q.H").read_text()), (2, text))

    def test_prints_and_outputs_do_not_share_a_file(self):
        self.write("P.H", '0 BEGIN PGM P MM\n1 FN 16: F-PRINT M.A / X.TXT\n2 END PGM P MM\n')
        self.write("M.A", '"hello";\n')
        os.symlink("X.TXT", self.path / "link")
        for name in ("X.TXT", "link"):
            for words in (("run", "P.H", "-o", name), ("check", "P.H", "--html", name), ("plot", "P.H", "-o", name)):
                code, out, err = self.obrys(*words, "--prints", ".", "--force")
                self.assertEqual(code, 2, (words, err))
                self.assertIn("X.TXT is an output of this call", out + err)
        code, _, err = self.obrys("run", "P.H", "-o", "y.txt", "--prints", ".", "--force")
        self.assertNotEqual(code, 2, err)


class Jobs(Folder):
    def test_a_file_that_is_missing_is_said_at_its_line(self):
        for key, line in (('tool_file = "no.toa"', 3), ('preset_tables = ["no.pr"]', 3), ('[part]\nfile = "no.stl"', 4),
                          ('[stock]\nfile = "no.stl"', 4), ('datum_tables = ["no.d"]', 3)):
            self.write("j.toml", 'program = "MAIN.MPF"\nmachine = "mill-generic"\n' + key + "\n")
            code, _, err = self.obrys("check", "j.toml")
            self.assertEqual(code, 2, (key, err))
            self.assertTrue(err.startswith(f"j.toml:{line}:"), (key, err))


    def test_an_empty_body_is_said_at_its_line(self):
        self.write("e.stl", "")
        for key in ('[part]\nfile = "e.stl"', '[stock]\nfile = "e.stl"'):
            self.write("j.toml", 'program = "MAIN.MPF"\nmachine = "mill-generic"\n' + key + '\n[check]\nscope = "motion"\n')
            code, _, err = self.obrys("check", "j.toml")
            self.assertEqual(code, 2, (key, err))
            self.assertTrue(err.startswith("j.toml:4:"), (key, err))
            self.assertIn("[file-empty]", err)

    def test_a_job_file_with_zero_bytes_is_no_text(self):
        self.write("j.toml", 'program = "MAIN.MPF"\n\0\0')
        code, _, err = self.obrys("check", "j.toml")
        self.assertEqual(code, 2, err)
        self.assertIn("[file-binary]", err)

    def test_a_link_that_leads_nowhere(self):
        os.symlink("gone.nc", self.path / "dangling.nc")
        code, _, err = self.obrys("check", "dangling.nc")
        self.assertEqual(code, 2, err)
        self.assertIn("dangling.nc is a link that leads nowhere: there is no file gone.nc", err)
        self.assertNotIn("did you mean", err)


class Verdicts(Folder):
    """Scope, baseline, fail-on, several inputs: of the shipped groove and its wrong variant."""

    def job(self, name):
        return str(EXAMPLES / "groove" / f"{name}.job.toml")

    def check(self, *words):
        code, out, err = self.obrys("check", *words, "--format", "json")
        self.assertEqual(err, "")
        return code, json.loads(out)

    def test_a_job_without_a_part_can_be_clean_within_a_scope(self):
        self.write("P.H", "0 BEGIN PGM P MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+50 Y+50 Z+0\n3 TOOL CALL 1 Z S2000\n"
                   "4 L Z+50 R0 FMAX M3\n5 L X-20 Y+25 FMAX\n6 L Z-5 FMAX\n7 L X+70 F500\n8 L Z+50 FMAX M30\n9 END PGM P MM\n")
        job = 'program = "P.H"\nmachine = "mill-generic"\n[[tool]]\nnumber = 1\nkind = "end-mill"\ndiameter = 10\ncutting_length = 30\nlength = 80\n%s'
        self.write("j.toml", job % "")
        code, all_of_it = self.check("j.toml")
        self.assertEqual((code, all_of_it["scope"]), (3, "all"))
        self.assertIn("no part", json.dumps(all_of_it["unchecked"]))
        self.write("j.toml", job % '[check]\nscope = "collisions"\n')
        code, within = self.check("j.toml")
        self.assertEqual((code, within["verdict"], within["scope"]), (0, "clean", "collisions"), within["unchecked"])
        code, out, _ = self.obrys("check", "j.toml")
        self.assertIn('clean within the scope "collisions" (the part\'s shape not judged)', out)
        code, motion = self.check("j.toml", "--scope", "motion")
        self.assertEqual((code, motion["verdict"]), (0, "clean"), motion["unchecked"])

    def test_the_scope_part_says_what_it_left_out(self):
        code, part = self.check(self.job("groove_wrong"), "--scope", "part")
        self.assertEqual(code, 1)
        self.assertNotIn("rapid-in-stock", {f["code"] for f in part["findings"]})
        self.assertIn("rapid-in-stock", json.dumps(part["assumptions"]))

    def test_fail_on(self):
        wrong = self.job("groove_wrong")
        self.assertEqual(self.check(wrong, "--fail-on", "rest-material")[0], 0)
        self.assertEqual(self.check(wrong, "--fail-on", "gouge")[0], 1)
        self.assertEqual(self.check(wrong, "--fail-on", "warning")[0], 1)
        code, result = self.check(self.holder_job("a", "G21 G90 G17 G94\nT1 M6\nG43 H1\nS3000 M3\nG0 X-10 Y-10\nG0 Z20\nG0 Z-40\nG1 F300 Y50\nM2\n"),
                                  "--fail-on", "warning")  # errors are worse than that
        self.assertEqual((code, {f["severity"] for f in result["findings"]}), (1, {"error"}))
        self.assertEqual(self.obrys("check", wrong, "--fail-on", "gauge")[0], 2)

    def test_known_findings_do_not_fail_until_they_get_worse(self):
        wrong = self.job("groove_wrong")
        self.assertEqual(self.check(wrong, "--write-baseline", "known.json")[0], 1)
        code, again = self.check(wrong, "--baseline", "known.json")
        self.assertEqual((code, again["verdict"], {f["known"] for f in again["findings"]}), (0, "findings", {True}))
        self.assertIn("all known", self.obrys("check", wrong, "--baseline", "known.json")[1])
        known = json.loads((self.path / "known.json").read_text())
        worst = max(known["findings"], key=lambda f: f["amount"])
        worst["amount"] /= 2
        (self.path / "known.json").write_text(json.dumps(known))
        self.assertEqual(self.check(wrong, "--baseline", "known.json")[0], 1)
        self.assertEqual(self.obrys("check", wrong, "--baseline", "MAIN.MPF")[0], 2)
        for version in ("1e300", "-1e300", '"1"', "null", "[]"):
            (self.path / "known.json").write_text(f'{{"format": "obrys-baseline", "version": {version}, "findings": []}}')
            self.assertEqual(self.obrys("check", wrong, "--baseline", "known.json")[0], 2, version)
        (self.path / "known.json").write_text('{"format": 1}')
        self.assertEqual(self.obrys("check", wrong, "--baseline", "known.json")[0], 2)

    def test_a_baseline_outlives_moved_lines(self):
        self.write("A.MPF", "N10 G90\nN20 SETAL(65000)\nN30 M30\n")
        self.obrys("check", "A.MPF", "--write-baseline", "known.json")
        self.write("A.MPF", "; a comment\n\nN15 G90\nN25 SETAL(65000)\nN35 M30\n")
        code, out, _ = self.obrys("check", "A.MPF", "--baseline", "known.json")
        self.assertIn("known: the baseline has it", out, code)

    def holder_job(self, folder, program):
        (self.path / folder).mkdir(exist_ok=True)
        self.write(f"{folder}/P.ngc", program)
        self.write(f"{folder}/j.toml", 'program = "P.ngc"\ncontrol = "linuxcnc"\nmachine = "mill-generic"\n[[tool]]\nnumber = 1\n'
                   'kind = "end-mill"\ndiameter = 10.0\nlength = 100.0\ncutting_length = 20.0\nshank = [{diameter = 10.0, length = 10.0}]\n'
                   'holder = [{diameter = 40.0, length = 70.0}]\n[stock]\nbox = { min = [0.0, 0.0, -60.0], max = [60.0, 40.0, 0.0] }\n'
                   '[check]\nscope = "collisions"\ntolerance = 0.1\n')
        return f"{folder}/j.toml"

    def test_a_known_collision_hides_no_other(self):
        one = "G21 G90 G17 G94\nT1 M6\nG43 H1\nS3000 M3\nG0 X-10 Y-10\nG0 Z20\nG0 Z-40\nG1 F300 Y50\nG0 Z20\n"
        job = self.holder_job("a", one + "M2\n")
        self.assertEqual(self.check(job, "--write-baseline", "known.json")[0], 1)
        self.assertEqual(self.check(job, "--baseline", "known.json")[0], 0)
        moved = self.holder_job("a", one.replace("T1", "\n(moved)\nT1") + "M2\n")
        self.assertEqual(self.check(moved, "--baseline", "known.json")[0], 0)
        # The same holder, not as deep, in other lines, even where one reads as a known one does.
        other = self.holder_job("a", one + "G0 X72 Y-10\nG0 Z-40\nG1 F300 Y50\nG0 Z20\nM2\n")
        self.assertEqual(self.check(other, "--baseline", "known.json")[0], 1)
        # Another program of this name.
        self.assertEqual(self.check(self.holder_job("b", one + "M2\n"), "--baseline", "known.json")[0], 1)

    def test_a_baseline_of_an_earlier_version_is_refused(self):
        self.write("old.json", '{"format": "obrys-baseline", "version": 1, "findings": []}')
        code, _, err = self.obrys("check", self.job("groove"), "--baseline", "old.json")
        self.assertEqual(code, 2)
        self.assertIn("write it anew", err)

    def test_several_inputs(self):
        code, results = self.check(self.job("groove"), self.job("groove_wrong"))
        self.assertEqual((code, [r["verdict"] for r in results]), (1, ["clean", "findings"]))
        code, out, _ = self.obrys("check", self.job("groove"), "not there.MPF", "--format", "json")
        self.assertEqual((code, [r["verdict"] for r in json.loads(out)]), (2, ["clean", None]))
        code, out, _ = self.obrys("check", self.job("groove"), self.job("groove_wrong"), "--format", "sarif")
        self.assertEqual(len(json.loads(out)["runs"]), 2)
        self.assertEqual(self.obrys("check", self.job("groove"), self.job("groove_wrong"), "--html", "a.html")[0], 2)


if __name__ == "__main__":
    OBRYS, EXAMPLES = str(pathlib.Path(sys.argv.pop(1)).resolve()), pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
