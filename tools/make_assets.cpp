// Writes the bundled assets: make_assets FOLDER. The same program writes the same bytes; the files are in the
// repository, so only who changes a model needs this.
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <numbers>

#include "tools/asset_sketch.h"

namespace solitaire {
namespace {

const Surface kOak{"oak", {0.76, 0.58, 0.38}, 0.65};
const Surface kWalnut{"walnut", {0.45, 0.30, 0.20}, 0.6};
const Surface kBirch{"birch", {0.87, 0.77, 0.62}, 0.65};
const Surface kSteel{"steel", {0.66, 0.68, 0.71}, 0.35, 0.3};
const Surface kDark{"dark metal", {0.20, 0.21, 0.23}, 0.5, 0.2};
const Surface kWhite{"white", {0.93, 0.93, 0.91}, 0.6};
const Surface kGrey{"grey fabric", {0.46, 0.52, 0.58}, 0.95};
const Surface kBlack{"black plastic", {0.13, 0.13, 0.14}, 0.6};
const Surface kLinen{"linen", {0.90, 0.88, 0.84}, 0.95};
const Surface kLeaves{"leaves", {0.27, 0.50, 0.24}, 0.9};
const Surface kSoil{"soil", {0.25, 0.18, 0.13}, 1};

Affine turned_about_y(double degrees) { return to_affine({{}, about_up(degrees), {1, 1, 1}}); }

/// Leans backwards (top towards -z) about the line y, z.
Affine leaning(double degrees, double y, double z) {
  const double half = -degrees * std::numbers::pi / 360;
  return to_affine({{0, y, z}, {std::sin(half), 0, 0, std::cos(half)}, {1, 1, 1}}) *
         to_affine({{0, -y, -z}, {0, 0, 0, 1}, {1, 1, 1}});
}

/// Four posts at the corners of a w × d rectangle, leaning outward by `splay`.
void legs(AssetSketch& sketch, double w, double d, double top, double upper, double lower, double splay = 0) {
  for (const int sx : {-1, 1}) {
    for (const int sz : {-1, 1}) {
      sketch.post(sx * w / 2, sz * d / 2, 0, lower, lower, top, upper, upper, -sx * splay, -sz * splay);
    }
  }
}

AssetSketch table() {
  AssetSketch t("table", "none");
  t.of(kOak).soft_block({-0.7, 0.705, -0.4}, {0.7, 0.74, 0.4}, 0.008);
  t.of(kWalnut);
  legs(t, 1.28, 0.68, 0.705, 0.065, 0.045);
  for (const int s : {-1, 1}) {
    t.block({-0.61, 0.62, s * 0.34 - 0.01}, {0.61, 0.705, s * 0.34 + 0.01});
    t.block({s * 0.64 - 0.01, 0.62, -0.31}, {s * 0.64 + 0.01, 0.705, 0.31});
  }
  return t;
}

AssetSketch chair() {
  AssetSketch c("chair", "+Z");
  c.of(kBirch).soft_block({-0.22, 0.43, -0.2}, {0.22, 0.465, 0.23}, 0.012);
  legs(c, 0.38, 0.36, 0.43, 0.04, 0.03, 0.01);
  const Affine back = leaning(8, 0.46, -0.19);
  for (const int s : {-1, 1})
    c.block({s * 0.195 - 0.018, 0.44, -0.205}, {s * 0.195 + 0.018, 0.86, -0.17}, back);
  c.soft_block({-0.22, 0.74, -0.21}, {0.22, 0.87, -0.175}, 0.01, back);
  for (const double y : {0.56, 0.65}) c.block({-0.18, y, -0.2}, {0.18, y + 0.035, -0.182}, back);
  c.of(kGrey).soft_block({-0.2, 0.465, -0.165}, {0.2, 0.495, 0.21}, 0.014);
  return c;
}

AssetSketch seat_furniture(const std::string& name, double width, int cushions) {
  AssetSketch s(name, "+Z");
  const double arm = 0.16, inner = width - 2 * arm, each = inner / cushions;
  s.of(kGrey).soft_block({-width / 2 + 0.02, 0.1, -0.42}, {width / 2 - 0.02, 0.3, 0.42}, 0.02);
  s.soft_block({-width / 2 + 0.04, 0.2, -0.45}, {width / 2 - 0.04, 0.8, -0.24}, 0.05);
  for (const int side : {-1, 1}) {
    const double x = side * (width / 2 - arm / 2);
    s.soft_block({x - arm / 2, 0.1, -0.44}, {x + arm / 2, 0.6, 0.45}, 0.045);
  }
  const Affine lean = leaning(10, 0.4, -0.2);
  for (int i = 0; i < cushions; ++i) {
    const double x = -inner / 2 + each * i;
    s.soft_block({x + 0.005, 0.3, -0.24}, {x + each - 0.005, 0.44, 0.44}, 0.04);
    s.soft_block({x + 0.015, 0.42, -0.22}, {x + each - 0.015, 0.78, -0.08}, 0.05, lean);
  }
  s.of(kWalnut);
  for (const int x : {-1, 1}) {
    for (const int z : {-1, 1}) s.post(x * (width / 2 - 0.1), z * 0.36, 0, 0.035, 0.035, 0.1, 0.05, 0.05);
  }
  return s;
}

AssetSketch sofa() { return seat_furniture("sofa", 2.0, 3); }
AssetSketch armchair() { return seat_furniture("armchair", 0.9, 1); }

AssetSketch bookcase() {
  AssetSketch b("bookcase", "+Z");
  const double w = 0.45, depth = 0.16, height = 1.9;
  b.of(kOak);
  for (const int s : {-1, 1})
    b.block({s * w - (s > 0 ? 0.025 : 0), 0, -depth}, {s * w + (s < 0 ? 0.025 : 0), height, depth});
  b.block({-w + 0.025, 0, -depth}, {w - 0.025, height, -depth + 0.012});
  const int shelves = 6;
  for (int i = 0; i < shelves; ++i) {
    const double y = i == shelves - 1 ? height - 0.025 : 0.06 + i * (height - 0.085) / (shelves - 1);
    b.block({-w + 0.025, y, -depth + 0.012}, {w - 0.025, y + 0.025, depth - 0.005});
  }
  const std::array<Surface, 3> covers = {Surface{"red book", {0.66, 0.25, 0.20}, 0.8},
                                         Surface{"blue book", {0.22, 0.36, 0.52}, 0.8},
                                         Surface{"paper", {0.88, 0.83, 0.70}, 0.9}};
  for (int shelf = 0; shelf < shelves - 1; ++shelf) {
    const double y = 0.085 + shelf * (height - 0.085) / (shelves - 1);
    double x = -w + 0.035;
    for (int book = 0; x < w - 0.07 - 0.09 * ((shelf * 3) % 4); ++book) {
      const int kind = (book * 7 + shelf * 5) % 11;  // any fixed order that looks like none
      const double thick = 0.025 + 0.004 * (kind % 5), tall = 0.2 + 0.014 * (kind % 6),
                   out = 0.1 + 0.01 * (kind % 4);
      b.of(covers[static_cast<std::size_t>(kind % 3)])
          .block({x, y, -depth + 0.02}, {x + thick, y + tall, out - 0.01});
      x += thick + 0.002;
    }
  }
  return b;
}

AssetSketch whiteboard() {
  AssetSketch w("whiteboard", "+Z");
  w.of({"board", {0.97, 0.97, 0.98}, 0.25}).block({-0.87, 0.83, -0.012}, {0.87, 1.87, 0.014});
  w.of(kSteel);
  for (const double y : {0.8, 1.87}) w.block({-0.9, y, -0.02}, {0.9, y + 0.03, 0.02});
  for (const int s : {-1, 1}) {
    w.block({s * 0.885 - 0.015, 0.8, -0.02}, {s * 0.885 + 0.015, 1.9, 0.02});
    w.block({s * 0.82 - 0.02, 0.06, -0.02}, {s * 0.82 + 0.02, 0.8, 0.02});
    w.block({s * 0.82 - 0.025, 0.06, -0.27}, {s * 0.82 + 0.025, 0.1, 0.27});
  }
  w.block({-0.82, 0.3, -0.015}, {0.82, 0.34, 0.015});
  w.block({-0.6, 0.795, 0.02}, {0.6, 0.81, 0.09});
  w.of(kBlack);
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1})
      w.block({s * 0.82 - 0.015, 0, t * 0.24 - 0.03}, {s * 0.82 + 0.015, 0.06, t * 0.24 + 0.03});
  }
  w.of({"pens", {0.16, 0.30, 0.62}, 0.5}).block({-0.2, 0.81, 0.04}, {-0.06, 0.825, 0.055});
  w.block({0.05, 0.81, 0.04}, {0.19, 0.825, 0.055});
  return w;
}

