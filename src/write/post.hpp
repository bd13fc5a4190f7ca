#pragma once
/// A post: what the programs of a control look like, as data. File form: docs/posts.md.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/comment.hpp"
#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "cl/record.hpp"
#include "shop/files/document.hpp"
#include "shop/files/section.hpp"
#include "write/commands.hpp"
#include "write/functions.hpp"
#include "write/hooks.hpp"
#include "write/magazine.hpp"
#include "write/staircase_form.hpp"
#include "write/tape.hpp"
#include "write/template.hpp"

namespace obrys::write {

struct DatumForm {
    std::uint32_t from = 0, to = 0;  ///< numbers of zeros that it writes
    double less = 0;                 ///< the number written is that of the stream less this
    Template text;
    double set_less = 0;  ///< as `less`, in `set`
    Template set;         ///< gives it another place in the machine
    Template add;         ///< moves it by so much
};

struct Condition {
    ValueIndex value = 0;
    bool present = true;
    std::optional<double> equals{};
};

/// One way of writing a kind of cycle; the first of which all conditions hold and which says all that the cycle says.
struct CycleForm {
    std::vector<Condition> when;
    std::vector<ValueIndex> unsaid;  ///< roles that need not be said
    Template define;                 ///< where the values are others than those of the last cycle
    Template call;                   ///< at each place
    bool moves_over = false;         ///< the call moves over the hole by itself
    std::string stops_spindle;       ///< the word that is in force behind it (M5); empty: none comes into it
};

struct BlockNumbers {
    Block text;  ///< stands before each block
    double first = 10, step = 10;
    std::vector<std::string> skip;  ///< blocks that begin so have none
};

/// Where the text of a called part stands.
enum class SubprogramPlace : std::uint8_t {
    end,   ///< in the program's file, behind the end of the program
    here,  ///< in the program's file, before its first call
    file,  ///< in a file of its own
};

/// How a part that is called several times is written once. Values: `number`, `passes` of a repeated call; text `name`.
struct SubprogramForm {
    SubprogramPlace place = SubprogramPlace::end;
    double first = 1;    ///< number of the first one
    bool lower = false;  ///< names in small letters
    Template begin, end, call;
    Template repeat;     ///< the call of several passes; empty: call by call
    Template file_name;  ///< of those in files of their own
};

/// The characters of what is written.
enum class Encoding : std::uint8_t { utf8, windows_1252, ascii };

struct Post {
    std::string name, title, control, suffix;
    bool for_mills_alone = false;  ///< it has no words for programs of lathes
    bool is_canon = false;         ///< canonical calls (write/canon) instead of templates
    std::string block_end;         ///< behind each block (" *")
    std::string line_end = "\n";
    Tape tape = Tape::none;                  ///< code of the punched tape; none: the text as it is
    double most_sweep = 0;                   ///< degrees of an arc that one block holds; 0: a turn and more
    std::optional<MagazineForm> magazine;    ///< tools are written by their places and offsets
    double most_tapping_speed = 0;           ///< 1/min; 0: as fast as the spindle turns
    std::optional<StaircaseForm> staircase;  ///< the control moves one axis at a time
    bool by_quadrants = false;               ///< arcs end where they pass from one quadrant to the next
    Encoding encoding = Encoding::utf8;
    std::optional<SubprogramForm> subprogram;  ///< in the program's file
    std::optional<SubprogramForm> own_file;    ///< in files beside it
    /// mm: the control takes lengths in such steps and rounds what is finer (least input increment); 0: as written.
    double increment = 0;
    double least_arc =
        0;  ///< mm: such steps of a control whose posts say finer places; ends of arcs within one are one
    std::vector<NumberStyle> styles;
    std::size_t words = 0;                 ///< how many are modal
    std::vector<bool> word_is_coordinate;  ///< of those: forgotten where the frame changes
    std::vector<std::vector<std::string>> groups;
    std::vector<std::string> in_force;  ///< words of groups that hold at the begin
    std::array<Template, static_cast<std::size_t>(Command::count)> commands;
    std::vector<DatumForm> datums;
    std::map<cl::CycleKind, std::vector<CycleForm>> cycles;
    std::optional<BlockNumbers> numbers;
    std::string
        change_stops_spindle;      ///< the word that is in force behind a tool change (M5); empty: none comes into it
    bool repeats_tool = false;     ///< a tool that is in the spindle already is called again
    bool length_moves = false;     ///< its words alone may move the tool by its length: they stand beside Z
    bool plane_is_whole = false;   ///< a tilted plane is said with the shifts and turns around it as one where need be
    bool plane_anew = false;       ///< always so; it ends before another one is set, and the axes turn to each anew
    bool plane_by_centre = false;  ///< an arc lies in that of its centre's two coordinates, without a word for it
    bool plane_returns = false;    ///< to that of X and Y behind what asks for another one
    std::string stop_stops_spindle;         ///< the same of stops of the program
    bool speeds_call_cycle = false;         ///< a block with S in a series calls its cycle: it ends the series first
    bool place_known_behind_cycle = false;  ///< X, Y, Z that hold behind a cycle need not be said anew
    bool raises_to_retract_plane = false;   ///< before cycles, where the tool stands below it, and before it moves over
    std::vector<std::string> kept_in_cycles;  ///< letters of words that stay in force within a series of cycles
    bool rise_before_cycle_end = false;  ///< the way up between two cycles stands before the word that ends the first
    bool corner_in_block = true;         ///< of the element; else a block of its own behind it
    base::CommentRules comments;         ///< and other texts
    std::string function_letters;        ///< of functions that the control has; empty: all
    std::vector<FunctionNumbers> functions_refused;     ///< the control would take them for nothing, or something else
    std::vector<FunctionNumbers> functions_with_speed;  ///< beside which the speed stands
    std::size_t longest_name = 0;                       ///< of a program; 0: as long as it is
    bool name_is_plain = false;                         ///< it holds letters, digits, `_`, `-` and points alone
    std::optional<HookText> lua;                        ///< functions that are asked before the templates
    std::set<Command> hooked;                           ///< what it has functions for
    std::set<cl::CycleKind> hooked_cycles;
    Grammar grammar;  ///< of templates

