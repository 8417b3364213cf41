/* Times forward and inverse dynamics of an arm by emitted C: a worker of run.py, which documents the lines it reads and answers.
 *
 * `arms STATES`: parameters in the first line of the file, then lines of q, u and u'. Compiled with JOINTS and PARAMETERS. The
 * functions stand in another file, so that the compiler cannot see into a call.
 */
#define _GNU_SOURCE
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { N = JOINTS, P = PARAMETERS, STATES = 128 };

/* out = the accelerations at (q, u), with parameters p. */
void forward(const double *p, const double *q, const double *u, double *out);
/* out = the torques for the accelerations a. */
void inverse(const double *p, const double *q, const double *u, const double *a, double *out);

static double p[P], states[STATES][3][N], out[STATES][N];

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
    for (int i = 0; good && i < STATES * 3 * N; ++i)
        good = fscanf(file, "%lf", &states[0][0][0] + i) == 1;
    if (file)
        fclose(file);
    return good;
}

static void call(int is_forward, int i)
{
    if (is_forward)
        forward(p, states[i][0], states[i][1], out[i]);
    else
        inverse(p, states[i][0], states[i][1], states[i][2], out[i]);
}

static void answer_time(int is_forward, long passes)
{
    const double begin = seconds();
    for (long pass = 0; pass < passes; ++pass)
        for (int i = 0; i < STATES; ++i)
            call(is_forward, i);
    printf("%.9e\n", (seconds() - begin) / passes / STATES);
}

/* Accelerations and torques at the first states, one after the other. */
static void answer_values(int count)
{
    for (int i = 0; i < 2 * count && i < 2 * STATES; ++i) {
        call(i % 2 == 0, i / 2);
        for (int j = 0; j < N; ++j)
            printf("%s%.17g", i + j ? " " : "", out[i / 2][j]);
    }
    putchar('\n');
}

int main(int count, char **arguments)
{
    if (count != 2 || !read_states(arguments[1]))
        return 2;
    char line[256], what[16];
    while (fgets(line, sizeof line, stdin)) {
        long number;
        if (sscanf(line, "%15s %ld", what, &number) != 2)
            return 2;
        if (strcmp(what, "values") == 0)
            answer_values((int)number);
        else if (strcmp(what, "forward") == 0 || strcmp(what, "inverse") == 0)
            answer_time(what[0] == 'f', number);
        else
            return 2;
        fflush(stdout);
    }
    return 0;
}
