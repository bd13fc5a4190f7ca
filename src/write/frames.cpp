#include "write/frames.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::write {

namespace {

constexpr double frame_noise = 1e-9;  ///< of factors and directions

struct Commands {
    Command set, reset;
};
std::optional<Commands> commands_of(cl::FrameKind kind) {
    switch (kind) {
        case cl::FrameKind::shift: return Commands{Command::shift, Command::shift_off};
        case cl::FrameKind::rotation: return Commands{Command::rotation, Command::rotation_off};
        case cl::FrameKind::mirror: return Commands{Command::mirror, Command::mirror_off};
        case cl::FrameKind::scaling: return Commands{Command::scaling, Command::scaling_off};
        case cl::FrameKind::plane: return Commands{Command::plane, Command::plane_off};
        case cl::FrameKind::programmed: return Commands{Command::programmed, Command::programmed_off};
        case cl::FrameKind::datum: return std::nullopt;
    }
    return std::nullopt;
}

/// Rotation, factors along the axes and mirrors of which the linear part is made: turn * scale.
struct Pieces {
    std::array<double, 9> turn{1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::array<double, 3> factor{1, 1, 1};
};

std::optional<Pieces> pieces_of(const std::array<double, 9>& l) {
    Pieces p;
    for (std::size_t c = 0; c < 3; ++c) {
        const double length = std::sqrt(l[c] * l[c] + l[3 + c] * l[3 + c] + l[6 + c] * l[6 + c]);
        if (!(length > 1e-12) || !std::isfinite(length)) return std::nullopt;
        p.factor[c] = length;
        for (std::size_t r = 0; r < 3; ++r) p.turn[3 * r + c] = l[3 * r + c] / length;
    }
    const auto column = [&](std::size_t c) { return geom::Vec3{p.turn[c], p.turn[3 + c], p.turn[6 + c]}; };
    if (std::abs(geom::dot(column(0), column(1))) > frame_noise ||
        std::abs(geom::dot(column(0), column(2))) > frame_noise ||
        std::abs(geom::dot(column(1), column(2))) > frame_noise)
        return std::nullopt;
    if (geom::dot(geom::cross(column(0), column(1)), column(2)) > 0) return p;
    // A mirror: of the axis whose sign makes the turn the smaller, which is how a plain mirror comes out.
    std::size_t mirrored = 0;
    for (std::size_t c = 1; c < 3; ++c)
        if (p.turn[4 * c] < p.turn[4 * mirrored]) mirrored = c;
    p.factor[mirrored] = -p.factor[mirrored];
    for (std::size_t r = 0; r < 3; ++r) p.turn[3 * r + mirrored] = -p.turn[3 * r + mirrored];
    return p;
}

/// Mirrors of two axes turn by half a turn: what is called a mirror is one in each axis whose sign changes.
std::optional<Pieces> mirrors_of(const std::array<double, 9>& l) {
    Pieces p;
    for (std::size_t i = 0; i < 9; ++i) {
        const bool diagonal = i % 4 == 0;
        if (std::abs(std::abs(l[i]) - (diagonal ? 1 : 0)) > frame_noise) return std::nullopt;
        if (diagonal) p.factor[i / 4] = l[i] < 0 ? -1 : 1;
    }
    return p;
}

bool is_identity(const std::array<double, 9>& m) {
    for (std::size_t i = 0; i < 9; ++i)
        if (std::abs(m[i] - (i % 4 == 0 ? 1 : 0)) > frame_noise) return false;
    return true;
}

/// Turns about the fixed axes x, then y, then z: m = Z * Y * X.
void set_turns(const std::array<double, 9>& m, Values& values) {
    const double across = std::hypot(m[7], m[8]);
    const double y = std::atan2(-m[6], across);
    double x = 0, z = 0;
    if (across > frame_noise) {
        x = std::atan2(m[7], m[8]);
        z = std::atan2(m[3], m[0]);
    } else {
        z = std::atan2(-m[1], m[4]);
    }
    values.set(Value::angle_x, geom::degrees(x));
    values.set(Value::angle_y, geom::degrees(y));
    values.set(Value::angle_z, geom::degrees(z));
    if (std::abs(x) < frame_noise && std::abs(y) < frame_noise) values.set(Value::angle, geom::degrees(z));
    if (std::abs(x) < frame_noise && std::abs(z) < frame_noise) values.set(Value::angle, geom::degrees(y));
    if (std::abs(y) < frame_noise && std::abs(z) < frame_noise) values.set(Value::angle, geom::degrees(x));
}

/// Turns about z, then x, then z, each as the ones before have left it: m = Z1 * X2 * Z3, X2 from 0 to half a turn.
void set_euler(const std::array<double, 9>& m, Values& values) {
    const double across = std::hypot(m[2], m[5]);
    double z1 = 0, z3 = 0;
    if (across > frame_noise) {
        z1 = std::atan2(m[2], -m[5]);
        z3 = std::atan2(m[6], m[7]);
    } else {
        z3 = std::atan2(m[8] > 0 ? m[3] : -m[3], m[0]);
    }
    values.set(Value::euler_1, geom::degrees(z1));
    values.set(Value::euler_2, geom::degrees(std::atan2(across, m[8])));
    values.set(Value::euler_3, geom::degrees(z3));
}

/// The place that stays where it is, of a turn or of factors about it; 0 along axes in which all places stay. Nothing
/// where the frame shifts such an axis.
std::optional<geom::Vec3> centre_of(const geom::Frame& f) {
    geom::Frame difference;  // p -> p - linear * p, with 1 in axes that stay, so that it has an inverse
    std::array<bool, 3> stays{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) difference.linear[3 * r + c] = (r == c ? 1 : 0) - f.linear[3 * r + c];
        stays[r] = std::all_of(difference.linear.begin() + static_cast<std::ptrdiff_t>(3 * r),
                               difference.linear.begin() + static_cast<std::ptrdiff_t>(3 * r + 3),
                               [](double v) { return std::abs(v) < frame_noise; });
        if (stays[r]) difference.linear[4 * r] = 1;
    }
    const std::array<double, 3> origin{f.origin.x, f.origin.y, f.origin.z};
    for (std::size_t r = 0; r < 3; ++r)
        if (stays[r] && std::abs(origin[r]) > frame_noise) return std::nullopt;
    if (!geom::is_invertible(difference)) return std::nullopt;
    return geom::apply_direction(geom::inverse(difference), f.origin);
}

}  // namespace

