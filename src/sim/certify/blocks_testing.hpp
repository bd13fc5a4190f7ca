#pragma once
/// For tests: straight blocks over small meshes with their greatest gouge along z, worked out by another program as one
/// concave maximum over block and triangle; negative: the clearance.

#include <array>
#include <string>
#include <vector>

#include "sim/certify/body.hpp"

namespace obrys::sim::certify::testing {

using Corners = std::vector<std::array<geom::Vec3, 3>>;

struct BlockCase {
    std::string name;
    const Corners& triangles;
    Shape tool;
    geom::Vec3 from, to;
    double gouge = 0;
};

inline const Corners ridge{{geom::Vec3{-20, -20, -10}, geom::Vec3{20, -20, -10}, geom::Vec3{20, 0, 6}},
                           {geom::Vec3{-20, -20, -10}, geom::Vec3{20, 0, 6}, geom::Vec3{-20, 0, 2}},
                           {geom::Vec3{-20, 0, 2}, geom::Vec3{20, 0, 6}, geom::Vec3{20, 20, -14}},
                           {geom::Vec3{-20, 0, 2}, geom::Vec3{20, 20, -14}, geom::Vec3{-20, 20, -14}}};
inline const Corners pyramid{{geom::Vec3{-10, -10, 0}, geom::Vec3{10, -10, 0}, geom::Vec3{1, 2, 9}},
                             {geom::Vec3{10, -10, 0}, geom::Vec3{10, 10, 0}, geom::Vec3{1, 2, 9}},
                             {geom::Vec3{10, 10, 0}, geom::Vec3{-10, 10, 0}, geom::Vec3{1, 2, 9}},
                             {geom::Vec3{-10, 10, 0}, geom::Vec3{-10, -10, 0}, geom::Vec3{1, 2, 9}}};
inline const Corners groove{{geom::Vec3{-20, -20, 12}, geom::Vec3{0, -20, 0}, geom::Vec3{0, 20, 0}},
                            {geom::Vec3{-20, -20, 12}, geom::Vec3{0, 20, 0}, geom::Vec3{-20, 20, 12}},
                            {geom::Vec3{0, -20, 0}, geom::Vec3{20, -20, 15}, geom::Vec3{20, 20, 15}},
                            {geom::Vec3{0, -20, 0}, geom::Vec3{20, 20, 15}, geom::Vec3{0, 20, 0}}};
inline const Corners box{{geom::Vec3{-10, -6, 0}, geom::Vec3{-10, 6, 0}, geom::Vec3{10, 6, 0}},
                         {geom::Vec3{-10, -6, 0}, geom::Vec3{10, 6, 0}, geom::Vec3{10, -6, 0}},
                         {geom::Vec3{-10, -6, 8}, geom::Vec3{10, -6, 8}, geom::Vec3{10, 6, 8}},
                         {geom::Vec3{-10, -6, 8}, geom::Vec3{10, 6, 8}, geom::Vec3{-10, 6, 8}},
                         {geom::Vec3{-10, -6, 0}, geom::Vec3{10, -6, 0}, geom::Vec3{10, -6, 8}},
                         {geom::Vec3{-10, -6, 0}, geom::Vec3{10, -6, 8}, geom::Vec3{-10, -6, 8}},
                         {geom::Vec3{-10, 6, 0}, geom::Vec3{-10, 6, 8}, geom::Vec3{10, 6, 8}},
                         {geom::Vec3{-10, 6, 0}, geom::Vec3{10, 6, 8}, geom::Vec3{10, 6, 0}},
                         {geom::Vec3{-10, -6, 0}, geom::Vec3{-10, -6, 8}, geom::Vec3{-10, 6, 8}},
                         {geom::Vec3{-10, -6, 0}, geom::Vec3{-10, 6, 8}, geom::Vec3{-10, 6, 0}},
                         {geom::Vec3{10, -6, 0}, geom::Vec3{10, 6, 0}, geom::Vec3{10, 6, 8}},
                         {geom::Vec3{10, -6, 0}, geom::Vec3{10, 6, 8}, geom::Vec3{10, -6, 8}}};

inline const std::vector<BlockCase> blocks{
    {"ridge ball",
     ridge,
     {{0, 5, 0, 5, 5}, {5, 5, 5, 60, 0}},
     {-4.933, -6.983, 5.811},
     {-11.972, 0.718, 5.005},
     -2.1863442089147336},
    {"ridge flat", ridge, {{5, 0, 5, 60, 0}}, {0.658, -9.626, 3.281}, {-8.873, -9.921, 5.076}, -1.94941873485089},
    {"ridge bull",
     ridge,
     {{4, 1, 4, 1, 1}, {5, 1, 5, 60, 0}},
     {-12.301, -4.625, 6.064},
     {5.381, 3.514, 4.809},
     -0.06086514206862681},
    {"ridge cone",
     ridge,
     {{0, 0, 4, 4.000000000000001, 0}, {4, 4.000000000000001, 4, 60, 0}},
     {-12.621, -0.531, 2.473},
     {11.746, -6.139, 1.658},
     -0.05370000000000008},
    {"pyramid ball",
     pyramid,
     {{0, 5, 0, 5, 5}, {5, 5, 5, 60, 0}},
     {-11.735, 5.758, 6.366},
     {8.034, 2.559, 5.5},
     2.918929574863984},
    {"pyramid flat", pyramid, {{5, 0, 5, 60, 0}}, {11.132, -9.322, 6.618}, {3.508, -3.228, 8.788}, -0.277993785765867},
    {"pyramid bull",
     pyramid,
     {{4, 1, 4, 1, 1}, {5, 1, 5, 60, 0}},
     {3.938, 9.128, 6.037},
     {-2.993, -1.033, 3.995},
     4.840963952656965},
    {"pyramid cone",
     pyramid,
     {{0, 0, 4, 4.000000000000001, 0}, {4, 4.000000000000001, 4, 60, 0}},
     {12.77, 0.276, 1.221},
     {-0.94, 0.677, -0.889},
     8.772210304799},
    {"groove ball",
     groove,
     {{0, 5, 0, 5, 5}, {5, 5, 5, 60, 0}},
     {-6.069, 3.233, 4.175},
     {-2.206, -3.227, 3.807},
     0.2973518948453003},
    {"groove flat", groove, {{5, 0, 5, 60, 0}}, {2.881, 7.281, 5.777}, {-8.492, 4.678, 8.556}, 0.13375000000000004},
    {"groove bull",
     groove,
     {{4, 1, 4, 1, 1}, {5, 1, 5, 60, 0}},
     {5.941, -2.13, 4.315},
     {3.159, 3.544, 3.248},
     3.3907499999999997},
    {"groove cone",
     groove,
     {{0, 0, 4, 4.000000000000001, 0}, {4, 4.000000000000001, 4, 60, 0}},
     {-5.859, -3.041, 7.004},
     {-0.097, 8.597, 4.562},
     -3.488599999999999},
    {"box ball",
     box,
     {{0, 5, 0, 5, 5}, {5, 5, 5, 60, 0}},
     {-9.691, 5.549, 3.655},
     {13.736, 8.234, 5.423},
     4.345000000000001},
    {"box flat", box, {{5, 0, 5, 60, 0}}, {-5.511, -1.821, 6.274}, {-1.542, 4.566, 3.843}, 4.157},
    {"box bull",
     box,
     {{4, 1, 4, 1, 1}, {5, 1, 5, 60, 0}},
     {-7.982, -4.679, -1.572},
     {-10.192, -1.877, -2.047},
     10.046999999999999},
    {"box cone",
     box,
     {{0, 0, 4, 4.000000000000001, 0}, {4, 4.000000000000001, 4, 60, 0}},
     {8.764, -4.936, 5.871},
     {-3.341, 6.794, 3.673},
     4.178218073316282},
};

}  // namespace obrys::sim::certify::testing
