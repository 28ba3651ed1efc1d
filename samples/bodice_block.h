#pragma once
// The upper body block of the samples: half back and half front from the waist up, by direct measure after the way of the
// German systems (back width, armhole diameter and front width as shares of the bust; dart from the balance of front and back).

#include "drafting.h"

namespace toile::drafting {

struct BodiceEase {
  double bust = 6e-2;     // m, round the bust
  double armhole = 0;     // m, deeper than the block's
  double front_neck = 0;  // m, deeper
  double neck = 0;        // m, wider at each shoulder
  double shoulder = 0;    // m, longer (or shorter) than to the bone
  bool bust_dart = true;  // else the front keeps a third of its extra length at the neck, and the side seams agree
};

// Centre on x = 0, waist on y = 0, side at x > 0. Lines run counter-clockwise: armhole from the underarm up, neck towards the
// centre.
struct BodiceHalf {
  double side = 0;  // m, from the centre to the underarm
  Line armhole, shoulder, neck;
  Eigen::Vector2d underarm() const { return armhole.front(); }
};

struct Bodice {
  BodiceHalf back, front;
  Eigen::Vector2d bust_point;
  double bust_dart = 0;  // m, by which the front side seam is longer; the dart at the side takes it in
};

double nape_to_waist(const Measures& m);
double waist_to_hip(const Measures& m);

Bodice draft_bodice(const Measures& m, const BodiceEase& ease);

struct SleeveRule {
  double biceps_ease = 5e-2;  // m
  double cap_ease = 2e-2;     // m, by which the cap is longer than the armhole
  double length = 0.4;        // m, from the top of the cap
  double hem = 0.28;          // m, round the hem
  double hem_allowance = 3e-2;
};

// A one-piece sleeve for the left arm, front at x < 0, underarm on y = 0; the height of the cap follows from the armholes and
// the width. Edges hem, seam_back, cap_back, cap_front, seam_front; notches 1 on the front, 2 on the back, and at the shoulder.
Piece draft_sleeve(const Measures& m, const Bodice& bodice, const SleeveRule& rule);

// Where the armhole has its notches, m from the underarm; the sleeve's cap has them at the same distance.
double front_notch(const Bodice& bodice);
std::vector<double> back_notches(const Bodice& bodice);

}  // namespace toile::drafting
