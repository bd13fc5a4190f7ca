#include "path/compensation/rs274_testing.hpp"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "base/number.hpp"
#include "path/compensation/preset.hpp"
#include "path/compensation/refusal.hpp"

namespace obrys::path::test {

namespace {

using geom::Vec2;
using Words = std::map<char, double>;

/// G codes by ten times their number.
struct Block {
    std::vector<int> g, m;
    Words words;
    std::optional<int> marker;
};

Block read(const std::string& line) {
    Block b;
    for (std::size_t i = 0; i < line.size() && line[i] != ';';) {
        const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(line[i++])));
        if (c == '(') {
            if (line.compare(i, 5, "MSG,c") == 0) b.marker = static_cast<int>(number(line, i += 5));
            i = line.find(')', i);
            i = i == std::string::npos ? line.size() : i + 1;
        } else if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            while (i < line.size() && line[i] == ' ') ++i;
            const double v = number(line, i);
            if (c == 'G')
                b.g.push_back(static_cast<int>(std::lround(10 * v)));
            else if (c == 'M')
                b.m.push_back(static_cast<int>(std::lround(v)));
            else
                b.words[c] = v;
        }
    }
    return b;
}

/// The program with its subs put in the place of their calls and #100 replaced by its value.
std::vector<std::string> flat(const std::string& program) {
    std::vector<std::string> lines;
    std::map<std::string, std::vector<std::string>> subs;
    std::string open, value = "0";
    const auto add = [&](std::string line) {
        const std::size_t at = line.find("#100");
        lines.push_back(at == std::string::npos ? std::move(line) : line.replace(at, 4, value));
    };
    std::istringstream in(program);
    for (std::string line; std::getline(in, line);) {
        const std::string name = line.substr(0, line.find(' '));
        if (line.starts_with("#100="))
            value = line.substr(5);
        else if (line.ends_with(" endsub"))
            open.clear();
        else if (line.ends_with(" sub"))
            open = name;
        else if (line.ends_with(" call"))
            for (const std::string& l : subs[name]) add(l);
        else if (open.empty())
            add(line);
        else
            subs[open].push_back(line);
    }
    return lines;
}

class Machine {
public:
    explicit Machine(const std::vector<TableTool>& table) : table_(table) { stretches_.emplace_back(); }

    void run(const std::string& line) {
        const Block b = read(line);
        if (b.marker) {
            stretches_.emplace_back();
            path_ = ContourPath{};
            waiting_.clear();
            add({Call::Kind::marker, {static_cast<double>(*b.marker)}, 0});
        }
        if (!stretches_.back().refusal.empty()) return;
        line_ = line;
        for (const int g : b.g) select(g, b);
        if (b.words.contains('T')) selected_ = static_cast<int>(b.words.at('T'));
        for (const int m : b.m) technology(m);
        if (g40_) switch_off();
        const bool shifts = !b.g.empty() && b.g.front() == 920;
        if (stretches_.back().refusal.empty() && moves(b) && !shifts) move(b);
        for (const int m : b.m) stop(m);
    }

    std::vector<Stretch> stretches_;

private:
    static bool moves(const Block& b) {
        for (const char c : {'X', 'Y', 'Z'})
            if (b.words.contains(c)) return true;
        return b.words.contains('I') || b.words.contains('J') || b.words.contains('K');
    }

    void select(int g, const Block& b) {
        switch (g) {
            case 0:
            case 10:
            case 20:
            case 30: motion_ = g / 10; break;
            case 170:
            case 180: plane_ = g / 10; break;
            case 200: unit_ = 25.4; break;
            case 210: unit_ = 1; break;
            case 400: g40_ = true; break;
            case 410:
            case 420:
            case 411:
            case 421: select_side(g, b); break;
            case 920: preset(b); break;
            case 921: preset_off(); break;
            case 900: incremental_ = false; break;
            case 910: incremental_ = true; break;
            default: break;
        }
        setting_.limits = held_move_preset(unit_).limits;
    }

    void select_side(int g, const Block& b) {
        int orientation = 0;
        double diameter = 0;
        if (g % 10 == 1) {
            diameter = b.words.at('D');
            if (b.words.contains('L')) orientation = static_cast<int>(b.words.at('L'));
        } else {
            const int tool = b.words.contains('D') ? static_cast<int>(b.words.at('D')) : tool_;
            for (const TableTool& t : table_)
                if (t.number == tool) orientation = t.orientation, diameter = t.diameter;
        }
        setting_ = held_move_preset(unit_);
        setting_.side = g / 10 == 41 ? Side::left : Side::right;
        setting_.radius = 0.5 * diameter * unit_;
        if (plane_ == 18) setting_.tip = table_nose_offset(orientation, std::abs(setting_.radius)).value_or(Vec2{});
    }

