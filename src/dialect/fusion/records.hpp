#pragma once
/// Records of Autodesk's intermediate CL files ("compact-nci"): a number that says what it is, then its data, numbers
/// with their low byte first. Sources: the corpus' 85 jobs, whose tool and context records were told apart by the
/// parameters of the same operation, which say the same by name. docs/dialects/fusion.md.

#include <cstdint>
#include <span>
#include <string_view>

namespace obrys::dialect::fusion {

enum class FieldType : std::uint8_t { f32, f64, u32, flags };

struct Field {
    std::string_view name;  ///< empty: the numbers stand without a name
    FieldType type = FieldType::f32;
    std::uint16_t offset = 0;  ///< bytes from the record's begin
    std::uint8_t count = 1;
};

enum class RecordKind : std::uint8_t {
    parameter,
    stock,
    section,
    section_end,
    linear,
    rapid,
    arc_ccw,
    arc_cw,
    linear_5axis,
    rapid_5axis,
    command,
    cycle,
    cycle_end,
    frame,
    tool_mill,
    tool_turn,
    context,
    tool_assembly,
};

/// What stands behind the number of the record.
enum class Shape : std::uint8_t {
    fields,         ///< so many bytes, of which `fields` are known
    text,           ///< a name and a text of bytes
    wide_text,      ///< a name and a text of UTF-16
    whole,          ///< a name and a whole number
    real,           ///< a name and a number
    name,           ///< a name
    names_and_axes  ///< two names, nine numbers
};

struct Record {
    std::uint32_t number = 0;
    std::string_view name;  ///< as the listing calls it
    RecordKind kind = RecordKind::parameter;
    Shape shape = Shape::fields;
    std::uint16_t size = 0;      ///< bytes of `fields` with the record's number
    std::uint16_t pairs_at = 0;  ///< where it says how many pairs of eight bytes follow at its end; 0: there are none
    std::span<const Field> fields{};
};

[[nodiscard]] const Record* find_record(std::uint32_t number);
/// By its name in the listing; of several with one name the first.
[[nodiscard]] const Record* find_record(std::string_view name);

/// The end of the name that the file begins with.
inline constexpr std::string_view format_name = "/namespace/nc/format/compact-nci";
inline constexpr std::size_t header_bytes = 7;  ///< behind that name; they differ from version to version

}  // namespace obrys::dialect::fusion
