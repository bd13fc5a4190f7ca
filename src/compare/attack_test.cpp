/// Nothing that makes a difference is called equal: each word of each record is changed, one at a time, in the middle
/// of streams at random, and has to be found. The words come from the text form, so that a field that is added to a
/// record is attacked as soon as a line here has it; the one table of exceptions says what makes no difference, and
/// why.

#include <set>

#include "base/seed_testing.hpp"
#include "base/text.hpp"
#include "compare/streams_testing.hpp"

namespace obrys::compare {
namespace {

/// A line, and what has to stand before it. All kinds, with all their words; more than one where words exclude others.
struct Attacked {
    std::string line;
    std::vector<std::string> before = {};
    bool is_annotation = false;  ///< the machine does not do it: it has to be found in any aspect, not in what is done
};

const std::vector<Attacked>& attacked() {
    static const std::string frame = "by 0 -1 0 1 0 0 0 0 1";
    static const std::vector<Attacked> lines{
        {"linear 3 4 5 axis 0 0.6 0.8"},
        {"rapid 3 4 5 axis 0 0.6 0.8"},
        {"linear 3 4 5 axis 0 0 1 seeks contact"},
        {"arc 10 0 2 centre 0 0 0 normal 0 0 1 sweep 1.5", {"linear 0.7073720166770291 -9.974949866040545 0"}},
        {"arc 10 0 2 centre 0 0 0 normal 0 0 1 sweep 1.5 rapid", {"linear 0.7073720166770291 -9.974949866040545 0"}},
        {"spline 1 2 3 k3 1 2 3 k2 3 2 1 k1 4 5 6 axis 0 0.6 0.8 \"A\" 10 1 2 3 deg \"U\" 10 1 2 3 mm"},
        {"axis \"C\" 30 deg counted | linear 3 4 5"},
        {"axis \"U\" 30 mm | linear 3 4 5"},
        {"thread 3 4 5 pitch 1.5 tap start 30 change 0.1"},
        {"thread 3 4 5 pitch 1.5 axis 0 0.6 0.8"},
        {"arc 10 0 2 centre 0 0 0 normal 0 0 1 sweep 1.5 axis 0 0.6 0.8",
         {"linear 0.7073720166770291 -9.974949866040545 0"}},
        {"machine home 2 x 1 y 2 z 3"},
        {"machine coordinates x 1 y 2 z 3"},
        {"dwell 2 0"},
        {"dwell 0 5"},
        {"feed 111 mm/min"},
        {"feed 0.11 mm/rev"},
        {"spindle 700 1/min cw limit 3000"},
        {"spindle 150 m/min ccw limit 2000"},
        {"spindle 0 1/min stop limit 0 held 30"},
        {"tool 7 edge 2 \"MILL\" raised 0.1 wider 0.2 lengthened offset 3"},
        {"tool 7 edge 3 \"\" offset 3"},
        {"tool 7 edge 1 \"\" offset 7"},
        {"tool-data 5 edge 2 length 100 radius 4"},
        {"zero-data 55 1 2 3 turned 0.5 added"},
        {"length added offset 4"},
        {"length subtracted offset 4"},
        {"length added offset 0 by 1 2 3"},
        {"coolant flood mist"},
        {"stop optional"},
        {"stop end pallets", {}, true},
        {"other-spindle 2 speed 700"},
        {"other-spindle 2 cw"},
        {"other-spindle 2 held 30"},
        {"other-spindle 2 limit 2000"},
        {"other-spindle 2 function 41"},
        {"datum 55 1 2 3"},
        {"frame shift 1 2 3 " + frame + " plane 1 2 3 " + frame, {}, true},
        {"tolerance 0.03 rotary 0.2 roughing", {}, true},
        {"path within tolerance 0.02 merge 0.01 way 642", {}, true},
        {"aux \"M\" 33"},
        {"aux \"H\" 33 extension 2"},
        {"output 3 analog 0.5 with-motion"},
        {"override feed off"},
        {"cycle drill \"C\" at 1 2 3 plane 1 2 3 " + frame +
             " modal pass 2 of 3 clearance 2 depth -20 written \"Q200\" 2",
         {},
         true},
        {"compensation left radius 5 offset 3 around sharp normal 0 1 0", {}, true},
        {"programmed 1 2 3 to 4 5 6 rapid chamfer 2 feed 30", {}, true},
        {"programmed 1 2 3 to 1 5 3 centre 1 3.5 3 normal 0 0 1 sweep 3.2 rounding 2", {}, true},
        {"call \"P\" pass 1 of 2 with \"D\" 3 \"N\" \"T\"", {}, true},
        {"lead onto tangent-arc at 1 2 3 length 4 radius 5 angle 1 feed 6", {}, true},
    };
    return lines;
}

std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t end = std::min(line.find(' ', i), line.size());
        if (end > i) out.push_back(line.substr(i, end - i));
        i = end + 1;
    }
    return out;
}