bool frame_values(const cl::FramePart& part, Values& values) {
    const geom::Frame& f = part.frame;
    values.clear();
    if (!geom::is_finite(f.origin)) return false;
    auto pieces = part.kind == cl::FrameKind::mirror ? mirrors_of(f.linear) : std::nullopt;
    if (!pieces) pieces = pieces_of(f.linear);
    if (!pieces) return false;
    values.set(Value::shift_x, f.origin.x);
    values.set(Value::shift_y, f.origin.y);
    values.set(Value::shift_z, f.origin.z);
    if (part.turn.side != 0) values.set(Value::side, part.turn.side);
    values.set(Value::turn_side, part.turn.side != 0 ? part.turn.side : 1);
    if (part.turn.table_turns) values.set(Value::table_turns, 1);
    const bool is_plane = part.kind == cl::FrameKind::plane;
    if (is_plane || !is_identity(pieces->turn)) set_turns(pieces->turn, values);
    if (is_plane) set_euler(pieces->turn, values);
    constexpr std::array factors{Value::factor_x, Value::factor_y, Value::factor_z};
    constexpr std::array mirrors{Value::mirror_x, Value::mirror_y, Value::mirror_z};
    for (std::size_t c = 0; c < 3; ++c) {
        if (pieces->factor[c] < 0) values.set(mirrors[c], 0);
        if (std::abs(std::abs(pieces->factor[c]) - 1) > frame_noise)
            values.set(factors[c], std::abs(pieces->factor[c]));
    }
    if (const auto centre = centre_of(f)) {
        values.set(Value::centre_x, centre->x);
        values.set(Value::centre_y, centre->y);
        values.set(Value::centre_z, centre->z);
    }
    return true;
}

