/* What the C workers share: the scene, the coefficients of DOP853, and the lines that run.py documents.
 *
 * A worker includes this and defines the function declared here. Coefficients, error estimate, step control and choice of
 * the first step are those of DOP853: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I (1993),
 * sections II.4 and II.5. Absent on purpose: the solution inside a step, the test for stiffness.
 */
#define _GNU_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "disk_form.h"

/* SAMPLE: runs of a batch whose ends are answered, evenly spaced. */
enum { N = 10, STAGES = 12, SAMPLE = 16 };

typedef struct {
    long steps, evaluations;
} Counts;

/* q1 ... q5, the angles being 10, 2 and 45 degrees; their rates. */
static const double START[N] = {0.17453292519943295, 0.03490658503988659, 0.7853981633974483, 5, 1,
                                0.01, -0.1, 0.02, 0.4, 0.1};
static const double SPAN = 10;

/* From a start to the end of the span, at rtol = atol = tolerance. */
static Counts integrate(const Parameters *p, double tolerance, const double start[N], double end[N]);

/* Row i: the point of stage i + 1, from 0; the last row is the end of the step. */
static const double A[STAGES + 1][STAGES] = {
    {0},
    {[0] = 5.26001519587677318785587544488e-2},
    {[0] = 1.97250569845378994544595329183e-2, [1] = 5.91751709536136983633785987549e-2},
    {[0] = 2.95875854768068491816892993775e-2, [2] = 8.87627564304205475450678981324e-2},
    {[0] = 2.41365134159266685502369798665e-1, [2] = -8.84549479328286085344864962717e-1,
     [3] = 9.24834003261792003115737966543e-1},
    {[0] = 3.7037037037037037037037037037e-2, [3] = 1.70828608729473871279604482173e-1,
     [4] = 1.25467687566822425016691814123e-1},
    {[0] = 3.7109375e-2, [3] = 1.70252211019544039314978060272e-1, [4] = 6.02165389804559606850219397283e-2,
     [5] = -1.7578125e-2},
    {[0] = 3.70920001185047927108779319836e-2, [3] = 1.70383925712239993810214054705e-1,
     [4] = 1.07262030446373284651809199168e-1, [5] = -1.53194377486244017527936158236e-2,
     [6] = 8.27378916381402288758473766002e-3},
    {[0] = 6.24110958716075717114429577812e-1, [3] = -3.36089262944694129406857109825,
     [4] = -8.68219346841726006818189891453e-1, [5] = 2.75920996994467083049415600797e1,
     [6] = 2.01540675504778934086186788979e1, [7] = -4.34898841810699588477366255144e1},
    {[0] = 4.77662536438264365890433908527e-1, [3] = -2.48811461997166764192642586468,
     [4] = -5.90290826836842996371446475743e-1, [5] = 2.12300514481811942347288949897e1,
     [6] = 1.52792336328824235832596922938e1, [7] = -3.32882109689848629194453265587e1,
     [8] = -2.03312017085086261358222928593e-2},
    {[0] = -9.3714243008598732571704021658e-1, [3] = 5.18637242884406370830023853209,
     [4] = 1.09143734899672957818500254654, [5] = -8.14978701074692612513997267357,
     [6] = -1.85200656599969598641566180701e1, [7] = 2.27394870993505042818970056734e1,
     [8] = 2.49360555267965238987089396762, [9] = -3.0467644718982195003823669022},
    {[0] = 2.27331014751653820792359768449, [3] = -1.05344954667372501984066689879e1,
     [4] = -2.00087205822486249909675718444, [5] = -1.79589318631187989172765950534e1,
     [6] = 2.79488845294199600508499808837e1, [7] = -2.85899827713502369474065508674,
     [8] = -8.87285693353062954433549289258, [9] = 1.23605671757943030647266201528e1,
     [10] = 6.43392746015763530355970484046e-1},
    {[0] = 5.42937341165687622380535766363e-2, [5] = 4.45031289275240888144113950566,
     [6] = 1.89151789931450038304281599044, [7] = -5.8012039600105847814672114227, [8] = 3.1116436695781989440891606237e-1,
     [9] = -1.52160949662516078556178806805e-1, [10] = 2.01365400804030348374776537501e-1,
     [11] = 4.47106157277725905176885569043e-2},
};
/* What the end is compared with: a method of order 3, and the difference from one of order 5. */
static const double THIRD[STAGES] = {[0] = 0.244094488188976377952755905512, [8] = 0.733846688281611857341361741547,
                                     [11] = 0.220588235294117647058823529412e-1};
