#include "read/sinumerik/archive.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace obrys::read::sinumerik {

namespace {

constexpr std::string_view prefix = "_N_";

bool is_name(char c) { return base::is_letter(c) || base::is_digit(c) || c == '_'; }

/// Reads the header at `text[at]` ('%'); nothing where the line is none.
bool read_header(std::string_view text, std::size_t at, ArchiveMember& member) {
    std::size_t i = at + 1;
    while (i < text.size() && is_name(text[i])) ++i;
    std::string name = base::to_upper(text.substr(at + 1, i - at - 1));
    if (!name.starts_with(prefix) || name.size() == prefix.size()) return false;
    name.erase(0, prefix.size());
    const std::size_t line_end = std::min(text.find_first_of("\r\n", i), text.size());
    if (!base::trim(text.substr(i, line_end - i)).empty()) return false;
    if (const std::size_t bar = name.rfind('_'); bar != std::string::npos && bar > 0 && name.size() - bar == 4) {
        member.kind = name.substr(bar + 1);
        name.erase(bar);
    }
    member.name = std::move(name);
    member.header = static_cast<std::uint32_t>(at);
    member.begin = static_cast<std::uint32_t>(line_end);
    return true;
}

}  // namespace

std::vector<ArchiveMember> archive_members(std::string_view text) {
    std::vector<ArchiveMember> members;
    for (std::size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%', at + 1)) {
        if (at > 0 && text[at - 1] != '\n' && text[at - 1] != '\r') continue;
        ArchiveMember member;
        if (!read_header(text, at, member)) continue;
        if (!members.empty()) members.back().end = member.header;
        members.push_back(std::move(member));
    }
    if (!members.empty()) members.back().end = static_cast<std::uint32_t>(text.size());
    return members;
}

std::string plain_name(std::string_view name) {
    std::string plain = base::to_upper(base::trim(name));
    if (const std::size_t slash = plain.rfind('/'); slash != std::string::npos) plain.erase(0, slash + 1);
    if (plain.starts_with(prefix) && plain.size() > prefix.size()) plain.erase(0, prefix.size());
    for (const std::string_view suffix : {"_SPF", "_MPF", "_CPF", ".SPF", ".MPF"})
        if (plain.size() > suffix.size() && plain.ends_with(suffix))
            return plain.substr(0, plain.size() - suffix.size());
    return plain;
}

}  // namespace obrys::read::sinumerik