void Frames::take(std::vector<cl::FramePart> parts) {
    parts_ = std::move(parts);
    geom::Frame all;
    for (const cl::FramePart& p : parts_) all = all * p.frame;
    into_ = geom::inverse(all);
    mirrors_ = geom::determinant(all) < 0;
}

namespace {

/// Whether the part is there without words of its own: what the selected zero has besides its place comes with its
/// selection. Where it shifts, it may be another tool whose length is compensated still, which needs the same words of
/// lengths.
bool comes_with_zero(const cl::FramePart& part, const Post& post) {
    if (part.kind != cl::FrameKind::datum) return false;
    return post.has(Command::length_on) || !is_identity(part.frame.linear);
}

}  // namespace

std::vector<FrameStep> Frames::clear(const cl::Frame& wanted, const Post& post) {
    std::vector<FrameStep> steps;
    for (std::size_t i = parts_.size(); i-- > 0;)
        if (const auto c = commands_of(parts_[i].kind)) steps.push_back({c->reset, {}});
    std::vector<cl::FramePart> stays;
    if (!wanted.parts.empty() && comes_with_zero(wanted.parts.front(), post)) stays.push_back(wanted.parts.front());
    wanted_ = stays;
    take(std::move(stays));
    return steps;
}

namespace {

/// Whether the words of the post say where a turn, a mirror or factors have their centre.
bool says_centre(const Template& text) {
    for (const Value v : {Value::centre_x, Value::centre_y, Value::centre_z, Value::shift_x, Value::shift_y})
        if (says(text, index_of(v))) return true;
    return false;
}

/// The parts as the post has words for them: what turns about another place than the zero, where its words say no
/// centre, turns about a zero that has been shifted there.
std::vector<cl::FramePart> sayable(const std::vector<cl::FramePart>& parts, const Post& post) {
    std::vector<cl::FramePart> out;
    for (cl::FramePart p : parts) {
        const auto commands = commands_of(p.kind);
        const bool about_zero = p.frame.origin == geom::Vec3{};
        const bool is_place = p.kind == cl::FrameKind::shift || p.kind == cl::FrameKind::datum;
        if (is_place || !commands || about_zero || says_centre(post[commands->set])) {
            out.push_back(std::move(p));
            continue;
        }
        const bool shifted = !out.empty() && out.back().kind == cl::FrameKind::shift;
        if (!shifted) out.push_back({cl::FrameKind::shift, {}});
        out.back().frame.origin = out.back().frame.origin + p.frame.origin;
        p.frame.origin = {};
        out.push_back(std::move(p));
    }
    return out;
}

/// One plane in the place of it and of all that stands around it; nothing where they come to more than a place and a
/// turn.
std::optional<std::vector<cl::FramePart>> as_one_plane(const std::vector<cl::FramePart>& parts, const Post& post) {
    const auto plane =
        std::find_if(parts.begin(), parts.end(), [](const auto& p) { return p.kind == cl::FrameKind::plane; });
    if (plane == parts.end()) return parts;
    const std::size_t first = comes_with_zero(parts.front(), post) ? 1 : 0;
    cl::FramePart whole{cl::FrameKind::plane, {}, plane->turn};
    for (std::size_t i = first; i < parts.size(); ++i) whole.frame = whole.frame * parts[i].frame;
    const auto pieces = pieces_of(whole.frame.linear);
    const bool rigid = pieces && std::all_of(pieces->factor.begin(), pieces->factor.end(),
                                             [](double f) { return std::abs(f - 1) <= frame_noise; });
    if (!rigid) return std::nullopt;
    std::vector<cl::FramePart> out(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(first));
    out.push_back(whole);
    return out;
}

/// What a control keeps as one: shifts alone, which are one in any order. Nothing where there is more.
std::optional<std::vector<cl::FramePart>> as_one_programmed(const std::vector<cl::FramePart>& parts, const Post& post) {
    const std::size_t first = !parts.empty() && comes_with_zero(parts.front(), post) ? 1 : 0;
    cl::FramePart whole{cl::FrameKind::programmed, {}};
    for (std::size_t i = first; i < parts.size(); ++i) {
        if (parts[i].kind != cl::FrameKind::shift) return std::nullopt;
        whole.frame = whole.frame * parts[i].frame;
    }
    std::vector<cl::FramePart> out(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(first));
    out.push_back(whole);
    return out;
}

bool has_plane(const std::vector<cl::FramePart>& parts) {
    return std::any_of(parts.begin(), parts.end(), [](const auto& p) { return p.kind == cl::FrameKind::plane; });
}

/// A control has one word for each kind.
bool has_twice(const std::vector<cl::FramePart>& parts, cl::FrameKind kind) {
    return std::count_if(parts.begin(), parts.end(), [&](const cl::FramePart& p) { return p.kind == kind; }) > 1;
}

}  // namespace

