#include "post_start.hpp"

#include "driver/session.hpp"
#include "driver/translate.hpp"

namespace obrys::cli {

namespace {

/// As a TOML string.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out + "\"";
}

constexpr const char* start_of_post =
    R"toml(# A post of one's own: what it does not say is that of the post it extends. Every key: docs/posts.md.
#   obrys post check FILE      what it writes, refuses, and what the control makes of that
#   obrys post preview FILE    every command with chosen values
#   obrys translate PROGRAM --to FILE -o OUT

# [numbers]
# length = { decimals = 3, point = true }    # 10. and 10.125
# feed = { decimals = 1, most = 9999.0 }     # what F cannot hold is refused

# [block_numbers]
# text = "N{block}"
# first = 10
# step = 10
# skip = ["%", "O"]                          # blocks that begin so have none

# [file]
# begin = ["%", "O0001 ({name})"]
# end = "%"

# [tool]
# change = ["M5", "T{number} M6"]            # an array is several blocks

# [spindle]
# cw = "S{speed} M3"

# [text]
# longest = 40
# plain = true                               # capitals, digits and signs alone

# A way of writing a kind of cycle of its own, which is looked at before those of the post it extends:
# [[cycle]]
# kind = "canned-drill"
# when = "dwell-bottom"
# call = "{return-level?G98|G99} G82 X{x!} Y{y!} Z{bottom} R{retract-plane} P{dwell-bottom*1000:whole} {feed}"
# unsaid = "surface"
# moves_over = true

# What tables cannot say; functions get the values of the command and return a block, a list of blocks, or nothing.
# [lua]
# text = '''
# on["stop.optional"] = function(v)
#     return {"M5", "M1"}
# end
# '''
)toml";

}  // namespace

std::string post_start(const std::string& title, const std::string& extends) {
    driver::Session s;
    const auto below = driver::find_post(extends, s);
    std::string out = "extends = " + quoted(extends) + "\ntitle = " + quoted(title) + "\n";
    if (below && !below->control.empty())
        out += "control = " + quoted(below->control) +
               "    # that reads it back; \"\": none\nsuffix = " + quoted(below->suffix) + "\n";
    return out + "\n" + start_of_post;
}

}  // namespace obrys::cli
