/// The shipped materials are whole, and what is wrong in a table is said at its place.

#include <gtest/gtest.h>

#include <algorithm>

#include "shop/files/cutting/blade_file.hpp"
#include "shop/files/cutting/cost_file.hpp"
#include "shop/files/cutting/job_cutting.hpp"
#include "shop/files/cutting/material_file.hpp"

namespace obrys::shop {
namespace {

struct Read {
    base::Sources sources;
    base::Diagnostics diagnostics;
    std::uint32_t add(const std::string& text) { return sources.add("file.toml", text); }
    [[nodiscard]] std::vector<std::string> said() const {
        std::vector<std::string> all;
        for (const base::Diagnostic& d : diagnostics.all()) {
            const auto at = sources.position(d.where);
            all.push_back(std::to_string(at.line) + ": " + d.text);
        }
        return all;
    }
};

TEST(Materials, shipped_ones_are_whole) {
    const auto& all = shipped_materials();
    ASSERT_GE(all.size(), 35U);
    for (const WorkMaterial& m : all) {
        EXPECT_TRUE(m.kienzle && !m.kienzle->source.empty()) << m.name;
        EXPECT_TRUE(m.vdi > 0 && m.density && m.elasticity) << m.name;
    }
    ASSERT_NE(find_material(all, "alsi12cu"), nullptr);
    EXPECT_EQ(find_material(all, "alsi12cu")->vdi, 24);
    EXPECT_EQ(find_material(all, "1.0503")->kienzle->kc11, 1500);
    EXPECT_EQ(find_material(all, "unobtainium"), nullptr);
    EXPECT_NE(material_remedy(all, "C54").find("C45"), std::string::npos);
}

TEST(Materials, no_name_stands_for_two) {
    std::vector<std::string> names;
    for (const WorkMaterial& m : shipped_materials()) {
        names.push_back(m.name);
        names.insert(names.end(), m.names.begin(), m.names.end());
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(Costs, variants_take_what_they_do_not_say) {
    Read r;
    const auto all = read_costs(r.add("[cost]\nwage = 100\nmachine = 850\npieces = 1000\n"
                                      "[[variant]]\nname = \"a\"\ntime = 166\n"
                                      "[[variant]]\nname = \"b\"\ntime = 1380\npieces = 150\n"),
                                r.sources, r.diagnostics);
    EXPECT_TRUE(r.said().empty());
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(*all[0].table.pieces, 1000);
    EXPECT_EQ(*all[1].table.pieces, 150);
    EXPECT_EQ(all[1].table.machine, 850);
}

TEST(Costs, percent_for_a_part_is_said) {
    Read r;
    static_cast<void>(
        read_costs(r.add("[cost]\nutilisation = 95\nwage = 100\nmachine = 850\n"), r.sources, r.diagnostics));
    ASSERT_EQ(r.said().size(), 1U);
    EXPECT_EQ(r.said()[0].substr(0, 3), "2: ");
}

TEST(Blades, stations_go_outwards) {
    Read r;
    static_cast<void>(read_blade(r.add("[blade]\nlength = 80\nE = 70000\ndensity = 2700\n"
                                       "[[station]]\nat = 40\nwidth = 30\nblank = 6\nfinished = 3\n"
                                       "[[station]]\nat = 10\nwidth = 30\nblank = 6\nfinished = 3\n"),
                                 r.sources, r.diagnostics));
    ASSERT_EQ(r.said().size(), 1U);
    EXPECT_EQ(r.said()[0].substr(0, 4), "11: ");
}

TEST(CuttingOfJobs, the_rest_of_the_job_is_no_mistake) {
    Read r;
    const CuttingJob job =
        read_cutting_job(r.add("program = \"x.H\"\nmaterial = \"C45\"\nspindle_torque = 35\n[[tool]]\nnumber = 1\n"
                               "[[cutting]]\ntool = 1\nhelix = 30\nfeed_per_tooth = [0.02, 0.05]\n"),
                         r.sources, r.diagnostics);
    EXPECT_TRUE(r.said().empty());
    EXPECT_EQ(job.material, "C45");
    ASSERT_NE(find_use(job, 1), nullptr);
    EXPECT_EQ(*find_use(job, 1)->helix, 30);
    EXPECT_EQ((*find_use(job, 1)->feed_per_tooth)[1], 0.05);
    EXPECT_EQ(find_use(job, 2), nullptr);
}

}  // namespace
}  // namespace obrys::shop
