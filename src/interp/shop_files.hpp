#pragma once
/// Files of the shop that a program reads or fills while it runs, by the names that it uses. The driver holds them;
/// nothing here touches a disk. Names are upper case, without folders: "ZERO.D".

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "shop/files/heidenhain/table.hpp"
#include "shop/files/heidenhain/views.hpp"

namespace obrys::interp {

struct DatumTable {
    std::string name;
    std::map<std::uint32_t, shop::DatumRow> rows;
};

class ShopFiles {
public:
    ShopFiles() = default;
    ShopFiles(const ShopFiles&) = delete;
    ShopFiles& operator=(const ShopFiles&) = delete;
    virtual ~ShopFiles() = default;

    /// A datum table (.D), or null. An empty name: the one that is in use where the program selects none.
    [[nodiscard]] virtual const DatumTable* datum_table(std::string_view name) = 0;
    /// A freely definable table (.TAB), or null. What is written into it stays in memory.
    [[nodiscard]] virtual shop::HeidenhainTable* table(std::string_view name) = 0;
    /// The text of a form (.A), or null.
    [[nodiscard]] virtual const std::string* form(std::string_view name) = 0;
    /// Puts text at the end of a file that the program prints to; `again`: what it held before this is thrown away.
    /// False where no folder is named for such files: the text is lost.
    [[nodiscard]] virtual bool print(std::string_view name, std::string_view text, bool again) = 0;
};

}  // namespace obrys::interp
