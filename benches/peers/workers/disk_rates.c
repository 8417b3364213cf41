/* The closed form as a function by itself, for rates.c. */
#define _GNU_SOURCE
#include "disk_form.h"

void rates(const double *p, const double *y, double *out)
{
    const Parameters parameters = {p[1], p[2]};
    disk_rates(&parameters, y, out);
}
