#include "body/spline_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "parallel/in_chunks.h"

namespace toile {
namespace {

const double pole = std::sqrt(3.0) - 2;
constexpr int horizon = 24;  // pole^24 = 2e-14

// Spline coefficients of `width` interleaved lines of n samples, in place.
void prefilter(std::vector<double>& lines, int n, int width) {
  const auto row = [&](int i) { return lines.data() + static_cast<std::ptrdiff_t>(i) * width; };
  for (double& value : lines) value *= 6;
  for (int w = 0; w < width; ++w) {
    double power = 1, sum = 0;
    for (int i = 0; i < std::min(horizon, n); ++i, power *= pole) sum += power * row(i)[w];
    row(0)[w] = sum;
  }
  for (int i = 1; i < n; ++i)
    for (int w = 0; w < width; ++w) row(i)[w] += pole * row(i - 1)[w];
  for (int w = 0; w < width; ++w) row(n - 1)[w] = pole / (pole * pole - 1) * (row(n - 1)[w] + pole * row(n - 2)[w]);
  for (int i = n - 2; i >= 0; --i)
    for (int w = 0; w < width; ++w) row(i)[w] = pole * (row(i + 1)[w] - row(i)[w]);
}

struct Weights {
  double value[4], first[4], second[4];
};

Weights weights(double t) {
  const double s = 1 - t;
  return {{s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6},
          {-s * s / 2, (3 * t * t - 4 * t) / 2, -(3 * s * s - 4 * s) / 2, t * t / 2},
          {s, 3 * t - 2, 3 * s - 2, t}};
}

struct Stencil {
  std::size_t first;  // coefficient (i - 1, j - 1, k - 1)
  Eigen::Vector3d t;  // place in the cell, 0..1
};

Stencil stencil(const GridFrame& frame, const Eigen::Vector3d& at) {
  Eigen::Vector3i base;
  Stencil found;
  for (int axis = 0; axis < 3; ++axis) {
    const double u = std::clamp((at[axis] - frame.origin[axis]) / frame.cell, 1.0, static_cast<double>(frame.size[axis] - 2));
    base[axis] = std::min(static_cast<int>(u), frame.size[axis] - 3);
    found.t[axis] = u - base[axis];
  }
  found.first = frame.index(base[0] - 1, base[1] - 1, base[2] - 1);
  return found;
}

double dot(const double* w, const float* c) {
  return w[0] * static_cast<double>(c[0]) + w[1] * static_cast<double>(c[1]) + w[2] * static_cast<double>(c[2]) +
         w[3] * static_cast<double>(c[3]);
}

}  // namespace

SplineGrid::SplineGrid(const GridFrame& frame, std::vector<float> samples, int threads)
    : frame_(frame), coefficients_(std::move(samples)) {
  if (frame.size.minCoeff() < 5) throw std::invalid_argument("SplineGrid: fewer than 5 nodes in one direction");
  if (coefficients_.size() != frame.nodes()) throw std::invalid_argument("SplineGrid: one sample for each node is needed");
  const int nx = frame.size[0], ny = frame.size[1], nz = frame.size[2];
  constexpr int batch = 16;
  // Lines of `n` samples `stride` apart, `width` of them side by side `beside` apart.
  const auto filter = [&](float* first, int n, std::size_t stride, int width, std::size_t beside) {
    std::vector<double> lines(static_cast<std::size_t>(n) * static_cast<std::size_t>(width));
    const auto each = [&](const auto& act) {
      std::size_t slot = 0;
      for (int i = 0; i < n; ++i)
        for (int w = 0; w < width; ++w)
          act(lines[slot++], first[static_cast<std::size_t>(i) * stride + static_cast<std::size_t>(w) * beside]);
    };
    each([](double& line, float& sample) { line = static_cast<double>(sample); });
    prefilter(lines, n, width);
    each([](double& line, float& sample) { sample = static_cast<float>(line); });
  };
  const auto row = static_cast<std::size_t>(nx), plane = row * static_cast<std::size_t>(ny);
  in_chunks(nz, threads, [&](int k) {
    for (int j = 0; j < ny; j += batch) filter(&coefficients_[frame.index(0, j, k)], nx, 1, std::min(batch, ny - j), row);
    for (int i = 0; i < nx; i += batch) filter(&coefficients_[frame.index(i, 0, k)], ny, row, std::min(batch, nx - i), 1);
  });
  in_chunks(ny, threads, [&](int j) {
    for (int i = 0; i < nx; i += batch) filter(&coefficients_[frame.index(i, j, 0)], nz, plane, std::min(batch, nx - i), 1);
  });
}

double SplineGrid::value(const Eigen::Vector3d& at) const {
  const Stencil s = stencil(frame_, at);
  const Weights x = weights(s.t[0]), y = weights(s.t[1]), z = weights(s.t[2]);
  const auto row = static_cast<std::size_t>(frame_.size[0]), plane = row * static_cast<std::size_t>(frame_.size[1]);
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const float* layer = coefficients_.data() + s.first + k * plane;
    double inner = 0;
    for (std::size_t j = 0; j < 4; ++j) inner += y.value[j] * dot(x.value, layer + j * row);
    sum += z.value[k] * inner;
  }
  return sum;
}

SplineSample SplineGrid::sample(const Eigen::Vector3d& at) const {
  const Stencil s = stencil(frame_, at);
  const Weights x = weights(s.t[0]), y = weights(s.t[1]), z = weights(s.t[2]);
  const auto row = static_cast<std::size_t>(frame_.size[0]), plane = row * static_cast<std::size_t>(frame_.size[1]);
  double f = 0, fx = 0, fy = 0, fz = 0, fxx = 0, fyy = 0, fzz = 0, fxy = 0, fxz = 0, fyz = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const float* layer = coefficients_.data() + s.first + k * plane;
    double g = 0, gx = 0, gy = 0, gxx = 0, gxy = 0, gyy = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      const float* c = layer + j * row;
      const double v = dot(x.value, c), d = dot(x.first, c);
      g += y.value[j] * v;
      gx += y.value[j] * d;
      gxx += y.value[j] * dot(x.second, c);
      gy += y.first[j] * v;
      gxy += y.first[j] * d;
      gyy += y.second[j] * v;
    }
    f += z.value[k] * g;
    fx += z.value[k] * gx;
    fy += z.value[k] * gy;
    fxx += z.value[k] * gxx;
    fxy += z.value[k] * gxy;
    fyy += z.value[k] * gyy;
    fz += z.first[k] * g;
    fxz += z.first[k] * gx;
    fyz += z.first[k] * gy;
    fzz += z.second[k] * g;
  }
  SplineSample result;
  result.value = f;
  result.gradient = Eigen::Vector3d(fx, fy, fz) / frame_.cell;
  result.hessian << fxx, fxy, fxz, fxy, fyy, fyz, fxz, fyz, fzz;
  result.hessian /= frame_.cell * frame_.cell;
  return result;
}

}  // namespace toile
