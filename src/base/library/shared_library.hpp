#pragma once
/// A shared library of the system that is loaded when it is first wanted: what few runs need is not to slow down the
/// start of all (ADR 36). It stays loaded until the process ends.

namespace obrys::base::library {

class SharedLibrary {
public:
    /// `name`: as the system's loader knows it, "libcairo.so.2". Throws std::runtime_error where it cannot be loaded.
    explicit SharedLibrary(const char* name);

    /// Gives `function` the address of that symbol, whose type the caller knows from the library's own header. Throws
    /// std::runtime_error where the library has no such symbol.
    template <class Function>
    void find(Function*& function, const char* symbol) const {
        function = reinterpret_cast<Function*>(address(symbol));  // POSIX: what dlsym gives is a function, too
    }

private:
    [[nodiscard]] void* address(const char* symbol) const;

    const char* name_;
    void* handle_;
};

}  // namespace obrys::base::library