// Doors and windows are a little thicker than the wall that they stand in, so that they show on both of its
// sides.
AssetSketch door() {
  AssetSketch d("door", "+Z");
  d.role("opening");
  const double face = 0.07, frame = 0.09;
  d.of(kOak).block({-0.4, 0.005, -face}, {0.4, 2.04, face});
  for (const int s : {-1, 1}) {
    const double near = s > 0 ? face : -face - 0.014, far = s > 0 ? face + 0.014 : -face;
    for (const double x : {-0.34, 0.04}) {
      for (const double y : {0.2, 1.15}) d.soft_block({x, y, near}, {x + 0.3, y + 0.78, far}, 0.01);
    }
  }
  d.of(kWhite);
  for (const int s : {-1, 1}) d.block({s * 0.425 - 0.025, 0, -frame}, {s * 0.425 + 0.025, 2.1, frame});
  d.block({-0.4, 2.04, -frame}, {0.4, 2.1, frame});
  d.of(kSteel);
  for (const int s : {-1, 1}) {
    const auto layer = [&](double x0, double x1, double y0, double y1, double from, double to) {
      d.block({x0, y0, s > 0 ? face + from : -face - to}, {x1, y1, s > 0 ? face + to : -face - from});
    };
    layer(0.352, 0.39, 0.98, 1.11, 0, 0.008);
    layer(0.363, 0.378, 1.05, 1.065, 0.008, 0.05);
    layer(0.25, 0.378, 1.048, 1.067, 0.036, 0.05);
  }
  return d;
}

