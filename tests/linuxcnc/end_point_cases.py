"""Programs of the corpus that are not held to the installed rs274, by name: the reason."""

# LinuxCNC 2.10, which our canonical calls follow, differs from the installed 2.9.0~pre1.
NEWER = {
    "rs274/LinuxCNC__linuxcnc/tests/interp/g71-endless-loop/g71-endless-loop.ngc": "2.9 never ends here (G71 with a wrong contour)",
    "rs274/LinuxCNC__linuxcnc/tests/interp/g71-endless-loop_2/g71-endless-loop_2.ngc": "2.9 never ends here (G71 with a wrong contour)",
}

# Programs that obrys does not run as rs274 does yet. One that agrees is an error, so that the list stays true.
KNOWN_FAILURES = {
    "rs274/CauldronDevelopmentLLC__CAMotics/tests/varRefTests/GlobalNamedTest/data/stdin": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/laser/raster_test.ngc": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/rose_engine/rcone_demo.ngc": "GT compares with a tolerance",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-dual-rotary/demos/xyzab-tdr-demo.ngc": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary-tilting/demos/impeller-7bl-xyzac.ngc": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary-tilting/demos/xyzac_switchkins_test_2.ngc": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/demos/incremental_repetition.ngc": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/demos/incremental_repetition_back_and_forth.ngc": "runs on behind a line that cannot be read",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g531remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g533remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g536remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/remap_subs/g69remap.ngc": "a line that is never run is refused",
    "rs274/LinuxCNC__linuxcnc/configs/sim/axis/vismach/millturn/example.ngc": "runs on behind a line that cannot be read",
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
    "fanuc_macro/LinuxCNC__linuxcnc/tests/interp/m98m99/05-M98-loops/test.ngc": "level of a series of cycles",
    "gcode/Unigraphics__NX.Postprocessor/Haas VF2 4 axis/4axis_test_only.cnc": "another fault of the line above is told first",
    "gcode/Unigraphics__NX.Postprocessor/Haas VF2 5 axis/BandB_mfg.cnc": "runs on behind a line that cannot be read",
    "gcode/dillonhuff__gpr/gcode_samples/HAAS_sample.NCF": "runs on behind a line that cannot be read",
    "gcode/dillonhuff__gpr/gcode_samples/camaster_sample.tap": "runs on behind a line that cannot be read",
}
