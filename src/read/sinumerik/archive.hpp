#pragma once
/// Archives: several files of a control in one text, each behind a line `%_N_NAME_KIND`.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::read::sinumerik {

struct ArchiveMember {
    std::string name;                  ///< upper case, without `_N_` and kind
    std::string kind;                  ///< MPF, SPF, TOA, INI, GUD, TEA, COM …; empty where the header names none
    std::uint32_t header = 0;          ///< byte of its `%`
    std::uint32_t begin = 0, end = 0;  ///< its text, behind the header line
    [[nodiscard]] bool is_program() const { return kind.empty() || kind == "MPF" || kind == "SPF" || kind == "CPF"; }
};

/// The members in order; empty for a text without such headers.
[[nodiscard]] std::vector<ArchiveMember> archive_members(std::string_view text);

/// Name of a program without what the control's file system adds: `_N_L320_SPF` -> `L320`; upper case.
[[nodiscard]] std::string plain_name(std::string_view name);

}  // namespace obrys::read::sinumerik
