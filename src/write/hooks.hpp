#pragma once
/// What a post says in Lua: functions by the names of commands and cycles, which get the values and say what is
/// written. They see no file, no process and no clock, and may take only so many steps and so much memory.
/// docs/posts.md.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.hpp"
#include "write/number_style.hpp"
#include "write/values.hpp"

namespace obrys::write {

/// Where the Lua text of a post stands.
struct HookText {
    std::string text;
    base::Span where;       ///< of the text
    bool verbatim = false;  ///< it stands there byte by byte, so that its lines have places of their own
};

/// The place of a line, counted from 1, of the text; of `near` within it where that stands there.
[[nodiscard]] base::Span place_in(const HookText& text, std::size_t line, std::string_view near = {});

/// What is wrong with the text.
struct HookFault {
    std::size_t line = 1;
    std::string text, near;
};

/// What a function has said.
struct Hooked {
    enum class Kind : std::uint8_t {
        usual,    ///< nothing: the template of the post stands
        blocks,   ///< templates of blocks, in the place of the post's
        refused,  ///< `text` says why
        failed    ///< it is wrong, or takes too long: `fault`
    };
    Kind kind = Kind::usual;
    std::vector<std::string> blocks;
    std::string text;
    HookFault fault;
};

struct NamedStyles {
    std::span<const std::string> names;
    std::span<const NumberStyle> styles;
};

class Hooks {
public:
    virtual ~Hooks() = default;
    /// Those that it has functions for.
    [[nodiscard]] virtual std::vector<std::string> names() const = 0;
    /// A function that has failed is not called again.
    [[nodiscard]] virtual Hooked ask(const std::string& name, const Values& values, bool in_cycle) = 0;
};

/// Whether this program was built with Lua.
[[nodiscard]] bool has_hooks();
/// Runs the text, which defines the functions; null, with what is wrong, where it cannot be used.
[[nodiscard]] std::unique_ptr<Hooks> load_hooks(const std::string& text, const NamedStyles& styles, HookFault& fault);

}  // namespace obrys::write
