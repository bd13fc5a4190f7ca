#include "write/samples.hpp"

#include <algorithm>

#include "cl/text.hpp"

namespace obrys::write {

namespace {

using cl::CycleRole;

cl::Linear line(const geom::Vec3& to, bool rapid = false) { return {to, {0, 0, 1}, rapid}; }

/// Makes samples where the tool stands.
class Maker {
public:
    explicit Maker(bool turning) : turning_(turning), at_(sample_place(turning)) {}

    void add(std::string name, std::vector<cl::Step> steps) {
        std::string kind = cl::to_text(cl::Record{steps.front(), {}, 0});
        kind.erase(std::min(kind.find_first_of(" \n"), kind.size()));
        samples.push_back({std::move(name), std::move(kind), std::move(steps)});
    }
    /// Of what holds from then on: a move follows.
    void add_modal(std::string name, cl::Step step) { add(std::move(name), {std::move(step), next()}); }
    [[nodiscard]] cl::Step next() const { return line(at_ + along_x(10)); }
    [[nodiscard]] geom::Vec3 along_x(double by) const {
        return turning_ ? geom::Vec3{0, 0, -by} : geom::Vec3{by, 0, 0};
    }

    void moves();
    void modes();
    void tools();
    void places();
    void frames();
    void contours();
    void events();
    std::vector<Sample> samples;

private:
    bool turning_;
    geom::Vec3 at_;
};

void Maker::moves() {
    add("rapid", {line(at_ + along_x(30), true)});
    add("line", {line(at_ + along_x(30))});
    const geom::Vec3 normal = turning_ ? geom::Vec3{0, 1, 0} : geom::Vec3{0, 0, 1};
    const geom::Vec3 centre = at_ + along_x(10);
    const auto arc = [&](double sweep, double rise) {
        const geom::Vec3 u = at_ - centre, v = geom::cross(normal, u);
        const double angle = sweep / 360 * geom::full_turn;
        return cl::Arc{centre + std::cos(angle) * u + std::sin(angle) * v + rise * normal, centre, normal, angle,
                       false};
    };
    add("arc counter-clockwise, a quarter", {arc(90, 0)});
    add("arc clockwise, more than a half", {arc(-225, 0)});
    if (!turning_) {
        add("circle", {arc(360, 0)});
        add("helix, half a turn", {arc(180, -2)});
        add("helix, two turns and a half", {arc(-900, -5)});
        const geom::Vec3 beside{at_.x, at_.y, at_.z - 5};
        add("arc in the plane of Z and X", {cl::Arc{{at_.x + 5, at_.y, at_.z - 5}, beside, {0, 1, 0}, geom::pi / 2}});
    }
    add("cubic", {cl::Spline{at_ + along_x(10), {}, {}, along_x(-10), {0, 0, 1}, {}}});
    const auto with = [&](const cl::AxisEnd& axis) {
        cl::Linear along = line(at_ + along_x(10));
        along.ends = {axis};
        return along;
    };
    add("rotary axis with a line", {with({{'C'}, 30, true})});
    add("numbered axis with a line", {with({{'C', '2'}, 30, true})});
    add("thread", {cl::Thread{at_ + geom::Vec3{0, 0, -10}, 1.5, false}});
    add("thread, begun at an angle", {cl::Thread{at_ + geom::Vec3{0, 0, -10}, 1.5, false, 90}});
    add("thread whose pitch rises", {cl::Thread{at_ + geom::Vec3{0, 0, -10}, 1.5, false, 0, 0.1}});
    for (const cl::Seek seek :
         {cl::Seek::contact, cl::Seek::contact_or_end, cl::Seek::release, cl::Seek::release_or_end})
        add("probing move " + std::to_string(static_cast<int>(seek)),
            {cl::Linear{at_ + along_x(10), {0, 0, 1}, false, seek}});
    if (!turning_)
        add("rigid tapping", {cl::Thread{at_ + geom::Vec3{0, 0, -10}, 1.5, true}, cl::Thread{at_, 1.5, true}});
}

void Maker::modes() {
    add_modal("feed, mm/min", cl::Feed{123.5});
    add_modal("feed, mm a revolution", cl::Feed{0.25, cl::FeedMode::per_rev});
    add_modal("feed, inverse time", cl::Feed{2, cl::FeedMode::inverse_time});
    add_modal("spindle counter-clockwise", cl::Spindle{800, cl::SpindleMode::rpm, -1});
    add_modal("spindle stops", cl::Spindle{1000, cl::SpindleMode::rpm, 0});
    add_modal("constant cutting speed, with a limit", cl::Spindle{150, cl::SpindleMode::surface, 1, 2500});
    add_modal("spindle held at an angle", cl::Spindle{1000, cl::SpindleMode::rpm, 0, 0, 90.0});
    add_modal("coolant, flood", cl::Coolant{true, false});
    add_modal("coolant, mist", cl::Coolant{false, true});
    add_modal("coolant, both", cl::Coolant{true, true});
    add("coolant off", {cl::Coolant{true, false}, next(), cl::Coolant{}, line(at_)});
    add_modal("tolerance, finishing", cl::Tolerance{0.02, 0, cl::Filter::finishing});
    add_modal("tolerance, roughing, with rotary axes", cl::Tolerance{0.05, 0.1, cl::Filter::roughing});
    add("tolerance taken back", {cl::Tolerance{0.02, 0, cl::Filter::finishing}, next(), cl::Tolerance{}, line(at_)});
    add_modal("exact path", cl::PathMode{cl::PathKind::exact});
    add_modal("exact stop", cl::PathMode{cl::PathKind::exact_stop});
    add("corners rounded", {cl::PathMode{cl::PathKind::exact}, next(), cl::PathMode{cl::PathKind::free}, line(at_)});
    add_modal("corners rounded within a tolerance", cl::PathMode{cl::PathKind::within, 0.05});
}

void Maker::tools() {
    cl::ToolChange second{2, 1, {}};
    second.with_length = true;
    add_modal("another tool", second);
    cl::ToolChange raised = second;
    raised.raised = 0.2;
    add_modal("another tool, raised (DL)", raised);
    cl::ToolChange by_name = second;
    by_name.number = 0, by_name.name = "DRILL_8";
    add_modal("a tool by its name", by_name);
    add_modal("no tool", cl::ToolChange{0, 1, {}});
    cl::ToolChange standing{1, 1, {}};
    standing.standing = standing.with_length = true;
    add_modal("the tool in the spindle", standing);
    add("what a tool is", {cl::ToolData{3, 1, 50.0, 4.0}});
    add_modal("length of the tool added", cl::ToolLength{1, 1, {}});
    add_modal("length of the tool subtracted", cl::ToolLength{-1, 1, {}});
    add_modal("length of the tool by values", cl::ToolLength{1, 0, geom::Vec3{0, 0, 12.5}});
    add_modal("length of the tool off", cl::ToolLength{});
}

void Maker::places() {
    using cl::MachinePlace, cl::PlaceKind;
    constexpr std::array z{false, false, true};
    const geom::Vec3 unknown{NAN, NAN, NAN}, up{at_.x, at_.y, NAN};
    add("machine coordinates", {MachinePlace{PlaceKind::coordinates, 1, z, {NAN, NAN, -10}}, line(up, true)});
    MachinePlace of_tip{PlaceKind::coordinates, 1, z, {NAN, NAN, -10}};
    of_tip.tip = true;
    add("machine coordinates of the tip", {of_tip, line(up, true)});
    add("reference point", {MachinePlace{PlaceKind::home, 1, z, unknown}, line(up, true)});
    add("second reference point", {MachinePlace{PlaceKind::home, 2, z, unknown}, line(up, true)});
    add("fixed place of the machine", {MachinePlace{PlaceKind::fixed, 1, z, unknown}, line(up, true)});
    for (const std::uint32_t number : {54U, 59U, 505U, 5401U, 1003U})
        add_modal("zero " + std::to_string(number), cl::Datum{number, unknown});
    add("place of a zero", {cl::DatumData{55, {100, turning_ ? NAN : 50, -20}, {}, false}});
    add("a zero is moved", {cl::DatumData{55, {1, turning_ ? NAN : 2, 3}, {}, true}});
}

void Maker::frames() {
    const auto frame = [&](const char* name, cl::FrameKind kind, const geom::Frame& f) {
        cl::Frame whole;
        whole.parts.push_back({kind, f});
        add(name, {whole, next()});
    };
    frame("frame: shift", cl::FrameKind::shift,
          geom::Frame::shift(turning_ ? geom::Vec3{5, 0, 7} : geom::Vec3{5, 6, 7}));
    frame("frame: rotation", cl::FrameKind::rotation, geom::Frame::rotation(turning_ ? 1 : 2, geom::pi / 6));
    frame("frame: mirror", cl::FrameKind::mirror, geom::Frame::scaling({-1, 1, 1}));
    frame("frame: scaling", cl::FrameKind::scaling, geom::Frame::scaling({2, 2, 2}));
    if (!turning_) {
        const geom::Frame tilted = geom::Frame::rotation(0, geom::pi / 4);
        cl::Frame whole;
        whole.parts.push_back({cl::FrameKind::plane, tilted});
        const geom::Vec3 axis{0, -std::sqrt(0.5), std::sqrt(0.5)};
        add("frame: tilted plane", {whole, cl::Linear{at_ + along_x(10), axis, false}});
        const geom::Vec3 unknown{NAN, NAN, NAN};
        add("frame: tilted plane, the axes turn",
            {whole, cl::Linear{unknown, axis, true, cl::Seek::nothing, {{{'A'}, 45, true, true}}}});
    }
    frame("frame: a programmed one", cl::FrameKind::programmed, geom::Frame::shift({0, 0, 3}));
}

void Maker::contours() {
    const geom::Vec3 normal = turning_ ? geom::Vec3{0, 1, 0} : geom::Vec3{0, 0, 1};
    const geom::Vec3 away = turning_ ? geom::Vec3{10, 0, 0} : geom::Vec3{0, 10, 0};
    const geom::Vec3 first = at_ + along_x(10), second = first + away;
    const auto element = [&](const geom::Vec3& from, const geom::Vec3& to, cl::Corner corner) {
        cl::Programmed p{from, to, {}, normal};
        p.corner = corner, p.size = corner == cl::Corner::none ? 0 : 1;
        return p;
    };
    for (const cl::CompensationSide side : {cl::CompensationSide::left, cl::CompensationSide::right}) {
        cl::CompensationBegin begin;
        begin.side = side, begin.radius = 0, begin.offset = 1, begin.normal = normal;
        add(side == cl::CompensationSide::left ? "compensation to the left" : "compensation to the right",
            {begin, element(at_, first, cl::Corner::none), line(first), element(first, second, cl::Corner::none),
             line(second), cl::CompensationEnd{}, line(at_)});
    }
    constexpr std::pair<cl::Corner, const char*> corners[] = {{cl::Corner::chamfer, "chamfer by its length"},
                                                              {cl::Corner::chamfer_leg, "chamfer by its legs"},
                                                              {cl::Corner::rounding, "rounding"}};
    for (const auto& [corner, name] : corners) {
        const double leg = corner == cl::Corner::chamfer ? std::sqrt(0.5) : 1;
        const geom::Vec3 begin = first - leg * along_x(1), end = first + leg * (1 / geom::length(away)) * away;
        const double sense = geom::dot(geom::cross(along_x(1), away), normal) > 0 ? 1 : -1;
        const cl::Arc rounding{end, begin + end - first, normal, sense * geom::pi / 2, false};
        const cl::Step cut = corner == cl::Corner::rounding ? cl::Step(rounding) : cl::Step(line(end));
        add(name,
            {element(at_, first, corner), line(begin), cut, element(first, second, cl::Corner::none), line(second)});
    }
    constexpr const char* leads[] = {"tangent line", "normal line", "tangent arc", "arc and line"};
    for (std::size_t k = 0; k < 4; ++k) {
        cl::LeadBegin lead;
        lead.kind = static_cast<cl::LeadKind>(k);
        lead.at = first;
        if (k < 2) lead.length = 5;
        if (k >= 2) lead.radius = 5;
        if (k == 2) lead.angle = geom::pi / 2;
        add(std::string("onto a contour by a ") + leads[k], {lead, line(first), cl::LeadEnd{}});
        lead.onto = false;
        add(std::string("off a contour by a ") + leads[k], {lead, line(first), cl::LeadEnd{}});
    }
}

void Maker::events() {
    add("a tool that is prepared", {cl::ToolSelection{2, {}}});
    add("an output on", {cl::Output{3, false, 1, false}});
    add("an output off with the next move", {cl::Output{3, false, 0, true}, next()});
    add("an output with a value", {cl::Output{3, true, 2.5, false}});
    for (const cl::OverrideKind kind : {cl::OverrideKind::feed, cl::OverrideKind::spindle,
                                        cl::OverrideKind::adaptive_feed, cl::OverrideKind::feed_hold})
        add("override " + std::to_string(static_cast<int>(kind)) + " off, and on again",
            {cl::Override{kind, false}, cl::Override{kind, true}});
    add("dwell, seconds", {cl::Dwell{1.5, 0}});
    add("dwell, revolutions", {cl::Dwell{0, 3}});
    add("programmed stop", {cl::Stop{cl::StopKind::program}, next()});
    add("optional stop", {cl::Stop{cl::StopKind::optional}, next()});
    add("end of the program", {cl::Stop{cl::StopKind::end}});
    add("end of the program, behind which it stays", {cl::Stop{.kind = cl::StopKind::end, .stays = true}});
    add("what another spindle is told", {cl::OtherSpindle{.number = 2, .speed = 800}});
    add("comment", {cl::Comment{"Roughing (1/2) \"A\"", false, false}});
    add("message for the operator", {cl::Comment{"Turn the part", true, false}});
    add("line for the terminal", {cl::Comment{"Turn the part", true, true}});
    add("M function", {cl::Auxiliary{'M', 188}});
    add("H function", {cl::Auxiliary{'H', 5}});
    add("a called part", {cl::PartBegin{cl::PartKind::call, "SUB", 1, 1}, next(), cl::PartEnd{}});
}

/// Whether the form prints a number that follows from this height of a hole.
bool follows_from(const CycleForm& form, CycleRole role) {
    const auto any = [&](std::initializer_list<Value> values) {
        return std::any_of(values.begin(), values.end(),
                           [&](Value v) { return says(form.define, index_of(v)) || says(form.call, index_of(v)); });
    };
    switch (role) {
        case CycleRole::surface: return any({Value::hole_top, Value::hole_gap, Value::hole_way});
        case CycleRole::retract_plane: return any({Value::hole_top, Value::hole_gap, Value::hole_end});
        case CycleRole::return_level: return any({Value::hole_end});
        case CycleRole::bottom: return any({Value::hole_way});
        default: return false;
    }
}

/// The roles that a form prints or asks for.
std::vector<cl::CycleValue> values_of(const CycleForm& form) {
    std::vector<cl::CycleValue> out;
    for (ValueIndex v = first_role; v < value_count; ++v) {
        bool there =
            says(form.define, v) || says(form.call, v) || follows_from(form, static_cast<CycleRole>(v - first_role));
        std::optional<double> number;
        for (const Condition& c : form.when)
            if (c.value == v && (c.present || !c.equals)) there = c.present, number = c.equals;
        if (there) out.push_back({static_cast<CycleRole>(v - first_role), number.value_or(sample_value(v))});
    }
    return out;
}

Sample cycle_sample(cl::CycleKind kind, std::string name, std::vector<cl::CycleValue> values, const geom::Vec3& at) {
    cl::Cycle cycle{kind, {}, values, std::string(cl::spelling(kind)), {}};
    cl::CycleBegin begin;
    begin.cycle = cycle;
    begin.place = at;
    std::vector<cl::Step> steps{begin};
    for (const cl::CycleValue& v : values)
        if (v.role == CycleRole::spindle_direction && v.value < 0)
            steps.insert(steps.begin(), cl::Spindle{1000, cl::SpindleMode::rpm, -1});
    return {std::move(name), "cycle", std::move(steps), std::move(values), kind};
}

}  // namespace

bool turns(const Post& post) {
    return post.has(Command::linear) && !says(post[Command::linear], index_of(Value::y)) &&
           post.hooked.count(Command::linear) == 0;
}

geom::Vec3 sample_place(bool turning) { return turning ? geom::Vec3{20, 0, 5} : geom::Vec3{10, 20, 5}; }

std::vector<cl::Step> sample_begin(const Post& post, double tool_radius) {
    const bool turning = turns(post);
    cl::ToolChange tool{1, 1, {}};
    tool.with_length = true;
    std::vector<cl::Step> out;
    if (post.has(Command::tool_data))
        for (const std::uint32_t number : {1U, 2U}) out.emplace_back(cl::ToolData{number, 1, 0.0, tool_radius});
    for (const cl::Step& step :
         {cl::Step(tool), cl::Step(cl::Spindle{1000, cl::SpindleMode::rpm, 1}), cl::Step(cl::Feed{200}),
          cl::Step(line(sample_place(turning) + geom::Vec3{0, 0, 10}, true)), cl::Step(line(sample_place(turning)))})
        out.push_back(step);
    return out;
}

std::vector<cl::Record> records_of(const std::vector<cl::Step>& steps) {
    std::vector<cl::Record> out;
    std::uint32_t block = 0;
    bool made = false;
    for (const cl::Step& step : steps) {
        if (!cl::is_move(step)) made = std::holds_alternative<cl::Programmed>(step);
        const cl::AxisEnds* ends = cl::ends_of(step);
        const bool turns =
            !out.empty() && std::holds_alternative<cl::Frame>(out.back().step) && ends != nullptr && !ends->empty();
        if ((!made || !cl::is_move(step)) && !turns) ++block;
        out.push_back({step, {0, block, block + 1}, 0});
    }
    return out;
}

std::vector<Sample> record_samples(const Post& post) {
    Maker maker(turns(post));
    maker.moves();
    maker.modes();
    maker.tools();
    maker.places();
    maker.frames();
    maker.contours();
    maker.events();
    return std::move(maker.samples);
}

std::vector<Sample> cycle_samples(const Post& post) {
    std::vector<Sample> out;
    const geom::Vec3 at = sample_place(turns(post));
    for (std::size_t k = 0; k <= static_cast<std::size_t>(cl::CycleKind::probe); ++k) {
        const auto kind = static_cast<cl::CycleKind>(k);
        const std::string name = "cycle " + std::string(cl::spelling(kind));
        const auto forms = post.cycles.find(kind);
        const std::size_t count = forms == post.cycles.end() ? 0 : forms->second.size();
        std::vector<cl::CycleValue> usual;
        if (post.hooked_cycles.count(kind) != 0)
            for (const CycleRole role : {CycleRole::surface, CycleRole::clearance, CycleRole::depth, CycleRole::infeed,
                                         CycleRole::feed_plunge, CycleRole::retract_plane, CycleRole::bottom})
                usual.push_back({role, sample_value(index_of(role))});
        if (count == 0) out.push_back(cycle_sample(kind, name, usual, at));
        for (std::size_t f = 0; f < count; ++f)
            out.push_back(cycle_sample(kind, count == 1 ? name : name + ", form " + std::to_string(f + 1),
                                       values_of(forms->second[f]), at));
    }
    return out;
}

}  // namespace obrys::write
