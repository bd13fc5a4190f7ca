#include "driver/timing/runs_file.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "driver/files.hpp"

namespace obrys::driver {
namespace {

struct Cell {
    std::string text;
    base::Span where;
};
using Row = std::vector<Cell>;

/// The cells of a text, line by line; empty lines and those that begin with # are left out.
class Table {
public:
    Table(std::uint32_t file, const base::Sources& sources) : file_(file), text_(sources[file].text) {
        // The first line that is no remark names the columns.
        while (at_ < text_.size() && text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
        const std::string_view head = text_.substr(at_, text_.find('\n', at_) - at_);
        separator_ = head.find(';') != std::string_view::npos ? ';' : ',';
    }
    [[nodiscard]] bool has_decimal_commas() const { return separator_ == ';'; }

    std::optional<Row> next() {
        while (at_ < text_.size()) {
            const std::size_t begin = at_, end = std::min(text_.find('\n', at_), text_.size());
            at_ = end + 1;
            const std::string_view line = text_.substr(begin, end - begin), plain = base::trim(line);
            if (plain.empty() || plain.front() == '#') continue;
            return cells(line, begin);
        }
        return {};
    }

private:
    [[nodiscard]] Row cells(std::string_view line, std::size_t begin) const {
        Row row;
        for (std::size_t at = 0; at <= line.size();) {
            const std::size_t end = std::min(line.find(separator_, at), line.size());
            const std::string_view raw = line.substr(at, end - at);
            std::string_view plain = base::trim(raw);
            const std::size_t from =
                begin + at + static_cast<std::size_t>(plain.empty() ? 0 : plain.data() - raw.data());
            const auto place = static_cast<std::uint32_t>(from);
            const base::Span where{file_, place, place + static_cast<std::uint32_t>(plain.size())};
            if (plain.size() >= 2 && plain.front() == '"' && plain.back() == '"')
                plain = plain.substr(1, plain.size() - 2);
            row.push_back({std::string(plain), where});
            at = end + 1;
        }
        return row;
    }

    std::uint32_t file_;
    std::string_view text_;
    char separator_ = ',';
    std::size_t at_ = 0;
};

class Reader {
public:
    Reader(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics)
        : table_(file, sources), file_(file), diagnostics_(diagnostics) {}

    /// The columns by name, of those that may be there; false after a complaint.
    bool read_head(const std::vector<std::string>& known, const std::vector<std::string>& needed) {
        const std::optional<Row> head = table_.next();
        if (!head) return fail({file_, 0, 0}, "the table is empty");
        for (const Cell& c : *head) {
            const auto found = std::find_if(known.begin(), known.end(), [&](const std::string& k) {
                return base::equals_ignoring_case(k, c.text);
            });
            const std::string name = found == known.end() ? "" : *found;
            if (found == known.end())
                return fail(c.where, "'" + c.text + "' is no column", "columns: " + listed(known));
            if (std::find(columns_.begin(), columns_.end(), name) != columns_.end())
                return fail(c.where, "the column '" + name + "' is there twice");
            columns_.push_back(name);
        }
        for (const std::string& name : needed)
            if (std::find(columns_.begin(), columns_.end(), name) == columns_.end())
                return fail(head->front().where, "there is no column '" + name + "'",
                            "the first line names the columns: " + listed(known));
        return true;
    }

    std::optional<Row> next() {
        std::optional<Row> row = table_.next();
        if (row && row->size() != columns_.size()) {
            fail(row->size() > columns_.size() ? (*row)[columns_.size()].where : row->back().where,
                 std::to_string(row->size()) + " values in a table of " + std::to_string(columns_.size()) + " columns");
            return {};
        }
        return row;
    }

    /// Of a column; null: there is none, or nothing stands in it.
    [[nodiscard]] const Cell* cell(const Row& row, const std::string& name) const {
        const auto found = std::find(columns_.begin(), columns_.end(), name);
        if (found == columns_.end()) return nullptr;
        const Cell& c = row[static_cast<std::size_t>(found - columns_.begin())];
        return c.text.empty() ? nullptr : &c;
    }
    std::optional<double> number(const Cell& c, const std::string& name) {
        std::string text = c.text;
        if (table_.has_decimal_commas()) std::replace(text.begin(), text.end(), ',', '.');
        const std::optional<double> v = base::parse_double(text);
        if (v && std::isfinite(*v)) return v;
        fail(c.where, "'" + name + "' must be a number, not '" + c.text + "'");
        return {};
    }
    std::optional<std::uint32_t> whole(const Cell& c, const std::string& name) {
        const std::optional<std::int64_t> v = base::parse_integer(c.text);
        if (v && *v >= 0 && *v < UINT32_MAX) return static_cast<std::uint32_t>(*v);
        fail(c.where, "'" + name + "' must be a whole number, not '" + c.text + "'");
        return {};
    }

