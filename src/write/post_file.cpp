#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "shop/files/section.hpp"
#include "write/commands.hpp"
#include "write/post.hpp"
#include "write/post_hooks.hpp"
#include "write/post_magazine.hpp"
#include "write/post_staircase.hpp"

namespace obrys::write {

namespace {

using shop::Entry;
using shop::Section;
namespace codes = base::codes;

/// Reads one post file; what it extends is in it already.
class Reader {
public:
    Reader(Section& file, Post& post) : file_(file), post_(post), grammar_(post.grammar) {}

    void read() {
        post_.title = file_.text("title").value_or("");
        post_.control = file_.text("control").value_or("");
        post_.suffix = file_.text("suffix").value_or("nc");
        post_.for_mills_alone = file_.boolean("mills_alone").value_or(false);
        if (const auto ends = file_.choice("line_end", {"lf", "crlf"})) post_.line_end = *ends == 0 ? "\n" : "\r\n";
        if (const auto tape = file_.choice("tape", {"none", "iso", "eia"})) post_.tape = static_cast<Tape>(*tape);
        if (const auto by = file_.choice("written_by", {"templates", "canon"})) post_.is_canon = *by == 1;
        post_.block_end = file_.text("block_end").value_or("");
        for (const std::string_view known : {"extends", "statements", "expressions", "operators", "functions",
                                             "parameters", "flow", "words", "frames", "system", "cycle-program"})
            static_cast<void>(file_.take(known));  // the tables: rewrite/language.hpp
        read_numbers();
        read_modal();
        read_commands();
        read_block_numbers();
        post_.subprogram = subprograms("subprogram");
        post_.own_file = subprograms("subprogram_file");
        read_datums();
        read_cycles();
    }

private:
    void complain(base::Span where, std::string text) { file_.error(codes::job_value, where, std::move(text)); }

    template <class Of>
    static std::size_t style_of(Of of) {
        return static_cast<std::size_t>(usual_style(of));
    }

    /// The control's least input increment, a decimal part of a millimetre.
    void read_increment(const Entry& e) {
        const bool is_number = e.value.kind == shop::ValueKind::number;
        const double value = is_number ? e.value.number : 0, digits = std::round(-std::log10(value));
        constexpr double most_digits = 6, noise = 1e-9;
        if (!(value > 0 && digits >= 0 && digits <= most_digits && std::abs(value * std::pow(10, digits) - 1) < noise))
            return complain(e.value.where, "'increment' is 1 mm or a decimal part of it (0.001, 0.0001)");
        post_.increment = value;
    }

    void read_numbers() {
        post_.styles.assign(usual_styles.size(), {});
        for (const std::string_view name : usual_styles) grammar_.style_names.emplace_back(name);
        NumberStyle& whole = post_.styles[static_cast<std::size_t>(Usual::whole)];
        whole.decimals = 0;
        whole.exact = true;
        const Entry* table = file_.sub_table("numbers");
        for (const Entry& e : table ? table->value.entries : std::vector<Entry>{}) {
            if (e.key == "increment") {
                read_increment(e);
                continue;
            }
            Section s(e.value, "[numbers] " + e.key, file_.diagnostics());
            const auto found = std::find(grammar_.style_names.begin(), grammar_.style_names.end(), e.key);
            const auto at = static_cast<std::size_t>(found - grammar_.style_names.begin());
            if (found == grammar_.style_names.end()) grammar_.style_names.push_back(e.key), post_.styles.emplace_back();
            NumberStyle& style = post_.styles[at];
            if (const auto d = s.integer("decimals", 0, 9)) style.decimals = static_cast<int>(*d);
            if (const auto d = s.integer("digits", 1, 9)) style.digits = static_cast<int>(*d);
            if (const auto d = s.integer("least", 0, style.decimals)) style.least = static_cast<int>(*d);
            style.point = s.boolean("point").value_or(style.point);
            style.of_increments = s.boolean("increments").value_or(style.of_increments);
            style.exact = s.boolean("exact").value_or(style.exact);
            style.plus = s.boolean("plus").value_or(style.plus);
            style.factor = s.number("factor").value_or(style.factor);
            if (style.factor == 0) complain(place(s, "factor"), "'factor' must not be 0");
            style.most = s.number("most", shop::Range::value).value_or(style.most);
            style.at_rapid = s.text("at_rapid").value_or(style.at_rapid);
            s.finish();
        }
        if (post_.increment > 0) count_in(post_, post_.increment);
        grammar_.style_of.resize(value_count);
        for (std::size_t v = 0; v < first_role; ++v) grammar_.style_of[v] = style_of(static_cast<Value>(v));
        for (std::size_t v = first_role; v < value_count; ++v)
            grammar_.style_of[v] = style_of(static_cast<cl::CycleRole>(v - first_role));
    }

