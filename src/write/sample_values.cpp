#include "write/samples.hpp"

namespace obrys::write {

namespace {

using cl::CycleRole;

/// Of roles; others have what fits their kind.
constexpr std::pair<CycleRole, double> role_values[] = {
    {CycleRole::surface, 0},
    {CycleRole::clearance, 2},
    {CycleRole::second_clearance, 50},
    {CycleRole::clearance_height, 50},
    {CycleRole::depth, -20},
    {CycleRole::hole_depth, -20},
    {CycleRole::end_surface, -2},
    {CycleRole::infeed, 5},
    {CycleRole::min_infeed, 1},
    {CycleRole::decrement, 0.5},
    {CycleRole::chip_break_distance, 0.2},
    {CycleRole::chip_break_depth, 5},
    {CycleRole::breaks_before_retract, 3},
    {CycleRole::stop_distance_first, 0.5},
    {CycleRole::stop_distance_last, 0.5},
    {CycleRole::deepened_start, 0},
    {CycleRole::allowance_side, 0},
    {CycleRole::allowance_floor, 0},
    {CycleRole::allowance_u, 0},
    {CycleRole::finish_infeed, 0},
    {CycleRole::countersink_depth, -1},
    {CycleRole::front_depth, 0},
    {CycleRole::front_offset, 0},
    {CycleRole::countersink_order, 0},
    {CycleRole::counterbore_depth, 5},
    {CycleRole::thickness, 20},
    {CycleRole::off_centre, 3.5},
    {CycleRole::edge_height, 15},
    {CycleRole::depth_reference, 0},
    {CycleRole::dwell_depth, 0},
    {CycleRole::spindle_direction, 3},
    {CycleRole::spindle_speed, 1000},
    {CycleRole::spindle_speed_position, 50},
    {CycleRole::rpm_factor, 1},
    {CycleRole::coolant_on, 8},
    {CycleRole::coolant_off, 9},
    {CycleRole::pitch, 1.5},
    {CycleRole::diameter, 18},
    {CycleRole::radius, 20},
    {CycleRole::predrilled_diameter, 0},
    {CycleRole::blank_diameter, 22},
    {CycleRole::centre_by_diameter, 0},
    {CycleRole::infeed_per_turn, 1},
    {CycleRole::threads_per_step, 0},
    {CycleRole::length, 60},
    {CycleRole::width, 30},
    {CycleRole::blank_length, 64},
    {CycleRole::blank_width, 34},
    {CycleRole::corner_radius, 6},
    {CycleRole::rounding_radius, 0},
    {CycleRole::side_clearance, 2},
    {CycleRole::start_angle, 0},
    {CycleRole::end_angle, 360},
    {CycleRole::angle_length, 90},
    {CycleRole::angle_step, 0},
    {CycleRole::rotation, 0},
    {CycleRole::pitch_circle, 80},
    {CycleRole::spacing_u, 20},
    {CycleRole::spacing_v, 20},
    {CycleRole::columns, 3},
    {CycleRole::rows, 2},
    {CycleRole::count, 1},
    {CycleRole::passes, 3},
    {CycleRole::position, 0},
    {CycleRole::approach_position, 0},
    {CycleRole::direction, 1},
    {CycleRole::retract_direction, 1},
    {CycleRole::spindle_angle, 0},
    {CycleRole::operation, 0},
    {CycleRole::overlap, 1},
    {CycleRole::plunge, 0},
    {CycleRole::strategy, 0},
    {CycleRole::move_at_clearance, 1},
    {CycleRole::traverse, 0},
    {CycleRole::feed_reference, 0},
    {CycleRole::retract_plane, 2},
    {CycleRole::bottom, -20},
    {CycleRole::return_level, 5},
    {CycleRole::shift_u, 1},
    {CycleRole::shift_v, 0},
    {CycleRole::counterbore_top, -15},
    {CycleRole::feed_out, 0},
    {CycleRole::centre_u, 10},
    {CycleRole::centre_v, 20},
    {CycleRole::start_u, 0},
    {CycleRole::start_v, 0},
    {CycleRole::start_w, 0},
    {CycleRole::second_u, 50},
    {CycleRole::second_v, 0},
    {CycleRole::second_w, 0},
    {CycleRole::third_u, 0},
    {CycleRole::third_v, 30},
    {CycleRole::third_w, 0},
    {CycleRole::fourth_u, 50},
    {CycleRole::fourth_v, 30},
    {CycleRole::fourth_w, 0},
};

double role_value(CycleRole role) {
    for (const auto& [known, value] : role_values)
        if (known == role) return value;
    const std::string_view name = cl::spelling(role);
    if (name.starts_with("feed-factor")) return 1;
    if (name.starts_with("feed")) return name == "feed-position" ? 750 : 200;
    if (name.starts_with("dwell")) return 0.5;
    if (name.find("angle") != std::string_view::npos) return 30;
    return 1;
}

}  // namespace

double sample_value(ValueIndex value) {
    if (value >= first_role) return role_value(static_cast<CycleRole>(value - first_role));
    switch (static_cast<Value>(value)) {
        case Value::x: return 10.5;
        case Value::machine_x: return 10;
        case Value::y:
        case Value::machine_y: return 20;
        case Value::z: return 5;
        case Value::machine_z: return -10;
        case Value::i:
        case Value::j:
        case Value::k: return 5;
        case Value::feed:
        case Value::own_feed: return 200;
        case Value::speed: return 1000;
        case Value::limit: return 2500;
        case Value::sweep:
        case Value::held:
        case Value::axis: return 90;
        case Value::angle:
        case Value::angle_x:
        case Value::angle_y:
        case Value::angle_z:
        case Value::euler_1:
        case Value::euler_2:
        case Value::euler_3: return 30;
        case Value::pitch:
        case Value::pitch_x:
        case Value::pitch_y:
        case Value::pitch_z: return 1.5;
        case Value::number: return 2;
        case Value::turret: return 202;
        case Value::turns: return 3;
        case Value::more_turns: return 2;
        case Value::seconds: return 1.5;
        case Value::contour: return 0.02;
        case Value::rotary: return 0.1;
        case Value::tool_radius: return 4;
        case Value::length: return 50;
        case Value::radius: return 12.5;
        case Value::raised:
        case Value::wider: return 0.2;
        case Value::way: return 642;
        case Value::merge: return 0.01;
        case Value::block: return 10;
        case Value::mirror_x:
        case Value::mirror_y:
        case Value::mirror_z: return 0;
        default: return 1;
    }
}

}  // namespace obrys::write