    bool fail(const base::Span& where, std::string text, std::string remedy = {}) {
        complain(diagnostics_, base::codes::runs_file, where, std::move(text), std::move(remedy));
        return false;
    }

private:
    static std::string listed(const std::vector<std::string>& names) {
        std::string out;
        for (const std::string& n : names) out += (out.empty() ? "" : ", ") + n;
        return out;
    }

    Table table_;
    std::uint32_t file_;
    base::Diagnostics& diagnostics_;
    std::vector<std::string> columns_;
};

bool take_numbers(Reader& reader, const Row& row, Run& run) {
    if (const Cell* c = reader.cell(row, "seconds")) {
        const std::optional<double> v = reader.number(*c, "seconds");
        if (!v) return false;
        if (!(*v > 0)) return reader.fail(c->where, "'seconds' must be above 0, not " + c->text);
        run.seconds = *v;
    } else if (run.trace.empty()) {
        return reader.fail(run.where, "a run without 'seconds', and without a 'trace' that would say them");
    }
    for (const auto& [name, to] :
         {std::pair{"tool", &run.tool}, std::pair{"first", &run.first}, std::pair{"last", &run.last}})
        if (const Cell* c = reader.cell(row, name); c != nullptr && !(*to = reader.whole(*c, name))) return false;
    if (run.first && run.last && *run.first > *run.last)
        return reader.fail(reader.cell(row, "last")->where, "'last' lies before 'first'");
    return true;
}

}  // namespace

std::optional<std::vector<Run>> read_runs(std::uint32_t file, const base::Sources& sources,
                                          base::Diagnostics& diagnostics) {
    Reader reader(file, sources, diagnostics);
    if (!reader.read_head({"program", "seconds", "tool", "first", "last", "trace"}, {"program"})) return {};
    std::vector<Run> runs;
    while (const std::optional<Row> row = reader.next()) {
        Run run;
        run.where = row->front().where;
        const Cell* program = reader.cell(*row, "program");
        if (program == nullptr) return reader.fail(run.where, "a run without a program"), std::nullopt;
        run.program = program->text;
        run.where = program->where;
        if (const Cell* trace = reader.cell(*row, "trace")) run.trace = trace->text, run.where_trace = trace->where;
        if (!take_numbers(reader, *row, run)) return {};
        runs.push_back(std::move(run));
    }
    if (diagnostics.has_errors()) return {};
    if (runs.empty()) return reader.fail({file, 0, 0}, "the table names no run"), std::nullopt;
    return runs;
}

std::optional<Trace> read_trace(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    Reader reader(file, sources, diagnostics);
    if (!reader.read_head({"t", "x", "y", "z", "f"}, {"t", "x", "y", "z"})) return {};
    Trace trace;
    struct Sample {
        double t = 0;
        std::array<double, 3> at{}, speed{};
    };
    Sample last, before;  // before: the one before the last
    double first = 0;
    while (const std::optional<Row> row = reader.next()) {
        Sample now;
        std::array<double*, 4> to{&now.t, &now.at[0], &now.at[1], &now.at[2]};
        for (std::size_t i = 0; i < to.size(); ++i) {
            const std::string name = std::string(1, "txyz"[i]);
            const Cell* c = reader.cell(*row, name);
            if (c == nullptr) return reader.fail(row->front().where, "a sample without '" + name + "'"), std::nullopt;
            const std::optional<double> v = reader.number(*c, name);
            if (!v) return {};
            *to[i] = *v;
        }
        if (trace.samples == 0) first = now.t;
        if (trace.samples > 0 && !(now.t > last.t))
            return reader.fail(row->front().where, "times must grow from line to line"), std::nullopt;
        for (std::size_t i = 0; i < 3 && trace.samples > 0; ++i)
            now.speed[i] = (now.at[i] - last.at[i]) / (now.t - last.t);
        for (std::size_t i = 0; i < 3 && trace.samples > 1; ++i) {
            // Two in turn, so that one sample that comes late makes no speed that was never gone.
            trace.speed[i] = std::max(trace.speed[i], std::min(std::abs(now.speed[i]), std::abs(last.speed[i])));
            if (trace.samples > 2)
                trace.acceleration[i] =
                    std::max(trace.acceleration[i], std::abs(now.speed[i] - before.speed[i]) / (now.t - before.t));
        }
        before = last;
        last = now;
        ++trace.samples;
    }
    if (diagnostics.has_errors()) return {};
    if (trace.samples < 2) return reader.fail({file, 0, 0}, "a trace needs two samples at least"), std::nullopt;
    trace.seconds = last.t - first;
    return trace;
}

}  // namespace obrys::driver
