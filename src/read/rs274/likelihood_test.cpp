#include <gtest/gtest.h>

#include "read/rs274/read.hpp"

namespace obrys::read::rs274 {

TEST(Rs274Likelihood, TextAndSuffixCount) {
    EXPECT_GT(linuxcnc_likelihood("G21\nG0 X1\nM2\n", "A.ngc"), 70);
    EXPECT_GT(linuxcnc_likelihood("o<a> sub\n#<b> = 1\no<a> endsub\nM2\n", "a.txt"), 70);
    EXPECT_LT(linuxcnc_likelihood("N10 G1 X10\nN20 G01 X=R5\n", "A.MPF"), 20);
    EXPECT_LT(linuxcnc_likelihood("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z\n2 L X+1 FMAX\n", "A.H"), 10);
    EXPECT_LT(linuxcnc_likelihood("O0001\nIF[#1EQ1]GOTO10\nG65P9000\n", "A.NC"), 40);
    EXPECT_EQ(linuxcnc_likelihood("", ""), 5);
}

}  // namespace obrys::read::rs274
