#include "read/sinumerik/read.hpp"

#include <algorithm>

#include "dialect/sinumerik/tables.hpp"
#include "read/sinumerik/archive.hpp"
#include "read/sinumerik/block.hpp"
#include "read/sinumerik/control.hpp"

namespace obrys::read::sinumerik {

namespace {

/// Goes through the lines; the text behind is laid aside.
void read_lines(State& s, const base::Sources& sources) {
    const char* p = s.text.data() + s.unit.begin;
    const char* end = s.text.data() + s.unit.end;
    const char* aside = p;
    while (p < end) {
        if (p - aside > static_cast<std::ptrdiff_t>(base::Store::piece)) {
            sources.lay_aside(s.unit.file, static_cast<std::uint32_t>(p - s.text.data()));
            aside = p;
        }
        if (*p == '\n' || *p == '\r' || *p == ' ' || *p == '\t') {
            ++p;
            continue;
        }
        if (!s.odd_names && s.macros.empty()) {
            if (const char* behind = read_literal_block(s, p, end); behind != nullptr) {
                p = behind;
                continue;
            }
        }
        const char* line_end = p;
        while (line_end < end && *line_end != '\n' && *line_end != '\r') ++line_end;
        const char* text_end = line_end;
        while (text_end > p && (text_end[-1] == '\x1A' || text_end[-1] == '\0')) --text_end;
        s.cursor = Cursor(s.text.data(), static_cast<std::uint32_t>(p - s.text.data()),
                          static_cast<std::uint32_t>(text_end - s.text.data()));
        read_line(s);
        p = line_end;
    }
}

program::Unit read_unit(std::uint32_t file, const base::Sources& sources, const ArchiveMember& part,
                        program::Names& names, base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    program::Unit unit;
    unit.name = part.name;
    unit.file = file;
    unit.begin = part.begin;
    unit.end = part.end;
    unit.startable = part.kind == "MPF" || part.kind == "SPF";  // an archive's programs are there to be run
    unit.traits = &dialect::sinumerik::traits;
    unit.unended = "the program ends without M30, M2, M17 or RET: the text may be cut off";
    unit.reserve(part.end - part.begin);
    State s{.unit = unit,
            .names = names,
            .diagnostics = diagnostics,
            .text = source.text,
            .build = {unit, names, diagnostics, source.text},
            .cursor = {}};
    read_lines(s, sources);
    s.cursor = Cursor(s.text.data(), part.end, part.end);
    close_all(s);
    if (s.jumps_to_numbers) {
        sources.fetch(file);
        label_block_numbers(s);
    }
    sources.lay_aside(file, part.end);
    return unit;
}

/// True where something stands in front of the first header of an archive.
bool has_text(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
        const std::string_view body = base::trim(line);
        if (!body.empty() && body[0] != ';') return true;
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return false;
}

/// Dialogs of the operator panel (//M(…), //S(…)) are kept beside programs and are none.
bool is_dialog(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
        const std::string_view body = base::trim(line);
        if (!body.empty() && body[0] != ';') return body.starts_with("//");
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return false;
}

program::Unit refuse_dialog(std::uint32_t file, const base::Source& source, base::Diagnostics& diagnostics) {
    base::Diagnostic d;
    d.code = base::codes::unsupported;
    d.where = {file, 0, 0};
    d.text = "this is a dialog of the operator panel, not a program";
    diagnostics.add(std::move(d));
    program::Unit unit;
    unit.name = plain_name(base::stem(source.name));
    unit.file = file;
    unit.traits = &dialect::sinumerik::traits;
    return unit;
}

}  // namespace

std::vector<program::Unit> read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    std::vector<program::Unit> units;
    if (is_dialog(source.text)) {
        units.push_back(refuse_dialog(file, source, diagnostics));
        return units;
    }
    std::vector<ArchiveMember> members = archive_members(source.text);
    const auto size = static_cast<std::uint32_t>(source.text.size());
    const std::uint32_t head = members.empty() ? size : members.front().header;
    if (members.empty() || has_text(std::string_view(source.text).substr(0, head))) {
        ArchiveMember whole;
        whole.name = plain_name(base::stem(source.name));
        whole.end = head;
        members.insert(members.begin(), whole);
    }
    for (const ArchiveMember& member : members) {
        if (member.is_program()) {
            units.push_back(read_unit(file, sources, member, names, diagnostics));
            continue;
        }
        base::Diagnostic d;
        d.severity = base::Severity::note;
        d.code = base::codes::no_effect;
        d.where = {file, member.header, member.begin};
        d.text = "the archive member " + member.name + " (" + member.kind + ") is no program";
        diagnostics.add(std::move(d));
    }
    return units;
}

}  // namespace obrys::read::sinumerik