static const double FIFTH[STAGES] = {
    [0] = 0.1312004499419488073250102996e-1, [5] = -0.1225156446376204440720569753e+1, [6] = -0.4957589496572501915214079952,
    [7] = 0.1664377182454986536961530415e+1, [8] = -0.3503288487499736816886487290, [9] = 0.3341791187130174790297318841,
    [10] = 0.8192320648511571246570742613e-1, [11] = -0.2235530786388629525884427845e-1};

/* What is left of h before rounding hides it. */
static inline int too_small(double t, double h)
{
    return 0.1 * h <= t * 2.3e-16;
}

static inline double weight(double tolerance, double a)
{
    return tolerance + tolerance * fabs(a);
}

/* The first step: a hundredth of the time in which y changes by its size, then corrected by y''. `yy` and `ff` are the
 * norms of y and y' over the tolerances, squared; `change` that of the change of y' in the guessed step. */
static inline double first_guess(double yy, double ff)
{
    return fmin(ff <= 1e-10 || yy <= 1e-10 ? 1e-6 : 0.01 * sqrt(yy / ff), SPAN);
}

static inline double first_step(double guess, double ff, double change)
{
    const double largest = fmax(sqrt(change) / guess, sqrt(ff));
    const double second = largest <= 1e-15 ? fmax(1e-6, guess * 1e-3) : pow(0.01 / largest, 1.0 / 8);
    return fmin(fmin(100 * guess, second), SPAN);
}

/* The error of a step from the squared norms of the differences from orders 5 and 3. */
static inline double step_error(double h, double five, double three)
{
    const double both = five + 0.01 * three;
    return h * five * sqrt(1 / (N * (both > 0 ? both : 1)));
}

/* The next size, and whether the step that was tried is good. */
static inline int judge(double error, int *rejected, double *h)
{
    const double change = sqrt(sqrt(sqrt(error))) / 0.9;
    if (error <= 1) {
        const double next = *h / fmax(1 / 6.0, fmin(1 / 0.333, change));
        *h = *rejected ? fmin(next, *h) : next;
        *rejected = 0;
        return 1;
    }
    *h /= fmin(1 / 0.333, change);
    *rejected = 1;
    return 0;
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

static void answer_run(const Parameters *p, double tolerance, long repeats)
{
    double y[N];
    Counts counts = {0, 0};
    const double begin = seconds();
    for (long i = 0; i < repeats; ++i)
        counts = integrate(p, tolerance, START, y);
    printf("%.9e %ld %ld", (seconds() - begin) / repeats, counts.steps, counts.evaluations);
    for (int i = 0; i < N; ++i)
        printf(" %.17g", y[i]);
    putchar('\n');
}

/* Runs from all starts of a file of doubles, one after the other. */
static int answer_batch(const Parameters *p, long count, double tolerance, const char *path)
{
    double(*starts)[N] = malloc(count * sizeof *starts), (*ends)[N] = malloc(count * sizeof *ends);
    FILE *file = fopen(path, "rb");
    const int good = starts && ends && file && fread(starts, sizeof *starts, count, file) == (size_t)count;
    if (good) {
        long steps = 0;
        const double begin = seconds();
        for (long i = 0; i < count; ++i)
            steps += integrate(p, tolerance, starts[i], ends[i]).steps;
        printf("%.9e %ld", seconds() - begin, steps);
        for (long i = 0; i < SAMPLE * N; ++i)
            printf(" %.17g", ends[i / N * count / SAMPLE][i % N]);
        putchar('\n');
    }
    if (file)
        fclose(file);
    free(starts);
    free(ends);
    return good;
}

int main(void)
{
    volatile double R = 1, g = 9.81;
    const Parameters p = {R, g};
    char line[4096];
    while (fgets(line, sizeof line, stdin)) {
        double tolerance;
        long repeats;
        int at = 0;
        if (sscanf(line, "run %lf %ld", &tolerance, &repeats) == 2) {
            answer_run(&p, tolerance, repeats);
        } else if (sscanf(line, "batch %ld %lf %n", &repeats, &tolerance, &at) == 2 && at > 0) {
            line[strcspn(line, "\n")] = 0;
            if (!answer_batch(&p, repeats, tolerance, line + at))
                return 2;
        } else if (sscanf(line, "prepare %lf", &tolerance) == 1) {
            puts("0");
        } else if (!strncmp(line, "start", 5)) {
            printf("1 %.17g %.17g", p.R, p.g);
            for (int i = 0; i < N; ++i)
                printf(" %.17g", START[i]);
            putchar('\n');
        } else {
            return 2;
        }
        fflush(stdout);
    }
    return 0;
}
