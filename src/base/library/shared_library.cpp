#include "base/library/shared_library.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace obrys::base::library {

namespace {

[[noreturn]] void fail(const char* name) {
    const char* const why = dlerror();
    throw std::runtime_error(std::string(name) +
                             " cannot be used: " + (why != nullptr ? why : "the loader does not say why"));
}

}  // namespace

SharedLibrary::SharedLibrary(const char* name) : name_(name), handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) fail(name);
}

void* SharedLibrary::address(const char* symbol) const {
    void* const found = dlsym(handle_, symbol);
    if (found == nullptr) fail(name_);
    return found;
}

}  // namespace obrys::base::library
