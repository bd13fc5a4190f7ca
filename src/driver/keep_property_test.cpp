/// Programs written for another control statement by statement do the same, whatever they compute and wherever they go:
/// random programs, to every control and, where that has the words, on to the next one.

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "driver/keep.hpp"

namespace obrys::driver {
namespace {

/// A SINUMERIK program with parameters, structures and a subprogram; it ends.
class RandomProgram {
public:
    explicit RandomProgram(std::uint32_t seed, bool jumps) : random_(seed), jumps_(jumps) {}

    std::string text() {
        std::string out = "G17 G90 G71\nT1 D1 M6\nS1000 M3\nG94 F200\n";
        for (int r = 1; r <= 5; ++r)
            out += "R" + std::to_string(r) + "=" + std::to_string(one_to(9)) + "." + std::to_string(one_to(9)) + "\n";
        out += "R10=0\nR11=0\nR12=0\nR13=0\nG0 X0 Y0 Z50\n";
        for (int i = 0; i < 6; ++i) out += statement(0);
        return out + "M30\n";
    }
    std::string sub() {
        return "PROC SUB(REAL AA, REAL BB)\nDEF REAL CC\nCC=" + expression(1, true) + "\nIF " + condition(true) +
               "\nG1 X=CC Y=AA\nELSE\nG1 Z=BB\nENDIF\nM17\n";
    }

private:
    int one_to(int n) { return std::uniform_int_distribution<int>(1, n)(random_); }

    std::string operand(bool in_sub) {
        if (in_sub && one_to(2) == 1) return one_to(2) == 1 ? "AA" : "BB";
        return one_to(3) == 1 ? std::to_string(one_to(20)) : "R" + std::to_string(one_to(5));
    }
    std::string expression(int depth, bool in_sub = false) {
        if (depth > 2 || one_to(4) == 1) return operand(in_sub);
        const std::string a = expression(depth + 1, in_sub), b = expression(depth + 1, in_sub);
        switch (one_to(14)) {
            case 1: return "(" + a + "+" + b + ")";
            case 2: return "(" + a + "-" + b + ")";
            case 3: return a + "*0.3";
            case 4: return "(" + a + ")/7";
            case 5: return "MINVAL(" + a + "," + b + ")";
            case 6: return "MAXVAL(" + a + "," + b + ")";
            case 7: return "ROUNDUP(" + a + "+0.013)";
            case 8: return "TRUNC(" + a + "+0.017)";
            case 9: return "ROUND(" + a + "+0.019)";
            case 10: return "10*SIN(" + a + ")";
            case 11: return "SQRT(ABS(" + a + ")+1)";
            case 12: return "ATAN2(" + a + "+0.5," + b + "-30.7)/9";
            case 13: return "((" + a + "+0.0123) MOD 7)";
            default: return "-" + operand(in_sub);
        }
    }
    std::string comparison(bool in_sub) {
        constexpr std::array signs{"<", "<=", ">", ">=", "<>"};
        return "(" + expression(1, in_sub) + "+0.00317)" + signs[static_cast<std::size_t>(one_to(5) - 1)] + "(" +
               expression(1, in_sub) + ")";
    }
    std::string condition(bool in_sub = false) {
        switch (one_to(5)) {
            case 1: return "(" + comparison(in_sub) + ") AND (" + comparison(in_sub) + ")";
            case 2: return "(" + comparison(in_sub) + ") OR (" + comparison(in_sub) + ")";
            case 3: return "NOT ((" + comparison(in_sub) + ") AND (" + comparison(in_sub) + "))";
            default: return comparison(in_sub);
        }
    }
    std::string body(int depth) {
        std::string out;
        for (int i = one_to(2); i > 0; --i) out += statement(depth + 1);
        return out;
    }
    std::string statement(int depth) {
        const std::string counter = "R" + std::to_string(10 + depth), limit = std::to_string(one_to(3));
        switch (one_to(depth < 3 ? (jumps_ ? 11 : 10) : 5)) {
            case 1: return "G0 X=" + expression(0) + "\n";
            case 2: return "G1 X=" + expression(0) + " Y=" + expression(0) + "\n";
            case 3: return "G1 Z=" + expression(0) + "\n";
            case 4: return "R" + std::to_string(one_to(5)) + "=" + expression(0) + "\n";
            case 5: return "SUB(" + expression(1) + "," + expression(1) + ")\n";
            case 6: return "IF " + condition() + "\n" + body(depth) + "ELSE\n" + body(depth) + "ENDIF\n";
            case 7:
                return counter + "=0\nWHILE (" + counter + "<" + limit + ") AND (R5<>1234)\n" + body(depth) + counter +
                       "=" + counter + "+1\nENDWHILE\n";
            case 8: return "FOR " + counter + "=1 TO " + limit + "\n" + body(depth) + "ENDFOR\n";
            case 9:
                return counter + "=0\nREPEAT\n" + body(depth) + counter + "=" + counter + "+1\nUNTIL " + counter +
                       ">=" + limit + "\n";
            case 10: return "IF " + condition() + "\n" + body(depth) + "ENDIF\n";
            default: {
                const std::string label = "MARK" + std::to_string(++labels_);
                return "IF " + condition() + " GOTOF " + label + "\nG1 X=" + expression(1) + "\n" + label + ":\n";
            }
        }
    }

