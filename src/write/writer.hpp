#pragma once
/// The stream as a program of a control, by a post. Streams: memory does not grow with the number of moves; it holds
/// the text of parts that are called.

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cl/record.hpp"
#include "motion/cursor.hpp"
#include "write/frames.hpp"
#include "write/holes/lone_taps.hpp"
#include "write/layout.hpp"
#include "write/printer.hpp"
#include "write/staircase.hpp"
#include "write/writer_pieces.hpp"

namespace obrys::write {

struct HoleWay;

class Writer {
public:
    /// `name` of the program, as its head says it. `post` outlives the writer.
    Writer(const Post& post, std::string name, Output output);

    void take(const cl::Record& record);
    /// Writes what waits for what follows.
    void settle();
    void finish();
    /// Behind the last record: the program begins anew, without end. False where the post has no word for that.
    [[nodiscard]] bool begin_anew();
    /// Tools that it has called; null where the post has no magazine.
    [[nodiscard]] const Magazine* magazine() const { return magazine_ ? &*magazine_ : nullptr; }
    /// What has become of slopes and arcs; null where the post's control has both.
    [[nodiscard]] const StaircaseSums* stairs() const { return stairs_ ? &stairs_->sums() : nullptr; }

private:
    struct Held {
        cl::Record record;
        geom::Vec3 from;
    };
    struct Source {
        base::Span from;
        cl::StackId stack = 0;
        bool operator==(const Source&) const = default;
    };

    /// What is set by a record of its own and written later.
    enum class Topic : std::uint8_t {
        tool,
        length,
        datum,
        frame,
        spindle,
        coolant,
        tolerance,
        path,
        compensation,
        count
    };
    /// Notes are about the record that has set it, not about the one that it is written for.
    class About {
    public:
        About(Writer& writer, Topic topic);
        ~About();
        About(const About&) = delete;
        About& operator=(const About&) = delete;

    private:
        Writer& writer_;
        const Source* before_;
    };

    void remember_topic(const cl::Step& step);
    void take_part(const cl::Record& record);
    void open_part(const cl::Record& record, const cl::PartBegin& part);
    void close_part();
    void spill_parts();
    void keep_standing();
    void note_height(const cl::Linear* line);
    void begin_stairs(std::function<void(const cl::Record&)> run);
    void take_written(const cl::Record& record);
    void take_folded(const cl::Record& record);
    void take_move(const cl::Record& record);
    void take_lead(const cl::Record& record, const cl::LeadBegin& lead);
    void write_path_of_lead(const cl::LeadBegin& lead, const geom::Vec3& from);
    void take_cycle(const cl::Record& record, const cl::CycleBegin& begin);
    void take_event(const cl::Record& record);
    void take_programmed(const cl::Programmed& p);
    [[nodiscard]] bool moves_are_contour() const;
    [[nodiscard]] bool by_moves_of_corner(const cl::Programmed& p);
    // What is no move. A kind that is not named stops this from compiling until somebody says how it is written.
    void event(const cl::ToolChange& change);
    void event(const cl::ToolSelection& next);
    void event(const cl::ToolData& data);
    void event(const cl::DatumData& data);
    void event(const cl::CompensationBegin& begin);
    void event(const cl::CompensationEnd&);
    void event(const cl::Dwell& dwell);
    void event(const cl::Stop& stop);
    void event(const cl::OtherSpindle& other);
    void event(const cl::Comment& comment);
    [[nodiscard]] std::vector<std::string> lines_about_cycles() const;
    void event(const cl::Output& signal);
    void event(const cl::Override& allowed);
    void event(const cl::Auxiliary& aux);
    void event(const cl::Feed&) {}  // what holds is written before the next move
    void event(const cl::Spindle&) {}
    void event(const cl::Coolant&) {}
    void event(const cl::ToolLength&) {}
    void event(const cl::Datum&) {}
    void event(const cl::Frame&) {}
    void event(const cl::Tolerance&) {}
    void event(const cl::PathMode&) {}
    void event(const cl::PartBegin&) {}  // these have been taken before
    void event(const cl::PartEnd&) {}
    void event(const cl::CycleEnd&) {}  // of a cycle that is written by its moves
    void event(const cl::LeadEnd&) {}
    void event(const cl::MachinePlace&) {}
    void event(const cl::Programmed&) {}
    void event(const cl::CycleBegin&) {}
    void event(const cl::LeadBegin&) {}
    void event(const cl::Linear&) {}
    void event(const cl::Arc&) {}
    void event(const cl::Spline&) {}
    void event(const cl::Thread&) {}
    void end_program(Command command, std::string_view what);
    [[nodiscard]] bool is_of_stop(const cl::Record& record) const;
    void write_stop();
    void end_fold();
    [[nodiscard]] bool is_made(const cl::Record& record);
    void flush_held();
    [[nodiscard]] bool rise_waits() const;
    void write_rise();
    void write_first_held();

