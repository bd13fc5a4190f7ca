#pragma once
/// The world in which functions of posts run. Private to write, and there only where this program is built with Lua.

#include <cstddef>

#include "write/hooks.hpp"

struct lua_State;

namespace obrys::write {

/// What one state may use, and what its last call has come to.
struct Room {
    std::size_t held = 0, turned = 0;
    long steps = 0;
    std::size_t line = 0;     ///< where the error is; 0: not known
    std::size_t defined = 0;  ///< where the function begins
    bool refuses = false;
    const NamedStyles* styles = nullptr;
};

/// A state that takes its memory from `room` and counts its steps there; null where there is no memory. Lua reports
/// errors by longjmp: what may report one runs below lua_pcall, and no object with a destructor lives in a frame that
/// it may leave.
[[nodiscard]] lua_State* new_sandbox(Room& room);
[[nodiscard]] Room& room_of(lua_State* lua);

/// For lua_pcall: keeps the line of the post's text in which an error has come up.
int keep_line(lua_State* lua);
/// For lua_pcall: makes the world and runs the std::string that its argument points to; returns the table of functions.
int open_world(lua_State* lua);

}  // namespace obrys::write
