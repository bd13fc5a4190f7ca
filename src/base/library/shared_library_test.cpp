#include "base/library/shared_library.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace obrys::base::library {
namespace {

std::string complaint_of(const char* name, const char* symbol) {
    try {
        double (*function)(double) = nullptr;
        SharedLibrary(name).find(function, symbol);
        return "";
    } catch (const std::runtime_error& e) {
        return e.what();
    }
}

TEST(SharedLibrary, AFunctionIsFoundAndCalled) {
    double (*root)(double) = nullptr;
    SharedLibrary("libm.so.6").find(root, "sqrt");
    EXPECT_EQ(root(9.0), 3.0);
}

TEST(SharedLibrary, WhatIsNotThereIsSaidByName) {
    EXPECT_EQ(complaint_of("libobrys_nobody.so.1", "sqrt").find("libobrys_nobody.so.1 cannot be used: "), 0U);
    EXPECT_EQ(complaint_of("libm.so.6", "no_such_root").find("libm.so.6 cannot be used: "), 0U);
    EXPECT_NE(complaint_of("libm.so.6", "no_such_root").find("no_such_root"), std::string::npos);
    EXPECT_EQ(complaint_of("libm.so.6", "sqrt"), "");
}

}  // namespace
}  // namespace obrys::base::library
