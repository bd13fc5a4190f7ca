#include "dialect/fusion/records.hpp"

#include <algorithm>
#include <array>

namespace obrys::dialect::fusion {

namespace {

constexpr std::array box_fields{Field{"", FieldType::f32, 4, 6}};
constexpr std::array linear_fields{Field{"", FieldType::f32, 4, 3}, Field{"feed", FieldType::f32, 16},
                                   Field{"", FieldType::flags, 20}};
constexpr std::array rapid_fields{Field{"", FieldType::f32, 4, 3}, Field{"", FieldType::flags, 16}};
constexpr std::array arc_fields{Field{"", FieldType::f32, 4, 3}, Field{"centre", FieldType::f32, 16, 3},
                                Field{"normal", FieldType::f32, 28, 3}, Field{"feed", FieldType::f32, 40},
                                Field{"", FieldType::flags, 44}};
constexpr std::array linear_5axis_fields{Field{"", FieldType::f32, 4, 3}, Field{"axis", FieldType::f32, 16, 3},
                                         Field{"feed", FieldType::f32, 28}, Field{"", FieldType::flags, 32}};
constexpr std::array rapid_5axis_fields{Field{"", FieldType::f32, 4, 3}, Field{"axis", FieldType::f32, 16, 3},
                                        Field{"", FieldType::flags, 28}};
constexpr std::array command_fields{Field{"", FieldType::u32, 4}};
constexpr std::array context_fields{
    Field{"work-offset", FieldType::u32, 112},  Field{"turning", FieldType::u32, 128},
    Field{"spindle", FieldType::u32, 132},      Field{"origin", FieldType::f32, 16, 3},
    Field{"axes", FieldType::f32, 28, 9},       Field{"setup-origin", FieldType::f32, 64, 3},
    Field{"setup-axes", FieldType::f32, 76, 9},
};

/// The record of older files lacks what stands in the first 104 bytes of the newer one.
template <std::uint16_t at>
constexpr std::array mill_tool{
    Field{"number", FieldType::u32, at + 72},
    Field{"type", FieldType::u32, at + 4},
    Field{"diameter", FieldType::f64, at + 8},
    Field{"corner-radius", FieldType::f64, at + 24},
    Field{"flute-length", FieldType::f64, at + 40},
    Field{"body-length", FieldType::f64, at + 64},
    Field{"speed", FieldType::f64, at + 80},
    Field{"clockwise", FieldType::u32, at + 88},
    Field{"diameter-offset", FieldType::u32, at + 108},
    Field{"length-offset", FieldType::u32, at + 112},
    Field{"coolant", FieldType::u32, at + 120},
    Field{"flutes", FieldType::u32, at + 124},
    Field{"pitch", FieldType::f64, at + 152},
};
constexpr std::array turn_tool{
    Field{"number", FieldType::u32, 176},      Field{"type", FieldType::u32, 108},
    Field{"speed", FieldType::f64, 184},       Field{"clockwise", FieldType::u32, 192},
    Field{"offset", FieldType::u32, 220},      Field{"pitch", FieldType::f64, 256},
    Field{"nose-radius", FieldType::f64, 288},
};
constexpr std::array assembly{Field{"", FieldType::f64, 4, 2}};

using enum RecordKind;

constexpr std::array records{
    Record{10, "parameter", parameter, Shape::text},
    Record{11, "parameter", parameter, Shape::wide_text},
    Record{12, "parameter", parameter, Shape::whole},
    Record{14, "stock", stock, Shape::fields, 28, 0, box_fields},
    Record{15, "parameter", parameter, Shape::real},
    Record{30, "section", section, Shape::fields, 16},
    Record{31, "section-end", section_end, Shape::fields, 4},
    Record{100, "linear", linear, Shape::fields, 24, 0, linear_fields},
    Record{101, "rapid", rapid, Shape::fields, 20, 0, rapid_fields},
    Record{110, "arc-ccw", arc_ccw, Shape::fields, 48, 0, arc_fields},
    Record{111, "arc-cw", arc_cw, Shape::fields, 48, 0, arc_fields},
    Record{120, "linear-5axis", linear_5axis, Shape::fields, 36, 0, linear_5axis_fields},
    Record{121, "rapid-5axis", rapid_5axis, Shape::fields, 32, 0, rapid_5axis_fields},
    Record{130, "command", command, Shape::fields, 8, 0, command_fields},
    Record{300, "cycle", cycle, Shape::name},
    Record{301, "cycle-end", cycle_end, Shape::fields, 4},
    Record{500, "frame", frame, Shape::names_and_axes},
    Record{1033, "tool", tool_mill, Shape::fields, 160, 132, mill_tool<0>},
    Record{1034, "context", context, Shape::fields, 192, 0, context_fields},
    Record{1035, "tool", tool_mill, Shape::fields, 264, 236, mill_tool<104>},
    Record{1038, "turning-tool", tool_turn, Shape::fields, 484, 0, turn_tool},
    Record{1041, "tool-assembly", tool_assembly, Shape::fields, 20, 0, assembly},
};

}  // namespace

const Record* find_record(std::uint32_t number) {
    const auto found = std::lower_bound(records.begin(), records.end(), number,
                                        [](const Record& r, std::uint32_t n) { return r.number < n; });
    return found != records.end() && found->number == number ? &*found : nullptr;
}

const Record* find_record(std::string_view name) {
    const auto found = std::find_if(records.begin(), records.end(), [&](const Record& r) { return r.name == name; });
    return found == records.end() ? nullptr : &*found;
}

}  // namespace obrys::dialect::fusion
