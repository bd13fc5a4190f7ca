#pragma once
/// What LinuxCNC refuses of M62 to M68 and M19 by the values of their words; it ends the run.

namespace obrys::interp {

struct Run;

void refuse_signals(Moving&);

}  // namespace obrys::interp
