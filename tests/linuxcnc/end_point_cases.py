"""Programs of the corpus that are not held to the installed rs274, by name: the reason."""

# LinuxCNC 2.10, which our canonical calls follow, differs from the installed 2.9.0~pre1.
NEWER = {
    "rs274/LinuxCNC__linuxcnc/tests/interp/g71-endless-loop/g71-endless-loop.ngc": "2.9 never ends here (G71 with a wrong contour)",
    "rs274/LinuxCNC__linuxcnc/tests/interp/g71-endless-loop_2/g71-endless-loop_2.ngc": "2.9 never ends here (G71 with a wrong contour)",
}

# Programs that obrys does not run as rs274 does yet. One that agrees is an error, so that the list stays true.
KNOWN_FAILURES = {
    "rs274/LinuxCNC__linuxcnc/nc_files/smartprobe.ngc": "rs274 without a machine lets the probe touch a hundredth of an inch before the end; obrys says that it is not simulated",
    "rs274/LinuxCNC__linuxcnc/tests/interp/m98m99/11-main-program-oword/test-illegal-no-m30-before-osub.ngc": "the place of the refusal",
}