    void preset(const Block& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (!b.words.contains("XYZ"[i])) continue;
            const double is = b.words.at("XYZ"[i]) * unit_;
            preset_[i] += position_[i] - is;
            position_[i] = is;
        }
    }

    void preset_off() {
        for (std::size_t i = 0; i < 3; ++i) position_[i] += std::exchange(preset_[i], 0);
    }

    void technology(int m) {
        if (m == 6) tool_ = selected_;
        if (m == 8 || m == 9) waiting_.push_back(m == 8 ? 1 : 0);
        if ((m == 8 || m == 9) && path_.idle()) give_waiting();
    }

    void stop(int m) {
        if (m != 0 && m != 2) return;
        take(path_.flush([this](const Output& o) { output(o); }));
        if (stretches_.back().refusal.empty()) give_waiting();
    }

    void switch_off() {
        g40_ = false;
        setting_ = {};
        take(path_.switch_off([this](const Output& o) { output(o); }));
    }

    void give_waiting() {
        for (const int on : waiting_) add({Call::Kind::flood, {static_cast<double>(on)}, 0});
        waiting_.clear();
    }

    [[nodiscard]] std::array<double, 3> in_plane(const std::array<double, 3>& p) const {
        if (plane_ == 17) return p;
        return {p[2], p[0], p[1]};
    }

    void move(const Block& b) {
        std::array<double, 3> to = position_;
        for (std::size_t i = 0; i < 3; ++i)
            if (const auto w = b.words.find("XYZ"[i]); w != b.words.end())
                to[i] = w->second * unit_ + (incremental_ ? position_[i] : 0);
        const auto from = in_plane(position_), end = in_plane(to);
        Element e = line({from[0], from[1]}, {end[0], end[1]}, from[2]);
        e.w_to = end[2];
        if (motion_ > 1) bend(e, b);
        e.tag = rapid_.size();
        rapid_.push_back(motion_ == 0);
        e.before = std::exchange(waiting_, {});
        setting_.rapid = motion_ == 0;
        position_ = to;
        if (setting_.side == Side::off && path_.idle()) return output({std::move(e), Kind::passed});
        take(path_.push(std::move(e), setting_, {}, [this](const Output& o) { output(o); }));
    }

    void bend(Element& e, const Block& b) {
        const double turn = motion_ == 3 ? 1 : -1;
        const auto word = [&](char c) { return b.words.contains(c) ? b.words.at(c) * unit_ : 0; };
        if (b.words.contains('R')) {
            const double r = word('R');
            const Vec2 chord = e.to - e.from;
            const double l = geom::length(chord), h = std::sqrt(std::max(0.0, r * r - 0.25 * l * l));
            e.centre = e.from + 0.5 * chord + (turn * std::copysign(h, r) / l) * geom::left_of(chord);
        } else {
            const auto c = in_plane({word('I'), word('J'), word('K')});
            e.centre = e.from + Vec2{c[0], c[1]};
        }
        double angle = turn * turn_between(e.from - e.centre, e.to - e.centre);
        if (angle <= 1e-12) angle += 2 * geom::pi;
        const double more = b.words.contains('P') ? b.words.at('P') - 1 : 0;
        e.sweep = turn * (angle + 2 * geom::pi * more);
    }

    void output(const Output& o) {
        const Element& e = o.element;
        for (const int on : e.before) add({Call::Kind::flood, {static_cast<double>(on)}, 0});
        if (o.kind == Kind::events) return;
        const double k = 1 / unit_;
        if (is_arc(e)) {
            const double turns = std::max(1.0, std::ceil(std::abs(e.sweep) / (2 * geom::pi) - 1e-9));
            add({Call::Kind::arc,
                 {k * e.to.x, k * e.to.y, k * e.centre.x, k * e.centre.y, std::copysign(turns, e.sweep), k * e.w_to},
                 0});
            return;
        }
        const bool rapid = rapid_[e.tag];
        std::vector<double> v{k * e.to.x, k * e.to.y, k * e.w_to};
        if (plane_ == 18) v = {v[1], v[2], v[0]};
        add({rapid ? Call::Kind::traverse : Call::Kind::feed, v, 0});
    }

    void take(const PathFaults& faults) {
        for (const Fault& f : faults.compensation) {
            stretches_.back().refusal = message(f, unit_);
            stretches_.back().block = line_;
            return;
        }
    }

    void add(Call c) { stretches_.back().calls.push_back(std::move(c)); }

    const std::vector<TableTool>& table_;
    ContourPath path_;
    Setting setting_;
    std::string line_;
    std::array<double, 3> position_{}, preset_{};
    std::vector<bool> rapid_;
    Events waiting_;
    double unit_ = 1;
    int motion_ = 1, plane_ = 17, tool_ = 0, selected_ = 0;
    bool incremental_ = false, g40_ = false;
};

}  // namespace

std::vector<Stretch> run_here(const std::string& program, const std::vector<TableTool>& table) {
    Machine machine(table);
    for (const std::string& line : flat(program)) machine.run(line);
    return std::move(machine.stretches_);
}

}  // namespace obrys::path::test
