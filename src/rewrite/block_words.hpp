#pragma once
/// The words of one block, gathered and then written in the other language's order. Private to rewrite.

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

inline constexpr int stop_alone = -1;  ///< among M functions: STOP, which leaves the spindle to machine and operator

class BlockWords {
public:
    explicit BlockWords(Writing& w) : w_(w) {}
    void write();

    /// A word with its value. `is_length`: the language may want its sign.
    std::string spelt(std::string_view word, const Text& v, bool is_length);
    /// A chamfer or rounding behind an element.
    std::string corner(std::string_view key, const Text& v);
    /// An arc's centre by its coordinates.
    std::string absolute_centre(const Text& u, const Text& v);

private:
    struct Axis {
        char letter;
        Text value;
        bool incremental;
    };
    void gather();
    void modal(const program::Word& word);
    void take(program::Code code, ExprId id, const Text& v);
    void axis(char letter, ExprId id, const Text& given);
    Text across(const Text& v, bool source_across);
    /// `spelt` with a blank before it; empty where there is no value.
    std::string optional(std::string_view word, const std::optional<Text>& v);

    void modes();
    void tool();
    [[nodiscard]] bool tool_brings_length() const;
    [[nodiscard]] bool says_lengths() const;
    void length_on(int offset);
    void length_of_tool();
    std::string length_here(std::string_view key);
    void lengths();
    std::optional<int> radius_offset();
    bool changes_length();
    void radius_alone();
    [[nodiscard]] bool holder_goes() const;
    void feed_mode();
    void spindle();
    bool function_before(int m);
    void function_behind(int m);
    void stop();
    void move();
    std::optional<program::Modal> motion_here();
    std::optional<std::string> compensation_text();
    /// What of an arc, or beside a straight move, has no counterpart; true where something has not.
    bool refuse_arc(bool arc);
    [[nodiscard]] std::string_view key_of(program::Modal motion) const;
    void zero(int number);
    void no_move();
    void write_move(program::Modal motion, const std::string& feed, const std::string& compensation, bool by_mode);
    void pole();
    /// Of the pole in force; nothing after a complaint.
    std::optional<std::string> pole_text();
    void take_increments_of_pole();
    void joining(std::string_view key);
    std::string axes_text();
    std::string centre_text();
    [[nodiscard]] std::string source_of_block() const { return w_.source(w_.here); }

    Writing& w_;
    base::Span word_;  ///< at hand
    std::optional<program::Modal> motion_, plane_, distance_, feed_mode_, surface_, compensation_;
    std::optional<program::Modal> frame_;  ///< G52, G68, G69: the whole block is theirs
    std::optional<int> datum_;
    bool machine_ = false;  ///< G53: coordinates of the machine, which what holds the tool goes to
    bool dwell_ = false, length_ = false, length_off_ = false, change_ = false, prepares_ = false,
         joined_offset_ = false;
    std::vector<Axis> axes_;
    std::vector<std::pair<std::size_t, Text>> centre_;  ///< 0: along X
    bool centre_counts_on_ = true;                      ///< from the arc's start; else it has coordinates
    bool is_pole_ = false, about_pole_ = false, same_sense_ = false;
    std::optional<std::pair<std::string_view, Text>> corner_;  ///< chamfer or rounding: what it is
    std::optional<Text> radius_, feed_, speed_, limit_, tool_, edge_, dwell_time_, offset_, radius_offset_;
    bool call_cycle_ = false;
    std::vector<int> m_;
};

}  // namespace obrys::rewrite
