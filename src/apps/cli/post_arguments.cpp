#include "post_arguments.hpp"

#include <CLI/CLI.hpp>

#include "arguments.hpp"
#include "base/number.hpp"
#include "help_texts.hpp"
#include "shop/nearest.hpp"
#include "words.hpp"
#include "write/post.hpp"
#include "write/preview.hpp"

namespace obrys::cli {

namespace {

void add_post_output(CLI::App& verb, Arguments& a) {
    verb.add_option("-o,--output", a.output, "write to this file instead of standard output")->type_name("FILE");
    verb.add_flag("--force", a.request.force, "replace files that are there");
}

void add_post_format(CLI::App& verb, Arguments& a, const std::vector<std::string>& formats) {
    verb.add_option("--format", a.format, shop::joined(formats) + " (text)")->check(only(formats))->type_name("FORMAT");
}

void add_post_name(CLI::App& verb, Arguments& a) {
    verb.add_option("post", a.post.name,
                    "a shipped post (" + shop::joined(write::shipped_post_names()) + ") or a file (.toml)")
        ->required()
        ->type_name("NAME|FILE");
}

/// "depth=-20" with a value that there is.
std::string is_choice(const std::string& text) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos || !base::parse_double(std::string_view(text).substr(at + 1)))
        return "\"" + text + "\" is not of the form NAME=NUMBER";
    if (!write::is_value_name(text.substr(0, at)))
        return "there is no value called \"" + text.substr(0, at) + "\" (docs/posts.md)";
    return "";
}

CLI::App* add_verb(CLI::App& post, Arguments& a, const char* name, const char* what, PostVerb verb) {
    CLI::App* out = post.add_subcommand(name, what);
    out->callback([&a, verb] { a.post.verb = verb; });
    return out;
}

}  // namespace

CLI::App* add_post(CLI::App& app, Arguments& a) {
    CLI::App* post = app.add_subcommand("post", post_help);
    post->require_subcommand(1);
    CLI::App* list = add_verb(*post, a, "list", "The posts that are shipped.", PostVerb::list);
    add_post_format(*list, a, {"text", "json"});
    add_post_output(*list, a);
    CLI::App* make = add_verb(*post, a, "new", "A commented file to begin a post of one's own with.", PostVerb::make);
    make->add_option("name", a.post.name, "what the post is called")->required()->type_name("NAME");
    make->add_option("--extends", a.post.extends, "the shipped post that it stands on (fanuc)")
        ->check(only(write::shipped_post_names()))
        ->type_name("NAME");
    add_post_output(*make, a);
    CLI::App* check =
        add_verb(*post, a, "check",
                 "Reads a post and tries it out: what it writes of every kind of record and cycle, what it "
                 "expands by moves,\nwhat it refuses, and what its control makes of what was written.",
                 PostVerb::check);
    add_post_name(*check, a);
    add_post_format(*check, a, {"text", "json"});
    check->add_flag("--all", a.post.all, "text: also the blocks that are written without a remark");
    add_post_output(*check, a);
    CLI::App* preview =
        add_verb(*post, a, "preview", "Prints every command of a post with chosen values.", PostVerb::preview);
    add_post_name(*preview, a);
    preview->add_option("--command", a.post.command, "this one only: motion.arc-cw, cycle.drill")
        ->check([](const std::string& name) {
            return write::is_command_name(name) ? std::string()
                                                : "there is no command called \"" + name + "\" (docs/posts.md)";
        })
        ->type_name("COMMAND");
    preview->add_option("--set", a.post.set, "another value than the sample's: depth=-20")
        ->check(is_choice)
        ->type_name("NAME=NUMBER")
        ->allow_extra_args(false)
        ->take_all();
    add_post_format(*preview, a, {"text", "html"});
    add_post_output(*preview, a);
    return post;
}

}  // namespace obrys::cli
