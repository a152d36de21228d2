/* SPDX-License-Identifier: GPL-3.0-or-later
**
** dormand_prince.c - steps of an integration of order 8.
**
** The explicit Runge-Kutta method of J. R. Dormand and P. J. Prince with 12 stages, and with two estimates of the error,
** of orders 5 and 3 (E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed.,
** section II.5, the coefficients of their DOP853):
**
**    k_i   = f(x + c_i h, y + h sum_j a_ij k_j),   y(x + h) = y + h sum b_i k_i
**    e     = h e5^2 / sqrt(e5^2 + (0.1 e3)^2),     e5 = sum E5_i k_i,  e3 = sum E3_i k_i       (eq. 10.17)
**
** GSL has steps of this kind too, but they allocate memory, and its error handler is called if there is none.
*/
#include <math.h>
#include <string.h>

#include "fourlink.h"
#include "dormand_prince.h"

#define STAGES 12

static const double c[STAGES] = {0,
                                 0.05260015195876773,
                                 0.0789002279381516,
                                 0.1183503419072274,
                                 0.2816496580927726,
                                 0.3333333333333333,
                                 0.25,
                                 0.3076923076923077,
                                 0.6512820512820513,
                                 0.6,
                                 0.8571428571428571,
                                 1};

/* clang-format off */
/* Row i has the coefficients of stage i + 1; the last row are the weights b. */
static const double a[STAGES][STAGES] = {
    {0.05260015195876773},
    {0.0197250569845379, 0.0591751709536137},
    {0.02958758547680685, 0, 0.08876275643042054},
    {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
    {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
    {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
    {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328,
     -0.015319437748624402, 0.008273789163814023},
    {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671,
     20.154067550477894, -43.48988418106996},
    {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193,
     15.279233632882423, -33.28821096898486, -0.020331201708508627},
    {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927,
     -18.52006565999696, 22.739487099350505, 2.4936055526796523, -3.0467644718982196},
    {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188,
     27.94888452941996, -2.8589982771350235, -8.872856933530629, 12.360567175794303,
     0.6433927460157636},
    {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003,
     -5.801203960010585, 0.3111643669578199, -0.1521609496625161, 0.20136540080403034,
     0.04471061572777259}
};

static const double e5[STAGES] = {
    0.01312004499419488, 0, 0, 0, 0, -1.2251564463762044, -0.4957589496572502, 1.6643771824549864,
    -0.35032884874997366, 0.3341791187130175, 0.08192320648511571, -0.022355307863886294
};
static const double e3[STAGES] = {
    -0.18980075407240762, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585,
    -0.42268232132379197, -0.1521609496625161, 0.20136540080403034, 0.022651792198360825
};
/* clang-format on */

/* y + h sum a_j k_j */
static void combine(int n, const double *y, double h, const double *row, double k[][FLK_UNKNOWNS],
                    int stages, double *sum)
{
    int i, j;

    for (i = 0; i < n; i++) {
        double s = 0;

        for (j = 0; j < stages; j++)
            s += row[j] * k[j][i];
        sum[i] = y[i] + h * s;
    }
}

static double estimate(double h, double k[][FLK_UNKNOWNS], int i)
{
    double five = 0, three = 0, size;
    int j;

    for (j = 0; j < STAGES; j++) {
        five += e5[j] * k[j][i];
        three += e3[j] * k[j][i];
    }
    size = sqrt(five * five + 0.01 * three * three);
    return size > 0 ? fabs(h) * five * (five / size) : 0;
}

int flk_dormand_prince(flk_derivative *f, void *context, int n, double x, const double *y,
                       const double *dy, double h, double *next, double *error)
{
    double k[STAGES][FLK_UNKNOWNS], at[FLK_UNKNOWNS];
    int i, status;

    memcpy(k[0], dy, (size_t)n * sizeof *dy);
    for (i = 1; i < STAGES; i++) {
        combine(n, y, h, a[i - 1], k, i, at);
        status = f(context, x + c[i] * h, at, k[i]);
        if (status != FOURLINK_OK)
            return status;
    }
    for (i = 0; error && i < n; i++)
        error[i] = estimate(h, k, i);
    combine(n, y, h, a[STAGES - 1], k, STAGES, next);
    return FOURLINK_OK;
}
