/// What Lua's own libraries do without counting steps (patterns, rep, table.insert, table.move) is not there, or
/// written in Lua, where steps are counted.

#include "write/lua_sandbox.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <lua.hpp>

namespace obrys::write {

namespace {

constexpr std::size_t most_memory = std::size_t{2} << 20;       ///< bytes held
constexpr std::size_t most_turned = std::size_t{64} << 20;      ///< bytes taken during one call
constexpr long most_steps = 500'000, counted_at_a_time = 1000;  ///< instructions of Lua
constexpr std::size_t most_text = 100'000;                      ///< characters that rep and replace make
constexpr std::size_t most_needle = 200;                        ///< characters that find and replace look for
void* allocate(void* of, void* block, std::size_t old, std::size_t wanted) {
    Room& room = *static_cast<Room*>(of);
    if (block == nullptr) old = 0;  // it then tells what is to be made
    if (wanted == 0) {
        std::free(block);
        room.held -= old;
        return nullptr;
    }
    if (wanted > old && (room.held + (wanted - old) > most_memory || room.turned + wanted > most_turned))
        return nullptr;
    void* got = std::realloc(block, wanted);
    if (got == nullptr) return nullptr;
    room.held += wanted - old;
    room.turned += wanted;
    return got;
}

/// More work than an instruction, which counts as so many.
void charge(lua_State* lua, std::size_t steps) {
    Room& room = room_of(lua);
    room.steps += static_cast<long>(std::min<std::size_t>(steps, most_steps));
    if (room.steps > most_steps) luaL_error(lua, "takes more than %d steps", static_cast<int>(most_steps));
}

void count(lua_State* lua, lua_Debug*) { charge(lua, counted_at_a_time); }

int refuse(lua_State* lua) {
    luaL_checkstring(lua, 1);
    lua_settop(lua, 1);
    room_of(lua).refuses = true;
    return lua_error(lua);
}

/// Into `out`: the number in a style; what is wrong, where it cannot be.
const char* styled(double value, std::string_view style, const NamedStyles& styles, luaL_Buffer& out) {
    for (std::size_t i = 0; i < styles.names.size(); ++i) {
        if (styles.names[i] != style) continue;
        std::string text;
        if (!append_number(text, value, styles.styles[i])) return "no word can hold this number";
        if (text.size() >= LUAL_BUFFERSIZE) return "no word can hold this number";
        std::memcpy(luaL_buffaddr(&out), text.data(), text.size());
        luaL_addsize(&out, text.size());
        return nullptr;
    }
    return "there is no such style of numbers";
}

int number(lua_State* lua) {
    const double value = luaL_checknumber(lua, 1);
    const char* style = luaL_optstring(lua, 2, "length");
    luaL_Buffer out;
    luaL_buffinit(lua, &out);
    if (const char* fault = styled(value, style, *room_of(lua).styles, out))
        return luaL_error(lua, "number(%f, \"%s\"): %s", value, style, fault);
    luaL_pushresult(&out);
    return 1;
}

int repeat(lua_State* lua) {
    std::size_t size = 0;
    const char* text = luaL_checklstring(lua, 1, &size);
    const lua_Integer times = luaL_checkinteger(lua, 2);
    if (times > static_cast<lua_Integer>(most_text) ||
        (times > 0 && size * static_cast<std::size_t>(times) > most_text))
        return luaL_error(lua, "rep makes at most %d characters", static_cast<int>(most_text));
    charge(lua, static_cast<std::size_t>(std::max<lua_Integer>(times, 0)) / 8);
    luaL_Buffer out;
    luaL_buffinit(lua, &out);
    for (lua_Integer n = 0; n < times; ++n) luaL_addlstring(&out, text, size);
    luaL_pushresult(&out);
    return 1;
}

/// Text and what is looked for in it, with the steps that this may take.
std::string_view searched(lua_State* lua, std::string_view& needle) {
    std::size_t size = 0, sought = 0;
    const char* text = luaL_checklstring(lua, 1, &size);
    const char* what = luaL_checklstring(lua, 2, &sought);
    needle = {what, sought};
    if (sought == 0 || sought > most_needle) luaL_argerror(lua, 2, "1 to 200 characters can be looked for");
    charge(lua, size / 16 + size * sought / 256);
    return {text, size};
}

/// find(text, what, from): where it stands, as it is.
int find(lua_State* lua) {
    std::string_view needle;
    const std::string_view text = searched(lua, needle);
    const lua_Integer from = luaL_optinteger(lua, 3, 1);
    const std::size_t at = text.find(needle, static_cast<std::size_t>(std::max<lua_Integer>(from, 1) - 1));
    if (at == std::string_view::npos) return lua_pushnil(lua), 1;
    lua_pushinteger(lua, static_cast<lua_Integer>(at + 1));
    lua_pushinteger(lua, static_cast<lua_Integer>(at + needle.size()));
    return 2;
}

/// replace(text, what, with): everywhere, as it is.
int replace(lua_State* lua) {
    std::string_view needle;
    const std::string_view text = searched(lua, needle);
    std::size_t size = 0;
    const char* with = luaL_checklstring(lua, 3, &size);
    luaL_Buffer out;
    luaL_buffinit(lua, &out);
    std::size_t from = 0, made = 0;
    for (std::size_t at = text.find(needle); at != std::string_view::npos; at = text.find(needle, from)) {
        made += size;
        if (made > most_text)
            return luaL_error(lua, "replace makes at most %d characters", static_cast<int>(most_text));
        luaL_addlstring(&out, text.data() + from, at - from);
        luaL_addlstring(&out, with, size);
        from = at + needle.size();
    }
    luaL_addlstring(&out, text.data() + from, text.size() - from);
    luaL_pushresult(&out);
    return 1;
}

/// Functions of Lua's that a post may use: a library's, ended by an empty name.
constexpr std::array base_names{"assert", "error", "ipairs", "select", "tonumber", "tostring", "type"};
constexpr std::array string_names{"format", "sub", "upper", "lower", "len", "byte", "char", "reverse"};
constexpr std::array math_names{"abs", "ceil", "floor", "fmod", "huge", "max",  "min", "modf", "pi",       "sqrt",
                                "sin", "cos",  "tan",   "asin", "acos", "atan", "exp", "log",  "tointeger"};
constexpr std::array table_names{"concat", "sort", "unpack"};

/// What counts its steps by being written in Lua; the order in which pairs goes is always the same.
constexpr std::string_view prelude = R"lua(local next, sort = ...
local function before(a, b)
    if type(a) == type(b) then return a < b end
    return type(a) < type(b)
end
function pairs(t)
    local keys, i = {}, 0
    for key in next, t do keys[#keys + 1] = key end
    sort(keys, before)
    return function()
        i = i + 1
        if keys[i] ~= nil then return keys[i], t[keys[i]] end
    end
end
function table.insert(t, at, value)
    local n = #t
    if value == nil then t[n + 1] = at return end
    for i = n, at, -1 do t[i + 1] = t[i] end
    t[at] = value
end
function table.remove(t, at)
    local n = #t
    at = at or n
    local value = t[at]
    for i = at, n do t[i] = t[i + 1] end
    return value
end
on = {}
)lua";

/// The table at the top gets functions of the library below it.
template <std::size_t n>
void take(lua_State* lua, const std::array<const char*, n>& names) {
    for (const char* name : names) lua_getfield(lua, -2, name), lua_setfield(lua, -2, name);
}

template <std::size_t n>
void add_library(lua_State* lua, const char* name, lua_CFunction open, const std::array<const char*, n>& names) {
    luaL_requiref(lua, name, open, 0);
    lua_createtable(lua, 0, static_cast<int>(n));
    take(lua, names);
    lua_remove(lua, -2);
    lua_setfield(lua, 1, name);
}

}  // namespace

Room& room_of(lua_State* lua) { return **static_cast<Room**>(lua_getextraspace(lua)); }

lua_State* new_sandbox(Room& room) {
    lua_State* lua = lua_newstate(allocate, &room);
    if (lua == nullptr) return nullptr;
    *static_cast<Room**>(lua_getextraspace(lua)) = &room;
    lua_sethook(lua, count, LUA_MASKCOUNT, static_cast<int>(counted_at_a_time));
    return lua;
}

/// Keeps the line of the post's text in which an error has come up, also where it comes from a function of ours.
int keep_line(lua_State* lua) {
    Room& room = room_of(lua);
    lua_Debug at{};
    for (int level = 0; room.line == 0 && lua_getstack(lua, level, &at) != 0; ++level) {
        lua_getinfo(lua, "Sl", &at);
        if (std::strcmp(at.source, "=hooks") == 0 && at.currentline > 0)
            room.line = static_cast<std::size_t>(at.currentline);
    }
    return 1;
}

/// Makes the world of a post's functions, whose table of globals is the first on the stack, and runs the text.
int open_world(lua_State* lua) {
    const auto& text = *static_cast<const std::string*>(lua_touserdata(lua, 1));
    lua_settop(lua, 0);
    lua_newtable(lua);
    luaL_requiref(lua, "_G", luaopen_base, 0);
    lua_pushvalue(lua, 1);
    take(lua, base_names);
    lua_settop(lua, 1);
    add_library(lua, "string", luaopen_string, string_names);
    add_library(lua, "math", luaopen_math, math_names);
    add_library(lua, "table", luaopen_table, table_names);
    lua_getfield(lua, 1, "string");
    constexpr luaL_Reg own_strings[] = {{"rep", repeat}, {"find", find}, {"replace", replace}, {nullptr, nullptr}};
    luaL_setfuncs(lua, own_strings, 0);
    lua_pushliteral(lua, "");
    lua_getmetatable(lua, -1);
    lua_pushvalue(lua, 2);
    lua_setfield(lua, -2, "__index");  // ("x"):rep(3)
    lua_settop(lua, 1);
    constexpr luaL_Reg own[] = {{"refuse", refuse}, {"number", number}, {nullptr, nullptr}};
    luaL_setfuncs(lua, own, 0);
    lua_pushglobaltable(lua);
    lua_getfield(lua, -1, "next");
    lua_remove(lua, -2);
    lua_getfield(lua, 1, "table");
    lua_getfield(lua, -1, "sort");
    lua_remove(lua, -2);
    lua_pushvalue(lua, 1);
    lua_rawseti(lua, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    if (luaL_loadbufferx(lua, prelude.data(), prelude.size(), "=obrys", "t") != LUA_OK) return lua_error(lua);
    lua_insert(lua, -3);
    lua_call(lua, 2, 0);
    if (luaL_loadbufferx(lua, text.data(), text.size(), "=hooks", "t") != LUA_OK) return lua_error(lua);
    lua_call(lua, 0, 0);
    lua_getglobal(lua, "on");
    if (!lua_istable(lua, -1)) return luaL_error(lua, "'on' is the table of functions, and must stay one");
    return 1;
}

}  // namespace obrys::write
