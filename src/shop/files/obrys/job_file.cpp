#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "shop/files/obrys/job_file.hpp"
#include "shop/files/obrys/job_tables.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/files/obrys/machine_name.hpp"
#include "shop/files/obrys/profile.hpp"
#include "shop/files/obrys/solid_file.hpp"
#include "shop/files/obrys/tables.hpp"

namespace obrys::shop {

namespace {

std::optional<Section> section(Section& file, std::string_view key) {
    const Entry* e = file.sub_table(key);
    if (!e) return std::nullopt;
    return Section(e->value, "[" + std::string(key) + "]", file.diagnostics());
}

std::optional<ProfileFromProgram> read_program(Section& s) {
    const auto path = s.text("program");
    if (!path) return std::nullopt;
    return ProfileFromProgram{*path, find(s.table(), "program")->value.where};
}

void read_stock(Section& file, Job& job) {
    auto s = section(file, "stock");
    if (!s) return;
    s->one_of({"profile", "bar", "tube", "cone", "box", "cylinder", "file"}, true);
    job.stock = read_profile(*s);
    if (auto blank = read_blank(*s); blank && !job.stock) job.stock = std::move(blank);
    if (auto solid = read_solid(*s); solid && !job.stock) job.solid_stock = Stock{std::move(*solid), s->table().where};
    if (job.stock && s->has("offset"))
        s->error(base::codes::job_value, find(s->table(), "offset")->where, "'offset' means nothing for this stock");
    s->finish();
}

void read_part(Section& file, Job& job) {
    auto s = section(file, "part");
    if (!s) return;
    s->one_of({"profile", "program", "file"}, true);
    job.part = read_profile(*s);
    job.part_program = read_program(*s);
    if (auto part = read_part_file(*s); part && !job.part && !job.part_program) job.solid_part = std::move(part);
    s->finish();
    const bool turned = job.part || job.part_program;
    if ((turned && job.solid_stock) || (job.solid_part && job.stock))
        s->error(base::codes::job_value, head(s->table()),
                 turned ? "this part is turned, and the stock is one of milling"
                        : "this part is milled, and the stock is one of turning",
                 "a profile goes with profile, bar, tube or cone; a file with box, cylinder or file");
    if (turned && job.solid_stock) job.part.reset(), job.part_program.reset();
    if (job.solid_part && job.stock) job.solid_part.reset();
}

void read_geometry(Section& file, Job& job) {
    read_stock(file, job);
    read_part(file, job);
    job.clamps = read_clamps(file);
    if (auto s = section(file, "allowance")) {
        s->one_of({"profile", "program", "normal"}, true);
        Allowance a;
        a.profile = read_profile(*s);
        a.program = read_program(*s);
        const auto normal = s->number("normal", Range::not_negative);
        a.normal = normal.value_or(0);
        s->finish();
        if (job.solid_stock || job.solid_part)
            s->error(base::codes::job_value, head(s->table()),
                     "an allowance is judged on turned parts alone, and this job is one of milling",
                     "give as [part] the shape that this program must leave");
        else if (a.profile || a.program || normal)
            job.allowance = std::move(a);
    }
}

void read_overrides(Section& file, Job& job) {
    const Entry* table = file.sub_table("set");
    if (!table) return;
    for (const Entry& e : table->value.entries) {
        const auto value = finite_number(e.value, "'" + e.key + "'", Range::value, file.diagnostics());
        if (!value) continue;
        const std::string name = base::to_upper(e.key);
        const auto same = [&](const Override& o) { return o.name == name; };
        if (std::any_of(job.overrides.begin(), job.overrides.end(), same))
            file.error(base::codes::job_value, e.where,
                       "'" + e.key + "' is set twice (capitals and small letters are the same)");
        else
            job.overrides.push_back({name, *value, e.where});
    }
}

void read_limits(Section& file, Job& job) {
    if (auto s = section(file, "check")) {
        Tolerances& t = job.tolerances;
        t.gouge = s->number("gouge", Range::not_negative).value_or(t.gouge);
        t.rest_material = s->number("rest_material", Range::not_negative).value_or(t.rest_material);
        t.rapid = s->number("rapid", Range::not_negative).value_or(t.rapid);
        t.simulation = s->number("tolerance", Range::positive);
        if (t.simulation && *t.simulation > largest_tolerance) {
            s->error(base::codes::job_value, find(s->table(), "tolerance")->value.where,
                     "'tolerance' is too coarse: at most " + base::shortest(largest_tolerance) + " mm");
            t.simulation.reset();
        }
        if (const auto text = s->text("scope")) {
            if (const auto scope = scope_named(*text))
                job.scope = *scope;
            else
                s->error(base::codes::job_value, find(s->table(), "scope")->value.where,
                         "there is no scope \"" + *text + "\"",
                         words_remedy(*text, {"all", "part", "collisions", "motion"}));
        }
        s->finish();
    }
    if (auto s = section(file, "budget")) {
        Budgets& b = job.budgets;
        constexpr std::int64_t most = 1'000'000'000'000'000;
        if (const auto v = s->integer("blocks", 1, most)) b.blocks = static_cast<std::uint64_t>(*v);
        if (const auto v = s->integer("loop_passes", 1, most))
            b.loop_passes = static_cast<std::uint64_t>(*v), b.bounds_loops = true;
        if (const auto v = s->integer("simulated_moves", 1, most)) b.simulated_moves = static_cast<std::uint64_t>(*v);
        if (const auto v = s->integer("call_depth", 1, 1000)) b.call_depth = static_cast<std::uint32_t>(*v);
        if (const auto v = s->number("seconds", Range::positive)) b.seconds = *v, b.bounds_check = true;
        s->finish();
    }
}

void read_skip(Section& file, Job& job) {
    const Entry* e = file.take("skip");
    if (!e) return;
    if (e->value.kind != ValueKind::array) {
        file.error(base::codes::job_value, e->value.where,
                   "'skip' must be an array of levels 0 … 9, not " + std::string(kind_name(e->value.kind)));
        return;
    }
    for (const Value& v : e->value.items) {
        if (v.kind != ValueKind::integer || v.integer < 0 || v.integer > 9)
            file.error(base::codes::job_value, v.where, "a skip level is a whole number from 0 to 9");
        else if (std::find(job.skip_levels.begin(), job.skip_levels.end(), v.integer) == job.skip_levels.end())
            job.skip_levels.push_back(static_cast<int>(v.integer));
    }
}

void read_machine_name(Section& file, Job& job) {
    const auto name = file.text("machine");
    const bool turns =
        job.stock || job.part || job.part_program || std::any_of(job.tools.begin(), job.tools.end(), [](const Tool& t) {
            return t.kind == ToolKind::groove || t.kind == ToolKind::turning;
        });
    const std::string generic = turns ? "lathe-generic" : "mill-generic";
    if (name) {
        job.machine_name = *name;
        job.machine_where = find(file.table(), "machine")->value.where;
        job.machine_is_file = names_machine_file(*name);
    }
    auto machine = shipped_machine(name && !job.machine_is_file ? *name : generic);
    if (!machine) {
        file.error(base::codes::job_value, job.machine_where, no_shipped_machine(*name), machine_name_remedy(*name));
        machine = shipped_machine(generic);
    }
    use_machine(job, machine.value_or(Machine{}));
}

std::vector<NamedFile> files_of(Section& s, std::string_view key) {
    std::vector<NamedFile> files;
    for (const Value* v : s.text_values(key)) files.push_back({v->text, v->where});
    return files;
}

void read_all(Section& s, Job& job) {
    if (const auto program = s.text("program")) {
        job.program = *program;
        job.program_where = find(s.table(), "program")->value.where;
    }
    if (const auto start = s.text("start")) {
        job.start = *start;
        job.start_where = find(s.table(), "start")->value.where;
    }
    if (const auto control = s.text("control")) {
        job.control = *control;
        job.control_where = find(s.table(), "control")->value.where;
    }
    for (const char* key : {"tool_file", "tool_files"})
        for (NamedFile& f : files_of(s, key)) job.tool_files.push_back(std::move(f));
    job.search = files_of(s, "search");
    job.datum_tables = files_of(s, "datum_tables");
    job.preset_tables = files_of(s, "preset_tables");
    for (const char* key : {"variables_file", "variables_files"})
        for (NamedFile& f : files_of(s, key)) job.variables_files.push_back(std::move(f));
    if (const auto prints = s.text("prints")) {
        job.prints = *prints;
        job.prints_where = find(s.table(), "prints")->value.where;
    }
    if (const auto lengths = s.choice("tool_length", {"touched-off", "at-change", "gauge"}))
        job.tool_lengths = static_cast<ToolLengths>(*lengths + 1);
    read_skip(s, job);
    if (const auto first = s.integer("first_tool", 1, 99'999'999)) job.first_tool = static_cast<std::uint32_t>(*first);
    read_tool_tables(s, job.tools);
    job.defaults = read_defaults(s);
    job.datums = read_datums(s);
    read_geometry(s, job);
    read_overrides(s, job);
    job.variables = read_variables(s);
    read_limits(s, job);
    read_machine_name(s, job);
    // What it says of its cuts is read where forces are wanted (shop/files/cutting).
    for (const char* key : {"material", "materials", "spindle_torque"}) s.take(key);
    static_cast<void>(s.tables("cutting"));
}

}  // namespace

Job read_job(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    Job job;
    job.program_where = {file, 0, 0};
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return job;
    base::Diagnostics found;
    Section s(*root, "the job file", found);
    read_all(s, job);
    s.finish_file(diagnostics);
    return job;
}

}  // namespace obrys::shop
