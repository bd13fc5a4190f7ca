/// In the place of hooks_lua.cpp where this program is built without Lua.

#include "write/hooks.hpp"

namespace obrys::write {

bool has_hooks() { return false; }

std::unique_ptr<Hooks> load_hooks(const std::string&, const NamedStyles&, HookFault& fault) {
    fault.text = "this program was built without Lua";
    return nullptr;
}

}  // namespace obrys::write
