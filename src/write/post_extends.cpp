/// A post with all the posts that it extends.

#include <algorithm>

#include "base/codes.hpp"
#include "shop/files/section.hpp"
#include "shop/nearest.hpp"
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

/// A table, or several.
bool holds_tables(const shop::Value& v) {
    return v.kind == shop::ValueKind::table ||
           (v.kind == shop::ValueKind::array && !v.items.empty() && v.items.front().kind == shop::ValueKind::table);
}

shop::Value listed(const shop::Value& tables) {
    if (tables.kind == shop::ValueKind::array) return tables;
    shop::Value out;
    out.kind = shop::ValueKind::array;
    out.where = tables.where;
    out.items.push_back(tables);
    return out;
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
        // How many decimals, and that they are the control's increments, stand in each other's place.
        const std::string_view other = e.key == "decimals" ? "increments" : e.key == "increments" ? "decimals" : "";
        std::erase_if(out.entries, [&](const Entry& there) { return there.key == other; });
        const auto same = std::find_if(out.entries.begin(), out.entries.end(),
                                       [&](const Entry& there) { return there.key == e.key; });
        if (same == out.entries.end()) {
            out.entries.push_back(e);
            continue;
        }
        if (e.value.kind == shop::ValueKind::table && same->value.kind == shop::ValueKind::table) {
            same->value = joined(same->value, e.value);
        } else if (holds_tables(e.value) && holds_tables(same->value)) {  // [datum] is one of [[datum]]
            shop::Value all = listed(e.value);
            const shop::Value below = listed(same->value);
            all.items.insert(all.items.end(), below.items.begin(), below.items.end());
            same->value = std::move(all);
        } else {
            same->value = e.value;
        }
    }
    out.where = over.where;
    return out;
}

constexpr int deepest_extension = 8;

/// What whoever reads a post reads it with.
struct From {
    const base::Sources& sources;  ///< of own files
    base::Sources& texts;          ///< of shipped ones: places lie in them
    const LoadText& load;
    base::Diagnostics& diagnostics;
};

std::nullopt_t refuse_extension(const From& from, const shop::Value& value, std::string text, std::string remedy) {
    base::Diagnostic d;
    d.severity = base::Severity::error;
    d.code = codes::job_value;
    d.where = value.where;
    d.text = std::move(text);
    d.remedy = std::move(remedy);
    from.diagnostics.add(std::move(d));
    return std::nullopt;
}

/// The file with all that it extends below it.
std::optional<shop::Value> whole_file(std::uint32_t file, bool is_shipped, const From& from, int depth) {
    auto root = shop::parse_toml(file, is_shipped ? from.texts : from.sources, from.diagnostics);
    if (!root) return std::nullopt;
    const Entry* e = shop::find(*root, "extends");
    if (!e) return root;
    const std::string& name = e->value.text;
    const std::string remedy =
        "name one of: " + shop::joined(shipped_post_names()) + ", or a file (.toml) beside this one";
    if (e->value.kind != shop::ValueKind::text)
        return refuse_extension(from, e->value, "'extends' must be the name of a post", remedy);
    if (depth == deepest_extension)
        return refuse_extension(
            from, e->value,
            "posts extend each other in a circle, or more than " + std::to_string(deepest_extension) + " deep",
            "let the last one stand alone");
    std::optional<shop::Value> under;
    if (name.ends_with(".toml") && from.load) {
        const auto own = from.load(name, e->value.where);
        if (own) under = whole_file(*own, false, from, depth + 1);
    } else if (const ShippedPost* base = shipped_post(name)) {
        under = whole_file(from.texts.add(std::string(base->name), std::string(base->text)), true, from, depth + 1);
    } else {
        return refuse_extension(from, e->value, "there is no shipped post called '" + name + "'", remedy);
    }
    if (!under) return std::nullopt;
    return joined(*under, *root);
}

}  // namespace

std::optional<shop::Value> whole_post(std::uint32_t file, const base::Sources& sources, base::Sources& texts,
                                      base::Diagnostics& diagnostics, const LoadText& load) {
    return whole_file(file, false, {sources, texts, load, diagnostics}, 0);
}

}  // namespace obrys::write
