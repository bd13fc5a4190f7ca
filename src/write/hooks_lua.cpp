/// Functions of posts in Lua. What may report an error runs below lua_pcall: lua_sandbox.hpp.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <lua.hpp>
#include <optional>
#include <set>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "write/lua_sandbox.hpp"

namespace obrys::write {

namespace {

constexpr int most_blocks = 1000;

/// Values that are counted: they stand in Lua as whole numbers.
bool is_counted(ValueIndex v) {
    for (const Value counted :
         {Value::turns, Value::more_turns, Value::number, Value::edge, Value::turret, Value::offset, Value::nose,
          Value::around, Value::sharp, Value::way, Value::filter, Value::block})
        if (v == index_of(counted)) return true;
    return false;
}

struct Question {
    const std::string& name;
    const Values& values;
    bool in_cycle;
    Hooked& answer;
};

void push_value(lua_State* lua, const Values& values, ValueIndex v, std::string_view name) {
    lua_pushlstring(lua, name.data(), name.size());
    const double value = values.number(v);
    const std::optional<std::int64_t> count = is_counted(v) ? base::whole<std::int64_t>(value) : std::nullopt;
    if (count)
        lua_pushinteger(lua, *count);
    else
        lua_pushnumber(lua, value);
    lua_settable(lua, -3);
}

void push_values(lua_State* lua, const Question& q) {
    lua_newtable(lua);
    for (ValueIndex v = 0; v < first_role; ++v)
        if (q.values.has(v)) push_value(lua, q.values, v, name_of(static_cast<Value>(v)));
    if (q.in_cycle)
        for (ValueIndex v = first_role; v < value_count; ++v)
            if (q.values.has(v)) push_value(lua, q.values, v, cl::spelling(static_cast<cl::CycleRole>(v - first_role)));
    constexpr std::array<const char*, 3> texts{"name", "text", "letter"};
    for (std::size_t t = 0; t < texts.size(); ++t) {
        const std::string_view text = q.values.text(static_cast<Text>(t));
        if (text.empty()) continue;
        lua_pushlstring(lua, text.data(), text.size());
        lua_setfield(lua, -2, texts[t]);
    }
}

void add_block(lua_State* lua, Hooked& answer) {
    std::size_t size = 0;
    const char* text = lua_tolstring(lua, -1, &size);
    if (std::memchr(text, '\n', size) != nullptr) luaL_error(lua, "a block is one line: return a list of them");
    answer.blocks.emplace_back(text, size);
}

int ask_function(lua_State* lua) {
    const auto& q = *static_cast<const Question*>(lua_touserdata(lua, 2));
    lua_getfield(lua, 1, q.name.c_str());
    lua_Debug about{};
    lua_pushvalue(lua, -1);
    lua_getinfo(lua, ">S", &about);
    room_of(lua).defined = static_cast<std::size_t>(std::max(about.linedefined, 0));
    push_values(lua, q);
    lua_call(lua, 1, 1);
    if (lua_isnil(lua, -1)) return 0;
    q.answer.kind = Hooked::Kind::blocks;
    if (lua_type(lua, -1) == LUA_TSTRING) return add_block(lua, q.answer), 0;
    if (!lua_istable(lua, -1))
        return luaL_error(lua, "it returns neither text nor a list of texts, but a %s", luaL_typename(lua, -1));
    const lua_Unsigned blocks = lua_rawlen(lua, -1);
    if (blocks > most_blocks) return luaL_error(lua, "it returns more than %d blocks", most_blocks);
    for (lua_Unsigned i = 1; i <= blocks; ++i) {
        if (lua_geti(lua, -1, static_cast<lua_Integer>(i)) != LUA_TSTRING)
            return luaL_error(lua, "it returns a list with a %s in it", luaL_typename(lua, -1));
        add_block(lua, q.answer);
        lua_pop(lua, 1);
    }
    return 0;
}

int list_names(lua_State* lua) {
    auto& names = *static_cast<std::vector<std::string>*>(lua_touserdata(lua, 2));
    lua_pushnil(lua);
    while (lua_next(lua, 1) != 0) {
        if (lua_type(lua, -2) != LUA_TSTRING || !lua_isfunction(lua, -1))
            return luaL_error(lua, "'on' holds something else than functions by the names of commands");
        names.emplace_back(lua_tostring(lua, -2));
        lua_pop(lua, 1);
    }
    return 0;
}

class LuaHooks final : public Hooks {
public:
    explicit LuaHooks(const NamedStyles& styles) : styles_(styles), lua_(new_sandbox(room_)) {
        room_.styles = &styles_;
    }
    ~LuaHooks() override {
        if (lua_ != nullptr) lua_close(lua_);
    }
    LuaHooks(const LuaHooks&) = delete;
    LuaHooks& operator=(const LuaHooks&) = delete;

