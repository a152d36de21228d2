/* SPDX-License-Identifier: GPL-3.0-or-later
**
** dormand_prince.c - steps of an eighth-order integration.
**
** The explicit Runge-Kutta method of J. R. Dormand and P. J. Prince with 12 stages and two error estimates,
** of orders 5 and 3 (E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd
** ed., section II.5, the coefficients of their DOP853):
**
**    k_i   = f(x + c_i h, y + h sum_j a_ij k_j),   y(x + h) = y + h sum b_i k_i
**    e     = h e5^2 / sqrt(e5^2 + (0.1 e3)^2),     e5 = sum E5_i k_i,  e3 = sum E3_i k_i       (eq. 10.17)
**
** With four more stages it gives values within a step, of order 7 (section II.6, "A Dense Output Formula for
** the 8th Order Method"), at x + q h:
**
**    y     = y_0 + q (F_0 + (1 - q) (F_1 + q (F_2 + (1 - q) (F_3 + ... q F_6))))
**
** GSL has such steps too, but they allocate memory, and GSL calls its error handler on failure.
*/
#include <math.h>

#include "fourlink.h"
#include "dormand_prince.h"

#define STAGES FLK_STAGE_AT_END

static const double c[FLK_STAGES] = {0,
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
                                     1,
                                     1,
                                     0.1,
                                     0.2,
                                     0.7777777777777778};

/* clang-format off */
/* Row i has the coefficients of stage i + 1; the last three are those for values within a step. */
static const double a[FLK_STAGES - 1][FLK_STAGES - 1] = {
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
     0.04471061572777259},
    {0.056167502283047954, 0, 0, 0, 0, 0, 0.25350021021662483, -0.2462390374708025,
     -0.12419142326381637, 0.15329179827876568, 0.008201052295634691, 0.007567897660545699,
     -0.008298},
    {0.03183464816350214, 0, 0, 0, 0, 0.028300909672366776, 0.053541988307438566,
     -0.05492374857139099, 0, 0, -0.00010834732869724932, 0.0003825710908356584,
     -0.00034046500868740456, 0.1413124436746325},
    {-0.42889630158379194, 0, 0, 0, 0, -4.697621415361164, 7.683421196062599,
     4.06898981839711, 0.3567271874552811, 0, 0, 0, -0.0013990241651590145,
     2.9475147891527724, -9.15095847217987}
};

static const double e5[STAGES] = {
    0.01312004499419488, 0, 0, 0, 0, -1.2251564463762044, -0.4957589496572502, 1.6643771824549864,
    -0.35032884874997366, 0.3341791187130175, 0.08192320648511571, -0.022355307863886294
};
static const double e3[STAGES] = {
    -0.18980075407240762, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585,
    -0.42268232132379197, -0.1521609496625161, 0.20136540080403034, 0.022651792198360825
};
static const double d[FLK_POWERS - 3][FLK_STAGES] = {
    {-8.428938276109013, 0, 0, 0, 0, 0.5667149535193777, -3.0689499459498917,
     2.38466765651207, 2.117034582445028, -0.871391583777973, 2.2404374302607883,
     0.6315787787694688, -0.08899033645133331, 18.148505520854727, -9.194632392478356,
     -4.436036387594894},
    {10.427508642579134, 0, 0, 0, 0, 242.28349177525817, 165.20045171727028,
     -374.5467547226902, -22.113666853125306, 7.733432668472264, -30.674084731089398,
     -9.332130526430229, 15.697238121770845, -31.139403219565178, -9.352924358844479,
     35.81684148639408},
    {19.985053242002433, 0, 0, 0, 0, -387.0373087493518, -189.17813819516758,
     527.8081592054236, -11.57390253995963, 6.8812326946963, -1.0006050966910838,
     0.7777137798053443, -2.778205752353508, -60.19669523126412, 84.32040550667716,
     11.99229113618279},
    {-25.69393346270375, 0, 0, 0, 0, -154.18974869023643, -231.5293791760455,
     357.6391179106141, 93.40532418362432, -37.45832313645163, 104.0996495089623,
     29.8402934266605, -43.53345659001114, 96.32455395918828, -39.17726167561544,
     -149.72683625798564}
};
/* clang-format on */

/* y + h sum a_j k_j */
static void combine(const flk_step *step, const double *row, int stages, double *sum)
{
    int i, j;

    for (i = 0; i < FLK_UNKNOWNS; i++)
        sum[i] = row[0] * step->k[0][i];
    for (j = 1; j < stages; j++)
        if (row[j] != 0)
            for (i = 0; i < FLK_UNKNOWNS; i++)
                sum[i] += row[j] * step->k[j][i];
    for (i = 0; i < FLK_UNKNOWNS; i++)
        sum[i] = step->y[i] + step->h * sum[i];
}

static double estimate(const flk_step *step, int i)
{
    double five = 0, three = 0, size;
    int j;

    for (j = 0; j < STAGES; j++) {
        five += e5[j] * step->k[j][i];
        three += e3[j] * step->k[j][i];
    }
    size = sqrt(five * five + 0.01 * three * three);
    return size == 0 ? 0 : fabs(step->h) * fabs(five) * (fabs(five) / size); /* NaN stays NaN */
}

static int derive(flk_step *step, int from, int to)
{
    double y[FLK_UNKNOWNS];
    int i, status = FOURLINK_OK;

    for (i = from; i < to && status == FOURLINK_OK; i++) {
        combine(step, a[i - 1], i, y);
        status = step->f(step->context, step->x + c[i] * step->h, y, step->k[i]);
    }
    return status;
}

int flk_step_take(flk_step *step, double *error)
{
    int i, status = derive(step, 1, STAGES);

    if (status != FOURLINK_OK)
        return status;
    for (i = 0; i < FLK_UNKNOWNS; i++)
        error[i] = estimate(step, i);
    combine(step, a[STAGES - 1], STAGES, step->next);
    return FOURLINK_OK;
}

int flk_step_end(flk_step *step)
{
    return step->f(step->context, step->x + step->h, step->next, step->k[STAGES]);
}

int flk_step_within(flk_step *step, flk_curve_of_step *within)
{
    double h = step->h;
    int i, j, p, status = derive(step, STAGES + 1, FLK_STAGES);

    for (i = 0; i < FLK_UNKNOWNS && status == FOURLINK_OK; i++) {
        double *F = within->F[i], change = step->next[i] - step->y[i];

        F[0] = change;
        F[1] = h * step->k[0][i] - change;
        F[2] = 2 * change - h * (step->k[STAGES][i] + step->k[0][i]);
        for (p = 3; p < FLK_POWERS; p++) {
            F[p] = 0;
            for (j = 0; j < FLK_STAGES; j++)
                F[p] += h * d[p - 3][j] * step->k[j][i];
        }
    }
    return status;
}

double flk_step_change(const flk_curve_of_step *within, int i, double part, double *slope)
{
    const double *F = within->F[i];
    double sum = 0;
    int p;

    *slope = 0;
    for (p = FLK_POWERS - 1; p >= 0; p--) {
        double factor = p % 2 == 0 ? part : 1 - part;

        sum += F[p];
        *slope = *slope * factor + (p % 2 == 0 ? sum : -sum);
        sum *= factor;
    }
    return sum;
}