/// Words of every list of words in the text form, and flags.
const std::vector<std::string>& vocabulary() {
    static const std::vector<std::string> words = words_of(
        "linear rapid contact contact-or-end release release-or-end deg mm counted tap coordinates home "
        "fixed mm/min mm/rev 1/min m/min cw ccw stop standing lengthened added off subtracted flood "
        "mist program optional end analog with-motion feed spindle adaptive-feed feed-hold on none "
        "finishing roughing precision semi-finishing exact exact-stop free within shift rotation mirror "
        "scaling plane datum drill peck tap-rigid clearance depth surface modal pattern left right "
        "normal around smooth sharp chamfer chamfer-leg rounding onto tangent-line normal-line "
        "tangent-arc arc-and-line x y z");
    return words;
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : " ") + w;
    return out;
}

bool is_number(const std::string& word) { return word.find_first_not_of("0123456789.-?") == std::string::npos; }

/// All lines with one word changed, or one left out (with its number) that are a record, and another one.
std::set<std::string> changes_of(const std::string& line) {
    std::set<std::string> out;
    const auto same = step_of(line);
    const auto offer = [&](const std::vector<std::string>& words) {
        const auto changed = step_of(joined(words));
        if (changed && line_of(*changed) != line_of(*same)) out.insert(joined(words));
    };
    const std::vector<std::string> words = words_of(line);
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::vector<std::string> changed = words;
        const auto with = [&](const std::string& word) { changed[i] = word, offer(changed); };
        if (words[i] == "?") {
            with("7");
        } else if (is_number(words[i])) {
            with(base::trim(words[i]).find('.') == std::string_view::npos ? std::to_string(std::stoi(words[i]) + 1)
                                                                          : "0.37");
            with("?");
            if (words[i] == "0") with("1");
        } else if (words[i].starts_with('"')) {
            with("\"X\"");
            with("\"Y\"");
        } else {
            for (const std::string& other : vocabulary()) with(other);
        }
        changed = words;
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
        offer(changed);
        if (i + 1 < words.size()) changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i)), offer(changed);
    }
    for (const char* more :
         {"rapid", "counted", "added", "standing", "mist", "with-motion", "tap", "sharp", "pallets"}) {
        std::vector<std::string> longer = words;
        longer.emplace_back(more);
        offer(longer);
    }
    return out;
}

/// The machine does the same, and the program says the same.
bool makes_no_difference(const cl::Step& a, const cl::Step& b) {
    const auto* arc = std::get_if<cl::Arc>(&a);
    if (arc != nullptr && std::holds_alternative<cl::Arc>(b)) {  // the centre's height along the axis
        cl::Arc other = std::get<cl::Arc>(b);
        other.centre.z = arc->centre.z;
        return other == *arc;
    }
    const auto* spindle = std::get_if<cl::Spindle>(&a);
    const auto* turning = std::get_if<cl::Spindle>(&b);
    if (spindle != nullptr && turning != nullptr && spindle->direction == 0 && turning->direction == 0)
        return spindle->held == turning->held || (spindle->held && turning->held && std::isnan(*spindle->held) &&
                                                  std::isnan(*turning->held));  // a standing spindle has no speed
    const auto* cycle = std::get_if<cl::CycleBegin>(&a);
    const auto* cycle_b = std::get_if<cl::CycleBegin>(&b);
    if (cycle != nullptr && cycle_b != nullptr) {  // remarks
        cl::Cycle x = *cycle->cycle, y = *cycle_b->cycle;
        return x.kind == y.kind && x.values == y.values && x.plane == y.plane && cycle->place == cycle_b->place &&
               cycle->call == cycle_b->call && cycle->pass == cycle_b->pass && cycle->passes == cycle_b->passes;
    }
    const auto* side = std::get_if<cl::CompensationBegin>(&a);
    if (side != nullptr && std::holds_alternative<cl::CompensationBegin>(b)) {  // the radius says what it holds
        cl::CompensationBegin other = std::get<cl::CompensationBegin>(b);
        const bool unknown = !side->given && !(std::abs(side->radius) > 0) && side->offset != 0 && other.offset != 0;
        if (!unknown || other.given) other.offset = side->offset;
        return other == *side;
    }
    const auto* length = std::get_if<cl::ToolLength>(&a);
    const auto* length_b = std::get_if<cl::ToolLength>(&b);
    if (length != nullptr && length_b != nullptr)  // where values are said, no number counts
        return length->by && length->by == length_b->by && length->sense == length_b->sense;
    // A reference point of known coordinates, and the same coordinates.
    const auto* place = std::get_if<cl::MachinePlace>(&a);
    const auto* place_b = std::get_if<cl::MachinePlace>(&b);
    if (place != nullptr && place_b != nullptr) {
        const auto named = [](const cl::MachinePlace& p) {
            return p.kind == cl::PlaceKind::home || p.kind == cl::PlaceKind::coordinates;
        };
        cl::MachinePlace other = *place_b;
        other.kind = place->kind, other.number = place->number;
        return named(*place) && named(*place_b) && place->kind != place_b->kind && other == *place &&
               is_finite(place->to);
    }
    // A zero with another number at the same place; or nobody knows whether it is another one.
    const auto* datum = std::get_if<cl::Datum>(&a);
    const auto* datum_b = std::get_if<cl::Datum>(&b);
    if (datum != nullptr && datum_b != nullptr)
        return datum->origin == datum_b->origin || (datum->number == datum_b->number && !is_finite(datum_b->origin));
    // The offset of the tool's own number is its first edge, any other one the edge of that number.
    const auto* tool = std::get_if<cl::ToolChange>(&a);
    const auto* tool_b = std::get_if<cl::ToolChange>(&b);
    if (tool != nullptr && tool_b != nullptr) {
        const auto edge = [](const cl::ToolChange& t) { return t.offset != 0 && t.offset == t.number ? 1 : t.edge; };
        const auto named = [](const cl::ToolChange& t) {
            return t.offset != 0 && t.offset != t.number && t.offset != t.edge;
        };
        cl::ToolChange x = *tool, y = *tool_b;
        if (edge(x) != edge(y) || named(x) || named(y)) return false;
        x.edge = y.edge = x.offset = y.offset = 0;
        return x == y;
    }
    return false;
}

