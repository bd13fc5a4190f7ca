#pragma once
/// What the rows of HEIDENHAIN tables mean. Columns are found by their names, so tables with other columns, or in
/// another order, are read too; columns that are not named here are left alone (they stay in the table).
///
/// Lengths come out in mm (an INCH table's are converted), angles in radians but for tools (degrees, as in
/// shop/tool.hpp). Numbers are written with comma or point. A value that is no number, or that runs over into the next
/// column, is reported with row and column and left out. Sources: iTNC 530 User's Manual Conversational Programming
/// (606 42x): "Tool data", "Pocket table for tool changer", "Working with cutting data tables", "Point tables", "Datum
/// management with the preset table"; User's Manual Cycle Programming: "Datum shift with datum tables (cycle 7)".

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geom/vec.hpp"
#include "shop/files/heidenhain/table.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {

/// TOOL.T. L and R are needed columns; a tool without a value in them gets 0, said in `assumed`. T 5.1 is index 1 of
/// T 5.
[[nodiscard]] std::vector<Tool> tools_of(const HeidenhainTable& table, base::Diagnostics& diagnostics);

/// TOOL_P.TCH: the place P of a tool in the magazine.
struct Pocket {
    std::uint32_t pocket = 0, magazine = 0;               ///< `1.12` is pocket 12 of magazine 1
    std::optional<std::uint32_t> tool;                    ///< T; nothing where the pocket is empty
    std::string tool_name;                                ///< TNAME
    bool special = false, fixed = false, locked = false;  ///< ST, F, L
    base::Span where;
};
[[nodiscard]] std::vector<Pocket> pockets_of(const HeidenhainTable& table, base::Diagnostics& diagnostics);

/// A row of a datum table (.D, cycle 7) or preset table (.PR, cycle 247). NaN: the row says nothing about that axis; a
/// preset then leaves it as it is.
struct DatumRow {
    geom::Vec3 position;                ///< X Y Z, mm
    std::array<double, 3> rotary{};     ///< A B C, radians
    std::array<double, 3> secondary{};  ///< U V W, mm
    double rotation = 0;                ///< preset ROT, the basic rotation, radians; 0 where there is none
    std::string comment;                ///< DOC
    base::Span where;
};
/// By row number.
[[nodiscard]] std::map<std::uint32_t, DatumRow> datums_of(const HeidenhainTable& table, base::Diagnostics& diagnostics);

/// A row of a point table (.PNT). NaN: not written.
struct PatternPoint {
    std::uint32_t number = 0;
    geom::Vec3 position;
    bool hidden = false;   ///< FADE: passed over when the cycle is called
    double clearance = 0;  ///< CLEARANCE, coordinate of the tool axis for the way to this point; NaN: none
    base::Span where;
};
[[nodiscard]] std::vector<PatternPoint> points_of(const HeidenhainTable& table, base::Diagnostics& diagnostics);

/// A row of a cutting data table (.CDT): for a work material and a cutter material pairs of cutting speed Vc1, Vc2, …
/// in m/min and feed F1, F2, … in mm per tooth (m/min and mm also in an INCH table; the control's tables have no unit).
struct CuttingData {
    std::string work_material, cutter_material;  ///< WMAT, TMAT: names of WMAT.TAB and TMAT.TAB
    struct Pair {
        double speed = 0, feed = 0;  ///< NaN where empty
    };
    std::vector<Pair> pairs;
};
[[nodiscard]] std::vector<CuttingData> cutting_data_of(const HeidenhainTable& table, base::Diagnostics& diagnostics);
/// The pair `n` (1, 2, …) of a row that has both names, capitals or not; nothing where there is none or a value is
/// empty.
[[nodiscard]] std::optional<CuttingData::Pair> find_cutting_data(const std::vector<CuttingData>& all,
                                                                 std::string_view work_material,
                                                                 std::string_view cutter_material, std::size_t n = 1);
/// Spindle speed in 1/min and feed in mm/min: S = 1000 Vc / (2 pi R), F = S z fz. NaN where radius or teeth are not
/// known.
struct SpindleAndFeed {
    double speed = 0, feed = 0;
};
[[nodiscard]] SpindleAndFeed spindle_and_feed(const CuttingData::Pair& pair, const Tool& tool);

/// NAME and DOC of WMAT.TAB or TMAT.TAB.
struct Material {
    std::string name, comment;
    base::Span where;
};
[[nodiscard]] std::vector<Material> materials_of(const HeidenhainTable& table);

/// The tools of a HEIDENHAIN tool table (TOOL.T): `read_heidenhain_table` and `tools_of` in one.
[[nodiscard]] std::vector<Tool> read_tool_t(std::uint32_t file, const base::Sources& sources,
                                            base::Diagnostics& diagnostics);

}  // namespace obrys::shop
