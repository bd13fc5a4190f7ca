// Prints what obrys runs of the HEIDENHAIN iTNC 530 as Markdown: the part of docs/dialects/heidenhain.md between its
// marks.
#include <cstdio>
#include <string>

#include "dialect/heidenhain/cycles.hpp"
#include "dialect/heidenhain/functions.hpp"
#include "dialect/heidenhain/g_codes.hpp"
#include "dialect/heidenhain/m_functions.hpp"
#include "dialect/heidenhain/path_functions.hpp"
#include "dialect/heidenhain/sysread.hpp"

namespace {

using namespace obrys::dialect::heidenhain;

std::string_view use_name(Use use) { return name(use); }
std::string_view use_name(Cycle::Use use) {
    return use == Cycle::Use::run ? "run" : use == Cycle::Use::accepted ? "accepted" : "refused";
}

std::string range(int first, int last) {
    return std::to_string(first) + (last > first ? " … " + std::to_string(last) : "");
}

/// A table row; bars inside a cell would end it.
std::string row(std::initializer_list<std::string_view> cells) {
    std::string out = "|";
    for (const std::string_view c : cells) {
        out += ' ';
        for (const char letter : c) out += letter == '|' ? '/' : letter;
        out += c.empty() ? "|" : " |";
    }
    return out + "\n";
}

std::string table(const std::string& title, std::initializer_list<std::string_view> columns) {
    std::string out = "\n### " + title + "\n" + row(columns) + "|";
    for (std::size_t i = 0; i < columns.size(); ++i) out += "---|";
    return out + "\n";
}

std::string path_functions() {
    std::string out = table("Path functions and program words", {"word", "use", "meaning"});
    for (const PathFunction& f : all_path_functions()) out += row({f.word, use_name(f.use), f.text});
    return out;
}

std::string fn_functions() {
    std::string out = table("FN functions", {"FN", "name", "use", "meaning"});
    for (const FnFunction& f : all_fn()) out += row({std::to_string(f.number), f.name, use_name(f.use), f.text});
    return out;
}

std::string sysread() {
    std::string out = table("System data (FN 18: SYSREAD)", {"ID", "NR", "IDX", "use", "meaning"});
    for (const SysReadEntry& e : all_sysread()) {
        const std::string idx = e.idx_last > 0 ? range(e.idx_first, e.idx_last) : "";
        out += row({std::to_string(e.id), range(e.nr, e.nr_last), idx, use_name(e.use), e.text});
    }
    return out;
}

std::string cycles() {
    std::string out = table("Cycles", {"cycle", "name", "acts at", "use", "remark"});
    for (const Cycle& c : all_cycles())
        out += row({std::to_string(c.number), c.name, c.call_active ? "call" : "definition", use_name(c.use), c.text});
    return out;
}

std::string m_functions() {
    std::string out = table("M functions", {"M", "with", "acts at block", "use", "meaning"});
    for (const MFunction& m : all_m())
        out += row(
            {std::to_string(m.number), m.parameters, m.when == When::start ? "start" : "end", use_name(m.use), m.text});
    return out;
}

std::string g_codes() {
    std::string out = table("G codes", {"G", "Klartext", "use", "meaning"});
    for (const GCode& g : all_g())
        out += row({std::to_string(g.number) + (g.block_only ? " *" : ""), g.klartext, use_name(g.use), g.text});
    return out + "\n\\* acts in its block only.\n";
}

}  // namespace

int main() {
    const std::string text = path_functions() + fn_functions() + sysread() + cycles() + m_functions() + g_codes();
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
