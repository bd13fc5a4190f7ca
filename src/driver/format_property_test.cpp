/// obrys fmt changes nothing but the looks: the formatted program makes the same stream and the same complaints.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/files_testing.hpp"
#include "base/text.hpp"
#include "cl/text.hpp"
#include "driver/programs.hpp"
#include "driver/session.hpp"
#include "format/heidenhain/format.hpp"

namespace obrys::driver {
namespace {

using base::testing::content;

namespace fmt = format::heidenhain;

/// What a program does: the records without source places, and the codes of all complaints.
struct FormattedRun {
    std::string records, codes;
    bool operator==(const FormattedRun&) const = default;
};

std::ostream& operator<<(std::ostream& out, const FormattedRun& run_klartext) {
    return out << run_klartext.records << "---\n" << run_klartext.codes;
}

FormattedRun run_klartext(const std::string& text, const fs::path& folder, const char* name = "PART.H") {
    Session s;
    const auto file = s.sources.add(name, text, base::BlockNumbers::leading);
    const Control* control = find_control("heidenhain-itnc530");
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics);
    if (!folder.empty()) s.programs->add_folder(folder);
    s.main = s.programs->read(file);
    s.job.budgets.blocks = 200000;
    FormattedRun out;
    std::string all;
    const auto collect = [&](std::string_view piece) { all += piece; };
    cl::TextWriter writer(collect);
    interpret(s, [&](const cl::Record& record) {
        cl::Record r = record;
        r.from = {};
        r.stack = 0;
        writer(r);
    });
    out.records = std::move(all);
    for (const base::Diagnostic& d : s.diagnostics.all()) out.codes += std::string(d.code) + "\n";
    return out;
}

/// Comments in their order: what stands behind `;` or begins with `*`, to the line's end.
std::vector<std::string> comments(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t at = text.find(';'); at != std::string::npos; at = text.find(';', at)) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        out.emplace_back(base::trim(std::string_view(text).substr(at, end - at)));
        at = end;
    }
    return out;
}

void expect_same_program(const std::string& text, const fs::path& folder, const std::string& name) {
    for (const fmt::Decimal decimal : {fmt::Decimal::keep, fmt::Decimal::comma, fmt::Decimal::point}) {
        const fmt::Options options{decimal, fmt::LineEnds::keep};
        const std::string once = fmt::formatted(text, fmt::Language::klartext, options).text;
        EXPECT_EQ(fmt::formatted(once, fmt::Language::klartext, options).text, once) << name;
        EXPECT_EQ(comments(once), comments(text)) << name;
        EXPECT_EQ(run_klartext(once, folder), run_klartext(text, folder)) << name;
    }
}

TEST(FormatProperty, programs_of_others_run_the_same) {
    const fs::path shared = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared";
    if (!fs::exists(shared)) GTEST_SKIP() << "needs ../shared";
    std::size_t programs = 0, left = 0;
    for (const char* folder : {"corpus/klartext", "programs/heidenhain"})
        for (const auto& entry : fs::recursive_directory_iterator(shared / folder)) {
            const std::string suffix = base::to_upper(entry.path().extension().string());
            if (suffix != ".H" && suffix != ".TXT") continue;
            const std::string text = content(entry.path());
            expect_same_program(text, entry.path().parent_path(), entry.path().string());
            left += fmt::formatted(text, fmt::Language::klartext).left.size();
            ++programs;
        }
    EXPECT_GE(programs, 26u);
    EXPECT_EQ(left, 0u);
}

// --- generated programs, untidy on purpose

std::string any_of(std::initializer_list<const char*> choices) {
    return *rc::gen::elementOf(std::vector<std::string>(choices.begin(), choices.end()));
}

std::string blanks() { return any_of({" ", " ", "  ", "\t", "   "}); }
std::string maybe_blank() { return any_of({"", "", "", " "}); }

std::string number() {
    std::string n = std::to_string(*rc::gen::inRange(0, 200));
    const int form = *rc::gen::inRange(0, 4);
    if (form == 1) n += any_of({".", ","}) + std::to_string(*rc::gen::inRange(0, 1000));
    if (form == 2) n += ".";
    if (form == 3) n = any_of({".", ","}) + std::to_string(*rc::gen::inRange(1, 1000));
    return n;
}