AssetSketch plant() {
  AssetSketch p("plant", "none");
  p.keep_proportions();
  p.of(kLeaves);
  const int leaves = 22;
  for (int i = 0; i < leaves; ++i) {
    const double angle = i * 2.399963;  // the golden angle, as leaves grow
    const double rise = 1 - static_cast<double>(i) / leaves;
    const double reach = 0.3 - 0.16 * rise * rise, height = 0.42 + 0.68 * rise;
    const double x = std::sin(angle), z = std::cos(angle);
    p.leaf({x * 0.03, 0.36, z * 0.03}, {x * reach * 0.55, height * 0.93, z * reach * 0.55},
           {x * reach, height - 0.12 * (1 - rise), z * reach}, 0.14);
  }
  p.of({"pot", {0.74, 0.42, 0.29}, 0.85})
      .turned(0, 0, {{0.12, 0}, {0.17, 0.3}, {0.185, 0.3}, {0.185, 0.36}, {0.16, 0.36}}, 20);
  p.of(kSoil).turned(0, 0, {{0.158, 0.355}, {0.158, 0.362}}, 20);
  return p;
}

AssetSketch desk() {
  AssetSketch d("desk", "+Z");
  d.of(kBirch).soft_block({-0.7, 0.71, -0.35}, {0.7, 0.74, 0.35}, 0.006);
  d.block({-0.66, 0.35, -0.31}, {0.24, 0.7, -0.29});
  d.of(kWhite).block({0.24, 0.06, -0.3}, {0.66, 0.71, 0.3});
  d.of(kDark);
  for (const int s : {-1, 1}) d.post(-0.64, s * 0.3, 0, 0.04, 0.04, 0.71, 0.04, 0.04);
  d.block({-0.66, 0, -0.32}, {-0.62, 0.04, 0.32});
  d.block({0.27, 0, -0.27}, {0.63, 0.06, 0.27});
  for (int i = 0; i < 3; ++i) {
    const double y = 0.08 + i * 0.208;
    d.of(kWhite).soft_block({0.25, y, 0.3}, {0.65, y + 0.2, 0.318}, 0.004);
    d.of(kDark).block({0.38, y + 0.14, 0.318}, {0.52, y + 0.155, 0.335});
  }
  return d;
}

