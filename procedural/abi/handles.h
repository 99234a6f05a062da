#pragma once
// The structs behind the handles of the interface.

#include <memory>
#include <string>

#include "procedural/abi/cancel_watch.h"
#include "procedural/abi/open_groom.h"
#include "procedural/abi/run.h"
#include "procedural/abi/sized.h"
#include "procedural/abi/workspace.h"

struct lancret_context {
    explicit lancret_context(const lancret_host& given) : host(given) {}

    const lancret_host host;
    lancret::abi::Workspaces workspaces{host};
    lancret::abi::SharedByKey<std::string, lancret::abi::OpenGroom> grooms{0};
    lancret::abi::CancelWatch cancel{host};
};

struct lancret_groom {
    lancret_context& context;
    std::shared_ptr<const lancret::abi::OpenGroom> shared;
};
