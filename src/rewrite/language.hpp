#pragma once
/// How a control spells what a program computes and where it goes: the tables [expressions], [parameters], [flow] and
/// [words] of its post, [frames], [system] and [[cycle-program]]. File form: docs/translate.md.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/comment.hpp"
#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "cl/cycle.hpp"
#include "write/post.hpp"

namespace obrys::rewrite {

/// Numbers that parameters may have: Q0 to Q99.
struct Pool {
    std::string letters;
    std::uint32_t first = 0, last = 0;
};

/// Zeros of the stream (docs/cl-stream.md) and their words: G54.1 P{number}, from 5401, less 5400.
struct Zeros {
    std::uint32_t first = 0, last = 0, less = 0;
    std::string text;
};

/// Where a program's own variables live.
enum class LocalPlace : std::uint8_t {
    file,     ///< numbered, the whole file has them in common: no two programs may use the same
    program,  ///< numbered, every called program has its own
    name,     ///< they keep their names
};

/// A cycle as a program of its own.
struct CycleProgram {
    std::string call;  ///< {name} and the cycle's values by their roles
    std::string feed;  ///< of the contour's blocks
    std::string away;  ///< what holds how far the tool's centre lies from the contour
    std::string text;  ///< of the program
};

struct Language {
    /// Texts by "table.key"; a key that is not there is what the control lacks.
    std::map<std::string, std::string, std::less<>> texts;
    std::string open = "(", close = ")";
    bool point = false;              ///< numbers have one: "5."
    bool sign = false;               ///< values of words have one: "+5"
    bool computes = true;            ///< words take expressions; else a number or a parameter alone
    bool across = false;             ///< X words are diameters
    bool corner_beside = true;       ///< chamfers and roundings stand in the element's block; else behind it
    bool frames_together = false;    ///< a frame is said whole; else each part for itself
    bool shift_before_turn = false;  ///< the shift cannot be changed while the axes are turned
    bool feed_ends_surface = false;  ///< saying per minute or revolution ends constant cutting speed
    bool subs_first = false;         ///< called programs stand before the main one
    bool numbered_labels = false, numbered_programs = false;
    bool end_stops_all = true;  ///< the end of the program, written in a called one, ends the run
    std::size_t longest_label = 0, longest_program = 0, longest_variable = 0;  ///< characters; 0: as long as it is
    std::string control;                                                       ///< that reads it
    std::function<bool(std::string_view)> is_word;  ///< one of that control's own, in capitals; empty: none is known
    std::vector<std::string> kept_names;            ///< what names of the control's maker begin with
    int step = 0;                                   ///< of block numbers; 0: blocks have none
    std::vector<Zeros> zeros;                       ///< as translations by motion write them; none: the control has one
    base::CommentRules comments;
    write::Encoding encoding = write::Encoding::utf8;
    std::vector<Pool> global, local;
    LocalPlace local_place = LocalPlace::program;
    std::uint32_t shift = 0;  ///< of a global parameter's number where it can keep it: R3 is #103
    std::string arguments;    ///< letters of arguments, in the order of the parameters that they set
    std::vector<std::uint32_t> argument_numbers;  ///< of those parameters

    [[nodiscard]] const std::string* find(std::string_view key) const {
        const auto found = texts.find(key);
        return found == texts.end() ? nullptr : &found->second;
    }
    [[nodiscard]] std::string text_or_none(std::string_view key) const { return has(key) ? *find(key) : std::string(); }
    std::map<cl::CycleKind, CycleProgram> cycles;

    [[nodiscard]] const CycleProgram* cycle(cl::CycleKind kind) const {
        const auto found = cycles.find(kind);
        return found == cycles.end() ? nullptr : &found->second;
    }
    [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
};

/// A text of the language with values in its places: `{name}`.
using Places = std::vector<std::pair<std::string_view, std::string>>;
[[nodiscard]] std::string filled(std::string_view text, const Places& places);

/// Of a post; nothing, with what is wrong in `diagnostics`, where it has no such tables or they cannot be used.
[[nodiscard]] std::optional<Language> read_language(std::uint32_t file, const base::Sources& sources,
                                                    base::Diagnostics& diagnostics, const write::LoadText& load = {});

}  // namespace obrys::rewrite
