/// Blocks: motion, feed, spindle, tools and the rest of what words say, each as the language has it.

#include <algorithm>
#include <utility>

#include "base/whole.hpp"
#include "rewrite/block_words.hpp"

namespace obrys::rewrite {

using program::Modal;

namespace {

std::string lines_of_block(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words)
        if (!word.empty()) out += (out.empty() || out.back() == '\n' ? "" : " ") + word;
    return out;
}

}  // namespace

std::string BlockWords::spelt(std::string_view word, const Text& given, bool is_length) {
    Text v = given;
    const bool negated = v.level == Level::sign && v.text.find_first_of("([ ") == std::string::npos;
    if (!w_.language.computes && !v.number && !negated) v = w_.atom(v, program::no_expr);
    const bool plus = is_length && w_.language.sign && v.text[0] != '-';
    std::string value = (plus ? "+" : "") + v.text;
    if (word == "S" && v.number && value.ends_with('.')) value.pop_back();  // speeds are whole numbers without a point
    const std::string bracketed =
        v.number || v.level == Level::atom ? v.text : w_.language.open + v.text + w_.language.close;
    const bool plain = v.number || !w_.language.computes;
    const std::string* form = w_.language.find(plain ? "expressions.word" : "expressions.word-computed");
    if (form == nullptr) return std::string(word) + value;
    return filled(*form, {{"word", std::string(word)}, {"value", value}, {"bracketed", bracketed}});
}

std::string BlockWords::optional(std::string_view word, const std::optional<Text>& v) {
    return v ? " " + spelt(word, *v, false) : "";
}

bool BlockWords::function_before(int m) {
    switch (m) {
        case 3: return w_.say("words.cw", {}, "M3"), true;
        case 4: return w_.say("words.ccw", {}, "M4"), true;
        case 7: return w_.say("words.mist", {}, "M7"), true;
        case 8: return w_.say("words.flood", {}, "M8"), true;
        case 5: return w_.unit->traits->stops_before_motion && (w_.say("words.spindle-stop", {}, "M5"), true);
        case 9: return w_.unit->traits->stops_before_motion && (w_.say("words.coolant-off", {}, "M9"), true);
        case 6: return true;  // with the tool
        default: return false;
    }
}

/// The control may stop spindle and coolant with the program.
void BlockWords::stop() {
    for (const program::SpindleStop& s : w_.unit->traits->spindle_stops) {
        if (s.function != 0 || !s.certain) continue;
        w_.say("words.spindle-stop", {}, "M5");
        if (s.coolant) w_.say("words.coolant-off", {}, "M9");
    }
    w_.say("flow.stop", {}, "M0");
}

void BlockWords::function_behind(int m) {
    switch (m) {
        case 0: return stop();
        case stop_alone: return static_cast<void>(w_.say("flow.stop", {}, "STOP"));
        case 1: return static_cast<void>(w_.say("flow.optional-stop", {}, "M1"));
        case 2:
        case 30: return w_.end_all();
        case 17: return w_.unit == w_.programs.front() ? w_.end_all() : w_.leave();
        case 5: return static_cast<void>(w_.say("words.spindle-stop", {}, "M5"));
        case 9: return static_cast<void>(w_.say("words.coolant-off", {}, "M9"));
        default:
            w_.refuse(w_.here,
                      "M" + std::to_string(m) + " is not translated by structure: what it does is the machine's own");
    }
}

