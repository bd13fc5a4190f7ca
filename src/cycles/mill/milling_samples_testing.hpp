#pragma once
/// Sound calls of pockets, slots and studs, one of every kind.

#include "cycles/cycle_testing.hpp"

namespace obrys::cycles::test {

inline std::vector<Sample> milling_samples() {
    // sizes: table
    const Values levels = {{Role::clearance, 2},         {Role::depth, -20}, {Role::surface, 0},
                           {Role::second_clearance, 50}, {Role::infeed, 8},  {Role::feed_plunge, 150},
                           {Role::feed_mill, 500}};
    const Values complete = with(levels, {{Role::operation, 0},
                                          {Role::allowance_side, 0.3},
                                          {Role::allowance_floor, 0.2},
                                          {Role::finish_infeed, 10},
                                          {Role::feed_finish, 400},
                                          {Role::direction, 1},
                                          {Role::plunge, 0}});
    const Values box = {{Role::length, 60}, {Role::width, 40}, {Role::corner_radius, 6}};
    const Values centre = {{Role::centre_u, 40}, {Role::centre_v, 30}};
    const Values old = {{Role::clearance, 2},     {Role::depth, -20},     {Role::infeed, 8},
                        {Role::feed_plunge, 150}, {Role::feed_mill, 500}, {Role::direction, 1}};
    return {
        {Kind::rectangular_pocket,
         with(with(complete, box), {{Role::rotation, 20}, {Role::position, 0}, {Role::overlap, 1}})},
        {Kind::circular_pocket, with(complete, {{Role::diameter, 50}, {Role::overlap, 1}})},
        {Kind::slot,
         with(complete, {{Role::length, 60}, {Role::width, 14}, {Role::rotation, 20}, {Role::position, 2}})},
        {Kind::round_slot, with(with(complete, centre), {{Role::width, 14},
                                                         {Role::pitch_circle, 80},
                                                         {Role::position, 0},
                                                         {Role::start_angle, 10},
                                                         {Role::angle_length, 60},
                                                         {Role::angle_step, 90},
                                                         {Role::count, 2}})},
        {Kind::rectangular_stud, with(with(levels, box), {{Role::blank_length, 70},
                                                          {Role::blank_width, 55},
                                                          {Role::allowance_side, 0.3},
                                                          {Role::rotation, 20},
                                                          {Role::position, 0},
                                                          {Role::direction, -1},
                                                          {Role::overlap, 1}})},
        {Kind::circular_stud, with(levels, {{Role::diameter, 50},
                                            {Role::blank_diameter, 66},
                                            {Role::allowance_side, 0.3},
                                            {Role::direction, -1},
                                            {Role::overlap, 1}})},
        {Kind::rectangular_pocket_finish, with(with(levels, box), centre)},
        {Kind::rectangular_stud_finish, with(with(levels, box), centre)},
        {Kind::circular_pocket_finish, with(with(levels, centre), {{Role::diameter, 50}})},
        {Kind::circular_stud_finish, with(with(levels, centre), {{Role::diameter, 50}})},
        {Kind::slot_reciprocating, with(with(levels, centre), {{Role::operation, 0},
                                                               {Role::length, 60},
                                                               {Role::width, 14},
                                                               {Role::rotation, 20},
                                                               {Role::finish_infeed, 0}})},
        {Kind::round_slot_reciprocating, with(with(levels, centre), {{Role::operation, 0},
                                                                     {Role::pitch_circle, 80},
                                                                     {Role::width, 14},
                                                                     {Role::start_angle, 10},
                                                                     {Role::angle_length, 60},
                                                                     {Role::finish_infeed, 0}})},
        {Kind::rectangular_pocket_simple,
         with(old, {{Role::axis_x, 60}, {Role::axis_y, 40}, {Role::corner_radius, 6}})},
        {Kind::circular_pocket_simple, with(old, {{Role::radius, 25}})},
    };
}

}  // namespace obrys::cycles::test
