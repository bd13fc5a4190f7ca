"""Differences of random programs that stay, each with its reason: a pattern of what random_moves.py prints."""

KNOWN = (
    (r"Spindle (turning counterclockwise|not turning) in G84", "LinuxCNC goes over the hole before it refuses the tap; obrys refuses the block at once"),
    (r"^rs274: \('(Arc radius too small|Radius to end of arc)", "the move that compensation held back is printed by obrys before the block behind it is refused, by rs274 not at all"),
    (r"R turns the system in force while G92 or G52 shifts it", "LinuxCNC forgets the shift when it works out where it stands in the turned system; obrys stays where the machine is and says so"),
    (r"'[^']*\$\d", "obrys says that a second spindle is not run and goes on; LinuxCNC refuses the line"),
    (r"'Cannot use axis values without a g code", "a length offset beside the axis words is set before obrys refuses the block, not by LinuxCNC"),
    (r"feeds along the wrong axes, and a line leads", "G84 in G18 or G19 leaves LinuxCNC elsewhere than it believes; the stream leads from there to where it begins the arc behind"),
)
