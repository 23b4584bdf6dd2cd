#include "material_network.h"

namespace etendue::hydra {

InputSource resolve_input(const NodeRef& node, const std::string& name) {
    const TfToken key(name);
    const auto connection = node.node->inputConnections.find(key);
    if (connection != node.node->inputConnections.end() && !connection->second.empty()) {
        const HdMaterialConnection2& first = connection->second.front();
        const auto upstream = node.network->nodes.find(first.upstreamNode);
        if (upstream != node.network->nodes.end()) {
            return NodeOutput{{node.network, upstream->first, &upstream->second}, first.upstreamOutputName.GetString()};
        }
    }
    const auto parameter = node.node->parameters.find(key);
    if (parameter == node.node->parameters.end() || parameter->second.IsEmpty()) return {};
    Constant constant{parameter->second, {}};
    const auto space = node.node->parameters.find(TfToken("colorSpace:" + name));
    if (space != node.node->parameters.end() && space->second.IsHolding<TfToken>()) {
        constant.color_space = space->second.UncheckedGet<TfToken>().GetString();
    }
    return constant;
}

VtValue constant_input(Warnings& warnings, const NodeRef& node, const std::string& name) {
    const InputSource source = resolve_input(node, name);
    if (const auto* constant = std::get_if<Constant>(&source)) return constant->value;
    if (std::holds_alternative<NodeOutput>(source)) {
        warnings.warn("connected " + node.type() + "." + name, node.path,
                      "input '" + name + "' may only be a constant here; its default is used");
    }
    return {};
}

}  // namespace etendue::hydra