    [[nodiscard]] const Template& operator[](Command c) const { return commands[static_cast<std::size_t>(c)]; }
    [[nodiscard]] bool has(Command c) const { return !(*this)[c].empty() || hooked.count(c) != 0; }
    [[nodiscard]] NamedStyles named_styles() const { return {grammar.style_names, styles}; }
};

/// Of [text] and [file] of a post.
[[nodiscard]] base::CommentRules comment_rules(shop::Section& text);
[[nodiscard]] Encoding encoding_of(shop::Section& file);

/// Loads a file that a post names, at the place that names it; nothing, with a complaint, where it is not there.
using LoadText = std::function<std::optional<std::uint32_t>(const std::string& name, const base::Span& where)>;

/// Reads a post; nothing, with what is wrong in `diagnostics`, where it cannot be used. Without `load` it may name no
/// file.
[[nodiscard]] std::optional<Post> read_post(std::uint32_t file, const base::Sources& sources,
                                            base::Diagnostics& diagnostics, const LoadText& load = {});

/// For a control that takes lengths in other increments (mm) than the post says.
void count_in(Post&, double increment);

/// A post's file as it is written, with all that it extends below it; places in that lie in `texts`.
[[nodiscard]] std::optional<shop::Value> whole_post(std::uint32_t file, const base::Sources& sources,
                                                    base::Sources& texts, base::Diagnostics& diagnostics,
                                                    const LoadText& load = {});

/// The shipped posts of folder posts/: name and text, built in.
struct ShippedPost {
    std::string_view name, text;
};
[[nodiscard]] const ShippedPost* shipped_post(std::string_view name);
[[nodiscard]] std::vector<std::string> shipped_post_names();

}  // namespace obrys::write
