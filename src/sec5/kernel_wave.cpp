#include "sec5/kernel_wave.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdio>
namespace lattice {
namespace {
Vector<double> forces(const PowerContact& law, const Vector<double>& d) {
  return d.unaryExpr([&](double x) { return law.force(-x); });
}
Vector<double> stiffnesses(const PowerContact& law, const Vector<double>& d) {
  return d.unaryExpr([&](double x) { return law.stiffness(-x); });
}
std::vector<double> zeros_of(const HalfLine& line, const Vector<double>& d, double least) {
  std::vector<double> zeros;
  double peak = 0;  // of the closed contact that is being passed
  bool open_here = false;
  double top = d.maxCoeff();
  double begin = -1;
  for (Eigen::Index i = 0; i + 1 < d.size(); ++i) {
    if (d[i] > 0) peak = std::max(peak, d[i]);
    if ((d[i] > 0) == (d[i + 1] > 0)) continue;
    double low = line.t()[i], high = line.t()[i + 1];
    const bool falls = d[i] > 0;
    for (int pass = 0; pass < 56; ++pass) {
      const double m = (low + high) / 2;
      ((line.at(d, m) > 0) == falls ? low : high) = m;
    }
    const double z = (low + high) / 2;
    if (!falls) { begin = z; peak = 0; continue; }
    if (peak > least * top) { if (begin > 0) zeros.push_back(begin); zeros.push_back(z); }
  }
  (void)open_here;
  return zeros;
}
std::vector<double> cuts_for(const std::vector<double>& zeros, double T, double longest) {
  std::vector<double> at{0, T / 2};
  for (double z : zeros) { double m = std::fmod(z, T); at.push_back(std::min(m, T - m)); }
  std::sort(at.begin(), at.end());
  const double near = 1e-6;
  std::vector<double> cuts{0};
  for (double z : at)
    if (z > cuts.back() + near && z < T / 2 - near) cuts.push_back(z);
  cuts.push_back(T / 2);
  const double ratio = getenv("RATIO") ? atof(getenv("RATIO")) : 1e9;
  // graded
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<double> next{0};
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double l = cuts[i + 1] - cuts[i];
      const double left = i > 0 ? cuts[i] - cuts[i - 1] : l, right = i + 2 < cuts.size() ? cuts[i + 2] - cuts[i + 1] : l;
      if (l > ratio * left && left <= right) { next.push_back(cuts[i] + (ratio - 1) * left); changed = true; }
      else if (l > ratio * right) { next.push_back(cuts[i + 1] - (ratio - 1) * right); changed = true; }
      else if (l > longest) { next.push_back(cuts[i] + l / 2); changed = true; }
      next.push_back(cuts[i + 1]);
    }
    cuts = next;
  }
  return cuts;
}
std::size_t periods_for(const HalfLine& line, const Vector<double>& d) {
  const double top = d.cwiseAbs().maxCoeff();
  double last = 0;
  for (Eigen::Index i = 0; i < d.size(); ++i) if (std::abs(d[i]) > 1e-16 * top) last = line.t()[i];
  return std::size_t(std::ceil(last / line.shift_time())) + 1;
}
}
Vector<double> gmres_even(const HalfLine& line, const Vector<double>& stiffness, const Vector<double>& r) {
  const int most = 120;
  std::vector<Vector<double>> v;
  Matrix<double> h = Matrix<double>::Zero(most + 1, most);
  const double size = r.norm();
  v.push_back(r / size);
  std::vector<double> g(most + 1, 0.0), cs(most), sn(most);
  g[0] = size;
  int k = 0;
  while (k < most) {
    Vector<double> w = line.convolve(stiffness.cwiseProduct(v[k]));
    w = v[k] - w;
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j <= k; ++j) { const double c = w.dot(v[j]); h(j, k) += c; w -= c * v[j]; }
    const double rest = w.norm();
    for (int j = 0; j < k; ++j) {
      const double a = h(j, k), b = h(j + 1, k);
      h(j, k) = cs[j] * a + sn[j] * b, h(j + 1, k) = cs[j] * b - sn[j] * a;
    }
    const double length = std::hypot(h(k, k), rest);
    cs[k] = h(k, k) / length, sn[k] = rest / length, h(k, k) = length;
    g[k + 1] = -sn[k] * g[k], g[k] *= cs[k];
    ++k;
    if (std::abs(g[k]) < 1e-11 * size) break;
    v.push_back(w / rest);
  }
  std::vector<double> y(k);
  for (int j = k; j-- > 0;) {
    y[j] = g[j];
    for (int i = j + 1; i < k; ++i) y[j] -= h(j, i) * y[i];
    y[j] /= h(j, j);
  }
  Vector<double> x = Vector<double>::Zero(r.size());
  for (int j = 0; j < k; ++j) x += y[j] * v[j];
  if (getenv("LOUD")) printf("   gmres %d\n", k);
  return x;
}
KernelWave refine_wave(const KernelWave& guess, double T, const PowerContact& law, const Resolution& res) {
  KernelWave wave = guess;
  wave.law = law;
  const bool half = std::abs(std::round(2 * law.exponent) - 2 * law.exponent) < 1e-12;
  const Panel panel(res.nodes, half ? 2 : 3);
  double before = 1e300;
  for (int pass = 0; pass < 40; ++pass) {
    wave.zeros = zeros_of(wave.line, wave.d, 1e-8);
    const HalfLine line(T, cuts_for(wave.zeros, T, res.longest), periods_for(wave.line, wave.d), panel);
    wave.d = wave.line.onto(line, wave.d);
    wave.line = line;
    const Vector<double> r = line.convolve(forces(law, wave.d)) - wave.d;
    const double miss = r.cwiseAbs().maxCoeff() / wave.d.maxCoeff();
    if (getenv("LOUD")) printf("  pass %d N %ld cuts %zu periods %zu miss %.3e zeros %zu E %.15g A %.15g\n", pass, long(line.size()), line.size()/res.nodes/line.periods(), line.periods(), miss, wave.zeros.size(), wave.energy(), wave.action());
    wave.d += gmres_even(line, stiffnesses(law, wave.d), r);
    if ((miss < 1e-12 && periods_for(line, wave.d) <= line.periods()) || (miss < 1e-13 && miss > 0.5 * before)) break;
    before = miss;
  }
  return wave;
}
KernelWave seed_wave(double T, int start, const PowerContact& law) {
  const Panel panel(10, 2);
  std::vector<double> cuts;
  const int m = int(std::ceil(T / 2 / 0.4));
  for (int i = 0; i <= m; ++i) cuts.push_back(T / 2 * i / m);
  const HalfLine line(T, cuts, law.exponent < 1.3 ? 12 : 6, panel);
  Vector<double> f(line.size());
  const double a = law.exponent, p = 1 + 1 / a;
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    const double t = line.t()[i];
    f[i] = std::exp(-t * t * 3 / (T * T)) * law.force(-start * std::cos(t / (1 - 1.5708 / T)));
  }
  const auto norm = [&](const Vector<double>& g) { return std::pow(line.integral(g.unaryExpr([&](double x) { return std::pow(x, p); })), 1 / p); };
  f /= norm(f);
  Vector<double> kf = line.convolve(f);
  double q = line.integral(f.cwiseProduct(kf)), mu = 1;
  int it = 0;
  for (; it < 400; ++it) {
    Vector<double> g = (kf + mu * f.unaryExpr([&](double x) { return std::pow(x, 1 / a); })).unaryExpr([&](double x) { return x > 0 ? std::pow(x, a) : 0; });
    g /= norm(g);
    const Vector<double> kg = line.convolve(g);
    const double qg = line.integral(g.cwiseProduct(kg));
    if (qg < q) { mu *= 2; if (mu > 1e4) break; continue; }
    const double gain = qg - q;
    f = g, kf = kg, q = qg, mu *= 0.8;
    if (gain < 1e-7 * q) break;
  }
  // f = scale^... : K f = q f^(1/alpha), d = K (l f), l = q^(-alpha/(alpha-1))
  const double l = std::pow(q, -a / (a - 1));
  if (getenv("LOUD")) printf("  seed %d iterations q %.10f action %.8f\n", it, q, std::pow(q, -(a + 1) / (a - 1)));
  return {law, line, l * kf, {}};
}
Vector<double> KernelWave::force() const { return forces(law, d); }
double KernelWave::action() const { return line.integral(d.cwiseMax(0).cwiseProduct(force())); }
double KernelWave::quotient() const { return std::pow(action(), -(law.exponent - 1) / (law.exponent + 1)); }
double KernelWave::component() const { return line.respond(force()).component; }
double KernelWave::residual() const { return (line.convolve(force()) - d).cwiseAbs().maxCoeff() / peak(); }
double KernelWave::central_velocity() const {
  const auto r = line.respond(force());
  return 2 * r.half_v[0] + std::cos(line.shift_time() / 2) * r.component;
}
double KernelWave::energy() const {
  const auto r = line.respond(force());
  const double v = 2 * r.half_v[0] + std::cos(line.shift_time() / 2) * r.component;
  double e = v * v / 2;
  for (std::size_t j = 0; j < r.half.size(); ++j) {
    const bool more = j + 1 < r.half.size();
    const double y = (more ? r.half[j + 1] : 0) - r.half[j], w = (more ? r.half_v[j + 1] : 0) - r.half_v[j];
    const double x = line.at(d, (double(j) + 0.5) * line.shift_time());
    e += y * y + w * w + 2 * law.energy(-x);
  }
  return e;
}
std::size_t KernelWave::contacts() const {
  std::size_t n = 0; bool closed = false; double top = peak(), best = 0; std::size_t centre = d[0] > 0;
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    const bool now = d[i] > 0;
    if (now) { best = std::max(best, d[i]); }
    if (closed && !now) { if (best > 2.2e-16 * top) ++n; best = 0; }
    closed = now;
  }
  if (closed && best > 2.2e-16 * top) ++n;
  return 2 * n - centre;
}
}  // namespace lattice
