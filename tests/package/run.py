#!/usr/bin/env python3
"""Installs the build into an empty prefix and uses it as a stranger would: CMake, pkg-config, and the .deb.

usage: run.py <build folder> <folder of this test> <C++ compiler>
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile


def run(*command, **options):
    print("$", *command, flush=True)
    return subprocess.run([str(c) for c in command], check=True, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **options).stdout


def expect(condition, what):
    if not condition:
        print(f"failed: {what}")
        sys.exit(1)
    print(f"ok: {what}")


def version_runs(program, what):
    done = subprocess.run([str(program), "version"], capture_output=True, text=True, check=False)
    expect(done.returncode == 0 and "obrys" in done.stdout, f"{what}: obrys version says: {done.stdout.strip()!r}")


def consume(prefix, test, compiler, scratch):
    """Builds the ten-line program by find_package and by pkg-config; both must say the same."""
    build = scratch / "consumer"
    run("cmake", "-S", test / "consumer", "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}")
    run("cmake", "--build", build)
    expect(run(build / "consumer").strip() == "2.500", "a program built by find_package(obrys) runs")

    folders = [p.parent for p in prefix.rglob("obrys.pc")]
    expect(len(folders) == 1, "obrys.pc is installed once")
    flags = run("pkg-config", "--cflags", "--libs", "obrys", env={"PKG_CONFIG_PATH": str(folders[0]), "PATH": "/usr/bin:/bin"})
    run(compiler, test / "consumer" / "main.cpp", "-o", scratch / "by_pkg_config", *flags.split())
    expect(run(scratch / "by_pkg_config").strip() == "2.500", "a program built by pkg-config runs")


def use_doors(prefix, test, compiler, scratch):
    """The example of the library, as its README says to build it, on the installed groove."""
    build, shared = scratch / "library", prefix / "share/obrys/examples"
    run("cmake", "-S", shared / "library", "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}")
    run("cmake", "--build", build)
    said = run(build / "groove_variants", shared / "groove")
    print(said)
    expect("R11=2 mm: clean, 841 moves, 0 findings" in said, "the example of the library checks the groove")
    turned = run(build / "five_axis", shared / "library/SWIVEL.H")
    print(turned)
    expect("zero 1001 tip 11.160 0.000 -0.670 tool 0.500 0.000 0.866" in turned, "another one follows five axes")
    expect("B ? -> 30.000 deg" in turned and "C 0.000 -> -45.000 deg, counted" in turned, "with the rotary axes at both ends")
    expect("R11=1 mm: clean" in said and "R11=4 mm: " in said, "and runs it with other values")


def package(build, scratch):
    run("cpack", "-G", "DEB", "-B", scratch / "package", cwd=build)
    debs = list((scratch / "package").glob("*.deb"))
    module = [d for d in debs if d.name.startswith("obrys-step_")]
    debs = [d for d in debs if d not in module]
    expect(len(debs) == 1 and debs[0].name.startswith("obrys_"), "cpack makes one .deb of obrys itself")
    fields = run("dpkg-deb", "--field", debs[0])
    needs = next(line for line in fields.splitlines() if line.startswith("Depends:"))
    expect("libc6" in needs, "it names the shared libraries it needs")
    expect("libcairo" in needs and "libzip" in needs, "and those it loads while it runs")
    expect("libocct" not in fields, "it does not ask for Open CASCADE")
    content = run("dpkg-deb", "--contents", debs[0])
    for path in ("./usr/bin/obrys", "obrys.1", "libobrys.a", "include/obrys/base/diagnostic.hpp", "include/obrys/check.hpp", "obrysConfig.cmake",
                 "share/obrys/examples/groove/groove.job.toml"):
        expect(path in content, f"it holds {path}")
    expect("_test" not in content, "it holds no tests")
    expect("libobrys-step" not in content, "it does not hold the module that reads STEP files")
    run("dpkg-deb", "--extract", debs[0], scratch / "extracted")
    version_runs(scratch / "extracted/usr/bin/obrys", "from the .deb")
    if module:
        expect("Recommends: obrys-step" in fields, "it recommends the module's package")
        step_module(module, scratch)


STEP = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('part','2026-11-21T12:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=CARTESIAN_POINT('',(0.,0.,0.));
ENDSEC;
END-ISO-10303-21;
"""
JOB = """program = "P.H"
machine = "mill-generic"
[stock]
file = "part.step"
"""


def reads_step(program, scratch, expected, what):
    """A STEP file without a solid: whether it is the module that says so, or the want of one."""
    folder = scratch / "job"
    folder.mkdir(exist_ok=True)
    for name, text in (("part.step", STEP), ("job.toml", JOB), ("P.H", "0 BEGIN PGM P MM\n1 L X+1 R0 FMAX M30\n2 END PGM P MM\n")):
        (folder / name).write_text(text, encoding="utf-8")
    said = subprocess.run([str(program), "check", str(folder / "job.toml")], capture_output=True, text=True, check=False)
    expect(expected in said.stdout + said.stderr, f"{what}: {expected}")


def step_module(debs, scratch):
    expect(len(debs) == 1, "cpack makes one .deb of the module")
    fields = run("dpkg-deb", "--field", debs[0])
    expect("libocct-data-exchange" in fields and "obrys (=" in fields, "it asks for Open CASCADE and the same obrys")
    content = [line.split()[-1] for line in run("dpkg-deb", "--contents", debs[0]).splitlines() if not line.endswith("/")]
    expect(content == ["./usr/lib/obrys/libobrys-step.so"], "it holds the module alone")
    program = scratch / "extracted/usr/bin/obrys"
    reads_step(program, scratch, "need a module that is not installed", "without obrys-step")
    run("dpkg-deb", "--extract", debs[0], scratch / "extracted")
    reads_step(program, scratch, "holds no shape", "with obrys-step")


def main():
    build, test, compiler = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    if not shutil.which("dpkg-deb"):
        sys.exit("dpkg-deb is missing")
    with tempfile.TemporaryDirectory(prefix="obrys-package") as name:
        scratch = pathlib.Path(name)
        prefix = scratch / "prefix"
        run("cmake", "--install", build, "--prefix", prefix)
        version_runs(prefix / "bin/obrys", "installed")
        if (prefix / "lib/obrys/libobrys-step.so").exists():
            reads_step(prefix / "bin/obrys", scratch, "holds no shape", "installed")
        consume(prefix, test, compiler, scratch)
        use_doors(prefix, test, compiler, scratch)
        package(build, scratch)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        print(error.stdout)
        sys.exit(f"failed: {error}")
