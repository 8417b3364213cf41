// Holds the pendulum of a Furuta arm upright on a microcontroller: numbers are floats, nothing is allocated.
//
// The controller predicts the state one period ahead by the generated equations, since the torque that it computes acts
// from then on, and feeds the prediction back. The gains are those of a linear quadratic regulator with the weights
// Q = diag(1, 1, 0.1, 0.1) and R = 100, from `jacobian` and `parameter_jacobian` of the same model in Python.
#include "furuta_kane.h"

enum { N = FURUTA_KANE_COORDINATES, STATES = 2 * N };

static const tripos_real gains[STATES] = {-0.1f, 4.43156366f, -0.13665571f, 0.97693404f};
static const tripos_real upright = 3.14159265f;
static const tripos_real strongest = 0.4f;

// The derivative of the state (q, u) under a torque.
static void derivative(tripos_real *p, tripos_real torque, const tripos_real *x, tripos_real *out)
{
  p[FURUTA_KANE_P_tau] = torque;
  furuta_kane_derivative(p, x, x + N, out, out + N);
}

// Moves the state by one period, by the midpoint rule.
void step(tripos_real *p, tripos_real torque, tripos_real *x, tripos_real period)
{
  tripos_real slope[STATES], middle[STATES];
  int k;
  derivative(p, torque, x, slope);
  for (k = 0; k < STATES; k++) middle[k] = x[k] + 0.5f * period * slope[k];
  derivative(p, torque, middle, slope);
  for (k = 0; k < STATES; k++) x[k] += period * slope[k];
}

// The torque for the next period, from the measured state and the torque that acts now.
tripos_real balance(tripos_real *p, const tripos_real *measured, tripos_real torque, tripos_real period)
{
  tripos_real x[STATES], next = 0;
  int k;
  for (k = 0; k < STATES; k++) x[k] = measured[k];
  step(p, torque, x, period);
  x[1] -= upright;
  for (k = 0; k < STATES; k++) next -= gains[k] * x[k];
  return next > strongest ? strongest : next < -strongest ? -strongest : next;
}

// Ten seconds of the arm under the controller, from 6 degrees beside upright. Returns 0 if the pendulum stands then.
int main(void)
{
  tripos_real p[FURUTA_KANE_PARAMETERS], x[STATES] = {0, 3.04159265f, 0, 0}, torque = 0;
  const tripos_real period = 0.005f;
  int count;
  furuta_kane_defaults(p);
  for (count = 0; count < 2000; count++) {
    const tripos_real next = balance(p, x, torque, period);
    step(p, torque, x, period);
    torque = next;
  }
  return !(tripos_abs(x[1] - upright) < 1e-3f && tripos_abs(x[0]) < 0.1f);
}
