#include <math.h>
typedef struct { double m1, m2, l1, l2, g; } par_t;
void rhs(double t, const double *z, double *dz, const par_t *p)
{
    double q1 = z[0], q2 = z[1], w1 = z[2], w2 = z[3];
    double c2 = cos(q2), s2 = sin(q2);
    double h = p->m2*p->l1*p->l2*s2;
    double a = (p->m1 + p->m2)*p->l1*p->l1 + p->m2*pow(p->l2, 2) + 2.0*p->m2*p->l1*p->l2*c2;
    double b = p->m2*p->l2*p->l2 + p->m2*p->l1*p->l2*c2;
    double d = p->m2*p->l2*p->l2;
    double r1 = h*w2*(w1 + w2) - (p->m1 + p->m2)*p->g*p->l1*sin(q1) - p->m2*p->g*p->l2*sin(q1 + q2);
    double r2 = -h*w1*w1 - p->m2*p->g*p->l2*sin(q1 + q2);
    double det = a*d - b*b;
    dz[0] = w1;
    dz[1] = w2;
    dz[2] = (d*r1 - b*r2)/det;
    dz[3] = (a*r2 - b*r1)/det;
}
