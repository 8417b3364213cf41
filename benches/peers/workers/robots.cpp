/* Times Pinocchio's recursive Newton-Euler and articulated bodies of the tree of a robot: a worker of robots.py.
 *
 * `robots TREE STATES`: TREE begins with the acceleration of free fall. Then a line for each joint: the index of the joint that carries
 * it (0 for the ground), its kind (R, P, S or F: a turn, a displacement, a ball, free), its axis, its place on the joint before, three
 * numbers, and the nine of its rotation; mass, mass centre, the entries xx, yy, zz, xy, yz, zx of the inertia about it, and the armature.
 * STATES: lines of q, u and u' in Pinocchio's variables. Reads and answers lines as robots.c does.
 */
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody/model.hpp>

#include <fstream>
#include <iostream>
#include <string>
#include <time.h>
#include <vector>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;

/* Adds a joint of one coordinate: along an axis of its frame, or oblique. */
template <class X, class Y, class Z, class Oblique>
static pin::JointIndex add(
    pin::Model &model, pin::JointIndex parent, const Eigen::Vector3d &axis, const pin::SE3 &place, const std::string &name)
{
    if (axis == Eigen::Vector3d::UnitX())
        return model.addJoint(parent, X(), place, name);
    if (axis == Eigen::Vector3d::UnitY())
        return model.addJoint(parent, Y(), place, name);
    if (axis == Eigen::Vector3d::UnitZ())
        return model.addJoint(parent, Z(), place, name);
    return model.addJoint(parent, Oblique(axis), place, name);
}

static pin::Model tree(const char *path)
{
    pin::Model model;
    std::ifstream file(path);
    file >> model.gravity.linear()[0] >> model.gravity.linear()[1] >> model.gravity.linear()[2];
    std::vector<double> armatures;
    pin::JointIndex parent;
    char kind;
    while (file >> parent >> kind) {
        Eigen::Vector3d axis, position, centre;
        Eigen::Matrix3d turn, inertia;
        double mass, xx, yy, zz, xy, yz, zx, armature;
        file >> axis[0] >> axis[1] >> axis[2] >> position[0] >> position[1] >> position[2];
        for (int i = 0; i < 9; ++i)
            file >> turn(i / 3, i % 3);
        file >> mass >> centre[0] >> centre[1] >> centre[2] >> xx >> yy >> zz >> xy >> yz >> zx >> armature;
        inertia << xx, xy, zx, xy, yy, yz, zx, yz, zz;
        const pin::SE3 place(turn, position);
        const std::string name = "joint " + std::to_string(model.njoints);
        pin::JointIndex at;
        if (kind == 'F')
            at = model.addJoint(parent, pin::JointModelFreeFlyer(), place, name);
        else if (kind == 'S')
            at = model.addJoint(parent, pin::JointModelSpherical(), place, name);
        else if (kind == 'P')
            at = add<pin::JointModelPX, pin::JointModelPY, pin::JointModelPZ, pin::JointModelPrismaticUnaligned>(
                model, parent, axis, place, name);
        else
            at = add<pin::JointModelRX, pin::JointModelRY, pin::JointModelRZ, pin::JointModelRevoluteUnaligned>(
                model, parent, axis, place, name);
        model.appendBodyToJoint(at, pin::Inertia(mass, centre, inertia));
        for (int i = 0; i < model.joints[at].nv(); ++i)
            armatures.push_back(armature);
    }
    for (int i = 0; i < model.nv; ++i)
        model.armature[i] = armatures[i];
    return model;
}

/* Time of the processor, s: other programs on the machine do not count. */
static double seconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

int main(int count, char **words)
{
    if (count != 3)
        return 2;
    const pin::Model model = tree(words[1]);
    pin::Data data(model);
    std::ifstream file(words[2]);
    std::vector<Vector> q, u, a;
    for (double first; file >> first;) {
        std::vector<Vector> *parts[] = {&q, &u, &a};
        for (auto *part : parts) {
            Vector x(part == &q ? model.nq : model.nv);
            for (int i = 0; i < x.size(); ++i)
                if (part == &q && i == 0)
                    x[i] = first;
                else
                    file >> x[i];
            part->push_back(x);
        }
    }
    if (q.empty())
        return 2;
    const Vector none = Vector::Zero(model.nv);
    std::cout.precision(17);
    std::string what;
    for (long number; std::cin >> what >> number;) {
        if (what == "values") {
            for (long i = 0; i < number; ++i) {
                std::cout << pin::aba(model, data, q[i], u[i], none).transpose() << ' ';
                std::cout << pin::rnea(model, data, q[i], u[i], a[i]).transpose() << ' ';
            }
            std::cout << std::endl;
            continue;
        }
        const double begin = seconds();
        for (long pass = 0; pass < number; ++pass)
            for (std::size_t i = 0; i < q.size(); ++i)
                if (what == "forward")
                    pin::aba(model, data, q[i], u[i], none);
                else
                    pin::rnea(model, data, q[i], u[i], a[i]);
        std::cout << (seconds() - begin) / number / q.size() << std::endl;
    }
}