    std::mt19937 random_;
    bool jumps_;
    int labels_ = 0;
};

Request request_of(const std::shared_ptr<const Storage>& storage, const std::string& input) {
    Request request;
    request.input = input;
    request.machine = "mill-generic";
    request.folders = std::make_shared<Folders>(storage);
    return request;
}

/// What was written; empty where the session cannot be opened. It must do the same with three sets of values.
std::string translated(const std::shared_ptr<Memory>& memory, const std::string& input, const std::string& to) {
    Session s;
    const Request request = request_of(memory, input);
    if (!open(request, s)) return {};
    const auto post = find_post(to, s, PostFor::statements);
    const auto language = find_language(to, s);
    EXPECT_TRUE(post && language) << to;
    if (!post || !language) return {};
    const Kept kept = keep(s, *language, "MAIN");
    for (const rewrite::Note& note : kept.rewritten.notes)
        EXPECT_NE(note.fate, rewrite::Fate::lost) << to << ": " << note.what;
    auto sets = other_values(s, kept.rewritten, 2);
    sets.insert(sets.begin(), std::vector<std::string>{});
    for (const auto& set : sets) {
        std::string what;
        const Proved p = prove_with(set, kept, *post, request, {}, what);
        EXPECT_EQ(p.proof, Proof::same) << to << ": " << p.why_not << what << "\n" << kept.rewritten.text;
        if (p.proof != Proof::same && p.run != nullptr)
            for (const base::Diagnostic& d : p.run->diagnostics.all()) ADD_FAILURE() << d.text;
    }
    return kept.rewritten.text;
}

TEST(keep_property, random_programs_do_the_same_on_every_control) {
    std::mt19937 seeds(base::testing_seed());
    for (int n = 0; n < 12 && !::testing::Test::HasFailure(); ++n) {
        const auto seed = static_cast<std::uint32_t>(seeds());
        RandomProgram program(seed, n % 2 == 0);
        auto memory = std::make_shared<Memory>();
        memory->put("MAIN.MPF", program.text());
        memory->put("SUB.SPF", program.sub());
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + program.text());
        for (const char* to : {"heidenhain-itnc530", "fanuc", "haas", "sinumerik-840d", "linuxcnc"}) {
            if (std::string_view(to) == "linuxcnc" && n % 2 == 0) continue;  // it has no jumps
            EXPECT_FALSE(translated(memory, "MAIN.MPF", to).empty());
        }
    }
}

TEST(keep_property, what_was_written_is_translated_on) {
    std::mt19937 seeds(base::testing_seed() + 1);
    for (int n = 0; n < 4 && !::testing::Test::HasFailure(); ++n) {
        const auto seed = static_cast<std::uint32_t>(seeds());
        RandomProgram program(seed, true);
        auto memory = std::make_shared<Memory>();
        memory->put("MAIN.MPF", program.text());
        memory->put("SUB.SPF", program.sub());
        SCOPED_TRACE("seed " + std::to_string(seed));
        memory->put("MAIN.H", translated(memory, "MAIN.MPF", "heidenhain-itnc530"));
        EXPECT_FALSE(translated(memory, "MAIN.H", "sinumerik-840d").empty());
        memory->put("MAIN.NC", translated(memory, "MAIN.MPF", "fanuc"));
        EXPECT_FALSE(translated(memory, "MAIN.NC", "sinumerik-840d").empty());
    }
}

/// What a control can compute with, `a` and `b` for the operands; statements of its own where it has no expressions.
struct Arithmetic {
    const char* file;
    const char* begin;
    const char* set;  ///< {n} and {v}
    const char* end;
    const char *a, *b, *result;
    std::vector<std::string> all;
};

std::string with(std::string text, const std::string& place, const std::string& by) {
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + by.size()))
        text.replace(at, place.size(), by);
    return text;
}

