#include "write/post_hooks.hpp"

#include <algorithm>

#include "base/codes.hpp"

namespace obrys::write {

namespace {

namespace codes = base::codes;

/// Tables whose commands are parts of other blocks, and single commands of that kind.
bool is_part(const CommandName& c) {
    for (const std::string_view table : {"feed", "compensation", "axis", "corner"})
        if (c.table == table) return true;
    return c.name.starts_with("tool.length-");
}

const CommandName* command_named(std::string_view name) {
    const auto all = command_names();
    const auto found = std::find_if(all.begin(), all.end(), [&](const CommandName& c) { return c.name == name; });
    return found == all.end() ? nullptr : &*found;
}

/// What a function is for; why there can be none, where there can not.
std::string add_hook(const std::string& name, Post& post) {
    constexpr std::string_view cycle = "cycle.";
    if (name.starts_with(cycle)) {
        const auto kind = cl::cycle_kind_spelt(std::string_view(name).substr(cycle.size()));
        if (!kind) return "there is no kind of cycle called '" + name.substr(cycle.size()) + "'";
        post.hooked_cycles.insert(*kind);
        return {};
    }
    const CommandName* command = command_named(name);
    if (command == nullptr) return "there is no command called '" + name + "'";
    if (is_part(*command)) return "'" + name + "' is a part of other blocks: it can have no function";
    post.hooked.insert(command->command);
    return {};
}

/// The text as it stands in the TOML file, or the file that it names.
std::optional<HookText> text_of(shop::Section& s, const base::Sources& sources, const LoadText& load) {
    const auto text = s.text("text"), name = s.text("file");
    if (!s.one_of({"text", "file"}, true)) return std::nullopt;
    HookText out;
    if (text) {
        out.text = *text;
        out.where = shop::place(s, "text");
        const std::size_t at = sources.text(out.where).find(out.text);
        out.verbatim = at != std::string_view::npos && !out.text.empty();
        if (out.verbatim) out.where.begin += static_cast<std::uint32_t>(at);
        return out;
    }
    if (!name) return std::nullopt;
    const base::Span where = shop::place(s, "file");
    if (!load) return s.error(codes::job_value, where, "here a post can name no file"), std::nullopt;
    const auto file = load(*name, where);
    if (!file) return std::nullopt;
    out.text = sources[*file].text;
    out.where = {*file, 0, static_cast<std::uint32_t>(out.text.size())};
    out.verbatim = true;
    return out;
}

}  // namespace

void read_hooks(shop::Section& file, const base::Sources& sources, const LoadText& load, Post& post) {
    const shop::Entry* table = file.sub_table("lua");
    if (table == nullptr) return;
    shop::Section s(table->value, "[lua]", file.diagnostics());
    post.lua = text_of(s, sources, load);
    s.finish();
    if (!post.lua) return;
    if (!has_hooks())
        return file.error(codes::job_value, table->where,
                          "the post" + (post.title.empty() ? "" : " \"" + post.title + '"') +
                              " has functions in Lua, and this program was built without Lua");
    HookFault fault;
    const auto hooks = load_hooks(post.lua->text, post.named_styles(), fault);
    if (!hooks) return file.error(codes::job_value, place_in(*post.lua, fault.line, fault.near), fault.text);
    for (const std::string& name : hooks->names()) {
        const std::string why_not = add_hook(name, post);
        if (why_not.empty()) continue;
        const std::string quoted = '"' + name + '"';
        const std::size_t at = post.lua->text.find(quoted);
        const auto lines =
            std::count(post.lua->text.begin(),
                       post.lua->text.begin() + static_cast<std::ptrdiff_t>(std::min(at, post.lua->text.size())), '\n');
        const bool found = at != std::string::npos;
        file.error(codes::job_value,
                   place_in(*post.lua, found ? static_cast<std::size_t>(lines) + 1 : 1, found ? quoted : ""), why_not);
    }
}

}  // namespace obrys::write