    // What holds, before something happens.
    void write_state();
    [[nodiscard]] bool is_state_written() const;
    void write_all();  ///< and what waits for a move
    void write_tool();
    [[nodiscard]] bool place_tool(const cl::ToolChange& change, const std::string& what);
    void set_offsets(bool rapid);
    void note_cut_without_tool(bool rapid);
    void note_tapping();
    void note_tap_back(const geom::Vec3& to);
    void set_tap();
    void leave_tap(Command command);
    void stop_spindle(const std::string& word);
    void set_tool(const cl::ToolChange& change);
    void await_length_of(const cl::ToolChange& change);
    void write_standing(const cl::ToolChange& change);
    void write_length();
    void write_waiting_length();
    [[nodiscard]] bool can_end_length_alone() const;
    void write_length_alone();
    void write_last_length();
    void set_length();
    void write_datum();
    void write_datum_anew();
    void set_zero(std::uint32_t number, bool added);
    void write_zero(const cl::DatumData& data);
    void write_frame();
    [[nodiscard]] bool write_said(const cl::Linear& line, cl::MachinePlace place);
    [[nodiscard]] bool take_places_of_axes();
    [[nodiscard]] bool turns_with_plane(const cl::Step& step) const;
    [[nodiscard]] bool is_turned_by_control(const cl::Step& step) const;
    [[nodiscard]] bool write_turn(const cl::Linear& line, const geom::Vec3& from);
    [[nodiscard]] std::optional<Command> turning_form(const FrameStep& step) const;
    void note_speed(const cl::Spindle&);
    void write_spindle(const cl::Spindle& s);
    void ready_spindle(const cl::Thread& tap);
    void await_coolant();
    void write_coolant();
    void write_tolerance();
    void set_tolerance(const cl::Tolerance& t);
    void write_path();
    void begin_cycles(const std::string& defined);
    void end_cycles();
    void select_plane(const geom::Vec3& normal);

