#include "write/preview.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "write/printer.hpp"
#include "write/samples.hpp"

namespace obrys::write {

namespace {

class Preview {
public:
    Preview(const Post& post, const Choice& choice)
        : post_(post), choice_(choice), printer_(post, [](std::string_view) {}) {
        HookFault fault;  // read_post has tried them out
        if (post.lua) hooks_ = load_hooks(post.lua->text, post.named_styles(), fault);
    }

    void add(const CommandName& c) {
        Previewed p;
        p.command = c.name;
        const Template& usual = post_[c.command];
        values_.clear();
        for (const Value v : {Value::x, Value::y, Value::z, Value::feed, Value::speed}) use(index_of(v), p);
        use_all(usual, p);
        set_texts(c.command);
        leave_out_the_impossible(c.command, usual, p);
        Template said;
        const bool asks = hooks_ != nullptr && post_.hooked.count(c.command) != 0;
        const bool by_hook = asks && ask(p, false, said);
        if (p.fault.empty()) print(by_hook ? said : usual, p);
        keep_used(by_hook ? said : usual, p);
        out.push_back(std::move(p));
    }

    void add(cl::CycleKind kind) {
        const auto forms = post_.cycles.find(kind);
        const bool hooked = hooks_ != nullptr && post_.hooked_cycles.count(kind) != 0;
        if (forms != post_.cycles.end())
            for (const CycleForm& form : forms->second) add_form(kind, form, hooked);
        else if (hooked)
            add_form(kind, {}, true);
    }

    std::vector<Previewed> out;

private:
    void use(ValueIndex v, Previewed& p) {
        const std::string name(v < first_role ? name_of(static_cast<Value>(v))
                                              : cl::spelling(static_cast<cl::CycleRole>(v - first_role)));
        const auto chosen = choice_.find(name);
        const double number = chosen == choice_.end() ? sample_value(v) : chosen->second;
        values_.set(v, number);
        const bool known =
            std::any_of(p.values.begin(), p.values.end(), [&](const ChosenValue& c) { return c.value == v; });
        if (!known) p.values.push_back({v, name, number});
    }

    void use_all(const Template& form, Previewed& p) {
        for (ValueIndex v = 0; v < value_count; ++v)
            if (says(form, v)) use(v, p);
    }

    /// Those that nobody looks at are not shown, but those that somebody has chosen.
    void keep_used(const Template& form, Previewed& p) const {
        const bool feeds = has_part(form, Part::feed);
        std::erase_if(p.values, [&](const ChosenValue& c) {
            return !says(form, c.value) && choice_.count(c.name) == 0 && !(feeds && c.value == index_of(Value::feed));
        });
    }

    void set_texts(Command command) {
        const bool axis = command == Command::axis || command == Command::axis_numbered;
        values_.set(Text::name, !axis ? "NAME" : command == Command::axis_numbered ? "C2" : "C");
        values_.set(Text::text, "TEXT");
        const bool has_m = post_.function_letters.empty() || post_.function_letters.find('M') != std::string::npos;
        values_.set(Text::letter, has_m ? "M" : post_.function_letters.substr(0, 1));
    }

    void leave_out(Value v, Previewed& p) {
        if (choice_.count(std::string(name_of(v))) != 0) return;
        values_.drop(v);
        std::erase_if(p.values, [&](const ChosenValue& c) { return c.value == index_of(v); });
    }

    /// What the writer never says in one block: the pitch along several axes, a function that the post refuses, moves
    /// along several axes of a control that makes staircases of them.
    void leave_out_the_impossible(Command command, const Template& form, Previewed& p) {
        const auto has = [&](Value v) { return says(form, index_of(v)); };
        if (has(Value::pitch_z))
            leave_out(Value::pitch_x, p), leave_out(Value::pitch_y, p);
        else if (has(Value::pitch_x))
            leave_out(Value::pitch_y, p);
        const bool moves = command == Command::rapid || command == Command::linear;
        if (moves && post_.staircase) leave_out(Value::y, p), leave_out(Value::z, p);
        if (command == Command::function) choose_function(p);
    }

