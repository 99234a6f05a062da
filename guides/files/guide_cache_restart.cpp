#include "guides/files/guide_cache_restart.h"

#include "guides/files/guide_cache_reader.h"

namespace lancret {

using namespace hdf5;

namespace {

/// A name takes a few bytes of a file, but a dataset in memory.
constexpr hsize_t kMaxArrays = 1000;

std::string name_of_link(const Reader& reader, hsize_t index) {
    const auto read_name = [&](char* to, std::size_t size) {
        return H5Lget_name_by_idx(reader.file, ".", H5_INDEX_NAME, H5_ITER_INC, index, to,
                                  size, H5P_DEFAULT);
    };
    const ssize_t size = read_name(nullptr, 0);
    if (size < 1) fail(reader.path, fmt::format("group '{}' cannot be read", kRestart));
    std::string name(std::size_t(size) + 1, '\0');
    read_name(name.data(), name.size());
    name.pop_back();
    return name;
}

}  // namespace

Restart read_restart(const std::filesystem::path& path) {
    const Session session;
    const Handle file = open_file(path);
    if (!Reader{path, file}.has(kRestart)) {
        fail(path,
             fmt::format("no group '{}': the run cannot be continued from this cache",
                         kRestart));
    }
    const Handle group(H5Gopen2(file, kRestart, H5P_DEFAULT), H5Gclose);
    H5G_info_t info{};
    if (!group.good() || H5Gget_info(group, &info) < 0) {
        fail(path, fmt::format("'{}' is not a group, or a damaged one", kRestart));
    }
    if (info.nlinks > kMaxArrays) {
        fail(path, fmt::format("group '{}' contains {} arrays, expected at most {}",
                               kRestart, info.nlinks, kMaxArrays));
    }
    const Reader reader{path, group};
    Restart out;
    out.job = reader.text("job");
    for (hsize_t i = 0; i < info.nlinks; ++i) {
        const std::string name = name_of_link(reader, i);
        std::vector<hsize_t> shape{kAnyOrNone};
        const Handle data = reader.dataset(name.c_str(), shape);
        out.arrays[name] = reader.read(name.c_str(), data, {0}, shape);
    }
    return out;
}

}  // namespace lancret