    // Moves.
    void write_move(const cl::Step& step, const geom::Vec3& from);
    void write_way(const cl::Step& step, const geom::Vec3& from, bool points_as_before);
    void drop_standing_axes();
    void print_straight(const geom::Vec3& to, bool rapid, const cl::Programmed* corner, cl::Seek seek);
    void write_line(const geom::Vec3& to, bool rapid, const cl::Programmed* corner = nullptr,
                    cl::Seek seek = cl::Seek::nothing);
    void write_arc(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner = nullptr);
    [[nodiscard]] std::vector<double> cuts_of(const cl::Arc& arc, const geom::Vec3& from) const;
    void write_cut_arc(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner);
    void write_arc_in_space(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner);
    [[nodiscard]] bool is_lost_in_increments(const cl::Arc& arc, const geom::Vec3& start, const geom::Vec3& to,
                                             const geom::Vec3& centre) const;
    void write_turn(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner);
    [[nodiscard]] bool write_place(const cl::Linear& line);
    [[nodiscard]] Command home_command(const cl::MachinePlace& place) const;
    [[nodiscard]] Command place_command(const cl::MachinePlace& place, bool rapid) const;
    void note_assumed_home(const cl::MachinePlace& place, bool by_home);
    void write_spline(const cl::Spline& spline);
    void write_thread(const cl::Thread& thread, const geom::Vec3& from);
    [[nodiscard]] std::optional<Command> compensation_of(const cl::CompensationBegin& begin) const;
    void note_feed(bool rapid);
    void say_feed_mode(cl::FeedMode mode);
    void note_unknown(const geom::Vec3& from, const cl::Linear& line);
    void lose_axes();
    [[nodiscard]] bool stays(const cl::ToolChange& change) const;
    [[nodiscard]] bool has_offsets_alone(const cl::ToolChange& change) const;
    void drop_offsets_alone(const cl::ToolChange& next);
    void note_offsets();
    void return_plane();
    void take_axes(Parts& parts, bool home = false);
    enum class Urgency : std::uint8_t {
        may_wait,  ///< for a block that has a place for it
        now,
        at_end,  ///< of the program, which ends compensation where no word does
    };
    bool note_path_of_no_radius(const cl::CompensationBegin& begin);
    void end_compensation_alone(Urgency urgency);
    [[nodiscard]] bool ends_before(const Template& form, Command command) const;
    void end_wait_of_compensation(Command command, const Template& form, std::uint64_t line);
    void note_direction(const geom::Vec3& axis);
    void note_unsaid(Command command, bool rapid);
    void note_printed(Command command, const Template& form, const Parts& parts, std::uint64_t line);
    void print_move(Command command, bool rapid, const cl::Programmed* corner);
    [[nodiscard]] Command feed_command(bool rapid) const;
    [[nodiscard]] Parts parts_of(bool rapid, const cl::Programmed* corner);

    // Cycles.
    [[nodiscard]] const CycleForm* cycle_form(const cl::Cycle& cycle) const;
    [[nodiscard]] std::set<std::string> kept_words(const CycleForm& form) const;
    void end_series_that_says_more(const CycleForm& form);
    [[nodiscard]] double level_of_series(bool over) const;
    [[nodiscard]] bool gets_there(const CycleForm& form, const cl::Cycle& cycle, double level, double stands) const;
    void note_held_aside(const cl::Cycle& cycle);
    [[nodiscard]] bool fold(const cl::CycleBegin& begin);
    [[nodiscard]] bool fold_as(const cl::CycleBegin& begin, HoleWay way, bool may_come = false);
    [[nodiscard]] std::optional<geom::Vec3> lay_in_text(cl::Cycle& cycle) const;
    [[nodiscard]] bool fold_below(const cl::CycleBegin& begin, HoleWay way);
    void come_to_plane(const cl::Cycle& cycle, const geom::Vec3& at);
    [[nodiscard]] int spindle_word(const Template& call) const;
    void end_tap();
    [[nodiscard]] bool is_again(const Template& call, const Parts& parts);
    void set_values(const HoleWay& way, const geom::Vec3& at);

    void print_lead();
    bool print(Command command, std::string_view what, bool rapid = false);
    Printed put(Command command, const Parts& parts, std::string_view what, bool moves = false);
    [[nodiscard]] const Template* form_of(Command command, std::string_view what);
    [[nodiscard]] bool ask_cycle(const cl::Cycle& cycle, CycleForm& form);
    [[nodiscard]] Hooked ask(const std::string& name, std::string_view what, bool in_cycle, Template& said);
    void note(Fate fate, std::string what, std::uint64_t line = 0);
    void note_at(Note note);
    void coolant_said(std::uint64_t line);

    const Post& post_;
    Homes homes_;
    std::string name_;
    Layout layout_;
    Printer printer_;
    std::optional<Magazine> magazine_;
    const MagazineSlot* slot_ = nullptr;  ///< of the tool in the spindle
    bool offsets_wait_ = false;           ///< none of them has been said since the tool was called
    bool without_tool_noted_ = false;
    std::optional<Staircase> stairs_;  ///< before all else, where the control moves one axis at a time
    std::optional<LoneTaps> taps_;     ///< the same, where it taps by cycles alone
    std::function<void(const FoldedBy&)> folded_;
    std::set<std::size_t> by_moves_;
    std::size_t cycles_taken_ = 0;
    std::unique_ptr<Hooks> hooks_;                                         ///< null: the post has none
    Template said_;                                                        ///< by one of them
    std::array<Places, static_cast<std::size_t>(Command::count)> places_;  ///< of the post's commands
    [[nodiscard]] const Places& places(Command c) const { return places_[static_cast<std::size_t>(c)]; }
    Values values_;
    motion::Cursor cursor_;
    const cl::Record* now_ = nullptr;

