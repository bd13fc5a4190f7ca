#include "dialect/heidenhain/cycle_parameters.hpp"

namespace obrys::dialect::heidenhain::parameters {

namespace {

using Role = cl::CycleRole;
using P = CycleParameter;

constexpr P length(int q, Role role) { return {q, {}, role, CycleUnit::length, 0}; }
constexpr P plain(int q, Role role) { return {q, {}, role, CycleUnit::plain, 0}; }
constexpr P feed(int q, Role role) { return {q, {}, role, CycleUnit::feed, 0}; }

// Q numbers that mean the same in every cycle that has them.
constexpr P q200 = length(200, Role::clearance), q201 = length(201, Role::depth), q202 = length(202, Role::infeed);
constexpr P q203 = length(203, Role::surface), q204 = length(204, Role::second_clearance);
constexpr P q205 = length(205, Role::min_infeed), q206 = feed(206, Role::feed_plunge);
constexpr P q207 = feed(207, Role::feed_mill), q208 = feed(208, Role::feed_retract);
constexpr P q209 = feed(209, Role::feed_step), q210 = plain(210, Role::dwell_top);
constexpr P q211 = plain(211, Role::dwell_bottom), q212 = length(212, Role::decrement);
constexpr P q213 = plain(213, Role::breaks_before_retract), q214 = plain(214, Role::retract_direction);
constexpr P q215 = plain(215, Role::operation), q216 = length(216, Role::centre_u), q217 = length(217, Role::centre_v);
constexpr P q218 = length(218, Role::length), q219 = length(219, Role::width), q220 = length(220, Role::corner_radius);
constexpr P q221 = length(221, Role::allowance_u), q222 = length(222, Role::blank_diameter);
constexpr P q223 = length(223, Role::diameter), q224 = plain(224, Role::rotation);
constexpr P q225 = length(225, Role::start_u), q226 = length(226, Role::start_v), q227 = length(227, Role::start_w);
constexpr P q237 = length(237, Role::spacing_u), q238 = length(238, Role::spacing_v), q239 = length(239, Role::pitch);
constexpr P q240 = plain(240, Role::passes), q241 = plain(241, Role::count), q242 = plain(242, Role::columns);
constexpr P q243 = plain(243, Role::rows), q244 = length(244, Role::pitch_circle), q245 = plain(245, Role::start_angle);
constexpr P q246 = plain(246, Role::end_angle), q247 = plain(247, Role::angle_step);
constexpr P q248 = plain(248, Role::angle_length), q253 = feed(253, Role::feed_position);
constexpr P q254 = feed(254, Role::feed_countersink), q256 = length(256, Role::chip_break_distance);
constexpr P q257 = length(257, Role::chip_break_depth), q258 = length(258, Role::stop_distance_first);
constexpr P q259 = length(259, Role::stop_distance_last), q301 = plain(301, Role::move_at_clearance);
constexpr P q335 = length(335, Role::diameter), q336 = plain(336, Role::spindle_angle);
constexpr P q338 = length(338, Role::finish_infeed), q351 = plain(351, Role::direction);
constexpr P q355 = plain(355, Role::threads_per_step), q357 = length(357, Role::side_clearance);
constexpr P q358 = length(358, Role::front_depth), q359 = length(359, Role::front_offset);
constexpr P q366 = plain(366, Role::plunge), q367 = plain(367, Role::position);
constexpr P q368 = length(368, Role::allowance_side), q369 = length(369, Role::allowance_floor);
constexpr P q370 = plain(370, Role::overlap), q374 = plain(374, Role::rotation);
constexpr P q379 = length(379, Role::deepened_start), q385 = feed(385, Role::feed_finish);
constexpr P q395 = plain(395, Role::depth_reference), q439 = plain(439, Role::feed_reference);
constexpr P q512 = feed(512, Role::feed_approach);

// Contour cycles.
constexpr P q1 = length(1, Role::depth), q2 = plain(2, Role::overlap), q3 = length(3, Role::allowance_side);
constexpr P q4 = length(4, Role::allowance_floor), q5 = length(5, Role::surface), q6 = length(6, Role::clearance);
constexpr P q7 = length(7, Role::clearance_height), q8 = length(8, Role::rounding_radius);
constexpr P q9 = plain(9, Role::direction), q10 = length(10, Role::infeed), q11 = feed(11, Role::feed_plunge);
constexpr P q12 = feed(12, Role::feed_mill), q13 = plain(13, Role::pilot_tool), q14 = length(14, Role::allowance_left);
constexpr P q15 = plain(15, Role::direction), q16 = length(16, Role::cylinder_radius);
constexpr P q17 = plain(17, Role::dimension_kind), q18 = plain(18, Role::coarse_tool);
constexpr P q19 = feed(19, Role::feed_reciprocate), q20 = length(20, Role::slot_width);
constexpr P q21 = length(21, Role::tolerance), q401 = plain(401, Role::feed_factor), q404 = plain(404, Role::strategy);

/// Value of the numbered form.
constexpr P old(int line, std::string_view word, Role role, CycleUnit unit = CycleUnit::length) {
    return {-1, word, role, unit, static_cast<std::uint8_t>(line)};
}
// English of several software versions | German | French. Czech keywords were not found: the order decides there.
constexpr std::string_view set_up = "SET UP|SETUP|SET-UP|DIST|ABST|ABST.|DIST.";
constexpr std::string_view depth = "DEPTH|TIEFE|PROF|PROF.";
constexpr std::string_view infeed = "PECKG|PLNGNG|ZUSTLG|ZUSTLG.|PASSE";
constexpr std::string_view dwell = "DWELL|V.ZEIT|VERWEILZEIT|TEMPO|V.ZEIT.";
constexpr std::string_view allow = "ALLOW|ALLOWANCE|AUFMASS|SUREP";
constexpr std::string_view pitch = "PITCH|STEIG|STEIGUNG|PAS";
constexpr std::string_view angle = "ANGLE|WINKEL";
constexpr auto no_unit = CycleUnit::plain;
constexpr auto mm_per_minute = CycleUnit::feed;

constexpr P p1[] = {old(1, set_up, Role::clearance), old(2, depth, Role::depth), old(3, infeed, Role::infeed),
                    old(4, dwell, Role::dwell, no_unit), old(5, "F", Role::feed_plunge, mm_per_minute)};
constexpr P p2[] = {old(1, set_up, Role::clearance), old(2, depth, Role::depth), old(3, dwell, Role::dwell, no_unit),
                    old(4, "F", Role::feed_plunge, mm_per_minute)};
constexpr P p3[] = {old(1, set_up, Role::clearance),
                    old(2, depth, Role::depth),
                    old(3, infeed, Role::infeed),
                    old(3, "F", Role::feed_plunge, mm_per_minute),
                    old(4, "X", Role::axis_x),
                    old(4, "Y", Role::axis_y),
                    old(4, "Z", Role::axis_z),
                    old(5, "X", Role::axis_x),
                    old(5, "Y", Role::axis_y),
                    old(5, "Z", Role::axis_z),
                    old(6, "F", Role::feed_mill, mm_per_minute)};
constexpr P p4[] = {old(1, set_up, Role::clearance),
                    old(2, depth, Role::depth),
                    old(3, infeed, Role::infeed),
                    old(3, "F", Role::feed_plunge, mm_per_minute),
                    old(4, "X", Role::axis_x),
                    old(4, "Y", Role::axis_y),
                    old(4, "Z", Role::axis_z),
                    old(5, "X", Role::axis_x),
                    old(5, "Y", Role::axis_y),
                    old(5, "Z", Role::axis_z),
                    old(6, "F", Role::feed_mill, mm_per_minute),
                    old(6, "DR", Role::direction, no_unit),
                    old(6, "RADIUS", Role::corner_radius)};
constexpr P p5[] = {old(1, set_up, Role::clearance),       old(2, depth, Role::depth),
                    old(3, infeed, Role::infeed),          old(3, "F", Role::feed_plunge, mm_per_minute),
                    old(4, "RADIUS", Role::radius),        old(5, "F", Role::feed_mill, mm_per_minute),
                    old(5, "DR", Role::direction, no_unit)};
constexpr P p6[] = {old(1, set_up, Role::clearance),
                    old(1, depth, Role::depth),
                    old(2, infeed, Role::infeed),
                    old(2, "F", Role::feed_plunge, mm_per_minute),
                    old(2, allow, Role::allowance_side),
                    old(3, angle, Role::angle, no_unit),
                    old(3, "F", Role::feed_mill, mm_per_minute)};
constexpr P p15[] = {old(1, set_up, Role::clearance), old(1, depth, Role::depth), old(2, infeed, Role::infeed),
                     old(2, "F", Role::feed_plunge, mm_per_minute), old(2, allow, Role::allowance_side)};
constexpr P p16[] = {old(1, set_up, Role::clearance),        old(1, depth, Role::depth),
                     old(2, infeed, Role::infeed),           old(2, "F", Role::feed_plunge, mm_per_minute),
                     old(3, "DR", Role::direction, no_unit), old(3, "F", Role::feed_mill, mm_per_minute)};
constexpr P p17[] = {old(1, set_up, Role::clearance), old(2, depth, Role::depth), old(3, pitch, Role::pitch)};
constexpr P p18[] = {old(1, depth, Role::depth), old(2, pitch, Role::pitch)};

// The axes of datum shift and scaling stand in any line, so that line 0 says: any.
constexpr P p7[] = {old(0, "#", Role::datum_number, no_unit),
                    old(0, "X", Role::axis_x),
                    old(0, "Y", Role::axis_y),
                    old(0, "Z", Role::axis_z),
                    old(0, "A", Role::axis_a, no_unit),
                    old(0, "B", Role::axis_b, no_unit),
                    old(0, "C", Role::axis_c, no_unit),
                    old(0, "U", Role::axis_u),
                    old(0, "V", Role::axis_v),
                    old(0, "W", Role::axis_w)};
constexpr P p8[] = {
    old(0, "X", Role::axis_x, no_unit), old(0, "Y", Role::axis_y, no_unit), old(0, "Z", Role::axis_z, no_unit),
    old(0, "A", Role::axis_a, no_unit), old(0, "B", Role::axis_b, no_unit), old(0, "C", Role::axis_c, no_unit),
    old(0, "U", Role::axis_u, no_unit), old(0, "V", Role::axis_v, no_unit), old(0, "W", Role::axis_w, no_unit)};
constexpr P p9[] = {old(1, dwell, Role::dwell, no_unit)};
constexpr P p10[] = {old(1, "ROT", Role::angle, no_unit)};
constexpr P p11[] = {old(1, "SCL", Role::factor, no_unit)};
constexpr P p13[] = {old(1, angle, Role::spindle_angle, no_unit)};
constexpr P p14[] = {
    old(0, "CONTOUR LABEL|KONTURLABEL|LBL OBRYSU|LBL OBRYŠU|LABEL CONTOUR", Role::contour_label, no_unit)};
constexpr P p19[] = {old(1, "A", Role::axis_a, no_unit), old(1, "B", Role::axis_b, no_unit),
                     old(1, "C", Role::axis_c, no_unit), old(0, "F", Role::feed_position, mm_per_minute),
                     old(0, set_up, Role::setup_distance)};
constexpr P p26[] = {old(0, "X", Role::axis_x, no_unit), old(0, "Y", Role::axis_y, no_unit),
                     old(0, "Z", Role::axis_z, no_unit), old(0, "CCX", Role::centre_x),
                     old(0, "CCY", Role::centre_y),      old(0, "CCZ", Role::centre_z)};
constexpr P p32[] = {old(1, "T", Role::tolerance), old(2, "HSC-MODE", Role::tolerance_mode, no_unit),
                     old(2, "TA", Role::tolerance_angle, no_unit)};

constexpr P p20[] = {q1, q2, q3, q4, q5, q6, q7, q8, q9};
constexpr P p21[] = {q10, q11, q13};
constexpr P p22[] = {q10, q11, q12, q18, q19, q208, q401, q404};
constexpr P p23[] = {q11, q12, q208};
constexpr P p24[] = {q9, q10, q11, q12, q14};
constexpr P p25[] = {q1, q3, q5, q7, q10, q11, q12, q15};
constexpr P p27[] = {q1, q3, q6, q10, q11, q12, q16, q17};
constexpr P p28[] = {q1, q3, q6, q10, q11, q12, q16, q17, q20, q21};
constexpr P p29[] = {q1, q3, q6, q10, q11, q12, q16, q17, q20};
constexpr P p270[] = {plain(390, Role::approach), plain(391, Role::compensation), length(392, Role::approach_radius),
                      plain(393, Role::approach_angle), length(394, Role::auxiliary_distance)};

constexpr P p200[] = {q200, q201, q206, q202, q210, q203, q204, q211, q395};
constexpr P p201[] = {q200, q201, q206, q211, q208, q203, q204};
constexpr P p202[] = {q200, q201, q206, q211, q208, q203, q204, q214, q336};
constexpr P p203[] = {q200, q201, q206, q202, q210, q203, q204, q212, q213, q205, q211, q208, q256, q395};
constexpr P p204[] = {q200,
                      length(249, Role::counterbore_depth),
                      length(250, Role::thickness),
                      length(251, Role::off_centre),
                      length(252, Role::edge_height),
                      q253,
                      q254,
                      plain(255, Role::dwell),
                      q203,
                      q204,
                      q214,
                      q336};
constexpr P p205[] = {q200, q201, q206, q202, q203, q204, q212, q205, q258,
                      q259, q257, q256, q211, q379, q253, q208, q395};
constexpr P p206[] = {q200, q201, q206, q211, q203, q204};
constexpr P p207[] = {q200, q201, q239, q203, q204};
constexpr P p208[] = {q200, q201, q206, length(334, Role::infeed_per_turn),
                      q203, q204, q335, length(342, Role::predrilled_diameter),
                      q351};
constexpr P p209[] = {q200,
                      q201,
                      q239,
                      q203,
                      q204,
                      q257,
                      plain(256, Role::chip_break_distance),  // times the pitch
                      q336,
                      plain(403, Role::rpm_factor)};
constexpr P p240[] = {q200, plain(343, Role::centre_by_diameter), q201, length(344, Role::diameter), q206, q211, q203,
                      q204};
constexpr P p241[] = {q200,
                      q201,
                      q206,
                      q211,
                      q203,
                      q204,
                      q379,
                      q253,
                      q208,
                      plain(426, Role::spindle_direction),
                      plain(427, Role::spindle_speed_position),
                      plain(428, Role::spindle_speed),
                      plain(429, Role::coolant_on),
                      plain(430, Role::coolant_off),
                      length(435, Role::dwell_depth)};
constexpr P p262[] = {q335, q239, q201, q355, q253, q351, q200, q203, q204, q207, q512};
constexpr P p263[] = {
    q335, q239, q201, length(356, Role::countersink_depth), q253, q351, q200, q357, q358, q359, q203, q204,
    q254, q207, q512};
constexpr P p264[] = {
    q335, q239, q201, length(356, Role::hole_depth), q253, q351, q202, q258, q257, q256, q358, q359, q200, q203, q204,
    q206, q207, q512};
constexpr P p265[] = {q335, q239, q201, q253, q358, q359, plain(360, Role::countersink_order),
                      q200, q203, q204, q254, q207};
constexpr P p267[] = {q335, q239, q201, q355, q253, q351, q200, q358, q359, q203, q204, q254, q207, q512};

constexpr P p210[] = {q200, q201, q207, q202, q215, q203, q204, q216, q217, q218, q219, q224, q338, q206};
constexpr P p211[] = {q200, q201, q207, q202, q215, q203, q204, q216, q217, q244, q219, q245, q248, q338, q206};
constexpr P p212[] = {q200, q201, q206, q202, q207, q203, q204, q216, q217, q218, q219, q220, q221};
constexpr P p214[] = {q200, q201, q206, q202, q207, q203, q204, q216, q217, q222, q223};
constexpr P p220[] = {q216, q217, q244, q245, q246, q247, q241, q200, q203, q204, q301, plain(365, Role::traverse)};
constexpr P p221[] = {q225, q226, q237, q238, q242, q243, q224, q200, q203, q204, q301};
constexpr P p230[] = {q225, q226, q227, q218, q219, q240, q206, q207, q209, q200};
constexpr P p231[] = {q225,
                      q226,
                      q227,
                      length(228, Role::second_u),
                      length(229, Role::second_v),
                      length(230, Role::second_w),
                      length(231, Role::third_u),
                      length(232, Role::third_v),
                      length(233, Role::third_w),
                      length(234, Role::fourth_u),
                      length(235, Role::fourth_v),
                      length(236, Role::fourth_w),
                      q240,
                      q207};
constexpr P p232[] = {plain(389, Role::strategy),
                      q225,
                      q226,
                      q227,
                      length(386, Role::end_surface),
                      q218,
                      q219,
                      q202,
                      q369,
                      q370,
                      q207,
                      q385,
                      q253,
                      q200,
                      q357,
                      q204};
constexpr P p247[] = {plain(339, Role::preset_number)};
constexpr P p251[] = {q215, q218, q219, q220, q368, q224, q367, q207, q351, q201, q202,
                      q369, q206, q338, q200, q203, q204, q370, q366, q385, q439};
constexpr P p252[] = {q215, q223, q368, q207, q351, q201, q202, q369, q206,
                      q338, q200, q203, q204, q370, q366, q385, q439};
constexpr P p253[] = {q215, q218, q219, q368, q374, q367, q207, q351, q201, q202,
                      q369, q206, q338, q200, q203, q204, q366, q385, q439};
constexpr P p254[] = {q215,
                      q219,
                      q368,
                      length(375, Role::pitch_circle),
                      q367,
                      q216,
                      q217,
                      plain(376, Role::start_angle),
                      q248,
                      plain(378, Role::angle_step),
                      plain(377, Role::count),
                      q207,
                      q351,
                      q201,
                      q202,
                      q369,
                      q206,
                      q338,
                      q200,
                      q203,
                      q204,
                      q366,
                      q385,
                      q439};
constexpr P p256[] = {q218, length(424, Role::blank_length),
                      q219, length(425, Role::blank_width),
                      q220, q368,
                      q224, q367,
                      q207, q351,
                      q201, q202,
                      q206, q200,
                      q203, q204,
                      q370, plain(437, Role::approach_position)};
constexpr P p257[] = {
    q223, q222, q368, q207, q351, q201, q202, q206, q200, q203, q204, q370, plain(376, Role::start_angle)};

}  // namespace

constinit const List c1 = p1, c2 = p2, c3 = p3, c4 = p4, c5 = p5, c6 = p6, c7 = p7, c8 = p8, c9 = p9, c10 = p10,
                     c11 = p11, c13 = p13, c14 = p14, c15 = p15, c16 = p16, c17 = p17, c18 = p18, c19 = p19, c26 = p26,
                     c32 = p32;
constinit const List c20 = p20, c21 = p21, c22 = p22, c23 = p23, c24 = p24, c25 = p25, c27 = p27, c28 = p28, c29 = p29,
                     c39 = p27, c270 = p270;
constinit const List c200 = p200, c201 = p201, c202 = p202, c203 = p203, c204 = p204, c205 = p205, c206 = p206,
                     c207 = p207, c208 = p208, c209 = p209, c240 = p240, c241 = p241, c262 = p262, c263 = p263,
                     c264 = p264, c265 = p265, c267 = p267;
constinit const List c210 = p210, c211 = p211, c212 = p212, c214 = p214, c220 = p220, c221 = p221, c230 = p230,
                     c231 = p231, c232 = p232, c247 = p247, c251 = p251, c252 = p252, c253 = p253, c254 = p254,
                     c256 = p256, c257 = p257;

}  // namespace obrys::dialect::heidenhain::parameters
