#include "cycles/expand/samples_testing.hpp"
#include "cycles/hole/canned_samples_testing.hpp"
#include "cycles/mill/milling_samples_testing.hpp"

namespace obrys::cycles::test {

namespace {

const Values samples_hole = {
    {Role::clearance, 2}, {Role::depth, -20}, {Role::surface, 0}, {Role::second_clearance, 50}};
const Values thread_hole = with(
    samples_hole,
    {{Role::diameter, 30}, {Role::pitch, 2}, {Role::feed_position, 750}, {Role::direction, 1}, {Role::feed_mill, 400}});
const Values countersink = {{Role::front_depth, -3}, {Role::front_offset, 4}, {Role::feed_countersink, 150}};
const Values surface = {{Role::start_u, 10}, {Role::start_v, 12},  {Role::start_w, 4},    {Role::length, 150},
                        {Role::width, 75},   {Role::clearance, 2}, {Role::feed_mill, 500}};

std::vector<Sample> make() {
    // sizes: table
    const Values drilling =
        with(samples_hole, {{Role::feed_plunge, 250}, {Role::infeed, 8}, {Role::dwell_bottom, 0.5}});
    const Values old_hole = {{Role::clearance, 2}, {Role::depth, -20}};
    return {
        {Kind::peck, with(old_hole, {{Role::infeed, 6}, {Role::dwell, 1}, {Role::feed_plunge, 80}})},
        {Kind::drill, with(drilling, {{Role::dwell_top, 0.2}})},
        {Kind::universal_drill, with(drilling, {{Role::dwell_top, 0.2},
                                                {Role::decrement, 1},
                                                {Role::min_infeed, 3},
                                                {Role::breaks_before_retract, 2},
                                                {Role::chip_break_distance, 0.2},
                                                {Role::feed_retract, 1000}})},
        {Kind::universal_peck, with(drilling, {{Role::decrement, 1},
                                               {Role::min_infeed, 3},
                                               {Role::stop_distance_first, 0.5},
                                               {Role::stop_distance_last, 1},
                                               {Role::chip_break_depth, 3},
                                               {Role::chip_break_distance, 0.2},
                                               {Role::deepened_start, 2},
                                               {Role::feed_position, 500}})},
        {Kind::centre,
         with(samples_hole, {{Role::feed_plunge, 250}, {Role::dwell_bottom, 0.5}, {Role::centre_by_diameter, 0}})},
        {Kind::single_lip, with(samples_hole, {{Role::feed_plunge, 250},
                                               {Role::deepened_start, 5},
                                               {Role::feed_position, 500},
                                               {Role::feed_retract, 1000},
                                               {Role::spindle_direction, 3},
                                               {Role::spindle_speed_position, 20},
                                               {Role::spindle_speed, 2000},
                                               {Role::coolant_on, 8},
                                               {Role::coolant_off, 9}})},
        {Kind::ream,
         with(samples_hole, {{Role::feed_plunge, 250}, {Role::feed_retract, 500}, {Role::dwell_bottom, 0.5}})},
        {Kind::bore,
         with(samples_hole, {{Role::feed_plunge, 250}, {Role::dwell_bottom, 0.5}, {Role::retract_direction, 1}})},
        {Kind::back_bore,
         {{Role::clearance, 2},
          {Role::surface, 0},
          {Role::second_clearance, 50},
          {Role::counterbore_depth, 5},
          {Role::thickness, 20},
          {Role::off_centre, 3.5},
          {Role::edge_height, 15},
          {Role::feed_position, 750},
          {Role::feed_countersink, 200},
          {Role::dwell, 1},
          {Role::retract_direction, 2}}},
        {Kind::bore_mill, with(samples_hole, {{Role::feed_plunge, 250},
                                              {Role::infeed_per_turn, 0.5},
                                              {Role::diameter, 16},
                                              {Role::predrilled_diameter, 0},
                                              {Role::direction, 1}})},
        {Kind::tap_floating_simple, with(old_hole, {{Role::dwell, 1}, {Role::feed_plunge, 80}})},
        {Kind::tap_floating, with(samples_hole, {{Role::feed_plunge, 1500}, {Role::dwell_bottom, 0.5}})},
        {Kind::tap_rigid_simple, with(old_hole, {{Role::pitch, 1}})},
        {Kind::tap_rigid, with(samples_hole, {{Role::pitch, -1.5}})},
        {Kind::tap_chip_breaking,
         with(samples_hole,
              {{Role::pitch, 1}, {Role::chip_break_depth, 6}, {Role::chip_break_distance, 1}, {Role::rpm_factor, 2}})},
        {Kind::thread_cut, {{Role::depth, -20}, {Role::pitch, 1}}},
        {Kind::thread_mill, with(thread_hole, {{Role::threads_per_step, 1}, {Role::feed_approach, 100}})},
        {Kind::thread_mill_countersink, with(thread_hole, countersink)},
        {Kind::thread_mill_drill, with(thread_hole, {{Role::hole_depth, -24},
                                                     {Role::infeed, 5},
                                                     {Role::stop_distance_first, 0.2},
                                                     {Role::chip_break_depth, 2},
                                                     {Role::chip_break_distance, 0.2},
                                                     {Role::front_depth, -1},
                                                     {Role::front_offset, 3},
                                                     {Role::feed_plunge, 150}})},
        {Kind::thread_mill_helix, with(with(thread_hole, countersink), {{Role::countersink_order, 1}})},
        {Kind::thread_mill_outside,
         with(with(thread_hole, {{Role::threads_per_step, 3}}),
              {{Role::front_depth, -3}, {Role::front_offset, 21}, {Role::feed_countersink, 150}})},
        {Kind::multipass, with(surface, {{Role::passes, 25}, {Role::feed_plunge, 150}, {Role::feed_step, 200}})},
        {Kind::ruled_surface,
         {{Role::start_u, 0},
          {Role::start_v, 5},
          {Role::start_w, -2},
          {Role::second_u, 100},
          {Role::second_v, 15},
          {Role::second_w, 5},
          {Role::third_u, 110},
          {Role::third_v, 125},
          {Role::third_w, 12},
          {Role::fourth_u, 4},
          {Role::fourth_v, 120},
          {Role::fourth_w, 7},
          {Role::passes, 40},
          {Role::feed_mill, 500}}},
        {Kind::face_mill, with(surface, {{Role::strategy, 0},
                                         {Role::end_surface, 0},
                                         {Role::infeed, 1.5},
                                         {Role::allowance_floor, 0.5},
                                         {Role::overlap, 1.5},
                                         {Role::feed_finish, 300},
                                         {Role::feed_position, 2000},
                                         {Role::side_clearance, 2},
                                         {Role::second_clearance, 20}})},
    };
}

}  // namespace

const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = [] {
        std::vector<Sample> both = make();
        for (Sample& s : milling_samples()) both.push_back(std::move(s));
        for (Sample& s : canned_samples()) both.push_back(std::move(s));
        return both;
    }();
    return all;
}

}  // namespace obrys::cycles::test