    // What the text says so far.
    cl::Spindle spindle_;
    cl::Coolant coolant_;
    std::optional<Command> coolant_waits_;   ///< for the next block that has a place for it
    bool coolant_may_wait_ = false;          ///< a move follows that has
    cl::Feed feed_noted_;                    ///< of which has been said that it is lost
    std::optional<cl::FeedMode> feed_mode_;  ///< of the last move at feed
    cl::Tolerance tolerance_;
    std::optional<cl::PathMode> path_;
    std::optional<cl::Datum> datum_;
    bool zero_said_ = false;  ///< the text has said where the zero in force lies now
    cl::ToolLength length_;
    std::optional<Command> length_waits_;    ///< for the next straight move, whose block takes it
    std::optional<cl::MachinePlace> place_;  ///< where the next move leads
    std::optional<cl::ToolChange> tool_;     ///< in the spindle, as the text has it
    bool plain_ = false;                     ///< the tool's path stands in the place of a compensated contour
    bool tool_waits_ = false;
    std::uint32_t edge_said_ = 0;  ///< of the tool in the spindle, as the text has it
    bool offsets_unsaid_ = false;  ///< they are others than the text has
    bool z_of_machine_ = false;    ///< the last word of Z led to a place of the machine
    bool in_other_plane_ = false;  ///< the text has selected another plane than that of X and Y
    Frames frames_;
    std::map<std::array<char, 8>, double> axes_at_;  ///< where each stands, by the moves so far
    bool turned_by_control_ = false;  ///< the axes have turned by words of the plane: where the tip is, nobody knows
    bool counts_anew_ = false;        ///< with another plane the rotary axes count otherwise; nothing moves
    std::optional<geom::Vec3> taken_up_;   ///< normal of the tilted plane to which the text has turned the rotary axes
    std::optional<PlaneTurn> plane_turn_;  ///< while it is being written
    std::optional<cl::Frame> frames_refused_;  ///< that the post cannot say
    CycleSeries series_;
    TapState tap_;

    /// X, Y and Z as moves without a word for them leave them: posts of lathes have no Y.
    std::array<double, 3> stands_{NAN, 0, NAN};
    geom::Vec3 pointed_{0, 0, 1};             ///< where the tool has pointed in the last straight move
    geom::Vec3 direction_noted_;              ///< of which has been said that it is lost
    std::set<Command> without_feed_;          ///< of which has been said that they have no place for it
    cl::AxisEnds axes_;                       ///< that the next move takes along
    std::vector<Held> held_;                  ///< rapids of one block, which a cycle may make by itself
    int folding_ = 0;                         ///< brackets that are open since one was written as a cycle or a lead
    double turning_speed_ = 0;                ///< 1/min, of the spindle when it turned last
    bool height_said_ = false;                ///< a block has said Z since the tool was changed
    std::optional<Command> compensation_;     ///< that the next element of the contour has to say
    bool is_compensating_ = false;            ///< the text has switched it on
    std::optional<Source> compensation_end_;  ///< what ended the last contour
    std::optional<Lead> lead_;                ///< the way onto a contour that is being read
    bool corner_by_moves_ = false;            ///< of the last element
    bool contour_begun_ = false;              ///< an element has been written under compensation
    std::vector<Source> programmed_;          ///< sources of elements whose moves the control makes
    bool straight_alone_ = false;             ///< since all that holds was written, nothing but straight moves has come
    bool ended_ = false;
    std::optional<cl::Record> stop_waits_;  ///< for what else its block does

    std::array<Source, static_cast<std::size_t>(Topic::count)> topics_{};
    const Source* about_ = nullptr;
    std::vector<OpenPart> parts_;
};

}  // namespace obrys::write