    void read_modal() {
        const Entry* table = file_.sub_table("modal");
        if (!table) return;
        Section s(table->value, "[modal]", file_.diagnostics());
        const std::vector<std::string> coordinates = s.texts("coordinates"), others = s.texts("words");
        for (const auto* list : {&coordinates, &others})
            grammar_.modal_words.insert(grammar_.modal_words.end(), list->begin(), list->end());
        post_.words = grammar_.modal_words.size();
        post_.word_is_coordinate.assign(post_.words, false);
        std::fill_n(post_.word_is_coordinate.begin(), coordinates.size(), true);
        if (const Entry* groups = s.take("groups")) {
            for (const shop::Value& group : groups->value.items) {
                std::vector<std::string> words;
                if (group.kind != shop::ValueKind::array) complain(group.where, "'groups' is a list of lists of words");
                for (const shop::Value& word : group.items) words.push_back(word.text);
                grammar_.groups.push_back(std::move(words));
            }
        }
        post_.groups = grammar_.groups;
        post_.in_force = s.texts("start");
        s.finish();
    }

    /// A text that says nothing is no block: what the post below has is taken back.
    Template blocks(Section& s, std::string_view key) {
        Template out;
        for (const shop::Value* text : s.text_values(key)) {
            std::string error;
            auto block = parse_block(text->text, grammar_, error);
            if (!block)
                complain(text->where, error);
            else if (!block->empty())
                out.push_back(std::move(*block));
        }
        return out;
    }

    /// "no" takes back what the post below says.
    static std::string stopped_by(Section& s) {
        std::string word = s.text("stops_spindle").value_or("");
        return word == "no" ? "" : word;
    }

    void read_commands() {
        for (std::size_t i = 0; i < command_names().size();) {
            const std::string_view name = command_names()[i].table;
            const Entry* table = file_.sub_table(name);
            const shop::Value none;
            Section s(table ? table->value : none, "[" + std::string(name) + "]", file_.diagnostics());
            for (; i < command_names().size() && command_names()[i].table == name; ++i)
                if (table) post_.commands[i] = blocks(s, command_names()[i].key);
            if (!table) continue;
            if (name == "motion") {
                post_.most_sweep = s.number("most_sweep", shop::Range::positive).value_or(0);
                post_.least_arc = s.number("least_arc", shop::Range::not_negative).value_or(0);
                post_.by_quadrants = s.boolean("by_quadrants").value_or(false);
            }
            if (name == "tool") post_.change_stops_spindle = stopped_by(s);
            if (name == "spindle")
                post_.most_tapping_speed = s.number("most_tapping", shop::Range::positive).value_or(0);
            if (name == "tool") post_.repeats_tool = s.boolean("repeats").value_or(false);
            if (name == "tool") post_.length_moves = s.boolean("length_moves").value_or(false);
            if (name == "frame") post_.plane_is_whole = s.boolean("plane_is_whole").value_or(false);
            if (name == "frame") post_.plane_anew = s.boolean("plane_anew").value_or(false);
            if (name == "plane") post_.plane_returns = s.boolean("returns").value_or(false);
            if (name == "plane") post_.plane_by_centre = s.boolean("by_centre").value_or(false);
            if (name == "stop") post_.stop_stops_spindle = stopped_by(s);
            if (name == "cycles") post_.speeds_call_cycle = s.boolean("speeds_call").value_or(false);
            if (name == "cycles") post_.place_known_behind_cycle = s.boolean("place_known").value_or(false);
            if (name == "cycles") post_.raises_to_retract_plane = s.boolean("raises_first").value_or(false);
            if (name == "cycles") post_.rise_before_cycle_end = s.boolean("rise_before_end").value_or(false);
            if (name == "cycles") post_.kept_in_cycles = s.texts("keeps");
            if (name == "file") read_file_table(s);
            if (name == "corner") post_.corner_in_block = s.boolean("in_block").value_or(true);
            if (name == "cycles") read_inheritance(s);
            if (name == "function") read_functions(s, post_);
            if (name == "text") post_.comments = comment_rules(s);
            s.finish();
        }
    }

    void read_block_numbers() {
        const Entry* table = file_.sub_table("block_numbers");
        if (!table) return;
        Section s(table->value, "[block_numbers]", file_.diagnostics());
        BlockNumbers numbers;
        if (const Template t = blocks(s, "text"); !t.empty()) numbers.text = t.front();
        numbers.skip = s.texts("skip");
        if (const auto n = s.integer("first", 0, 99'999'999)) numbers.first = static_cast<double>(*n);
        numbers.step = s.number("step", shop::Range::positive).value_or(numbers.step);
        s.finish();
        post_.numbers = std::move(numbers);
    }