std::string value() {
    if (*rc::gen::inRange(0, 5) == 0) return any_of({"", "+", "-"}) + any_of({"Q1", "q2", "QL3", "QR4"});
    return any_of({"", "+", "-", "- "}) + number();
}

std::string any_case(std::string word) {
    for (char& c : word)
        if (*rc::gen::inRange(0, 6) == 0 && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return word;
}

std::string path_word() {
    switch (*rc::gen::inRange(0, 8)) {
        case 0: return any_of({"F", "f"}) + maybe_blank() + any_of({"MAX", "AUTO"});
        case 1: return "F" + maybe_blank() + number();
        case 2: return any_of({"R0", "RL", "RR", "R", "R 0"});
        case 3: return any_of({"M3", "M8", "M", "M99", "m5"});
        case 4: return any_of({"I", "i"}) + any_of({"X", "Y", "Z"}) + value();
        default: return any_of({"X", "Y", "Z", "x", "A", "C"}) + maybe_blank() + value();
    }
}

std::string path_block() {
    std::string out = any_case(any_of({"L", "L", "L", "CC", "C", "CR", "CT", "LP", "CP", "RND", "STOP", "APPR LT"}));
    const int n = *rc::gen::inRange(0, 5);
    for (int i = 0; i < n; ++i) out += blanks() + path_word();
    if (*rc::gen::inRange(0, 5) == 0) out += blanks() + any_of({"DR+", "DR-", "R20", "PA+30", "IPA-7", "PR 5"});
    return out;
}

std::string formula() {
    std::string out = any_of({"Q1", "Q2", "QL3", "qr4"}) + maybe_blank() + "=" + maybe_blank() + value();
    const int n = *rc::gen::inRange(0, 4);
    for (int i = 0; i < n; ++i)
        out += maybe_blank() + any_of({"+", "-", "*", "/", "^"}) + maybe_blank() +
               any_of({"", "SIN ", "sqrt ", "INT", "( - 3 + 2 ) *"}) + number();
    return out;
}

std::string other_block() {
    return any_of({"LBL 1",
                   "lbl2",
                   "LBL 0",
                   "LBL \"a B\"",
                   "CALL LBL  3 REP2",
                   "FN9:IF +Q1 EQU  +Q2 goto LBL7",
                   "FN 0:Q5=-3,5",
                   "FN 1: Q1 = +Q2 + -5",
                   "FN 18: SYSREAD Q5 = ID20 NR1",
                   "TOOL CALL 1 Z  S800 dl0.1",
                   "TOOL DEF 1 L0 R+5",
                   "CYCL DEF 7.0 DATUM",
                   "CYCL DEF 7.1  X10",
                   "CYCL DEF 200 Drill ~\nQ200 = 2;a ~\n Q201=-5",
                   "CYCL DEF 200 Drill\nQ200=2\n;x\nQ201=-5",
                   "cycl call  M3",
                   "CYCL DEF 9.1 5",
                   "PLANE RESET  stay",
                   "BLK FORM 0.1 Z X0 Y0 Z-10",
                   "BLK FORM 0,2 X+10 Y1 Z0",
                   "* structure  x",
                   "CALL PGM  TNC:\\a.h",
                   "L X+1 ~\n  Y 2",
                   "L M ~\n 99",
                   "Q7 = 1 ~\n + 2",
                   "; c ~\n 12 L X+5",
                   "nonsense x1",
                   "L X+1.2.3",
                   "X+5 F100",
                   "M3",
                   "FOO",
                   "12.5 L",
                   "L X+1 \r Y+2",
                   "LBL \"open",
                   "FN 16: F-PRINT a.b/C.d"});
}

std::string any_program() {
    std::string out = any_of({"BEGIN PGM P MM\n", "0 BEGIN PGM P MM\n", "0  begin pgm P INCH\r\n", ""});
    const int n = *rc::gen::inRange(1, 14);
    const int numbering = *rc::gen::inRange(0, 3);
    for (int i = 0; i < n; ++i) {
        if (numbering > 0 && *rc::gen::inRange(0, 10) < 9)
            out += any_of({"", "", "", "/", " "}) + std::to_string(i * 3) + any_of({" ", " ", "  ", " /"});
        const int kind = *rc::gen::inRange(0, 8);
        out += kind < 4 ? path_block() : kind < 5 ? formula() : kind < 7 ? other_block() : std::string{};
        out +=
            any_of({"", "", "", " ", " ;note  x", ";a ~", "  ", " ~"}) + any_of({"\n", "\n", "\r\n", "\n\n", "\n  \n"});
    }
    return out + any_of({"99 END PGM P MM\n", "END PGM P MM", ""});
}

RC_GTEST_PROP(FormatProperty, untidy_programs_run_the_same, ()) {
    const std::string text = any_program();
    const fmt::Options options{*rc::gen::element(fmt::Decimal::keep, fmt::Decimal::point, fmt::Decimal::comma),
                               fmt::LineEnds::keep};
    const std::string once = fmt::formatted(text, fmt::Language::klartext, options).text;
    RC_LOG(text + "=== formatted ===\n" + once);
    RC_ASSERT(fmt::formatted(once, fmt::Language::klartext, options).text == once);
    RC_ASSERT(comments(once) == comments(text));
    RC_ASSERT(run_klartext(once, {}) == run_klartext(text, {}));
}

// --- DIN/ISO

std::string iso_word() {
    switch (*rc::gen::inRange(0, 6)) {
        case 0: return any_of({"F500", "F 250", "f100"});
        case 1: return any_of({"M3", "m8", "M99", "S1000", "T1"});
        case 2: return any_of({"I", "J", "H", "R"}) + value();
        default: return any_of({"X", "Y", "Z", "x", "A"}) + maybe_blank() + value();
    }
}

std::string iso_block() {
    const int kind = *rc::gen::inRange(0, 6);
    if (kind == 0) return formula();
    if (kind == 1)
        return any_of({"G98 L1", "g98 L0", "L1,3", "L2,0", "D00 Q1 P01  +10", "D09 P01 +Q1 P02 +0 P03 7", "G54 X10 Y-5",
                       "%SUB", "G200 Drilling Q200=2 Q201=-5", "G83 P01 +2 P02 -20 P03 5", "* structure", "G53 P01 5",
                       "foo", "G 01 X5", "G00 X1 ~\n  Y2", "G200 Drilling ~\nQ200 = 2 ;a ~\nQ201=-5",
                       "G200 Drilling\nQ200=2 ;x\n Q201=-5"});
    std::string out = any_of({"G00", "g01", "G1", "G02", "G03", "G40 G90", "G91", "G41", "G10", "G11", "G12"});
    const int n = *rc::gen::inRange(0, 5);
    for (int i = 0; i < n; ++i) out += any_of({" ", " ", "  ", ""}) + iso_word();
    return out;
}

std::string any_iso_program() {
    std::string out = any_of({"%P G71 *\n", "%P G70*\r\n", "% P G71 *\n"});
    const int n = *rc::gen::inRange(1, 14);
    for (int i = 0; i < n; ++i) {
        out +=
            any_of({"", "", "", "/", " "}) + "N" + std::to_string(i * 5) + any_of({" ", " ", "  ", ""}) + iso_block();
        out +=
            any_of({"*", "*", " *", " * ;note  x", "*;n", "", " "}) + any_of({"\n", "\n", "\r\n", "\n\n", "\n;c  d\n"});
    }
    return out + any_of({"N99999999 %P G71 *\n", "N99999 M30 *\nN99999999 %P G71 *", ""});
}

RC_GTEST_PROP(FormatProperty, untidy_iso_programs_run_the_same, ()) {
    const std::string text = any_iso_program();
    const fmt::Options options{*rc::gen::element(fmt::Decimal::keep, fmt::Decimal::point, fmt::Decimal::comma),
                               fmt::LineEnds::keep};
    const std::string once = fmt::formatted(text, fmt::Language::iso, options).text;
    RC_LOG(text + "=== formatted ===\n" + once);
    RC_ASSERT(fmt::formatted(once, fmt::Language::iso, options).text == once);
    RC_ASSERT(comments(once) == comments(text));
    RC_ASSERT(run_klartext(once, {}, "PART.I") == run_klartext(text, {}, "PART.I"));
}

}  // namespace
}  // namespace obrys::driver
