#include "render_test/plugin/strands.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "guides/base/errors.h"
#include "procedural/bind/report.h"

namespace lancret {

namespace {

void number_segments(Curves& curves) {
    curves.segments = Buffer<std::uint32_t>(curves.segment_count());
    tbb::parallel_for(std::size_t(0), curves.classes.size(), [&](std::size_t c) {
        const CurveClass& alike = curves.classes[c];
        std::uint32_t* to = curves.segments.data() + alike.segment;
        for (std::uint32_t i = 0; i < alike.strands; ++i) {
            for (std::uint32_t j = 0; j < alike.segments; ++j) {
                *to++ = alike.point + i * alike.points + j;
            }
        }
    });
}

/// Per time, the address of `point` in the buffer; empty if the buffers are.
std::vector<const float*> arrays_at(std::vector<Curves>& curves,
                                    Buffer<Point4f> Curves::*buffer, std::size_t point) {
    std::vector<const float*> out;
    for (Curves& c : curves) {
        if ((c.*buffer).size() > 0) out.push_back(&(c.*buffer)[point].x);
    }
    return out;
}

void add(lancret_chunk_info& to, const lancret_chunk_info& more) {
    to.strands += more.strands;
    to.bytes += more.bytes;
    for (const auto& [counter, field] : kBindCounterFields<lancret_chunk_info>) {
        to.*field += more.*field;
    }
}

}  // namespace

PluginStrands::PluginStrands(const PluginGroom& groom, StrandRequest request)
    : groom_(groom), request_(std::move(request)), chunks_(groom.info().chunks) {
    const Plugin& plugin = groom.plugin();
    try {
        tbb::parallel_for(std::size_t(0), chunks_.size(), [&](std::size_t c) {
            Chunk& chunk = chunks_[c];
            const lancret_options options = options_of(c);
            groom_.throw_if_failed(plugin->chunk_open(groom_.handle(), lancret_u32(c),
                                                      &options, &chunk.handle));
            chunk.sizes.size = sizeof chunk.sizes;
            groom_.throw_if_failed(plugin->chunk_get_sizes(chunk.handle, &chunk.sizes));
        });
        for (Chunk& chunk : chunks_) {
            chunk.strand = strands_;
            chunk.point = points_;
            strands_ += chunk.sizes.strands;
            points_ += chunk.sizes.points;
            lancret_chunk_info info{};
            info.size = sizeof info;
            groom_.throw_if_failed(plugin->chunk_get_info(chunk.handle, &info));
            add(info_, info);
        }
        if (points_ > std::numeric_limits<std::uint32_t>::max()) {
            throw InputError(fmt::format(
                "{} strands have {} points, more than 2^32: reduce the number of strands "
                "or intervals",
                strands_, points_));
        }
    } catch (...) {
        close();
        throw;
    }
}

PluginStrands::~PluginStrands() { close(); }

void PluginStrands::close() {
    for (Chunk& chunk : chunks_) groom_.plugin()->chunk_close(chunk.handle);
    chunks_.clear();
}

lancret_options PluginStrands::options_of(std::size_t chunk) const {
    lancret_options out{};
    out.size = sizeof out;
    out.times = request_.times.data();
    out.time_count = request_.times.size();
    out.basis = groom_.info().basis;
    if (request_.faces || groom_.shape() == CurveShape::ribbon) {
        out.attributes = LANCRET_NORMALS;
    }
    if (request_.strands_per_pixel > 0) {
        out.pixels = request_.pixels[chunk];
        out.strands_per_pixel = request_.strands_per_pixel;
    }
    return out;
}

void PluginStrands::each_chunk(const std::function<void(const Chunk&)>& work) const {
    tbb::parallel_for(std::size_t(0), chunks_.size(),
                      [&](std::size_t c) { work(chunks_[c]); });
}

std::vector<Curves> PluginStrands::curves() const {
    std::vector<Curves> out(request_.times.size());
    for (Curves& c : out) {
        c.basis = groom_.basis();
        c.shape = groom_.shape().value_or(CurveShape::flat);
        c.points = Buffer<Point4f>(points_);
        if (c.basis == CurveBasis::hermite) c.tangents = Buffer<Point4f>(points_);
        if (request_.faces || c.shape == CurveShape::ribbon) {
            c.normals = Buffer<Point4f>(points_);
        }
    }
    std::vector<std::uint32_t> counts(strands_), ids(strands_);
    each_chunk([&](const Chunk& chunk) {
        if (chunk.sizes.strands == 0) return;
        const auto positions = arrays_at(out, &Curves::points, chunk.point),
                   tangents = arrays_at(out, &Curves::tangents, chunk.point),
                   normals = arrays_at(out, &Curves::normals, chunk.point);
        const auto or_null = [](const auto& arrays) {
            return arrays.empty() ? nullptr : arrays.data();
        };
        lancret_curves to = chunk.sizes;
        to.counts = counts.data() + chunk.strand;
        to.ids = ids.data() + chunk.strand;
        to.positions = positions.data();
        to.tangents = or_null(tangents);
        to.normals = or_null(normals);
        groom_.throw_if_failed(groom_.plugin()->chunk_write(chunk.handle, &to));
    });
    for (Curves& c : out) {
        for (std::size_t i = 0, first = 0; i < strands_; ++i) {
            if (i + 1 < strands_ && counts[i + 1] == counts[i]) continue;
            c.add_class(std::uint32_t(i + 1 - first),
                        layout_of(c.basis).segments(counts[i]));
            first = i + 1;
        }
        c.ids = ids;
        number_segments(c);
    }
    return out;
}

StrandValues PluginStrands::figures(int figure, std::size_t time,
                                    const Curves& curves) const {
    StrandValues out;
    out.at_places = figure == LANCRET_ORTHOGONALITY;
    if (figure != LANCRET_LENGTH_ERROR && figure != LANCRET_REGION) {
        out.first.push_back(0);
        for (const CurveClass& alike : curves.classes) {
            for (std::uint32_t i = 0; i < alike.strands; ++i) {
                out.first.push_back(out.first.back() + alike.segments + out.at_places);
            }
        }
    }
    out.values.resize(out.first.empty() ? strands_ : out.first.back());
    each_chunk([&](const Chunk& chunk) {
        if (chunk.sizes.strands == 0) return;
        const std::size_t first =
            out.first.empty() ? chunk.strand : out.first[chunk.strand];
        groom_.throw_if_failed(groom_.plugin()->chunk_get_figures(
            chunk.handle, figure, time, out.values.data() + first));
    });
    return out;
}

StrandGuides PluginStrands::guides() const {
    StrandGuides out;
    out.neighbours = groom_.info().neighbours;
    out.guides.resize(strands_ * out.neighbours);
    out.weights.resize(out.guides.size());
    each_chunk([&](const Chunk& chunk) {
        if (chunk.sizes.strands == 0) return;
        lancret_curves to = chunk.sizes;
        to.guides = out.guides.data() + chunk.strand * out.neighbours;
        to.weights = out.weights.data() + chunk.strand * out.neighbours;
        groom_.throw_if_failed(groom_.plugin()->chunk_write(chunk.handle, &to));
    });
    return out;
}

}  // namespace lancret
