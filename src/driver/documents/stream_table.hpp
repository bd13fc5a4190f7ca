#pragma once
/// The CL stream as CSV and JSON lines for other tools. Columns: docs/cl-stream.md.

#include <string>
#include <string_view>

#include "base/function_ref.hpp"
#include "base/source.hpp"
#include "motion/cursor.hpp"

namespace obrys::driver {

using TextSink = base::FunctionRef<void(std::string_view)>;

/// One row a move: i, file, line, block, kind, x, y, z, feed, cx, cy, cz, sense. mm, x as a radius; unknown: empty.
class CsvWriter {
public:
    CsvWriter(const base::Sources& sources, TextSink out);
    void operator()(const cl::Record& record);

private:
    const base::Sources& sources_;
    TextSink out_;
    motion::Cursor cursor_;
    std::string row_;
};

/// One JSON object a move in an array; the same fields.
class JsonWriter {
public:
    JsonWriter(const base::Sources& sources, TextSink out) : sources_(sources), out_(out) {}
    void operator()(const cl::Record& record);
    void finish();

private:
    const base::Sources& sources_;
    TextSink out_;
    motion::Cursor cursor_;
};

}  // namespace obrys::driver
