#include "mesh/package/three_mf.hpp"

#include <gtest/gtest.h>

#include "mesh/primitives.hpp"

namespace obrys::mesh::package {
namespace {

TEST(ThreeMf, is_a_zip_file_and_always_the_same) {
    const Mesh m = box({0, 0, 0}, {1, 1, 1});
    const std::string file = write_3mf(m);
    EXPECT_EQ(file.substr(0, 4), "PK\3\4");
    EXPECT_NE(file.find("3D/3dmodel.model"), std::string::npos);
    EXPECT_EQ(write_3mf(m), file);
    EXPECT_EQ(write_3mf(Mesh{}).substr(0, 4), "PK\3\4");
}

}  // namespace
}  // namespace obrys::mesh::package
