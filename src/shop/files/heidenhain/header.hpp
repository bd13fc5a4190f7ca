#pragma once
/// What stands above the rows of a HEIDENHAIN table. Private to this room.

#include "shop/files/heidenhain/table.hpp"
#include "shop/files/lines.hpp"

namespace obrys::shop {

/// Takes the lines up to the column names and fills in name, extension, unit and columns.
void read_table_head(TableLines& lines, HeidenhainTable& table, base::Diagnostics& diagnostics);

}  // namespace obrys::shop
