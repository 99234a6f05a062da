#include "tools/preview/groom.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "procedural/bind/report.h"
#include "tools/progress.h"

namespace lancret {

namespace {

BindReport report_of(const lancret_chunk_info& info) {
    BindReport out;
    for (const auto& [counter, field] : kBindCounterFields<lancret_chunk_info>) {
        out.*counter = info.*field;
    }
    return out;
}

}  // namespace

std::unique_ptr<PluginGroom> open_groom(const Job& job) {
    std::vector<PluginParameter> parameters;
    for (const GroomParameter& p : job.source.parameters) {
        parameters.push_back({p.name, p.text, p.number});
    }
    const auto line = std::make_shared<StageLine>();
    const auto warn = [line](const std::string& text) {
        line->clear();
        fmt::print(stderr, "lancret: warning: {}\n", text);
    };
    const auto show = [line](const std::string& stage) { line->show(stage); };
    auto out = std::make_unique<PluginGroom>(job.source.path, parameters,
                                             PluginLog{.stage = show, .warning = warn});
    line->clear();
    return out;
}

void print_binding_report(const PluginStrands& strands) {
    fmt::print(stderr, "{}",
               bind_table(report_of(strands.info()), strands.size(), "lancret: "));
}

nlohmann::json groom_stats(const PluginGroom& groom, const PluginStrands& strands) {
    const lancret_groom_info& info = groom.info();
    nlohmann::json out = nlohmann::json::parse(groom.description());
    out["strands"] = strands.size();
    out["intervals"] = info.intervals;
    out["seconds"] = {{"load", info.load_seconds},
                      {"fit", info.fit_seconds},
                      {"bind", info.bind_seconds}};
    out["bytes"]["binding"] = strands.info().bytes;
    out["bytes"]["binding_per_strand"] =
        double(strands.info().bytes) / double(std::max<std::size_t>(1, strands.size()));
    out["bind"] = bind_json(report_of(strands.info()));
    return out;
}

}  // namespace lancret
