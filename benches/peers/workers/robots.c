/* Times emitted C of a robot: a worker of robots.py.
 *
 * `robots STATES`: lines of q, u and the accelerations of the chosen speeds. Compiled with NAME, the beginning of the names of the
 * emitted functions, and COORDINATES, SPEEDS and PARAMETERS. The functions stand in another file, so that the compiler cannot see
 * into a call. Reads lines `forward PASSES` (accelerations) or `inverse PASSES` (generalized forces), and answers the seconds of
 * the processor for a call; `values COUNT` answers both at the first states.
 */
#define _GNU_SOURCE
#include <stdio.h>
#include <string.h>
#include <time.h>

#define JOINED(a, b) a##b
#define NAMED(a, b) JOINED(a, b)

enum { STATES = 128 };

void NAMED(NAME, _defaults)(double *p);
void NAMED(NAME, _accelerations)(const double *p, const double *q, const double *u, double *out);
void NAMED(NAME, _inverse_dynamics)(const double *p, const double *q, const double *u, const double *a, double *out);

static double p[PARAMETERS], q[STATES][COORDINATES], u[STATES][SPEEDS], a[STATES][SPEEDS], out[STATES][SPEEDS];

/* Time of the processor, s: other programs on the machine do not count. */
static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

static int read_row(FILE *file, double *row, int count)
{
    for (int i = 0; i < count; ++i)
        if (fscanf(file, "%lf", row + i) != 1)
            return 0;
    return 1;
}

static void call(int is_forward, int i)
{
    if (is_forward)
        NAMED(NAME, _accelerations)(p, q[i], u[i], out[i]);
    else
        NAMED(NAME, _inverse_dynamics)(p, q[i], u[i], a[i], out[i]);
}

int main(int count, char **arguments)
{
    FILE *file = count == 2 ? fopen(arguments[1], "r") : NULL;
    if (!file)
        return 2;
    for (int i = 0; i < STATES; ++i)
        if (!read_row(file, q[i], COORDINATES) || !read_row(file, u[i], SPEEDS) || !read_row(file, a[i], SPEEDS))
            return 2;
    fclose(file);
    NAMED(NAME, _defaults)(p);
    char line[256], what[16];
    while (fgets(line, sizeof line, stdin)) {
        long number;
        if (sscanf(line, "%15s %ld", what, &number) != 2)
            return 2;
        const int is_forward = what[0] == 'f';
        if (strcmp(what, "values") == 0) {
            for (int i = 0; i < 2 * number && i < 2 * STATES; ++i) {
                call(i % 2 == 0, i / 2);
                for (int j = 0; j < SPEEDS; ++j)
                    printf("%s%.17g", i + j ? " " : "", out[i / 2][j]);
            }
            putchar('\n');
        } else {
            const double begin = seconds();
            for (long pass = 0; pass < number; ++pass)
                for (int i = 0; i < STATES; ++i)
                    call(is_forward, i);
            printf("%.9e\n", (seconds() - begin) / number / STATES);
        }
        fflush(stdout);
    }
    return 0;
}
