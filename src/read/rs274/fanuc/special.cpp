/// G codes that are more than one word: what they make of their block.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

namespace {

void dwell(FanucState& s, const FanucG& g, const Address& a) {
    for (const char letter : {'P', 'X', 'U'}) {
        Address* time = find_address(s, letter);
        if (time == nullptr) continue;
        time->used = true;
        // P counts milliseconds, X and U seconds, or thousandths of a second where there is no point.
        const bool increments = letter == 'P' || s.control.whole_numbers == WholeNumbers::increments;
        const auto q = letter == 'P' ? Quantity::milliseconds : increments ? Quantity::thousandths : Quantity::plain;
        put_value(s, Order::value, Code::p, scaled(s, time->value, q), *time);
        break;
    }
    refuse_axes(s, "G4 takes its time from P, X or U: what the control does with this word is not known");
    add_modal(s, g.order, Modal::dwell, 0, a.begin, a.end);
}

void home(FanucState& s, const FanucG& g, const Address& a) {
    int number = g.number;
    if (Address* p = g.number == 2 ? find_address(s, 'P') : nullptr) {
        p->used = true;
        const auto n = as_integer(p->value);
        if (!n || *n < 2 || *n > 4) return fail(s, p->begin, p->end, "G30 needs P2, P3 or P4");
        number = *n;
    }
    add_modal(s, g.order, g.modal, number, a.begin, a.end);
}

/// G10 L: which table it writes; nothing for those that are not run.
std::optional<DataTable> data_table(const FanucState& s, int l, int p) {
    const bool diameters = s.control.haas;  // setting 40 as delivered
    switch (l) {
        case 2: return p == 0 ? DataTable::external_datum : DataTable::datum;
        case 20: return DataTable::extended_datum;
        case 1:
        case 11: return DataTable::tool_length_wear;
        case 10: return DataTable::tool_length;
        case 12: return diameters ? DataTable::tool_diameter : DataTable::tool_radius;
        case 13: return diameters ? DataTable::tool_diameter_wear : DataTable::tool_radius_wear;
        default: return std::nullopt;
    }
}

void set_data(FanucState& s, const FanucG& g, const Address& a) {
    Address *l = find_address(s, 'L'), *p = find_address(s, 'P');
    const int number = l != nullptr ? as_integer(l->value).value_or(-1) : -1;
    const int row = p != nullptr ? as_integer(p->value).value_or(-1) : -1;
    const auto table = data_table(s, number, row);
    const bool datum = table && *table <= DataTable::extended_datum;
    if (table && (datum || !s.control.is_lathe())) {
        l->used = true;
        return add_modal(s, g.order, g.modal, static_cast<int>(*table), a.begin, a.end);
    }
    use_letters(s, "LPRQXYZABCUVWIJKHD");
    const bool offset = s.control.is_lathe() && (number < 0 || (number >= 10 && number <= 13));
    add_problem(s, Code::unsupported, a.begin, s.line.end(),
                number == 50 ? "sets parameters of the control"
                : offset     ? "sets a tool offset"
                             : "sets data of the control");
}

/// G92, G50 of lathes: with S the highest spindle speed; with axis words the position becomes what they say.
void position(FanucState& s, const FanucG& g, const Address& a) {
    if (Address* speed = find_address(s, 'S')) {
        speed->used = true;
        put_value(s, Order::technology, Code::speed_limit, speed->value, *speed);
    }
    const bool axes = std::any_of(s.addresses.begin(), s.addresses.end(), [](const Address& x) {
        return !x.used && std::string_view("XYZABCUVWH").find(x.letter) != std::string_view::npos;
    });
    if (axes) add_modal(s, g.order, g.modal, 0, a.begin, a.end);
}

void hole_cycle(FanucState& s, const FanucG& g, const Address& a) {
    const bool counts_up = g.number == 870 && s.incremental && !s.control.haas;  // Z from R, R from the start
    const auto& table = s.variant.traits->canned;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < table.size() && !counts_up; ++i)
        if (table[i].number == g.number && (!found || s.rigid)) found = i;
    // Haas 96-8000, G51: a cycle keeps its heights and depths along Z; FANUC B-63684EN, scaling: nor Q.
    const bool scaled = (s.transformed & enlarged) != 0;
    if (scaled && (s.control.haas || find_address(s, 'Q') != nullptr))
        add_problem(s, Code::unsupported, a.begin, a.end,
                    "G51 is in force, and of a cycle's heights and depths the control does not scale all");
    if (found) return add_modal(s, g.order, g.modal, static_cast<int>(*found), a.begin, a.end);
    add_problem(s, Code::unsupported, a.begin, a.end, "a hole cycle: the holes are not made");
    use_letters(s, "XYZABCUVWRQPKLIJ");
    s.facts.refused = true;
    s.lost_motion = true;
}

}  // namespace

