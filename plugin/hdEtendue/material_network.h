#pragma once

#include <string>
#include <variant>

#include <pxr/imaging/hd/material.h>

#include "usd.h"
#include "warnings.h"

namespace etendue::hydra {

/// A node of a network that outlives it.
struct NodeRef {
    const HdMaterialNetwork2* network = nullptr;
    SdfPath path;
    const HdMaterialNode2* node = nullptr;

    [[nodiscard]] const std::string& type() const { return node->nodeTypeId.GetString(); }
};

/// A value authored on the input; `color_space` is empty when none is authored.
struct Constant {
    VtValue value;
    std::string color_space;
};

struct NodeOutput {
    NodeRef node;
    std::string output;
};

/// What feeds an input; monostate when nothing is authored.
using InputSource = std::variant<std::monostate, Constant, NodeOutput>;

[[nodiscard]] InputSource resolve_input(const NodeRef& node, const std::string& name);

/// The input as a constant, empty when nothing is authored. A connection to a node is warned about and counts as
/// nothing.
[[nodiscard]] VtValue constant_input(Warnings& warnings, const NodeRef& node, const std::string& name);

}  // namespace etendue::hydra