    void choose_function(Previewed& p) {
        const auto chosen = choice_.find("number");
        const auto refused = [&](int n) { return is_among(post_.functions_refused, 'M', n); };
        int number = chosen != choice_.end() ? base::clipped<int>(chosen->second, 0, 9999) : 10;
        constexpr int most = 999;
        while (chosen == choice_.end() && number < most && refused(number)) ++number;
        if (!is_among(post_.functions_with_speed, 'M', number)) leave_out(Value::speed, p);
        if (chosen != choice_.end()) return;
        values_.set(Value::number, number);
        for (ChosenValue& c : p.values)
            if (c.value == index_of(Value::number)) c.number = number;
    }

    bool ask(Previewed& p, bool in_cycle, Template& said) {
        const Hooked answer = hooks_->ask(p.command, values_, in_cycle);
        if (answer.kind == Hooked::Kind::refused) p.fault = "refused: " + answer.text;
        if (answer.kind == Hooked::Kind::failed)
            p.fault = "line " + std::to_string(answer.fault.line) + " of its Lua: " + answer.fault.text;
        if (answer.kind != Hooked::Kind::blocks) return false;
        Grammar grammar = post_.grammar;
        grammar.in_cycle = in_cycle;
        for (const std::string& text : answer.blocks) {
            if (auto block = parse_block(text, grammar, p.fault))
                said.push_back(std::move(*block));
            else
                return true;
        }
        use_all(said, p);
        return true;
    }

    void print(const Template& form, Previewed& p) {
        Parts parts;
        parts.feed = &post_[Command::feed_per_minute];
        for (const Block& block : form) {
            const bool optional =
                !block.empty() && block.front().kind == Token::Kind::literal && block.front().before == "?";
            const auto text = printer_.whole(optional ? Block(block.begin() + 1, block.end()) : block, values_, parts);
            if (!text) {
                p.fault = "a word cannot hold its number";
                p.blocks.clear();
                return;
            }
            if (!text->empty()) p.blocks.push_back(*text + post_.block_end);
        }
    }

    static std::string asked(const CycleForm& form) {
        std::string out;
        for (const Condition& c : form.when) {
            const std::string name(cl::spelling(static_cast<cl::CycleRole>(c.value - first_role)));
            out += (out.empty() ? "" : ", ") + (c.equals    ? name + " = " + base::shortest(*c.equals)
                                                : c.present ? "with " + name
                                                            : "without " + name);
        }
        return out;
    }

    void add_form(cl::CycleKind kind, const CycleForm& form, bool hooked) {
        Previewed p;
        p.command = "cycle." + std::string(cl::spelling(kind));
        p.form = asked(form);
        values_.clear();
        for (const Value v : {Value::x, Value::y, Value::z, Value::feed, Value::speed}) use(index_of(v), p);
        use_all(form.define, p);
        use_all(form.call, p);
        if (form.define.empty() && form.call.empty())
            for (ValueIndex v = first_role; v < value_count; ++v) use(v, p);
        for (const Condition& c : form.when) {
            if (!c.present) values_.drop(c.value);
            if (c.present) use(c.value, p);
            if (c.equals) values_.set(c.value, *c.equals);
        }
        Template all = form.define, said;
        all.insert(all.end(), form.call.begin(), form.call.end());
        const bool by_hook = hooked && ask(p, true, said);
        if (p.fault.empty()) print(by_hook ? said : all, p);
        keep_used(by_hook ? said : all, p);
        out.push_back(std::move(p));
    }

    const Post& post_;
    const Choice& choice_;
    Printer printer_;
    std::unique_ptr<Hooks> hooks_;
    Values values_;
};

constexpr std::string_view cycle_prefix = "cycle.";

}  // namespace

std::vector<Previewed> preview(const Post& post, const std::string& command, const Choice& choice) {
    Preview p(post, choice);
    for (const CommandName& c : command_names())
        if ((command.empty() || c.name == command) && post.has(c.command)) p.add(c);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(cl::CycleKind::probe); ++k) {
        const auto kind = static_cast<cl::CycleKind>(k);
        if (command.empty() || command == std::string(cycle_prefix) + std::string(cl::spelling(kind))) p.add(kind);
    }
    return std::move(p.out);
}

bool is_command_name(std::string_view name) {
    if (name.starts_with(cycle_prefix)) return cl::cycle_kind_spelt(name.substr(cycle_prefix.size())).has_value();
    const auto all = command_names();
    return std::any_of(all.begin(), all.end(), [&](const CommandName& c) { return c.name == name; });
}

bool is_value_name(std::string_view name) {
    return value_named(name, true).has_value() || value_named(name, false).has_value();
}

}  // namespace obrys::write
