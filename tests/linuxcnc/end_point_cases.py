"""Programs of the corpus that are not held to the installed rs274, by name: the reason."""

# LinuxCNC 2.10, which our canonical calls follow, differs from the installed 2.9.0~pre1.
NEWER = {
    "rs274/LinuxCNC__linuxcnc/tests/interp/g71-endless-loop/g71-endless-loop.ngc": "2.9 never ends here (G71 with a wrong contour)",
    "rs274/LinuxCNC__linuxcnc/tests/interp/g71-endless-loop_2/g71-endless-loop_2.ngc": "2.9 never ends here (G71 with a wrong contour)",
}

# Programs that obrys does not run as rs274 does yet. One that agrees is an error, so that the list stays true.
KNOWN_FAILURES = {
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g531remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g533remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g536remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g69remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/puma/puma_cube.ngc": "G10 L2 does not move rotary axes",
    "rs274/LinuxCNC__linuxcnc/nc_files/g882.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/nc_files/gridprobe.ngc": "probing moves are named as not simulated",
    "rs274/LinuxCNC__linuxcnc/nc_files/lathe_g70_71_demo.ngc": "G70 is not compensated",
    "rs274/LinuxCNC__linuxcnc/nc_files/m6remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/nc_files/polar.ngc": "level of a series of cycles",
    "rs274/LinuxCNC__linuxcnc/nc_files/smartprobe.ngc": "does not end in obrys",
    "rs274/LinuxCNC__linuxcnc/tests/interp/m98m99/11-main-program-oword/test-illegal-no-m30-before-osub.ngc": "the place of the refusal",
    "rs274/LinuxCNC__linuxcnc/tests/m70-m73/m73-flood-mist-restore.0/test.ngc": "a line of Python is named as not run",
    "rs274/LinuxCNC__linuxcnc/tests/remap/nested-remaps-oword/rm400.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/tests/remap/nested-remaps-oword/rm401.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/tests/remap/nested-remaps-oword/rm402.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/tests/remap/nested-remaps-oword/testsub.ngc": "a line that is never run is refused",
    "gcode/Unigraphics__NX.Postprocessor/Haas VF2 4 axis/4axis_test_only.cnc": "another fault of the line above is told first",
}