std::vector<Arithmetic> arithmetics_of_iso() {
    return {{"MAIN.NGC",
             "G21 G90 G17\nT1 M6\nS100 M3\n",
             "{n}={v}\n",
             "G0 X{r} Y0 Z0\nM2\n",
             "#101",
             "#102",
             "#103",
             {"a+b",
              "a-b",
              "a*b",
              "a/b",
              "a**2",
              "a**b",
              "a MOD b",
              "a AND b",
              "a OR b",
              "a XOR b",
              "a EQ b",
              "a NE b",
              "a LT b",
              "a LE b",
              "a GT b",
              "a GE b",
              "-a",
              "SIN[a]",
              "COS[a]",
              "TAN[a]",
              "ASIN[a/9]",
              "ACOS[a/9]",
              "ATAN[a]/[b]",
              "SQRT[a*a]",
              "ABS[a]",
              "ROUND[a]",
              "FIX[a]",
              "FUP[a]",
              "LN[ABS[a]+1]",
              "EXP[a]",
              "[a LT b] XOR [b LT 1]",
              "[a XOR b] AND a",
              "1 XOR 0",
              "1+FIX[a]"}},
            {"MAIN.NC",
             "O1\nG21 G90 G17\nT1 M6\nS100 M3\n",
             "{n}={v}\n",
             "G0 X{r} Y0. Z0.\nM30\n",
             "#101",
             "#102",
             "#103",
             {"a+b",         "a-b",       "a*b",    "a/b",      "a MOD b",   "a AND b",    "a OR b",
              "a XOR b",     "-a",        "SIN[a]", "COS[a]",   "TAN[a]",    "ASIN[a/9.]", "ACOS[a/9.]",
              "ATAN[a]/[b]", "SQRT[a*a]", "ABS[a]", "ROUND[a]", "FIX[a]",    "FUP[a]",     "LN[ABS[a]+1.]",
              "EXP[a]",      "BIN[a]",    "BCD[a]", "ADP[a]",   "POW[a,2.]", "[a EQ b]"}}};
}

std::vector<Arithmetic> arithmetics_with_words() {
    return {{"MAIN.MPF",
             "G17 G90 G71\nT1 D1 M6\nS100 M3\n",
             "{n}={v}\n",
             "G0 X={r} Y0 Z0\nM30\n",
             "R1",
             "R2",
             "R3",
             {"a+b",           "a-b",           "a*b",         "a/b",
              "a DIV b",       "a MOD b",       "a==b",        "a<>b",
              "a<b",           "a<=b",          "a>b",         "a>=b",
              "a AND b",       "a OR b",        "a XOR b",     "(a<b) XOR (b<1)",
              "NOT a",         "NOT (a XOR b)", "a B_AND b",   "a B_OR b",
              "a B_XOR b",     "B_NOT a",       "-a",          "SIN(a)",
              "COS(a)",        "TAN(a)",        "ASIN(a/9)",   "ACOS(a/9)",
              "ATAN2(a,b)",    "SQRT(a*a)",     "ABS(a)",      "POT(a)",
              "TRUNC(a)",      "ROUND(a)",      "ROUNDUP(a)",  "LN(ABS(a)+1)",
              "EXP(a)",        "MINVAL(a,b)",   "MAXVAL(a,b)", "BOUND(-9,9,a*b)",
              "TRUE XOR FALSE"}},
            {"MAIN.H",
             "BEGIN PGM MAIN MM\nTOOL CALL 1 Z S100\n",
             "{n} = {v}\n",
             "L X+{r} Y+0 Z+0 R0 FMAX M3\nM30\nEND PGM MAIN MM\n",
             "Q1",
             "Q2",
             "Q3",
             {"a + b",
              "a - b",
              "a * b",
              "a / b",
              "a ^ 2",
              "a % b",
              "- a",
              "SIN a",
              "COS a",
              "TAN a",
              "ASIN ( a / 9 )",
              "ACOS ( a / 9 )",
              "ATAN a",
              "SQRT ( a * a )",
              "SQ a",
              "ABS a",
              "INT a",
              "FRAC a",
              "NEG a",
              "SGN a",
              "LN ( ABS a + 1 )",
              "LOG ( ABS a + 1 )",
              "EXP a"}}};
}