void BlockWords::tool() {
    if (prepares_) return;  // a magazine makes it ready, and nothing else follows
    const bool on_m6 = std::find(m_.begin(), m_.end(), 6) != m_.end();
    if (tool_ && !change_ && !on_m6 && w_.tools_wait()) {
        w_.prepared_edge = edge_;
        return;
    }
    if (!tool_ && on_m6 && w_.held()[Mode::prepared] > 0)
        tool_ = w_.number_text(w_.held()[Mode::prepared]), edge_ = edge_ ? edge_ : w_.prepared_edge;
    if (!tool_ && (on_m6 || change_) && !(change_ && speed_))
        return w_.refuse(w_.here, "which tool comes into the spindle is not known from this block",
                         "write T and M6 in one block");
    if (!tool_ && edge_) {
        if (w_.language.has("words.edge")) return static_cast<void>(w_.say("words.edge", {{"edge", edge_->text}}, "D"));
        if (edge_->number == 1.0) return;
        return w_.refuse(w_.here, "another edge of the tool in the spindle is not translated by structure");
    }
    if (!tool_) return;
    if (!tool_->number) return w_.refuse(w_.here, "a computed tool number is not translated by structure");
    int number = base::clipped<int>(*tool_->number, 0, 999'999), offset = number;
    if (joined_offset_) offset = number % 100, number = number / 100;
    if (edge_ && edge_->number == tool_->number && w_.unit->traits->edge_is_offset_number) edge_.reset();
    if (edge_ && edge_->number && *edge_->number > 1) {
        if (!w_.language.has("words.edge"))
            return w_.refuse(w_.here, "edge D" + edge_->text + " of a tool has no counterpart there");
    }
    if (joined_offset_ && offset != number)
        return w_.refuse(w_.here, "a tool with the offset of another number is not translated by structure");
    if (const std::string* off = w_.language.find("words.length-off"); off != nullptr && w_.length_waits == *off)
        w_.write_length();
    const auto two = [](int n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    w_.say("words.tool",
           {{"tool", std::to_string(number)},
            {"edge", edge_ ? edge_->text : "1"},
            {"turret", two(number) + two(number)},
            {"speed", w_.language.has("words.tool-has-speed") ? optional("S", speed_) : ""}},
           "a tool");
    if (w_.language.has("words.tool-has-speed")) speed_.reset();
    w_.tool_in_spindle = number;
    w_.length_waits.clear();  // of the tool before, which has not moved by it
    length_of_tool();
}

void BlockWords::spindle() {
    const std::string* beside = surface_ == Modal::surface_speed_on ? w_.language.find("words.surface-limit") : nullptr;
    const std::string limit =
        limit_ && beside != nullptr ? filled(*beside, {{"limit", spelt("", *limit_, false)}}) : "";
    if (limit_ && beside == nullptr)
        w_.say("words.speed-limit", {{"limit", spelt("", *limit_, false)}}, "a limit of the spindle speed (LIMS)");
    const int surface = w_.held()[Mode::surface];
    if (surface_ == Modal::surface_speed_on) {
        w_.say("words.surface", {{"speed", limit + optional("S", speed_)}}, "a constant cutting speed (G96)");
    } else if (surface_ == Modal::surface_speed_off) {
        if (speed_ || w_.language.has("words.surface"))
            w_.say("words.revolutions", {{"speed", optional("S", speed_)}}, "G97");
    } else if (speed_) {
        if (surface == several)
            return w_.refuse(w_.here, "whether S is a cutting speed here depends on the way that the run has come");
        if (surface == 1 && !w_.language.has("words.surface"))
            return w_.refuse(w_.here, "S is a cutting speed (G96) here, which the control has not");
        w_.say("words.spindle", {{"speed", spelt("S", *speed_, false)}}, "a speed");
    }
}

void BlockWords::feed_mode() {
    if (!feed_mode_) return;
    const bool per_rev = feed_mode_ == Modal::feed_per_rev;
    w_.say(per_rev ? "words.per-rev" : "words.per-minute", {}, per_rev ? "feed per revolution" : "feed per minute");
    const int surface = w_.held()[Mode::surface];
    const bool ends = w_.unit->traits->feed_mode_ends_surface_speed, there = w_.language.feed_ends_surface;
    if (surface == 0 || surface == never_there || surface_ || ends == there || !w_.language.has("words.surface"))
        return;
    if (ends) {
        w_.say("words.revolutions", {{"speed", ""}}, "G97");
    } else if (surface == 1) {
        w_.say("words.surface", {{"speed", ""}}, "G96");
    } else {
        w_.refuse(w_.here, "whether the cutting speed is constant here depends on the way that the run has come");
    }
}

void BlockWords::modes() {
    if (plane_) {
        const std::string_view key = *plane_ == Modal::plane_xy   ? "words.plane-xy"
                                     : *plane_ == Modal::plane_zx ? "words.plane-zx"
                                                                  : "words.plane-yz";
        if (w_.language.has(key))
            w_.say(key, {}, "a plane");
        else
            w_.tell(w_.here,
                    "the plane is that of the tool axis there: straight moves name their axes, arcs are written in X "
                    "and Y alone");
    }
    if (datum_) zero(*datum_);
}

std::string BlockWords::axes_text() {
    std::vector<std::string> words;
    for (const Axis& a : axes_) {
        const std::string* form = a.incremental ? w_.language.find("words.incremental-value") : nullptr;
        const std::string* letters = a.incremental ? w_.language.find("words.incremental-letters") : nullptr;
        std::string letter(1, a.letter);
        if (letters != nullptr && letters->find(a.letter) != std::string::npos &&
            letters->find(a.letter) + 1 < letters->size())
            letter = (*letters)[letters->find(a.letter) + 1];
        if (form == nullptr) {
            words.push_back(spelt(letter, a.value, true));
            continue;
        }
        words.push_back(
            filled(*form, {{"letter", letter}, {"value", a.value.text}, {"word", spelt(letter, a.value, true)}}));
    }
    return lines_of_block(words);
}

/// The motion of the block; nothing after a complaint.
std::optional<Modal> BlockWords::motion_here() {
    int held = w_.held()[Mode::motion];
    if (motion_) held = static_cast<int>(*motion_);
    if (held < 0) {
        w_.refuse(w_.here, "which motion is in force here depends on the way that the run has come, or is not said",
                  "write G0 or G1 in this block");
        return std::nullopt;
    }
    return static_cast<Modal>(held);
}

/// What of an arc has no counterpart.
bool BlockWords::refuse_arc(bool arc) {
    const int plane = w_.held()[Mode::plane];
    const auto no = [&](const char* what, const char* remedy = "") { return w_.refuse(w_.here, what, remedy), true; };
    if (!arc && (radius_ || !centre_.empty()))
        return no("a centre or radius beside a straight move is not translated by structure");
    if (!arc) return false;
    if (!w_.language.has("words.plane-zx") && (plane_ ? *plane_ != Modal::plane_xy : plane != 17))
        return no("an arc outside the plane of X and Y is not translated by structure to this control");
    if (same_sense_ && !motion_)
        return no("an arc in the sense of the last one has no counterpart", "write DR+ or DR-");
    if (!radius_ && centre_.empty() && !about_pole_)
        return no("an arc whose centre is said elsewhere is not translated by structure");
    return false;
}

std::string_view BlockWords::key_of(Modal motion) const {
    if (motion == Modal::rapid) return machine_ ? "words.machine-rapid" : "words.rapid";
    if (motion == Modal::linear) return machine_ ? "words.machine-linear" : "words.linear";
    const bool cw = motion == Modal::arc_cw, absolute = about_pole_ || !centre_counts_on_;
    if (radius_ && w_.language.has("words.arc-radius-cw")) return cw ? "words.arc-radius-cw" : "words.arc-radius-ccw";
    if (absolute && w_.language.has("words.arc-absolute-cw"))
        return cw ? "words.arc-absolute-cw" : "words.arc-absolute-ccw";
    return cw ? "words.arc-cw" : "words.arc-ccw";
}

void BlockWords::zero(int number) {
    const std::string name = "the zero offset G" + std::to_string(number);
    const auto& zeros = w_.language.zeros;
    const auto n = static_cast<std::uint32_t>(number);
    const auto words =
        std::find_if(zeros.begin(), zeros.end(), [&](const Zeros& z) { return z.first <= n && n <= z.last; });
    if (!w_.language.has("words.datum"))
        w_.tell(w_.here, name + " is the zero point that is active there");
    else if (words == zeros.end() || n < words->less)
        w_.refuse(w_.here, name + " has no counterpart there", "use one that both controls have");
    else
        w_.say(filled(words->text, {{"number", std::to_string(n - words->less)}}));
}

void BlockWords::no_move() {
    if (compensation_ && *compensation_ != Modal::compensation_off)
        w_.refuse(w_.here, "compensation without a move is not translated by structure");
    if (compensation_ == Modal::compensation_off && w_.language.has("words.comp-off-alone"))
        w_.say("words.comp-off-alone", {}, "G40");
}

void BlockWords::move() {
    std::string feed = feed_ ? spelt("F", *feed_, false) : "";
    const bool moves = !axes_.empty() || !centre_.empty();
    const auto motion = moves || radius_ ? motion_here() : std::optional(Modal::linear);
    if (!motion) return;
    const bool arc = *motion == Modal::arc_cw || *motion == Modal::arc_ccw;
    if (moves && !arc && *motion != Modal::rapid && *motion != Modal::linear)
        return w_.refuse(w_.here, "the motion in force here is not translated by structure");
    if (!feed.empty() && (!moves || *motion == Modal::rapid)) {
        w_.say("words.no-move", {{"feed", feed}}, "a feed");
        feed.clear();
    }
    if (!moves) return no_move();
    const auto compensation = compensation_text();
    if (!compensation) return;
    const auto counts_on = [](const Axis& a) { return a.incremental; };
    const bool by_mode = std::any_of(axes_.begin(), axes_.end(), counts_on) &&
                         !w_.language.has("words.incremental-value") && !w_.language.has("words.incremental-letters");
    if (by_mode && !std::all_of(axes_.begin(), axes_.end(), counts_on))
        return w_.refuse(w_.here, "absolute and incremental coordinates in one block have no counterpart there",
                         "write them in two blocks");
    if (machine_ && (arc || by_mode || compensation_ || std::any_of(axes_.begin(), axes_.end(), counts_on)))
        return w_.refuse(w_.here, "a place of the machine beside these words is not translated by structure");
    if (!refuse_arc(arc)) write_move(*motion, feed, *compensation, by_mode);
}

void BlockWords::write_move(Modal motion, const std::string& feed, const std::string& compensation, bool by_mode) {
    const bool arc = motion == Modal::arc_cw || motion == Modal::arc_ccw;
    const std::optional<std::string> centre = !arc ? std::string() : about_pole_ ? pole_text() : centre_text();
    if (!centre) return;
    const std::string axes = axes_text(), corner_words = corner_ ? corner(corner_->first, corner_->second) : "";
    const bool beside = w_.language.corner_beside;
    const std::string length = length_here(key_of(motion));
    const std::size_t before = w_.lines.size();
    w_.say(key_of(motion),
           {{"length", length},
            {"axes", axes},
            {"feed", feed},
            {"comp", compensation},
            {"centre", *centre},
            {"corner", beside ? corner_words : ""}},
           "this motion");
    if (!beside && !corner_words.empty()) w_.say(corner_words);
    if (!by_mode) return;
    if (const std::string* increments = w_.language.find("words.incremental");
        increments != nullptr && before < w_.lines.size())
        w_.lines[before].text = *increments + " " + w_.lines[before].text;
    w_.say("words.absolute", {}, "absolute coordinates");
}

void BlockWords::write() {
    w_.tool_in_spindle = std::max(w_.held()[Mode::tool], 0);
    gather();
    if (frame_) return w_.write_length(), w_.frame_block(*frame_);
    if (is_pole_) return pole();
    take_increments_of_pole();
    if (dwell_) {
        const auto time = w_.unit->traits->dwell_in_feed_words ? feed_ : dwell_time_;
        if (!time || !axes_.empty())
            return w_.refuse(w_.here, source_of_block() + ": this dwell is not translated by structure");
        w_.say("words.dwell", {{"seconds", spelt("", *time, false)}}, "a dwell");
        feed_.reset();
    } else if (dwell_time_) {
        return w_.refuse(w_.here, source_of_block() + ": P is not translated by structure here");
    }
    modes();
    tool();
    lengths();
    radius_alone();
    feed_mode();
    spindle();
    std::vector<int> behind;
    for (const int m : m_)
        if (!function_before(m)) behind.push_back(m);
    move();
    if (call_cycle_) w_.write_length(), w_.cycle_call();
    std::stable_partition(behind.begin(), behind.end(), [](int m) { return m != 2 && m != 30 && m != 17; });
    for (const int m : behind) function_behind(m);
}

void Writing::block(std::uint32_t) { BlockWords(*this).write(); }

void Writing::write_length() {
    if (!length_waits.empty()) say(std::exchange(length_waits, {}));
}

}  // namespace obrys::rewrite