/// Operator's manual, multiple-thread cutting: 0 to 360000, thousandths of a degree, no decimal point; it holds in its
/// block alone, and without it the thread begins at 0.
std::optional<Value> start_angle(FanucState& s, Address& q) {
    constexpr double whole_turn = 360'000;
    q.used = true;
    if (!q.value.is_literal()) return scaled(s, q.value, Quantity::milliseconds);
    if (!q.value.literal.integer) {
        fail(s, q.begin, q.end,
             s.control.haas ? "the starting angle of a thread is a whole number"
                            : "a decimal point cannot stand here (alarm 7)",
             "write thousandths of a degree: Q180000 is 180 degrees");
        return std::nullopt;
    }
    if (q.value.number() >= 0 && q.value.number() <= whole_turn) return scaled(s, q.value, Quantity::milliseconds);
    add_problem(s, Code::unsupported, q.begin, q.end,
                "the starting angle of a thread counts thousandths of a degree, from 0 to 360000");
    return std::nullopt;
}

namespace {

/// The lead stands in F (E for inches with many digits), or is the F before: along Z, or along X where Z is not
/// programmed. False where it is not run.
bool thread_lead(FanucState& s, const Address& a) {
    if (Address* e = find_address(s, 'E')) {
        e->used = true;
        add_problem(s, Code::unsupported, e->begin, e->end, "a thread's lead or number of threads in E");
        s.facts.refused = true;
        s.lost_motion = true;
        return false;
    }
    const bool along_z = find_address(s, 'Z') != nullptr || find_address(s, 'W') != nullptr;
    Address* f = find_address(s, 'F');
    Address lead = f != nullptr ? *f : a;
    const Value v = f != nullptr ? scaled(s, f->value, Quantity::feed) : feed_in_force(s, a.begin, a.end);
    put_value(s, Order::value, along_z ? Code::k : Code::i, v, lead);
    if (Address* q = find_address(s, 'Q'))
        if (const auto angle = start_angle(s, *q)) put_value(s, Order::value, Code::q, *angle, *q);
    return !s.failed;
}

void thread(FanucState& s, const FanucG& g, const Address& a) {
    if (thread_lead(s, a)) add_modal(s, g.order, g.modal, 0, a.begin, a.end);
}

/// Blocks without a G code go on with the thread of the one before, with its lead or one of their own.
void continued_thread(FanucState& s) {
    if (s.own_motion || !s.motion.is_thread()) return;
    for (const char letter : {'Z', 'W', 'X', 'U'})
        if (const Address* a = find_address(s, letter)) return static_cast<void>(thread_lead(s, Address(*a)));
}

/// A hole at a place given from the last one.
void hole_block(FanucState& s, double dx, double dy, const Address& a) {
    program::Builder& b = s.build();
    b.statement(StatementKind::block, s.line.begin());
    const auto axis = [&](Code code, double d) {
        const ExprId by = b.number(d, false, a.begin, a.end);
        b.expression(code, b.with_reference(program::Reference::incremental, by, a.begin, a.end), a.begin, a.end);
    };
    axis(Code::x, dx);
    axis(Code::y, dy);
    b.end_statement(s.line.end());
}

/// Haas G70 and G71: the hole cycle in force at points of a circle about the place where the tool stands.
void hole_pattern(FanucState& s, const FanucG& g, const Address& a) {
    constexpr int most = 1000;
    const auto literal = [&](char letter, double missing) -> std::optional<double> {
        Address* x = find_address(s, letter);
        if (x == nullptr) return missing;
        x->used = true;
        const Value v =
            letter == 'L' ? x->value : scaled(s, x->value, letter == 'I' ? Quantity::length : Quantity::angle);
        if (!v.is_literal()) s.inch.rely();
        return v.is_literal() ? std::optional(v.number()) : std::nullopt;
    };
    const auto radius = literal('I', 0), start = literal('J', 0), count = literal('L', 0), step = literal('K', 0);
    const bool axes = find_address(s, 'X') != nullptr || find_address(s, 'Y') != nullptr;
    if (!radius || !start || !count || !step || axes) {
        s.facts.refused = true;
        return add_problem(s, Code::unsupported, a.begin, s.line.end(),
                           "a hole pattern with computed values or a centre");
    }
    if (hole_of(s) == 0) {
        s.facts.refused = true;
        return add_problem(s, Code::unsupported, a.begin, a.end, "the hole pattern needs a hole cycle before it");
    }
    if (!(*count >= 1) || *count > most) return fail(s, a.begin, a.end, "L is the number of holes, 1 to 1000");
    double x = 0, y = 0;
    const int holes = base::clipped<int>(*count, 1, most);
    for (int i = 0; i < holes; ++i) {
        const double angle = (*start + i * (g.code == 710 ? *step : 360 / *count)) * 3.14159265358979323846 / 180;
        const auto rounded = [](double v) { return std::round(v * 1e9) / 1e9 + 0.0; };
        const double nx = rounded(std::abs(*radius) * std::cos(angle));
        const double ny = rounded(std::abs(*radius) * std::sin(angle));
        hole_block(s, nx - x, ny - y, a);
        x = nx, y = ny;
    }
}

/// G54.1 P3, G54 P3, Haas G154 P3 and G112: datum 5403.
void extended_datum(FanucState& s, int number, const Address& a) {
    constexpr int first = 5401, most = 300;
    if (Address* p = number == 0 ? find_address(s, 'P') : nullptr) {
        p->used = true;
        number = as_integer(p->value).value_or(-1);
    }
    if (number < 1 || number > most)
        return add_problem(s, Code::unsupported, a.begin, a.end, "a work offset by a number that is not written");
    add_modal(s, Order::datum, Modal::datum, first + number - 1, a.begin, a.end);
}

/// G54 P1 is G54.1 P1.
void datum_with_number(FanucState& s) {
    if (s.control.is_lathe() || find_address(s, 'P') == nullptr || !s.special.empty() || hole_of(s) != 0) return;
    const auto other = std::find_if(s.own_words.begin(), s.own_words.end(), [](const OwnWords& own) {
        return own.letters.find('P') != std::string_view::npos;
    });
    for (std::size_t i = 0; i < s.words.size(); ++i) {
        const BlockWord w = s.words[i];
        if (w.code != Code::modal || w.payload != program::modal_word(Modal::datum, 54)) continue;
        if (other != s.own_words.end()) return add_problem(s, Code::unsupported, other->begin, other->end, read_twice);
        s.words.erase(s.words.begin() + static_cast<std::ptrdiff_t>(i));
        Address a;
        a.begin = w.begin;
        a.end = w.end;
        return extended_datum(s, 0, a);
    }
}

/// G187 of Haas: P says how smooth, E by how much corners are rounded in place of setting 85 (Mill Operator's Manual
/// 96-8000, "G187 Accuracy Control").
void corner_rounding(FanucState& s) {
    const auto is_g187 = [](const BlockWord& w) {
        return w.code == Code::modal && w.payload == program::modal_word(Modal::path_blend, 187);
    };
    if (std::none_of(s.words.begin(), s.words.end(), is_g187)) return;
    if (Address* p = find_address(s, 'P'); p != nullptr) p->used = true;
    Address* e = find_address(s, 'E');
    if (e == nullptr) return;
    e->used = true;
    put_value(s, Order::value, Code::p, scaled(s, e->value, Quantity::length), *e);
}

/// The block's coordinates are ways from where the tool is: G91, or U, V, W, H of lathes in system A.
bool is_incremental_block(FanucState& s) {
    if (s.incremental) return true;
    if (!s.control.is_lathe() || s.control.system != dialect::rs274::GSystem::a) return false;
    const auto has = [&](std::string_view letters) {
        return std::any_of(letters.begin(), letters.end(), [&](char c) { return find_address(s, c) != nullptr; });
    };
    return has("UVWH") && !has("XYZC");
}

/// "When an incremental command is specified, the G53 command is ignored" (FANUC B-63684EN, machine coordinate system);
/// what Haas does was not to be found.
void drop_machine_position(FanucState& s, BlockWord& word) {
    word.payload = program::modal_word(Modal::suppress_all, program::position_ignored);  // said when it is run
    if (!s.control.haas) return;
    s.facts.refused = true;
    add_problem(s, Code::unsupported, word.begin, word.end, "machine coordinates as ways from where the tool is");
}

/// G1 of the block holds from the next one on.
void run_as_rapid(FanucState& s) {
    const auto own = std::find_if(s.words.begin(), s.words.end(),
                                  [](const BlockWord& w) { return w.code == Code::modal && w.modal == Modal::linear; });
    if (own == s.words.end()) return;
    own->modal = Modal::rapid;
    own->payload = program::modal_word(Modal::rapid, 0);
    s.restore_motion = true;
}

/// G53 moves in rapid traverse whatever holds; what held comes back behind it.
void machine_position(FanucState& s) {
    const auto found = std::find_if(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        return w.code == Code::modal && w.modal == Modal::suppress_all;
    });
    if (found == s.words.end()) return;
    if (hole_of(s) != 0) {
        s.facts.refused = true;
        return add_problem(s, Code::unsupported, found->begin, found->end,
                           "machine coordinates while a hole cycle is in force: write G80 before them");
    }
    if (is_incremental_block(s)) return drop_machine_position(s, *found);
    if (s.motion == Modal::rapid || (s.own_motion && (s.control.haas || s.motion != Modal::linear))) return;
    if (s.own_motion) return run_as_rapid(s);
    const std::uint32_t begin = found->begin, end = found->end;
    add_modal(s, Order::motion, Modal::rapid, 0, begin, end);
    s.restore_motion = true;
}

}  // namespace