const std::vector<Arithmetic>& arithmetics() {
    static const std::vector<Arithmetic> all = [] {
        std::vector<Arithmetic> every = arithmetics_of_iso();
        for (Arithmetic& a : arithmetics_with_words()) every.push_back(std::move(a));
        return every;
    }();
    return all;
}

/// It says what it cannot write, or what it wrote does the same.
void judge_arithmetic(const Arithmetic& c, const std::string& program, const std::string& to) {
    SCOPED_TRACE(to + "\n" + program);
    auto memory = std::make_shared<Memory>();
    memory->put(c.file, program);
    Session s;
    const Request request = request_of(memory, c.file);
    if (!open(request, s)) return;
    const auto post = find_post(to, s, PostFor::statements);
    const auto language = find_language(to, s);
    ASSERT_TRUE(post && language);
    const Kept kept = keep(s, *language, "MAIN");
    if (kept.rewritten.loses()) return;
    std::string what;
    const Proved p = prove_with({}, kept, *post, request, {}, what);
    if (p.why_not.starts_with("the program ends with an alarm")) return;  // said, and nothing is written
    EXPECT_NE(p.proof, Proof::differs) << p.why_not << what << "\n" << kept.rewritten.text;
}

TEST(keep_property, whatever_a_control_computes_is_written_or_refused) {
    for (const Arithmetic& c : arithmetics())
        for (const std::string& expression : c.all)
            for (const auto& [a, b] : {std::pair("3.", "2."), std::pair("-2.4", "0.5")}) {
                const auto set = [&](const std::string& n, const std::string& v) {
                    return with(with(c.set, "{n}", n), "{v}", v);
                };
                // Names of functions are written in capitals, the operands are not.
                const std::string value = with(with(expression, "a", c.a), "b", c.b);
                const std::string program =
                    c.begin + set(c.a, a) + set(c.b, b) + set(c.result, value) + with(c.end, "{r}", c.result);
                for (const char* to : {"heidenhain-itnc530", "fanuc", "haas", "sinumerik-840d", "linuxcnc"})
                    judge_arithmetic(c, program, to);
            }
}

TEST(keep, names_are_mapped) {
    const NameMap map{{"R3", "Q3"}, {"R4", "Q7"}};
    EXPECT_EQ(mapped({"r3=150", "R5=1", "R4=-2"}, map), (std::vector<std::string>{"Q3=150", "R5=1", "Q7=-2"}));
    EXPECT_FALSE(names_of_ledger("{"));
    EXPECT_FALSE(names_of_ledger("{\"names\": [{\"from\": 1, \"to\": \"Q1\"}]}"));
    const auto names = names_of_ledger(
        "{\"names\": [{\"from\": \"R1\", \"to\": \"Q1\"}, {\"from\": \"A\", \"to\": \"QL1\", \"program\": \"S\"}]}");
    ASSERT_TRUE(names);
    EXPECT_EQ(*names, (NameMap{{"R1", "Q1"}}));
}

}  // namespace
}  // namespace obrys::driver
