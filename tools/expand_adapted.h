#pragma once

#include "tools/command.h"

namespace lancret {

/// lancret expand --adapt: grows the children of a generator at rest, each with as many
/// intervals as it needs; writes them to a .hair file where `output` names one, and says
/// what that saves and how far strands are off. Throws InputError.
void expand_adapted(const Job& job, const Generator& generator,
                    const std::filesystem::path& output, const std::string& stats_file);

}  // namespace lancret
