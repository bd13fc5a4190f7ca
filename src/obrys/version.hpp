#pragma once
/// The version of the doors. Within a major version what compiles against them goes on to, and means the same; a minor
/// one adds. Before 1 a minor version may still change them: CHANGELOG.md says what.

namespace obrys::api {

inline constexpr int version_major = 0, version_minor = 2;

/// That of the library which is linked: "0.1.0".
[[nodiscard]] const char* version();

}  // namespace obrys::api