AssetSketch lamp() {
  AssetSketch l("lamp", "none");
  l.keep_proportions();
  l.of({"shade", {0.98, 0.90, 0.74}, 0.9, 0, 0.35}).turned(0, 0, {{0.2, 1.3}, {0.14, 1.6}}, 24);
  l.of(kDark).turned(0, 0, {{0.15, 0}, {0.15, 0.02}, {0.03, 0.035}, {0.012, 0.05}, {0.012, 1.3}}, 24);
  return l;
}

AssetSketch cabinet() {
  AssetSketch c("cabinet", "+Z");
  c.of(kOak).block({-0.4, 0.08, -0.22}, {0.4, 1.08, 0.195});
  c.soft_block({-0.41, 1.08, -0.225}, {0.41, 1.105, 0.225}, 0.006);
  c.of(kWhite);
  for (const int s : {-1, 1})
    c.soft_block({s * 0.1985 - 0.1945, 0.095, 0.195}, {s * 0.1985 + 0.1945, 1.065, 0.215}, 0.005);
  c.of(kDark);
  for (const int s : {-1, 1}) c.block({s * 0.035 - 0.007, 0.5, 0.215}, {s * 0.035 + 0.007, 0.68, 0.235});
  c.block({-0.38, 0, -0.2}, {0.38, 0.08, 0.17});
  return c;
}

AssetSketch rug() {
  AssetSketch r("rug", "none");
  r.of({"rug", {0.66, 0.33, 0.28}, 1}).block({-0.9, 0, -0.6}, {0.9, 0.012, 0.6});
  r.of({"rug border", {0.90, 0.84, 0.72}, 1});
  for (const int s : {-1, 1}) {
    r.block({-1, 0, s > 0 ? 0.6 : -0.7}, {1, 0.011, s > 0 ? 0.7 : -0.6});
    r.block({s > 0 ? 0.9 : -1, 0, -0.6}, {s > 0 ? 1 : -0.9, 0.011, 0.6});
  }
  r.of({"rug pattern", {0.24, 0.28, 0.38}, 1}).block({-0.7, 0.012, -0.4}, {0.7, 0.014, 0.4});
  r.of({"rug", {}, 1}).block({-0.55, 0.014, -0.26}, {0.55, 0.016, 0.26});
  return r;
}

// Walls and floors are stretched to any size: nothing on them may look stretched.
AssetSketch wall() {
  AssetSketch w("wall", "none");
  w.role("wall");
  w.of({"plaster", {0.91, 0.89, 0.85}, 0.95}).block({-0.5, 0, -0.06}, {0.5, 2.6, 0.06});
  return w;
}

AssetSketch floor_slab() {
  AssetSketch f("floor", "none");
  f.of({"boards", {0.80, 0.72, 0.60}, 0.8}).block({-0.5, 0, -0.5}, {0.5, 0.02, 0.5});
  return f;
}

