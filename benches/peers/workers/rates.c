/* Times a right-hand side that stands in another file: a worker of run.py, which documents the lines it reads and answers.
 *
 * Compiled with COORDINATES and PARAMETERS, so that lengths are known where the caller's own work depends on them. The call is one
 * the compiler cannot see into, as an integrator's is that serves any equations.
 */
#define _GNU_SOURCE
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { N = COORDINATES, D = 2 * COORDINATES, P = PARAMETERS, STATES = 128 };

/* out = (q', q'') at y = (q, q'), with parameters p. */
#ifdef __cplusplus
extern "C"
#endif
void rates(const double *p, const double *y, double *out);

static double p[P], states[STATES][D], out[STATES][D];

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

static int read_states(const char *path)
{
    FILE *file = fopen(path, "r");
    int good = file != NULL;
    for (int i = 0; good && i < P; ++i)
        good = fscanf(file, "%lf", &p[i]) == 1;
    for (int i = 0; good && i < STATES * D; ++i)
        good = fscanf(file, "%lf", &states[i / D][i % D]) == 1;
    if (file)
        fclose(file);
    return good;
}

/* Calls that do not wait for one another. */
static void answer_throughput(long passes)
{
    const double begin = seconds();
    for (long pass = 0; pass < passes; ++pass)
        for (int i = 0; i < STATES; ++i)
            rates(p, states[i], out[i]);
    printf("%.9e\n", (seconds() - begin) / passes / STATES);
}

/* Calls that each wait for the one before, as in a run. */
static void answer_chained(long passes)
{
    double carried = 0, y[D], f[D];
    const double begin = seconds();
    for (long pass = 0; pass < passes; ++pass)
        for (int i = 0; i < STATES; ++i) {
            for (int j = 0; j < D; ++j)
                y[j] = states[i][j] + 1e-300 * carried;
            rates(p, y, f);
            carried = f[N + 1] + f[D - 2] + f[D - 1];
        }
    printf("%.9e %.17g\n", (seconds() - begin) / passes / STATES, carried);
}

/* The derivatives at the first states, one after the other. */
static void answer_values(int count)
{
    for (int i = 0; i < count && i < STATES; ++i) {
        rates(p, states[i], out[i]);
        for (int j = 0; j < D; ++j)
            printf("%s%.17g", i + j ? " " : "", out[i][j]);
    }
    putchar('\n');
}

int main(int count, char **arguments)
{
    if (count != 2 || !read_states(arguments[1]))
        return 2;
    char line[256];
    while (fgets(line, sizeof line, stdin)) {
        long number;
        if (sscanf(line, "throughput %ld", &number) == 1)
            answer_throughput(number);
        else if (sscanf(line, "chained %ld", &number) == 1)
            answer_chained(number);
        else if (sscanf(line, "values %ld", &number) == 1)
            answer_values((int)number);
        else
            return 2;
        fflush(stdout);
    }
    return 0;
}
