#include "write/lesser.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::write {

namespace {

/// Takes the words of these commands, the last one included; false where the post has none of them.
bool take_words(Post& post, Command first, Command last) {
    bool any = false;
    for (auto c = static_cast<std::size_t>(first); c <= static_cast<std::size_t>(last); ++c) {
        any = any || post.has(static_cast<Command>(c));
        post.commands[c].clear();
        post.hooked.erase(static_cast<Command>(c));
    }
    return any;
}

}  // namespace

bool leave_out_turns(Post& post) { return take_words(post, Command::plane_turn, Command::plane_move_off); }

bool leave_out_frames(Post& post) { return take_words(post, Command::shift, Command::programmed_off); }

double half_step(const Post& post, std::string_view style) {
    const std::vector<std::string>& names = post.grammar.style_names;
    for (std::size_t i = 0; i < names.size() && i < post.styles.size(); ++i)
        if (names[i] == style)
            return 0.5 * std::pow(10.0, -post.styles[i].decimals) / std::max(std::abs(post.styles[i].factor), 1e-9);
    return 0;
}

double least_arc(const Post& post) { return post.increment > 0 ? post.increment : post.least_arc; }

void count_in(Post& post, double increment) {
    post.increment = increment;
    for (NumberStyle& style : post.styles)
        if (style.of_increments) style.decimals = base::clipped(std::round(-std::log10(increment)), 0, 9);
}

}  // namespace obrys::write
