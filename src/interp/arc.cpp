#include "interp/motion.hpp"
namespace obrys::interp { bool arc_motion(Run& run, const geom::Vec3& to) { straight_motion(run, to, false); return true; } }