void run_specials(FanucState& s) {
    datum_with_number(s);
    corner_rounding(s);
    continued_thread(s);
    for (const Special& x : std::vector<Special>(s.special)) {
        if (s.failed) return;
        switch (x.g->special) {
            case FanucSpecial::dwell: dwell(s, *x.g, x.address); break;
            case FanucSpecial::home: home(s, *x.g, x.address); break;
            case FanucSpecial::probe: add_modal(s, x.g->order, x.g->modal, 1, x.address.begin, x.address.end); break;
            case FanucSpecial::set_data: set_data(s, *x.g, x.address); break;
            case FanucSpecial::position: position(s, *x.g, x.address); break;
            case FanucSpecial::datum_number: extended_datum(s, x.g->number, x.address); break;
            case FanucSpecial::canned: hole_cycle(s, *x.g, x.address); break;
            case FanucSpecial::thread: thread(s, *x.g, x.address); break;
            case FanucSpecial::polar_face:
            case FanucSpecial::cylinder_face:
            case FanucSpecial::interpolation_off: surface_special(s, *x.g, x.address); break;
            case FanucSpecial::local_pattern: hole_pattern(s, *x.g, x.address); break;
            default:
                frame_special(s, *x.g, x.address);
                turning_special(s, *x.g, x.address);
                break;
        }
    }
    if (!s.failed) machine_position(s);
}

}  // namespace obrys::read::rs274
