#pragma once

/// NumPy arrays to and from the façade's vectors. Both directions copy: neither side keeps a view of the other.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace etendue::python {

using FloatArray = pybind11::array_t<float, pybind11::array::c_style | pybind11::array::forcecast>;
using DoubleArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// (n, N) floats to n tuples. ValueError for any other shape.
template <std::size_t N>
std::vector<std::array<float, N>> tuples_from_array(const FloatArray& array) {
    if (array.size() == 0) return {};
    if (array.ndim() != 2 || array.shape(1) != static_cast<pybind11::ssize_t>(N)) {
        throw pybind11::value_error("expected an array of shape (n, " + std::to_string(N) + ")");
    }
    std::vector<std::array<float, N>> tuples(static_cast<std::size_t>(array.shape(0)));
    std::copy_n(array.data(), array.size(), tuples.data()->data());
    return tuples;
}

/// n tuples to a new (n, N) array of float32.
template <std::size_t N>
pybind11::array_t<float> array_from_tuples(const std::vector<std::array<float, N>>& tuples) {
    pybind11::array_t<float> array({tuples.size(), N});
    if (!tuples.empty()) std::copy_n(tuples.data()->data(), tuples.size() * N, array.mutable_data());
    return array;
}

/// (n,) integers of any width to int32. ValueError for floats, other shapes and values beyond 32 bits.
inline std::vector<std::int32_t> indices_from_array(const pybind11::array& array) {
    if (array.size() == 0) return {};
    if (array.ndim() != 1) throw pybind11::value_error("expected an array of shape (n,)");
    if (array.dtype().kind() != 'i' && array.dtype().kind() != 'u') {
        throw pybind11::value_error("expected an array of integers");
    }
    if (array.dtype().is(pybind11::dtype::of<std::int32_t>())) {
        // As they come from USD: nothing to check, and no copy of twice the size.
        const auto same = pybind11::array_t<std::int32_t, pybind11::array::c_style>::ensure(array);
        return {same.data(), same.data() + same.size()};
    }
    const auto wide =
        pybind11::array_t<std::int64_t, pybind11::array::c_style | pybind11::array::forcecast>::ensure(array);
    std::vector<std::int32_t> indices(static_cast<std::size_t>(wide.size()));
    std::transform(wide.data(), wide.data() + wide.size(), indices.begin(), [](std::int64_t index) {
        if (index < std::numeric_limits<std::int32_t>::min() || index > std::numeric_limits<std::int32_t>::max()) {
            throw pybind11::value_error("an index does not fit in 32 bits");
        }
        return static_cast<std::int32_t>(index);
    });
    return indices;
}

/// A new (n,) array of int32.
inline pybind11::array_t<std::int32_t> array_from_indices(const std::vector<std::int32_t>& indices) {
    return pybind11::array_t<std::int32_t>(static_cast<pybind11::ssize_t>(indices.size()), indices.data());
}

}  // namespace etendue::python