std::optional<std::vector<FrameStep>> Frames::lead_to(const cl::Frame& frame, const Post& post) {
    auto steps = post.plane_anew ? std::nullopt : lead_to_parts(frame, frame.parts, post);
    if (steps) return steps;
    const bool as_plane = (post.plane_is_whole || post.plane_anew) && (post.plane_anew || has_plane(frame.parts));
    const bool as_programmed = !as_plane && !frame.parts.empty() && post.has(Command::programmed);
    if (!as_plane && !as_programmed) return std::nullopt;
    const auto joined = as_plane ? as_one_plane(frame.parts, post) : as_one_programmed(frame.parts, post);
    return joined ? lead_to_parts(frame, *joined, post) : std::nullopt;
}

std::optional<std::vector<FrameStep>> Frames::lead_to_parts(const cl::Frame& frame,
                                                            const std::vector<cl::FramePart>& parts, const Post& post) {
    Values values;
    geom::Frame all;
    cl::Frame wanted{sayable(parts, post)};
    if (wanted.parts.size() != parts.size() && has_twice(wanted.parts, cl::FrameKind::shift)) return std::nullopt;
    for (const cl::FramePart& p : wanted.parts) {
        all = all * p.frame;
        const auto commands = commands_of(p.kind);
        if (comes_with_zero(p, post)) continue;
        if (!commands || !post.has(commands->set) || !post.has(commands->reset) || !frame_values(p, values))
            return std::nullopt;
    }
    if (!geom::is_invertible(all)) return std::nullopt;
    std::size_t common = 0;
    while (common < parts_.size() && common < wanted.parts.size() && parts_[common] == wanted.parts[common]) ++common;
    // Setting a part anew takes the place of the last one of its kind; where the kinds are others, or stand in another
    // order, all go first.
    const bool ends_first = post.plane_anew && has_plane(parts_) && common < wanted.parts.size();
    const bool in_place =
        !ends_first && std::equal(parts_.begin(), parts_.end(), wanted.parts.begin(), wanted.parts.end(),
                                  [](const cl::FramePart& a, const cl::FramePart& b) { return a.kind == b.kind; });
    std::vector<FrameStep> steps;
    for (std::size_t i = parts_.size(); i-- > common && !in_place;)
        if (const auto c = commands_of(parts_[i].kind)) steps.push_back({c->reset, {}});
    for (std::size_t i = common; i < wanted.parts.size(); ++i)
        if (const auto c = commands_of(wanted.parts[i].kind)) steps.push_back({c->set, wanted.parts[i]});
    take(std::move(wanted.parts));
    wanted_ = frame.parts;
    return steps;
}

namespace {

/// A row of a frame times a vector; what counts nothing may be unknown.
double row(const geom::Frame& f, std::size_t r, const geom::Vec3& v) {
    double sum = 0;
    const std::array<double, 3> c{v.x, v.y, v.z};
    for (std::size_t k = 0; k < 3; ++k)
        if (f.linear[3 * r + k] != 0) sum += f.linear[3 * r + k] * c[k];
    return sum;
}

}  // namespace

geom::Vec3 Frames::programmed(const geom::Vec3& p) const {
    return geom::Vec3{row(into_, 0, p), row(into_, 1, p), row(into_, 2, p)} + into_.origin;
}

geom::Vec3 Frames::programmed_direction(const geom::Vec3& d) const {
    const geom::Vec3 v{row(into_, 0, d), row(into_, 1, d), row(into_, 2, d)};
    const double length = geom::length(v);
    return length > 0 ? (1 / length) * v : v;
}

}  // namespace obrys::write
