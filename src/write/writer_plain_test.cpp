/// What most moves need not be asked again: the same comes out where each of them is asked.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

/// Few numbers, so that words often hold; two of them are the same in three decimals.
double coordinate() { return *rc::gen::element<double>(0.0, -0.0, 1.0, 1.0001, -2.5, 10.125, NAN); }

cl::Step any_step() {
    const auto number = [](int least, int most) { return *rc::gen::inRange(least, most); };
    switch (number(0, 14)) {
        case 0: return cl::Feed{100.0 * number(0, 3), static_cast<cl::FeedMode>(number(0, 2))};
        case 1:
            return cl::Spindle{1000.0 * number(0, 3), cl::SpindleMode::rpm, static_cast<std::int8_t>(number(-1, 2))};
        case 2: return cl::Coolant{number(0, 2) == 1, number(0, 2) == 1};
        case 3:
            return cl::ToolLength{static_cast<std::int8_t>(number(0, 2)), static_cast<std::uint32_t>(number(1, 3)), {}};
        case 4: return cl::Datum{static_cast<std::uint32_t>(number(54, 56)), {coordinate(), 0, 0}};
        case 5: {
            cl::Frame frame;
            if (number(0, 2) == 1)
                frame.parts.push_back({cl::FrameKind::rotation, geom::Frame::rotation(2, geom::radians(number(0, 3)))});
            if (!frame.parts.empty() && number(0, 3) == 0) frame.parts.front().frame.origin.x = NAN;
            return frame;
        }
        case 6: return cl::Tolerance{0.01 * number(0, 3), 0, cl::Filter::none};
        case 7: return cl::PathMode{static_cast<cl::PathKind>(number(0, 4))};
        case 8: return cl::Arc{{coordinate(), 1, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi};
        case 9: return cl::ToolChange{static_cast<std::uint32_t>(number(1, 3)), 1, {}};
        default: {
            const double x = coordinate(), y = coordinate(), z = coordinate();
            return cl::Linear{{x, y, z}, {0, 0, 1}, number(0, 3) == 0};
        }
    }
}

Post shipped(const std::string& name) { return post_of(std::string(shipped_post(name)->text)); }

/// The end of a lead writes nothing, but behind it all that holds is looked at.
RC_GTEST_PROP(Writer, WhatHoldsIsLookedAtWhereItMayBeAnother, ()) {
    static const std::vector<Post> posts{shipped("heidenhain-itnc530"), shipped("haas"),
                                         post_of("extends = \"fanuc\"\n"), shipped("sinumerik-840d")};
    const Post& post = posts[*rc::gen::inRange<std::size_t>(0, posts.size())];
    std::vector<cl::Step> steps, asked;
    for (int n = *rc::gen::inRange(0, 30); n > 0; --n) {
        steps.push_back(any_step());
        asked.push_back(steps.back());
        asked.push_back(cl::LeadEnd{});
    }
    const Written plain = write(post, steps), looked = write(post, asked);
    RC_ASSERT(plain.text == looked.text);
    RC_ASSERT(plain.lost == looked.lost);
    RC_ASSERT(plain.expanded == looked.expanded);
}

TEST(Writer, WhatHoldsIsWrittenBehindAnyNumberOfStraightMoves) {
    const Written w = write(shipped("heidenhain-itnc530"),
                            {cl::Feed{100}, cl::Linear{{1, 2, 3}}, cl::Linear{{2, 2, 3}},
                             cl::Spindle{1000, cl::SpindleMode::rpm, 1}, cl::Linear{{3, 2, 3}}, cl::Linear{{4, 2, 3}}});
    EXPECT_NE(w.text.find("2 L X+2\n3 TOOL CALL S1000\n4 M3\n5 L X+3\n6 L X+4\n"), std::string::npos) << w.text;
}

/// Words are left out where they would be the same text as the last of their letter, however they are found to be.
RC_GTEST_PROP(Printer, LeavesOutAWordThatItsTextSaysAlready, ()) {
    const Post post = post_of(
        "[modal]\ncoordinates = [\"X\", \"Y\"]\nwords = [\"F\"]\n[numbers]\nlength = { decimals = 3, plus = true }\n"
        "fine = { decimals = 1 }\n"
        "[motion]\nlinear = \"G1 X{x} Y{y} F{feed}\"\nrapid = \"G0 X{x*-1:fine} Y{y} F{feed!}\"\n");
    std::vector<std::string> printed;
    Printer printer(post, [&](std::string_view block) { printed.emplace_back(block); });
    std::string x = "", y = "", f = "";
    for (int n = *rc::gen::inRange(1, 30); n > 0; --n) {
        const bool rapid = *rc::gen::arbitrary<bool>();
        const Template& form = post[rapid ? Command::rapid : Command::linear];
        const double to_x = coordinate(), to_y = coordinate(), feed = *rc::gen::inRange(1, 3);
        Values values;
        values.set(Value::x, to_x), values.set(Value::y, to_y), values.set(Value::feed, feed);
        printed.clear();
        const Printed how = printer.print(form, values);
        const NumberStyle& of_x = post.styles[form.front()[1].style];
        std::string wanted = rapid ? "G0" : "G1", new_x = "X", new_y = "Y", new_f = "F";
        const bool known = append_number(new_x, rapid ? -to_x : to_x, of_x) &&
                           append_number(new_y, to_y, post.styles[form.front()[2].style]) &&
                           append_number(new_f, feed, post.styles[form.front()[3].style]);
        RC_ASSERT((how == Printed::failed) == !known);
        if (!known) continue;
        if (new_x != x) wanted += " " + new_x;
        if (new_y != y) wanted += " " + new_y;
        if (new_f != f || rapid) wanted += " " + new_f;
        x = new_x, y = new_y, f = new_f;
        const bool says = wanted.size() > 2;  // a block without a word that is asked for is none
        RC_ASSERT(printed == (says ? std::vector<std::string>{wanted} : std::vector<std::string>{}));
    }
}

}  // namespace
}  // namespace obrys::write