AssetSketch window() {
  AssetSketch w("window", "+Z");
  w.role("opening");
  const double glass = 0.065, bar = 0.08, frame = 0.09;
  w.of(kWhite);
  for (const int s : {-1, 1}) {
    w.block({s * 0.57 - 0.03, 0, -frame}, {s * 0.57 + 0.03, 1.4, frame});
    w.block({-0.54, s > 0 ? 1.34 : 0, -frame}, {0.54, s > 0 ? 1.4 : 0.06, frame});
  }
  w.block({-0.025, 0.06, -bar}, {0.025, 1.34, bar});
  w.block({-0.54, 0.9, -bar}, {-0.025, 0.935, bar}).block({0.025, 0.9, -bar}, {0.54, 0.935, bar});
  for (const int s : {-1, 1})
    w.soft_block({-0.62, 0, s > 0 ? frame : -0.14}, {0.62, 0.035, s > 0 ? 0.14 : -frame}, 0.006);
  w.of(kSteel).block({-0.007, 0.62, bar}, {0.007, 0.74, bar + 0.02});
  w.of({"glass", {0.66, 0.82, 0.90}, 0.05});  // opaque: the wall behind it has no hole
  for (const int s : {-1, 1}) {
    const double x = s * 0.2825;
    w.block({x - 0.2575, 0.06, -glass}, {x + 0.2575, 0.9, glass});
    w.block({x - 0.2575, 0.935, -glass}, {x + 0.2575, 1.34, glass});
  }
  return w;
}

AssetSketch office_chair() {
  AssetSketch c("office_chair", "+Z");
  c.of(kGrey).soft_block({-0.25, 0.45, -0.22}, {0.25, 0.52, 0.27}, 0.03);
  const Affine back = leaning(9, 0.5, -0.22);
  c.soft_block({-0.23, 0.6, -0.27}, {0.23, 1.08, -0.21}, 0.027, back);
  c.of(kBlack).block({-0.16, 0.42, -0.16}, {0.16, 0.45, 0.2});
  c.block({-0.03, 0.42, -0.31}, {0.03, 0.85, -0.27}, back);
  c.block({-0.03, 0.42, -0.3}, {0.03, 0.445, -0.16});
  for (const int s : {-1, 1}) {
    c.block({s * 0.275 - 0.012, 0.44, -0.06}, {s * 0.275 + 0.012, 0.66, 0.0});
    c.block({s * 0.21 - 0.075, 0.43, -0.06}, {s * 0.21 + 0.075, 0.45, 0.0});
    c.soft_block({s * 0.275 - 0.035, 0.66, -0.14}, {s * 0.275 + 0.035, 0.69, 0.14}, 0.012);
  }
  for (int i = 0; i < 5; ++i) {
    const Affine arm = turned_about_y(i * 72);
    c.block({-0.025, 0.07, 0.02}, {0.025, 0.105, 0.3}, arm);
    c.turned(0, 0.28, {{0.018, 0.05}, {0.018, 0.075}}, 8, arm);
    c.soft_block({-0.03, 0, 0.252}, {0.03, 0.055, 0.308}, 0.014, arm);
  }
  c.of(kSteel).turned(0, 0, {{0.045, 0.06}, {0.045, 0.2}, {0.028, 0.2}, {0.028, 0.42}}, 16);
  return c;
}

AssetSketch stool() {
  AssetSketch s("stool", "none");
  s.of(kBirch).turned(0, 0, {{0.17, 0.43}, {0.19, 0.44}, {0.19, 0.46}, {0.18, 0.47}}, 24);
  s.of(kWalnut);
  legs(s, 0.26, 0.26, 0.435, 0.04, 0.03, 0.03);
  for (const int k : {-1, 1}) {
    s.block({-0.11, 0.16, k * 0.12 - 0.008}, {0.11, 0.185, k * 0.12 + 0.008});
    s.block({k * 0.12 - 0.008, 0.2, -0.11}, {k * 0.12 + 0.008, 0.225, 0.11});
  }
  return s;
}

AssetSketch bed() {
  AssetSketch b("bed", "+Z");
  b.of({"blanket", {0.34, 0.45, 0.56}, 1}).soft_block({-0.79, 0.33, -0.35}, {0.79, 0.54, 1.02}, 0.045);
  b.of(kOak).soft_block({-0.8, 0.1, -1.0}, {0.8, 0.32, 1.05}, 0.015);
  b.soft_block({-0.8, 0, -1.05}, {0.8, 1.0, -1.0}, 0.012);
  for (const int s : {-1, 1}) b.block({s * 0.72 - 0.035, 0, 0.93}, {s * 0.72 + 0.035, 0.1, 1.0});
  b.of(kLinen).soft_block({-0.77, 0.3, -0.99}, {0.77, 0.5, 1.0}, 0.04);
  for (const int s : {-1, 1})
    b.soft_block({s * 0.38 - 0.32, 0.49, -0.94}, {s * 0.38 + 0.32, 0.62, -0.52}, 0.05,
                 leaning(6, 0.5, -0.94));
  return b;
}

