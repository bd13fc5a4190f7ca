/// Functions of the post are asked before its templates.

#include "write/writer.hpp"

namespace obrys::write {

/// What the post's function says; its blocks, read as templates, in `said`. What it refuses, and what is wrong with it,
/// is noted.
Hooked Writer::ask(const std::string& name, std::string_view what, bool in_cycle, Template& said) {
    said.clear();
    Hooked answer = hooks_->ask(name, values_, in_cycle);
    if (answer.kind == Hooked::Kind::blocks) {
        Grammar grammar = post_.grammar;
        grammar.in_cycle = in_cycle;
        for (const std::string& text : answer.blocks) {
            std::string error;
            auto block = parse_block(text, grammar, error);
            if (!block) {
                answer.kind = Hooked::Kind::failed;
                answer.fault.text = error + " in \"" + text + '"';
                break;
            }
            if (!block->empty()) said.push_back(std::move(*block));
        }
    }
    if (answer.kind == Hooked::Kind::usual || answer.kind == Hooked::Kind::blocks) return answer;
    const bool fails = answer.kind == Hooked::Kind::failed;
    Note n{in_cycle ? Fate::expanded : Fate::lost, std::string(what) + ": ", {}, 0, 0};
    n.what +=
        fails ? "the post's function for " + name + ": " + answer.fault.text : "the post refuses it: " + answer.text;
    if (fails) n.fate = Fate::lost;
    if (fails) n.in_post = place_in(*post_.lua, answer.fault.line, answer.fault.near);
    note_at(std::move(n));
    return answer;
}

/// What the command prints now; null where the post's function refuses it.
const Template* Writer::form_of(Command command, std::string_view what) {
    if (hooks_ == nullptr || post_.hooked.count(command) == 0) return &post_[command];
    switch (ask(std::string(name_of(command)), what, false, said_).kind) {
        case Hooked::Kind::usual: return &post_[command];
        case Hooked::Kind::blocks: return &said_;
        case Hooked::Kind::refused:
        case Hooked::Kind::failed: break;
    }
    return nullptr;
}

Printed Writer::put(Command command, const Parts& parts, std::string_view what, bool moves) {
    const Template* form = form_of(command, what);
    if (form == nullptr) return Printed::refused;
    const Printed printed = printer_.print(*form, values_, parts, moves && form != &said_, form == &said_);
    if (form == &said_) printer_.forget_words_of(said_);
    return printed;
}

/// False where the function refuses the cycle, which then is written by its moves.
bool Writer::ask_cycle(const cl::Cycle& cycle, CycleForm& form) {
    const std::string kind(cl::spelling(cycle.kind));
    const Hooked answer = ask("cycle." + kind, "cycle " + kind, true, form.call);
    return answer.kind == Hooked::Kind::usual || answer.kind == Hooked::Kind::blocks;
}

}  // namespace obrys::write
