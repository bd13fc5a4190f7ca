#include "interp/value.hpp"

#include <cmath>
#include <limits>

#include "base/number.hpp"

namespace obrys::interp {

namespace {
const std::string no_text;
const geom::Frame no_frame;
constexpr double integer_limit = 2147483648.0;  // 32-bit INT of the control
}  // namespace

Value Value::unknown(Type type) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Value v{type, nan, nullptr, nullptr};
    if (v.is_text()) v.text = std::make_shared<const std::string>("?");
    if (type == Type::frame) v.frame = std::make_shared<const geom::Frame>(geom::Frame::shift({nan, nan, nan}));
    return v;
}
Value Value::unknown_text(std::string shown) {
    Value v = unknown(Type::string);
    v.text = std::make_shared<const std::string>(std::move(shown));
    return v;
}
bool Value::is_unknown() const { return std::isnan(number); }
Value Value::string(std::string s) {
    return {Type::string, 0, std::make_shared<const std::string>(std::move(s)), nullptr};
}
Value Value::axis(std::string name) {
    return {Type::axis, 0, std::make_shared<const std::string>(std::move(name)), nullptr};
}
Value Value::of_frame(const geom::Frame& f) {
    return {Type::frame, 0, nullptr, std::make_shared<const geom::Frame>(f)};
}
const std::string& Value::as_text() const { return text ? *text : no_text; }
const geom::Frame& Value::as_frame() const { return frame ? *frame : no_frame; }

std::string_view name(Type t) {
    switch (t) {
        case Type::boolean: return "BOOL";
        case Type::character: return "CHAR";
        case Type::integer: return "INT";
        case Type::real: return "REAL";
        case Type::string: return "STRING";
        case Type::axis: return "AXIS";
        case Type::frame: return "FRAME";
    }
    return "REAL";
}

std::string printed(const Value& v) {
    if (v.is_unknown() && !v.is_text()) return "?";
    switch (v.type) {
        case Type::boolean:
        case Type::integer: return base::fixed(v.number, 0);
        case Type::character: return std::string(1, character(v.number));
        case Type::string:
        case Type::axis: return v.as_text();
        case Type::frame: return "FRAME";
        case Type::real: break;
    }
    std::string s = base::fixed(v.number, 7);
    s.erase(s.find_last_not_of('0') + 1);
    if (s.ends_with('.')) s.pop_back();
    return s == "-0" ? "0" : s;
}

void Array::allocate() {
    if (type <= Type::real)
        numbers.resize(size());
    else
        others.resize(size(), type == Type::frame    ? Value::of_frame({})
                              : type == Type::string ? Value::string({})
                                                     : Value::axis({}));
}

void Array::allocate_unknown(Held why) {
    const Value unknown = Value::unknown(type);
    if (type <= Type::real)
        numbers.resize(size(), unknown.number);
    else
        others.resize(size(), unknown);
    held.resize(size(), why);
}

Value Array::get(std::size_t i) const {
    return type <= Type::real ? Value{type, numbers[i], nullptr, nullptr} : others[i];
}

void Array::set(std::size_t i, const Value& v) {
    if (!held.empty()) held[i] = Held::own;
    if (type <= Type::real)
        numbers[i] = v.number;
    else
        others[i] = v;
}

Conversion convert(Value& v, Type to, std::size_t string_length) {
    if (v.is_unknown() && v.type != to && (v.is_number() || to <= Type::real)) {
        v = Value::unknown(to);  // what it is, nobody can say
        return Conversion::ok;
    }
    if (to == Type::string && v.is_text()) {
        v.type = Type::string;
        return v.as_text().size() > string_length ? Conversion::too_long : Conversion::ok;
    }
    if (to == Type::string && v.type == Type::character) {
        v = Value::string(std::string(1, character(v.number)));
        return Conversion::ok;
    }
    if (to == Type::axis && v.type == Type::axis) return Conversion::ok;
    if (to == Type::frame && v.type == Type::frame) return Conversion::ok;
    if (to == Type::boolean && v.type == Type::string) {
        v = Value::boolean(!v.as_text().empty());
        return Conversion::ok;
    }
    if (to == Type::character && v.type == Type::string && v.as_text().size() == 1) {
        v = {Type::character, static_cast<double>(static_cast<unsigned char>(v.as_text()[0])), nullptr, nullptr};
        return Conversion::ok;
    }
    if (!v.is_number() || to == Type::string || to == Type::axis || to == Type::frame) return Conversion::wrong_type;
    const bool unknown = v.is_unknown();
    v.type = to;
    if (unknown) return Conversion::ok;
    if (to == Type::boolean) v.number = v.number != 0 ? 1 : 0;
    if (to == Type::integer || to == Type::character) v.number = std::floor(v.number + 0.5);
    const double high = to == Type::character ? 256 : integer_limit;
    const double low = to == Type::character ? 0 : -integer_limit;
    if ((to == Type::integer || to == Type::character) && (v.number < low || v.number >= high))
        return Conversion::out_of_range;
    return Conversion::ok;
}

}  // namespace obrys::interp