    bool open(const std::string& text, HookFault& fault) {
        if (lua_ == nullptr) return fault.text = "there is no memory for Lua", false;
        begin_call();
        lua_pushcfunction(lua_, open_world);
        lua_pushlightuserdata(lua_, const_cast<std::string*>(&text));
        if (lua_pcall(lua_, 1, 1, 1) != LUA_OK) return take_fault(fault), false;
        lua_pushcfunction(lua_, list_names);
        lua_pushvalue(lua_, 2);
        lua_pushlightuserdata(lua_, &names_);
        if (lua_pcall(lua_, 2, 0, 1) != LUA_OK) return take_fault(fault), false;
        return true;
    }

    [[nodiscard]] std::vector<std::string> names() const override { return names_; }

    Hooked ask(const std::string& name, const Values& values, bool in_cycle) override {
        Hooked answer;
        answer.kind = Hooked::Kind::failed;
        if (failed_.count(name) != 0) {
            answer.fault.text = "it has failed before, and is not called again";
            return answer;
        }
        begin_call();
        answer.kind = Hooked::Kind::usual;
        const Question question{name, values, in_cycle, answer};
        lua_pushcfunction(lua_, ask_function);
        lua_pushvalue(lua_, 2);
        lua_pushlightuserdata(lua_, const_cast<Question*>(&question));
        if (lua_pcall(lua_, 2, 0, 1) == LUA_OK) return answer;
        answer.blocks.clear();
        answer.kind = room_.refuses ? Hooked::Kind::refused : Hooked::Kind::failed;
        take_fault(answer.fault);
        if (room_.refuses)
            answer.text = answer.fault.text;
        else
            failed_.insert(name);
        return answer;
    }

private:
    /// The stack holds the function that keeps lines, then the table of functions.
    void begin_call() {
        room_.turned = 0, room_.steps = 0, room_.line = 0, room_.defined = 0, room_.refuses = false;
        if (lua_gettop(lua_) == 0) lua_pushcfunction(lua_, keep_line);
    }

    /// "hooks:12: unexpected symbol near '='": line, text, and what it is near.
    void take_fault(HookFault& fault) {
        std::size_t size = 0;
        const char* said = lua_type(lua_, -1) == LUA_TSTRING ? lua_tolstring(lua_, -1, &size) : nullptr;
        fault.text = said == nullptr ? "it ends with an error that is no text" : std::string(said, size);
        lua_settop(lua_, std::min(lua_gettop(lua_) - 1, 2));
        for (const std::string_view of : {"hooks:", "obrys:"}) {
            if (!fault.text.starts_with(of)) continue;
            const std::size_t end = fault.text.find(": ", of.size());
            if (end == std::string::npos) continue;
            const auto line = base::parse_integer(std::string_view(fault.text).substr(of.size(), end - of.size()));
            if (of == "hooks:" && room_.line == 0 && line) room_.line = static_cast<std::size_t>(*line);
            fault.text.erase(0, end + 2);
        }
        if (fault.text == "not enough memory")
            fault.text = "it takes more memory than it may (2 MB held, 64 MB in one call)";
        fault.line = std::max<std::size_t>(room_.line != 0 ? room_.line : room_.defined, 1);
        constexpr std::string_view near = " near '";
        if (const std::size_t at = fault.text.rfind(near); at != std::string::npos && fault.text.ends_with('\''))
            fault.near = fault.text.substr(at + near.size(), fault.text.size() - at - near.size() - 1);
    }

    Room room_;
    NamedStyles styles_;
    lua_State* lua_;
    std::vector<std::string> names_;
    std::set<std::string> failed_;
};

}  // namespace

bool has_hooks() { return true; }

std::unique_ptr<Hooks> load_hooks(const std::string& text, const NamedStyles& styles, HookFault& fault) {
    auto hooks = std::make_unique<LuaHooks>(styles);
    if (!hooks->open(text, fault)) return nullptr;
    return hooks;
}

}  // namespace obrys::write
