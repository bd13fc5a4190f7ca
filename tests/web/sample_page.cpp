// Writes the browser test's page: sample_page <file> [<rows> <columns> <cells>]. With 0 rows: a run that never began.
// Ends with 77 where the library was built without the page's script.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "sample.hpp"

int main(int argc, char** argv) {
    using namespace obrys;
    if (argc != 2 && argc != 5) return 2;
    if (!report::milling_page_available()) {
        std::puts("skipped: built without the milling page's script (OBRYS_PAGE)");
        return 77;
    }
    web_test::Size size;
    if (argc == 5) size = {std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4])};
    const report::MillingPage page = size.rows > 0 ? web_test::sample(size) : web_test::nothing();
    const auto start = std::chrono::steady_clock::now();
    const std::string text = report::milling_page(page);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    std::printf("%zu moves, %zu triangles, page of %.1f MB made in %.0f ms\n", page.path.moves.size(),
                page.surface.indices.size() / 3, static_cast<double>(text.size()) / 1e6, took.count());
    std::ofstream file(argv[1], std::ios::binary);
    file << text;
    return file.good() ? 0 : 1;
}
