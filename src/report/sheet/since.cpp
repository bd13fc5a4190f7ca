/// What differs between two sheets: both as their JSON, so that an older one is read as it was written.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr double same_number = 1e-6;

std::string value_text(const OrderedJson& v) {
    if (v.is_null()) return "?";
    if (v.is_number_float()) return base::fixed(v.get<double>(), 3);
    return v.is_string() ? v.get<std::string>() : v.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

bool is_same(const OrderedJson& a, const OrderedJson& b) {
    if (a.is_number() && b.is_number()) return std::abs(a.get<double>() - b.get<double>()) <= same_number;
    if (!a.is_array() || !b.is_array() || a.size() != b.size()) return a == b;
    return std::equal(a.begin(), a.end(), b.begin(), is_same);
}

/// How a tool or a zero is called, where lists of both are held against each other.
std::string label_of(const OrderedJson& item, const std::string& list) {
    if (!item.is_object()) return value_text(item);
    if (list == "zeros") return "zero " + value_text(item.value("number", OrderedJson()));
    if (list == "programs") return item.value("program", "");
    std::string label =
        "T" + value_text(item.value("number", OrderedJson())) + " D" + value_text(item.value("edge", OrderedJson()));
    const std::string name = item.value("name", "");
    return name.empty() ? label : label + " " + name;
}

class Differences {
public:
    void objects(const OrderedJson& old, const OrderedJson& now, const std::string& where) {
        for (const auto& [key, value] : now.items()) {
            if (!old.contains(key))
                lines.push_back(where + key + ": new: " + value_text(value));
            else
                values(old[key], value, where, key);
        }
        for (const auto& [key, value] : old.items())
            if (!now.contains(key)) lines.push_back(where + key + ": gone: " + value_text(value));
    }

    std::vector<std::string> lines;

private:
    void values(const OrderedJson& old, const OrderedJson& now, const std::string& where, const std::string& key) {
        const bool list = key == "tools" || key == "zeros" || key == "programs" || key == "called" ||
                          key == "messages" || key == "clamps";
        if (list && old.is_array() && now.is_array()) return lists(old, now, where, key);
        if (old.is_object() && now.is_object()) return objects(old, now, where + key + " ");
        if (!is_same(old, now)) lines.push_back(where + key + ": " + value_text(old) + " -> " + value_text(now));
    }

    void lists(const OrderedJson& old, const OrderedJson& now, const std::string& where, const std::string& key) {
        std::vector<bool> met(old.size(), false);
        for (const OrderedJson& item : now) {
            const std::string label = label_of(item, key);
            std::size_t at = 0;
            while (at < old.size() && (met[at] || label_of(old[at], key) != label)) ++at;
            if (at == old.size()) {
                lines.push_back(where + label + ": new in " + key);
                continue;
            }
            met[at] = true;
            if (item.is_object()) objects(old[at], item, where + label + ": ");
        }
        for (std::size_t i = 0; i < old.size(); ++i)
            if (!met[i]) lines.push_back(where + label_of(old[i], key) + ": no longer in " + key);
    }
};

}  // namespace

std::optional<Since> since(const std::string& name, const std::string& old_json, const std::vector<Program>& programs) {
    const OrderedJson old = OrderedJson::parse(old_json, nullptr, false);
    const OrderedJson now = OrderedJson::parse(as_json(programs));
    const auto same = [&](const char* key) { return old.contains(key) && old[key] == now[key]; };
    if (!old.is_object() || !same("format") || !same("version")) return std::nullopt;
    Differences differences;
    try {
        // One program each is the same job under whatever name.
        const bool single = old.at("programs").size() == 1 && now.at("programs").size() == 1;
        if (single)
            differences.objects(old["programs"][0], now["programs"][0], "");
        else
            differences.objects(old, now, "");
    } catch (const OrderedJson::exception&) {  // of another shape than its version says
        return std::nullopt;
    }
    return Since{name, std::move(differences.lines)};
}

}  // namespace obrys::report::sheet