    std::optional<SubprogramForm> subprograms(std::string_view key) {
        const Entry* table = file_.sub_table(key);
        if (!table) return std::nullopt;
        Section s(table->value, "[" + std::string(key) + "]", file_.diagnostics());
        SubprogramForm form;
        const bool own = key == "subprogram_file";
        form.place =
            own ? SubprogramPlace::file : static_cast<SubprogramPlace>(s.choice("place", {"end", "here"}).value_or(0));
        form.first = s.number("first").value_or(form.first);
        form.lower = s.boolean("lower").value_or(false);
        form.begin = blocks(s, "begin");
        form.end = blocks(s, "end");
        form.call = blocks(s, "call");
        form.repeat = blocks(s, "repeat");
        if (own) form.file_name = blocks(s, "name");
        if (form.call.empty() || (own && form.file_name.empty()))
            complain(table->value.where, "'" + std::string(own ? "name' and 'call'" : "call'") + " must be said");
        s.finish();
        return form;
    }

    void read_datums() {
        for (const shop::Value* v : file_.tables("datum")) {
            Section s(*v, "[[datum]]", file_.diagnostics());
            DatumForm form;
            form.from = static_cast<std::uint32_t>(s.integer("from", 0, 100'000).value_or(0));
            form.to = static_cast<std::uint32_t>(s.integer("to", 0, 100'000).value_or(form.from));
            if (form.to < form.from) complain(place(s, "to"), "'to' must not be less than 'from'");
            form.less = s.number("less").value_or(0);
            form.text = blocks(s, "text");
            form.set = blocks(s, "set");
            form.add = blocks(s, "add");
            form.set_less = s.number("set_less").value_or(form.less);
            s.finish();
            post_.datums.push_back(std::move(form));
        }
    }

    void read_file_table(Section& s) {
        post_.encoding = encoding_of(s);
        post_.longest_name = static_cast<std::size_t>(s.integer("longest_name", 1, 255).value_or(0));
        post_.name_is_plain = s.boolean("plain_name").value_or(false);
    }

    /// What joined() has looked at.
    void read_inheritance(Section& s) {
        static_cast<void>(s.boolean("inherit"));
        for (const shop::Value* kind : s.text_values("without"))
            if (!cl::cycle_kind_spelt(kind->text))
                complain(kind->where, "there is no kind of cycle called '" + kind->text + "'");
    }

    std::optional<Condition> condition(const shop::Value& v) {
        std::string_view text = v.text;
        Condition c;
        if (text.starts_with('!')) c.present = false, text.remove_prefix(1);
        if (const std::size_t at = text.find('='); at != std::string_view::npos) {
            c.equals = base::parse_double(text.substr(at + 1));
            if (!c.equals) return complain(v.where, "what stands behind = is no number"), std::nullopt;
            text = text.substr(0, at);
        }
        const auto value = value_named(text, true);
        if (!value) return complain(v.where, "there is no value called '" + std::string(text) + "'"), std::nullopt;
        c.value = *value;
        return c;
    }

    void read_cycles() {
        grammar_.in_cycle = true;
        for (const shop::Value* v : file_.tables("cycle")) {
            Section s(*v, "[[cycle]]", file_.diagnostics());
            CycleForm form;
            for (const shop::Value* text : s.text_values("when"))
                if (const auto c = condition(*text)) form.when.push_back(*c);
            for (const shop::Value* text : s.text_values("unsaid"))
                if (const auto c = condition(*text)) form.unsaid.push_back(c->value);
            form.define = blocks(s, "define");
            form.call = blocks(s, "call");
            form.moves_over = s.boolean("moves_over").value_or(false);
            form.stops_spindle = s.text("stops_spindle").value_or("");
            for (const shop::Value* kind : s.text_values("kind")) {
                if (const auto known = cl::cycle_kind_spelt(kind->text))
                    post_.cycles[*known].push_back(form);
                else
                    complain(kind->where, "there is no kind of cycle called '" + kind->text + "'");
            }
            s.finish();
        }
        grammar_.in_cycle = false;
    }

    Section& file_;
    Post& post_;
    Grammar& grammar_;
};

}  // namespace

base::CommentRules comment_rules(Section& s) {
    base::CommentRules rules;
    rules.plain = s.boolean("plain").value_or(false);
    rules.holds_quotes = s.boolean("holds_quotes").value_or(true);
    rules.holds_brackets = s.boolean("holds_brackets").value_or(true);
    rules.active = s.texts("active");
    if (const auto n = s.integer("longest", 1, 10'000)) rules.longest = static_cast<std::size_t>(*n);
    return rules;
}

Encoding encoding_of(Section& file) {
    return static_cast<Encoding>(file.choice("encoding", {"utf-8", "windows-1252", "ascii"}).value_or(0));
}

std::optional<Post> read_post(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics,
                              const LoadText& load) {
    base::Sources texts;
    const auto root = whole_post(file, sources, texts, diagnostics, load);
    if (!root) return std::nullopt;
    base::Diagnostics own;
    Section section(*root, "the post", own);
    Post post;
    Reader(section, post).read();
    read_hooks(section, sources, load, post);
    read_staircase(section, post);
    read_magazine(section, post);
    section.finish_file(diagnostics);
    const bool lacks_hooks = shop::find(*root, "lua") != nullptr && !post.lua;  // load has said why
    if (own.has_errors() || lacks_hooks) return std::nullopt;
    return post;
}

}  // namespace obrys::write
