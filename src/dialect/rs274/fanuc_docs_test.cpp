#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

namespace {

std::string code_name(int code) {
    return "G" + std::to_string(code / 10) + (code % 10 != 0 ? "." + std::to_string(code % 10) : "");
}

/// The rows of what is not run or has no effect, and the list of what is run.
struct Matrix {
    std::string run, rows;
    void add(const std::string& name, const FanucG& g) {
        if (g.use == FanucUse::accepted || g.use == FanucUse::refused)
            rows += "| " + name + " | " + (g.use == FanucUse::accepted ? "accepted" : "refused") + " | " +
                    std::string(g.says) + " |\n";
        else
            run += (run.empty() ? "" : ", ") + name;
    }
};

std::string matrix() {
    Matrix mill, haas, lathe, haas_lathe;
    for (const FanucG& g : mill_g_table()) mill.add(code_name(g.code), g);
    for (const FanucG& g : haas_mill_g_table()) haas.add(code_name(g.code), g);
    for (const FanucG& g : haas_lathe_g_table()) haas_lathe.add(code_name(g.code), g);
    for (const LatheG& g : lathe_g_table()) {
        const auto name = [](int n) { return n < 0 ? std::string("-") : code_name(n); };
        const bool one = g.a == g.b && g.b == g.c;
        lathe.add(one ? name(g.a) : name(g.a) + "/" + name(g.b) + "/" + name(g.c), g.meaning);
    }
    const auto table = [](const char* title, const Matrix& m) {
        return std::string("### ") + title + "\nRun: " + m.run +
               "\n\n| code | use | what the control does |\n|---|---|---|\n" + m.rows + "\n";
    };
    return table("Mills", mill) + table("Haas mills, where they differ", haas) +
           table("Lathes (systems A/B/C where they differ)", lathe) +
           table("Haas lathes, where they differ", haas_lathe);
}

}  // namespace

/// The support matrix of the manual page is what the tables say.
TEST(FanucDocs, TheMatrixIsThatOfTheTables) {
    std::ifstream in(std::string(OBRYS_SOURCE_DIR) + "/docs/dialects/fanuc.md");
    const std::string page{std::istreambuf_iterator<char>(in), {}};
    const std::string wanted = matrix();
    EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
}

}  // namespace obrys::dialect::rs274