TEST(Attack, EveryWordIsFound) {
    const std::uint32_t seed = base::testing_seed();
    AnyStream any(seed);
    std::size_t tried = 0;
    for (const Attacked& attack : attacked()) {
        const auto original = step_of(attack.line);
        ASSERT_TRUE(original) << attack.line;
        for (const std::string& line : changes_of(attack.line)) {
            const cl::Step changed = *step_of(line);
            if (makes_no_difference(*original, changed)) continue;
            for (int times = 0; times < 8; ++times, ++tried) {
                Steps a = any.any(any.below(12)), b;
                for (const cl::Step& step : steps_of(attack.before)) a.push_back(step);
                b = a;
                // What it holds for: a move to another height, one at feed, and the tool standing.
                Steps behind = steps_of({"feed 77 mm/min", "rapid 61 62 63", "linear 64 65 66", "dwell 1 0"});
                if (std::holds_alternative<cl::Feed>(*original)) behind.erase(behind.begin());
                for (const cl::Step& step : any.any(any.below(12))) behind.push_back(step);
                a.push_back(*original), b.push_back(changed);
                a.insert(a.end(), behind.begin(), behind.end());
                b.insert(b.end(), behind.begin(), behind.end());
                if (any.one_in(2)) b = any.cut(b, 4);
                const Result r = compared(a, b, {.same_control = true});
                const bool found = std::any_of(r.first.begin(), r.first.end(), [&](const Difference& d) {
                    return attack.is_annotation || is_done(d.aspect);
                });
                EXPECT_TRUE(found) << "seed " << seed << "\n" << attack.line << "\n" << line;
                if (!found) break;
            }
        }
    }
    EXPECT_GT(tried, 3000U);
}

/// The zero in front of the first move, where nothing before it could tell that it is another one.
TEST(Attack, AZeroBeforeTheFirstMove) {
    const auto with = [](const std::string& datum) {
        Steps out = datum.empty() ? Steps{} : steps_of({datum});
        for (const cl::Step& step : steps_of({"rapid 1 2 30", "feed 100 mm/min", "linear 1 2 0"})) out.push_back(step);
        return out;
    };
    for (const std::string original : {"datum 54 10 20 30", "datum 54 ? ? ?", "datum 55 ? 20 ?"})
        for (const std::string& changed : changes_of(original)) {
            if (makes_no_difference(*step_of(original), *step_of(changed))) continue;
            const Result r = compared(with(original), with(changed), {.same_control = true});
            EXPECT_TRUE(std::any_of(r.first.begin(), r.first.end(),
                                    [](const Difference& d) { return is_done(d.aspect) || d.aspect == Aspect::datum; }))
                << original << "; " << changed;
        }
    for (const std::string datum : {"datum 54 10 20 30", "datum 54 ? ? ?"}) {
        EXPECT_FALSE(compared(with(datum), with(""), {.same_control = true}).first.empty()) << datum;
        EXPECT_FALSE(compared(with(""), with(datum), {.same_control = true}).first.empty()) << datum;
    }
}

/// A record more or less, wherever it stands.
TEST(Attack, EveryRecordTooManyIsFound) {
    const std::uint32_t seed = base::testing_seed();
    AnyStream any(seed);
    for (const Attacked& attack : attacked()) {
        for (int times = 0; times < 50; ++times) {
            Steps a = any.any(any.below(12));
            for (const cl::Step& step : steps_of(attack.before)) a.push_back(step);
            Steps b = a;
            b.push_back(*step_of(attack.line));
            for (const cl::Step& step : steps_of({"rapid 61 62 63", "linear 64 65 66", "dwell 1 0"}))
                a.push_back(step), b.push_back(step);
            const bool swap = any.one_in(2);
            const Result r = compared(swap ? b : a, swap ? a : b, {.same_control = true});
            const bool found = std::any_of(r.first.begin(), r.first.end(), [&](const Difference& d) {
                return attack.is_annotation || is_done(d.aspect);
            });
            EXPECT_TRUE(found) << "seed " << seed << "\n" << attack.line << "\n" << text_of(a);
            if (!found) break;
        }
    }
}

}  // namespace
}  // namespace obrys::compare
