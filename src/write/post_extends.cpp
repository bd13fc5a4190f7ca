/// A post with all the posts that it extends.

#include <algorithm>

#include "base/codes.hpp"
#include "shop/files/section.hpp"
#include "write/post.hpp"

namespace obrys::write {

namespace {

using shop::Entry;
namespace codes = base::codes;

/// Of the post below, those of kinds that are named here, as one text or several.
void erase_cycles(shop::Value& post, const shop::Value& kinds) {
    const auto is_named = [&](const std::string& kind) {
        return kinds.text == kind || std::any_of(kinds.items.begin(), kinds.items.end(),
                                                 [&](const shop::Value& v) { return v.text == kind; });
    };
    /// The form is of no other kind, and is to go; else it keeps the others.
    const auto leaves_out = [&](shop::Value& form) {
        const auto kind =
            std::find_if(form.entries.begin(), form.entries.end(), [](const Entry& e) { return e.key == "kind"; });
        if (kind == form.entries.end()) return false;
        std::vector<shop::Value>& several = kind->value.items;
        if (several.empty()) return is_named(kind->value.text);
        std::erase_if(several, [&](const shop::Value& v) { return is_named(v.text); });
        return several.empty();
    };
    for (Entry& e : post.entries)
        if (e.key == "cycle")
            e.value.items.erase(std::remove_if(e.value.items.begin(), e.value.items.end(), leaves_out),
                                e.value.items.end());
}

/// What `over` says stands in the place of what `under` says; tables are joined, arrays of tables too, those of `over`
/// first.
shop::Value joined(const shop::Value& under, const shop::Value& over) {
    shop::Value out = under;
    const Entry* cycles = shop::find(over, "cycles");
    const Entry* inherit = cycles != nullptr ? shop::find(cycles->value, "inherit") : nullptr;
    if (inherit != nullptr && inherit->value.kind == shop::ValueKind::boolean && !inherit->value.boolean)
        std::erase_if(out.entries, [](const Entry& e) { return e.key == "cycle"; });
    if (const Entry* without = cycles != nullptr ? shop::find(cycles->value, "without") : nullptr)
        erase_cycles(out, without->value);
    for (const Entry& e : over.entries) {
        const auto same = std::find_if(out.entries.begin(), out.entries.end(),
                                       [&](const Entry& there) { return there.key == e.key; });
        if (same == out.entries.end()) {
            out.entries.push_back(e);
            continue;
        }
        const bool tables = e.value.kind == shop::ValueKind::array && !e.value.items.empty() &&
                            e.value.items.front().kind == shop::ValueKind::table;
        if (e.value.kind == shop::ValueKind::table && same->value.kind == shop::ValueKind::table) {
            same->value = joined(same->value, e.value);
        } else if (tables && same->value.kind == shop::ValueKind::array) {
            shop::Value all = e.value;
            all.items.insert(all.items.end(), same->value.items.begin(), same->value.items.end());
            same->value = std::move(all);
        } else {
            same->value = e.value;
        }
    }
    out.where = over.where;
    return out;
}

constexpr int deepest_extension = 8;

/// The file with all that it extends below it. The texts of shipped posts are kept in `texts`, since places lie in
/// them.
std::optional<shop::Value> whole_file(std::uint32_t file, const base::Sources& sources, base::Sources& texts,
                                      base::Diagnostics& diagnostics, int depth) {
    auto root = shop::parse_toml(file, sources, diagnostics);
    if (!root) return std::nullopt;
    const Entry* e = shop::find(*root, "extends");
    if (!e) return root;
    const ShippedPost* base = shipped_post(e->value.text);
    if (base == nullptr || depth == deepest_extension) {
        base::Diagnostic d;
        d.code = codes::job_value;
        d.where = e->value.where;
        d.text = "there is no shipped post called '" + e->value.text + "'";
        diagnostics.add(std::move(d));
        return std::nullopt;
    }
    const std::uint32_t text = texts.add(std::string(base->name), std::string(base->text));
    const auto under = whole_file(text, texts, texts, diagnostics, depth + 1);
    if (!under) return std::nullopt;
    return joined(*under, *root);
}

}  // namespace

std::optional<shop::Value> whole_post(std::uint32_t file, const base::Sources& sources, base::Sources& texts,
                                      base::Diagnostics& diagnostics) {
    return whole_file(file, sources, texts, diagnostics, 0);
}

}  // namespace obrys::write
