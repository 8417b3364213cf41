/* Times Pinocchio's forward and inverse dynamics of an arm: a worker of run.py, which documents the lines it reads and answers.
 *
 * `arms CHAIN STATES`: a line for each joint of CHAIN, axis (1, 2, 3), then where the joint stands on the link before, three
 * numbers, and the nine of its rotation; mass, mass centre and the entries xx, yy, zz, xy, yz, zx of the inertia about it. The first
 * line is the acceleration of gravity. STATES: a line to skip, then lines of q, u and u'.
 */
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody/model.hpp>

#include <chrono>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;

static pin::Model arm(const char *path)
{
    pin::Model model;
    std::ifstream file(path);
    file >> model.gravity.linear()[0] >> model.gravity.linear()[1] >> model.gravity.linear()[2];
    pin::JointIndex at = 0;
    int axis;
    while (file >> axis) {
        Eigen::Vector3d place, centre;
        Eigen::Matrix3d turn, inertia;
        double mass, xx, yy, zz, xy, yz, zx;
        file >> place[0] >> place[1] >> place[2];
        for (int i = 0; i < 9; ++i)
            file >> turn(i / 3, i % 3);
        file >> mass >> centre[0] >> centre[1] >> centre[2] >> xx >> yy >> zz >> xy >> yz >> zx;
        inertia << xx, xy, zx, xy, yy, yz, zx, yz, zz;
        const pin::SE3 placement(turn, place);
        const std::string name = "joint " + std::to_string(at + 1);
        if (axis == 1)
            at = model.addJoint(at, pin::JointModelRX(), placement, name);
        else if (axis == 2)
            at = model.addJoint(at, pin::JointModelRY(), placement, name);
        else
            at = model.addJoint(at, pin::JointModelRZ(), placement, name);
        model.appendBodyToJoint(at, pin::Inertia(mass, centre, inertia));
    }
    return model;
}

int main(int count, char **words)
{
    if (count != 3)
        return 2;
    const pin::Model model = arm(words[1]);
    pin::Data data(model);
    std::ifstream file(words[2]);
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    std::vector<Vector> q, u, a;
    for (double first; file >> first;) {
        std::vector<Vector> *parts[] = {&q, &u, &a};
        for (auto *part : parts) {
            Vector x(model.nv);
            for (int i = 0; i < model.nv; ++i)
                if (part == &q && i == 0)
                    x[i] = first;
                else
                    file >> x[i];
            part->push_back(x);
        }
    }
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
        const auto begin = std::chrono::steady_clock::now();
        for (long pass = 0; pass < number; ++pass)
            for (std::size_t i = 0; i < q.size(); ++i)
                if (what == "forward")
                    pin::aba(model, data, q[i], u[i], none);
                else
                    pin::rnea(model, data, q[i], u[i], a[i]);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        std::cout << seconds.count() / number / q.size() << std::endl;
    }
}
