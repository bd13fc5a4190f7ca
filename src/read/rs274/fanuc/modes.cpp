#include "read/rs274/fanuc/modes.hpp"

namespace obrys::read::rs274 {

using program::ModeTable;
using program::ModeUse;

void FanucModes::begin_program(const program::Modes& values) {
    values_ = values;
    states_.clear();
    uses_.clear();
    last_state_ = last_use_ = 0;
    begin_block();
}

void FanucModes::begin_block() {
    relied_ = written_ = 0;
    pieces_.clear();
}

void FanucModes::begin_piece() {
    written_ = 0;
    before_ = values_;
}

std::uint32_t FanucModes::state(ModeTable& table, const program::Modes& m) {
    if (last_state_ < table.states.size() && table.states[last_state_] == m) return last_state_;
    const auto [at, added] = states_.try_emplace(m, static_cast<std::uint32_t>(table.states.size()));
    if (added) table.states.push_back(m);
    return last_state_ = at->second;
}

std::uint32_t FanucModes::use(ModeTable& table, const ModeUse& u) {
    if (last_use_ < table.uses.size() && table.uses[last_use_] == u) return last_use_;
    const std::array<std::uint32_t, 6> key{u.before, u.after, u.relied, u.written, u.piece, u.whole ? 1U : 0U};
    const auto [at, added] = uses_.try_emplace(key, static_cast<std::uint32_t>(table.uses.size()));
    if (added) table.uses.push_back(u);
    return last_use_ = at->second;
}

void FanucModes::end_piece(ModeTable& table, Piece piece, bool good) {
    pieces_.push_back(piece);
    const program::ModeSet relied = good ? relied_ : 0;
    if ((relied == 0 && written_ == 0) || piece.first == piece.last) return;
    ModeUse u;
    u.before = state(table, before_);
    u.after = written_ == 0 ? u.before : state(table, values_);
    u.relied = relied;
    u.written = written_;
    u.piece = static_cast<std::uint8_t>(pieces_.size() - 1);
    u.whole = piece.last - piece.first > 1 || u.before != u.after;
    add_span(table, piece, use(table, u));
}

void FanucModes::add_span(ModeTable& table, Piece piece, std::uint32_t use) {
    std::vector<program::ModeSpan>& spans = table.spans;
    if (!table.uses[use].whole && !spans.empty() && spans.back().last == piece.first && spans.back().use == use)
        spans.back().last = piece.last;
    else
        spans.push_back({piece.first, piece.last, use});
}

}  // namespace obrys::read::rs274