AssetSketch column() {
  AssetSketch c("column", "none");
  c.of({"stone", {0.84, 0.82, 0.78}, 0.9}).soft_block({-0.25, 0, -0.25}, {0.25, 0.14, 0.25}, 0.01);
  c.turned(0, 0,
           {{0.23, 0.14}, {0.235, 0.2}, {0.18, 0.26}, {0.175, 0.6}, {0.15, 2.5}, {0.2, 2.58}, {0.2, 2.66}},
           24);
  c.soft_block({-0.24, 2.66, -0.24}, {0.24, 2.8, 0.24}, 0.01);
  return c;
}

AssetSketch tree() {
  AssetSketch t("tree", "none");
  t.keep_proportions();
  t.of(kLeaves);
  const auto crown = [&](double x, double z, double y, double r) {
    std::vector<std::array<double, 2>> rings;
    const int steps = 6;
    for (int i = 0; i <= steps; ++i) {
      const double angle = std::numbers::pi * i / steps;
      rings.push_back({i == 0 || i == steps ? 0 : r * std::sin(angle), y - 0.9 * r * std::cos(angle)});
    }
    t.turned(x, z, rings, 12);
  };
  crown(0, 0, 3.0, 1.0);
  crown(0.55, 0.2, 2.45, 0.65);
  crown(-0.5, 0.35, 2.6, 0.7);
  crown(-0.1, -0.55, 2.5, 0.65);
  t.of({"bark", {0.38, 0.28, 0.20}, 1}).turned(0, 0, {{0.2, 0}, {0.14, 0.25}, {0.11, 1.6}, {0.07, 2.8}}, 12);
  return t;
}

// ---- plain shapes of one metre

const Surface kPlain{"plain", {0.78, 0.76, 0.72}, 0.8};

AssetSketch cylinder() {
  AssetSketch c("cylinder", "none");
  c.of(kPlain).turned(0, 0, {{0.5, 0}, {0.5, 1}}, 32);
  return c;
}

AssetSketch cone() {
  AssetSketch c("cone", "none");
  c.of(kPlain).turned(0, 0, {{0.5, 0}, {0, 1}}, 32);
  return c;
}

AssetSketch sphere() {
  AssetSketch s("sphere", "none");
  s.keep_proportions();
  const int steps = 12;
  std::vector<std::array<double, 2>> rings;
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi * i / steps;
    rings.push_back({i == 0 || i == steps ? 0 : 0.5 * std::sin(angle), 0.5 - 0.5 * std::cos(angle)});
  }
  s.of(kPlain).turned(0, 0, rings, 24);
  return s;
}

/// Rises from its front to its back.
AssetSketch wedge() {
  AssetSketch w("wedge", "+Z");
  w.of(kPlain).extruded({{-0.5, 0}, {0.5, 0}, {0.5, 1}}, -0.5, 0.5, turned_about_y(90));
  return w;
}

void write_all(const std::filesystem::path& folder) {
  constexpr std::array kModels = {table, chair, sofa,    armchair, bookcase, whiteboard, door,   plant,
                                  desk,  lamp,  cabinet, rug,      wall,     floor_slab, window, office_chair,
                                  stool, bed,   column,  tree,     cylinder, cone,       sphere, wedge};
  for (const auto model : kModels) {
    AssetSketch sketch = model();
    sketch.write(folder / (sketch.name() + ".glb"));
  }
}

}  // namespace
}  // namespace solitaire

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fputs("usage: make_assets FOLDER\n", stderr);
    return 2;
  }
  solitaire::write_all(arguments[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_assets: %s\n", error.what());
  return 3;
}
