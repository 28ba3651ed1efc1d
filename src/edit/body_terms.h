#pragma once
// What binds a garment to a body while its style is solved for: proportion, fit and contact, asked anew in every round, because
// skin slides under a moving garment.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "body/relative.h"
#include "style/style_solve.h"

namespace toile {

struct BodyWishes {
  std::vector<bool> moves;           // by vertex; the others are held and not looked at
  std::vector<int> limb;             // by vertex, index into limb_axes of the body
  Eigen::VectorXd release;           // by vertex, rho of E_fit in [0, 1]; 0: its distance to the body is free
  Eigen::VectorXd offset;            // by vertex, m off the skin along the ray from the bone, where release is not 0
  Eigen::VectorXd least;             // by vertex, m, nearest it may come to the body
  std::vector<SoftTerm> proportion;  // E_rl and what else does not change with the skin below
  std::function<double(int vertex, const Eigen::Vector3d& at)> keep = {};  // share of `release` where the vertex is now
};

// The distance at which a garment whose gaps (m, by vertex) are these lies on its body, 2 mm at most: asked of every vertex
// that newly touches, so that it does not stand out from its neighbours.
double contact_distance(const Eigen::VectorXd& gaps);

class BodyTerms {
 public:
  // Keeps a reference to `body`. `areas` by vertex, m^2.
  BodyTerms(const Body& body, const Eigen::VectorXd& areas, BodyWishes wishes);

  const std::vector<SoftTerm>& proportion() const { return wishes_.proportion; }
  // E_fit with the skin that is under each vertex at `x`.
  std::vector<SoftTerm> fit(const Eigen::Matrix3Xd& x) const;
  // For a shape near `x`: from now on only vertices that have skin under them there are asked to keep their distance, and to
  // the same part of it. Where a ray passes between the legs by a hair, skin would come and go otherwise.
  void keep_to_skin_at(const Eigen::Matrix3Xd& x);
  // As after a solve with `other`: the same skin, and what had to be pushed is pushed as hard.
  void go_on_from(const BodyTerms& other);
  // For solve_style, which must not outlive this: all of them, contact from the first round on; one that is pushed again and
  // again is pushed harder.
  SoftTermsAt all();

 private:
  struct SkinUnder {
    bool any = false;
    SkinPlace skin;
    Eigen::Vector3d vertex;  // where it was then
  };
  SkinUnder skin_under(Eigen::Index v, const Eigen::Vector3d& at) const;
  std::vector<SoftTerm> contact(const Eigen::Matrix3Xd& x);

  const Body& body_;
  std::vector<LimbAxis> axes_;
  StyleWeights weights_;
  Eigen::VectorXd areas_;
  BodyWishes wishes_;
  std::vector<SkinUnder> kept_skin_;  // by vertex; empty: none is kept to
  std::vector<int> pushes_;           // rounds in which the vertex was found too near the body
};

}  // namespace toile
