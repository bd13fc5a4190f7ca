/// A4 across, by cairo.

#include <algorithm>
#include <memory>
#include <new>

#include "base/text.hpp"
#include "report/drawing/cairo.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

using drawing::cairo;

namespace {

// pt
constexpr double page_width = 842, page_height = 595, margin = 36;
constexpr double size = 8.5, line_height = 12, gap = 8;

cairo_status_t append_bytes(void* to, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(to)->append(bytes, bytes + count);
    return CAIRO_STATUS_SUCCESS;
}

/// Text and lines from above to below; a page that is full is followed by another one.
class Paper {
public:
    Paper() : surface_(cairo().pdf_surface_create_for_stream(append_bytes, &bytes_, page_width, page_height)) {
        context_.reset(cairo().create(surface_.get()));
    }

    [[nodiscard]] double width_of(const std::string& text, bool bold) {
        set_font(size, bold);
        cairo_text_extents_t extents{};
        cairo().text_extents(context_.get(), text.c_str(), &extents);
        return extents.x_advance;
    }
    void text(double x, const std::string& content, double font, bool bold) {
        set_font(font, bold);
        cairo().move_to(context_.get(), x, y_);
        cairo().show_text(context_.get(), content.c_str());
    }
    void rule() {
        cairo().set_line_width(context_.get(), 0.4);
        cairo().move_to(context_.get(), margin, y_ + 3);
        cairo().line_to(context_.get(), page_width - margin, y_ + 3);
        cairo().stroke(context_.get());
    }
    /// Room for so much; true where a new page begins with it.
    bool advance(double height) {
        y_ += height;
        if (y_ < page_height - margin) return false;
        new_page();
        return true;
    }
    void new_page() {
        cairo().show_page(context_.get());
        y_ = margin + line_height;
    }
    [[nodiscard]] std::string finish() {
        const cairo_status_t drawn = cairo().status(context_.get());
        context_.reset();
        cairo().surface_finish(surface_.get());
        if (drawn != CAIRO_STATUS_SUCCESS || cairo().surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS)
            throw std::bad_alloc();
        return bytes_;
    }

private:
    struct End {
        void operator()(cairo_surface_t* s) const { cairo().surface_destroy(s); }
        void operator()(cairo_t* c) const { cairo().destroy(c); }
    };
    void set_font(double font, bool bold) {
        cairo().select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                                 bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo().set_font_size(context_.get(), font);
    }

    std::string bytes_;
    std::unique_ptr<cairo_surface_t, End> surface_;
    std::unique_ptr<cairo_t, End> context_;
    double y_ = margin + line_height;
};

/// Cairo draws nothing any more behind a text that is no UTF-8, or behind a control character in none.
std::string drawable(const std::string& text) {
    std::string out = base::as_utf8(text);
    std::replace_if(
        out.begin(), out.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return out;
}

/// A cell in lines that are no wider than its column.
std::vector<std::string> folded(Paper& paper, const std::string& cell, double width, bool bold) {
    std::vector<std::string> lines{""};
    const std::string text = drawable(cell);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        std::string word = text.substr(at, end - at);
        at = std::min(end + 1, text.size());
        if (lines.back().empty()) {
            lines.back() = std::move(word);
        } else if (paper.width_of(lines.back() + " " + word, bold) <= width) {
            lines.back() += " " + word;
        } else {
            lines.push_back(std::move(word));
        }
        // A word alone that is too long is cut, by whole characters.
        while (paper.width_of(lines.back(), bold) > width && base::character_count(lines.back()) > 1) {
            std::string first = lines.back();
            while (paper.width_of(first, bold) > width && base::character_count(first) > 1)
                base::cut_utf8(first, first.size() - 1);
            std::string rest = lines.back().substr(first.size());
            lines.back() = std::move(first);
            lines.push_back(std::move(rest));
        }
    }
    return lines;
}

void put_cells(Paper& paper, const std::vector<std::string>& row, const std::vector<double>& widths, bool bold) {
    std::vector<std::vector<std::string>> cells;
    std::size_t lines = 1;
    for (std::size_t i = 0; i < row.size(); ++i) {
        cells.push_back(folded(paper, row[i], widths[i] - gap, bold));
        lines = std::max(lines, cells.back().size());
    }
    for (std::size_t line = 0; line < lines; ++line) {
        double x = margin;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (line < cells[i].size()) paper.text(x, cells[i][line], size, bold);
            x += widths[i];
        }
        if (line + 1 == lines) paper.rule();
        static_cast<void>(paper.advance(line_height));
    }
}

/// As wide as what stands in the columns; less in all where that is more than the page.
std::vector<double> widths_of(Paper& paper, const Table& table) {
    std::vector<double> widths(table.head.size(), 0);
    const auto widen = [&](const std::vector<std::string>& row, bool bold) {
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], paper.width_of(drawable(row[i]), bold) + gap);
    };
    widen(table.head, true);
    for (const auto& row : table.rows) widen(row, false);
    double all = 0;
    for (const double w : widths) all += w;
    const double share = std::min(1.0, (page_width - 2 * margin) / std::max(all, 1.0));
    for (double& w : widths) w *= share;
    return widths;
}

}  // namespace

std::string as_pdf(const std::vector<Page>& pages) {
    Paper paper;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const Page& page = pages[i];
        if (i > 0) paper.new_page();
        paper.text(margin, drawable(page.title), 14, true);
        static_cast<void>(paper.advance(2 * line_height));
        Table facts{"", {"", ""}, {}};
        for (const auto& [name, value] : page.facts) facts.rows.push_back({name, value});
        const std::vector<double> fact_widths = widths_of(paper, facts);
        for (const auto& row : facts.rows) put_cells(paper, row, fact_widths, false);
        for (const Table& table : page.tables) {
            static_cast<void>(paper.advance(line_height));
            paper.text(margin, drawable(table.title), 10, true);
            static_cast<void>(paper.advance(1.5 * line_height));
            const std::vector<double> widths = widths_of(paper, table);
            if (table.head.size() > 1) put_cells(paper, table.head, widths, true);
            for (const auto& row : table.rows) put_cells(paper, row, widths, false);
        }
        static_cast<void>(paper.advance(line_height));
        for (const std::string& remark : page.remarks) put_cells(paper, {remark}, {page_width - 2 * margin}, false);
    }
    return paper.finish();
}

}  // namespace obrys::report::sheet
