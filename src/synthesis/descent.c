/* SPDX-License-Identifier: GPL-3.0-or-later
**
** descent.c - the linkage whose coupler point has the least sum of w distance^2 from many points.
**
** The method of Levenberg and Marquardt, with derivatives.  A crank angle theta_j that is not given is an
** unknown of its own.  It is in the rows of its own position only, so it is eliminated there.  With J the rows
** of all positions by the unknowns x of the linkage, t_j those of position j by theta_j, c_j = J_j' t_j and
** s_j = t_j't_j, a step is
**
**    (J'J + damping diag(J'J) - sum c_j c_j' / s_j) dx = -J'r + sum c_j t_j'r_j / s_j,   s_j times 1 + damping
**    dtheta_j = -(t_j'r_j + c_j'dx) / s_j
**
** gsl_multifit_nlinear does the same, without the elimination.  It allocates memory, and calls GSL's error
** handler if there is none; the handler is the host's, and by default it aborts.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "points.h"

#define WIDEST 0.5 /* rad, by which a step turns a crank at most */
#define TINY 1e-30

/* The last descent of a single crank angle: its most steps, and its last one, rad. */
#define SETTLING 100
#define SETTLED 1e-12

/* What the rows of all positions add up to. */
typedef struct sums {
    double H[FLK_UNKNOWNS][FLK_UNKNOWNS], g[FLK_UNKNOWNS]; /* J'J, -J'r */
    double G[FLK_UNKNOWNS][FLK_UNKNOWNS], h[FLK_UNKNOWNS]; /* sum of c c' / s, of c t'r / s */
    double c[FOURLINK_POSITIONS_MAX][FLK_UNKNOWNS], s[FOURLINK_POSITIONS_MAX],
        tr[FOURLINK_POSITIONS_MAX];
} sums;

/* The rows of a position: x, y, the coupler's angle, and how much |cos(mu)| is too large; their
** derivatives.  The rows of bounds are like the last one: two of the transmission angle, one of each
** length, one of their ratio. */
enum { X, Y, TURN, MU, ROWS, BOUND = MU, BOUNDS = 7 };
typedef struct rows {
    double r[ROWS], J[ROWS][FLK_UNKNOWNS], t[ROWS];
} rows;

/* ------------------------------------------------------------------------------------ the equations */

int flk_solve_normal(int n, double H[][FLK_UNKNOWNS], const double *g, double *x)
{
    int i, j, k;

    for (j = 0; j < n; j++)
        for (i = j; i < n; i++) {
            double sum = H[i][j];

            for (k = 0; k < j; k++)
                sum -= H[i][k] * H[j][k];
            if (i == j && !(sum > 0))
                return 0;
            H[i][j] = i == j ? sqrt(sum) : sum / H[j][j];
        }
    for (i = 0; i < n; i++) {
        x[i] = g[i];
        for (k = 0; k < i; k++)
            x[i] -= H[i][k] * x[k];
        x[i] /= H[i][i];
    }
    for (i = n - 1; i >= 0; i--) {
        for (k = i + 1; k < n; k++)
            x[i] -= H[k][i] * x[k];
        x[i] /= H[i][i];
    }
    return 1;
}

static double within_bounds(double x, double low, double high)
{
    return GSL_MAX_DBL(low, GSL_MIN_DBL(x, high));
}

static void put_part(rows *row, int k, double x, double y)
{
    row->J[X][k] = x;
    row->J[Y][k] = y;
}

/* P = A + (D - A) m and its derivatives. */
static void set_derivatives_of_pose(const flk_shape *shape, const double *x, const flk_pose *pose,
                                    fourlink_vector m, rows *row)
{
    double zx = x[FLK_DX] - x[FLK_AX], zy = x[FLK_DY] - x[FLK_AY], ground = zx * zx + zy * zy;
    fourlink_vector e = pose->coupler, turned; /* turned: i q e^(i theta3) */
    double mx, my;
    int k;

    put_part(row, FLK_AX, 1 - m.x, -m.y);
    put_part(row, FLK_AY, m.y, 1 - m.x);
    put_part(row, FLK_DX, m.x, m.y);
    put_part(row, FLK_DY, -m.y, m.x);
    put_part(row, FLK_QX, zx * e.x - zy * e.y, zx * e.y + zy * e.x);
    put_part(row, FLK_QY, -row->J[Y][FLK_QX], row->J[X][FLK_QX]);
    turned.x = -(x[FLK_QX] * e.y + x[FLK_QY] * e.x);
    turned.y = x[FLK_QX] * e.x - x[FLK_QY] * e.y;
    for (k = 0; k < 4; k++) {
        mx = turned.x * pose->turn[k];
        my = turned.y * pose->turn[k];
        mx += k < 3 ? shape->by[0][k] * pose->crank.x : -shape->ratio[0] * pose->crank.y;
        my += k < 3 ? shape->by[0][k] * pose->crank.y : shape->ratio[0] * pose->crank.x;
        put_part(row, FLK_SHAPE + k, zx * mx - zy * my, zx * my + zy * mx);
        row->J[TURN][FLK_SHAPE + k] = pose->turn[k];
    }
    row->J[TURN][FLK_AX] = zy / ground; /* of the direction of AD */
    row->J[TURN][FLK_AY] = -zx / ground;
    row->J[TURN][FLK_DX] = -zy / ground;
    row->J[TURN][FLK_DY] = zx / ground;
    row->J[TURN][FLK_ATTITUDE] = -1;
}

/* The row of the transmission angle at a crank angle: 0 while it is large enough. */
static void set_transmission(const flk_points *p, const flk_shape *shape, double theta2, rows *row)
{
    double by[4], cosine, excess, side;
    int k;

    row->r[MU] = 0;
    if (!(p->most_cosine < 1))
        return;
    cosine = flk_transmission(shape, theta2, by);
    excess = fabs(cosine) - p->most_cosine;
    if (!(excess > 0))
        return;
    side = cosine < 0 ? -p->stiffness : p->stiffness;
    row->r[MU] = p->stiffness * excess;
    for (k = 0; k < 4; k++)
        row->J[MU][FLK_SHAPE + k] = side * by[k];
}

/* The rows of a position; 0 if the linkage does not reach it. */
static int set_rows(const flk_points *p, const flk_trial *at, const flk_shape *shape,
                    unsigned long j, int with_derivatives, rows *row)
{
    const double *x = at->x;
    double zx = x[FLK_DX] - x[FLK_AX], zy = x[FLK_DY] - x[FLK_AY];
    flk_pose pose;
    fourlink_vector m;
    int i, k;

    if (!flk_pose_at(shape, at->theta2[j], &pose))
        return 0;
    m.x = shape->ratio[0] * pose.crank.x + x[FLK_QX] * pose.coupler.x - x[FLK_QY] * pose.coupler.y;
    m.y = shape->ratio[0] * pose.crank.y + x[FLK_QX] * pose.coupler.y + x[FLK_QY] * pose.coupler.x;
    row->r[X] = p->root[j] * (x[FLK_AX] + zx * m.x - zy * m.y - p->point[j].x);
    row->r[Y] = p->root[j] * (x[FLK_AY] + zx * m.y + zy * m.x - p->point[j].y);
    row->r[TURN] = p->has_angle ? p->root[j] * flk_reduced(atan2(zy, zx) +
                                                           atan2(pose.coupler.y, pose.coupler.x) -
                                                           x[FLK_ATTITUDE] - p->angle[j])
                                : 0;
    memset(row->J, 0, sizeof row->J);
    if (with_derivatives)
        set_derivatives_of_pose(shape, x, &pose, m, row);
    for (i = X; i <= TURN && with_derivatives; i++)
        for (k = 0; k < FLK_UNKNOWNS; k++)
            row->J[i][k] *= p->root[j];
    set_transmission(p, shape, at->theta2[j], row);
    for (i = X; i < ROWS; i++) {
        row->t[i] = row->J[i][FLK_START];
        if (!p->has_timing)
            row->J[i][FLK_START] = 0;
    }
    return 1;
}

/* The rows of the transmission angle where it may be least between the positions: at 0 and 180 deg, of a
** slider-crank at 90 and 270 deg, if the working range has them.  Returns how many. */
static int set_extremes(const flk_points *p, const flk_trial *at, const flk_shape *shape,
                        rows row[2])
{
    double low = at->theta2[0], high = low, first = shape->is_slider ? M_PI_2 : 0, extreme;
    unsigned long j;
    int n = 0, k;

    if (!(p->most_cosine < 1))
        return 0;
    for (j = 1; j < p->n; j++) {
        low = GSL_MIN_DBL(low, at->theta2[j]);
        high = GSL_MAX_DBL(high, at->theta2[j]);
    }
    for (k = 0; k < 2; k++) {
        extreme = first + M_PI * k;
        extreme += 2 * M_PI * ceil((low - extreme) / (2 * M_PI));
        if (!(extreme <= high))
            continue;
        memset(&row[n], 0, sizeof row[n]);
        set_transmission(p, shape, extreme, &row[n]);
        row[n++].J[MU][FLK_START] = 0;
    }
    return n;
}

/* A length of the linkage, and its derivatives. */
typedef struct length {
    double size, by[FLK_UNKNOWNS];
} length;

/* The lengths of the links, g = |D - A| times their ratios: all four, or crank and rod; returns how many. */
static int lengths_of(const flk_trial *at, const flk_shape *shape, length list[4])
{
    double zx = at->x[FLK_DX] - at->x[FLK_AX], zy = at->x[FLK_DY] - at->x[FLK_AY];
    double g = sqrt(zx * zx + zy * zy), ratio;
    int n = shape->is_slider ? 2 : 4, i, k;

    memset(list, 0, 4 * sizeof *list);
    for (i = 0; i < n; i++) {
        ratio = i ? shape->ratio[i - 1] : 1;
        list[i].size = g * ratio;
        list[i].by[FLK_AX] = -zx / g * ratio;
        list[i].by[FLK_AY] = -zy / g * ratio;
        list[i].by[FLK_DX] = zx / g * ratio;
        list[i].by[FLK_DY] = zy / g * ratio;
        for (k = 0; k < 3 && i; k++)
            list[i].by[FLK_SHAPE + k] = g * shape->by[i - 1][k];
    }
    return n;
}

/* The rows of lengths and of their ratio that are beyond their bounds; returns how many. */
static int set_length_rows(const flk_points *p, const flk_trial *at, const flk_shape *shape,
                           rows *row)
{
    length list[4];
    int n_links = lengths_of(at, shape, list), least = 0, most = 0, n = 0, i, k;
    double bound;

    for (i = 0; i < n_links; i++) {
        least = list[i].size < list[least].size ? i : least;
        most = list[i].size > list[most].size ? i : most;
        bound = within_bounds(list[i].size, p->shortest, p->longest);
        if (list[i].size == bound)
            continue;
        memset(&row[n], 0, sizeof row[n]);
        row[n].r[BOUND] = p->stiffness * (list[i].size - bound);
        for (k = 0; k < FLK_UNKNOWNS; k++)
            row[n].J[BOUND][k] = p->stiffness * list[i].by[k];
        n++;
    }
    if (!(list[most].size > p->length_ratio * list[least].size))
        return n;
    memset(&row[n], 0, sizeof row[n]);
    row[n].r[BOUND] = p->stiffness * log(list[most].size / (p->length_ratio * list[least].size));
    for (k = 0; k < FLK_UNKNOWNS; k++)
        row[n].J[BOUND][k] = p->stiffness * (list[most].by[k] / list[most].size -
                                             list[least].by[k] / list[least].size);
    return n + 1;
}

/* The rows of all bounds; returns how many. */
static int set_bound_rows(const flk_points *p, const flk_trial *at, const flk_shape *shape,
                          rows row[BOUNDS])
{
    int n = p->is_bounded ? set_extremes(p, at, shape, row) : 0;

    return p->is_bounded ? n + set_length_rows(p, at, shape, row + n) : 0;
}

/* The sum of squares of a trial, or any above `most`; infinite if a position is not reached. */
static double sum_of_squares(const flk_points *p, const flk_trial *at, double most)
{
    unsigned long j;
    flk_shape shape;
    double sum = 0;
    rows row, bound[BOUNDS];
    int n, i;

    flk_shape_of(p, at, &shape);
    n = set_bound_rows(p, at, &shape, bound);
    for (i = 0; i < n; i++)
        sum += bound[i].r[BOUND] * bound[i].r[BOUND];
    for (j = 0; j < p->n && sum <= most; j++) {
        if (!set_rows(p, at, &shape, j, 0, &row))
            return GSL_POSINF;
        for (i = 0; i < ROWS; i++)
            sum += row.r[i] * row.r[i];
    }
    return sum;
}

static void add_row(const rows *row, int i, sums *s)
{
    int k, l;

    for (k = 0; k < FLK_UNKNOWNS; k++) {
        s->g[k] -= row->J[i][k] * row->r[i];
        for (l = 0; l <= k; l++)
            s->H[k][l] += row->J[i][k] * row->J[i][l];
    }
}

/* Add the rows of a position to the sums. */
static void add_rows(const flk_points *p, const rows *row, unsigned long j, sums *s)
{
    double *c = s->c[j];
    int i, k, l;

    s->s[j] = TINY;
    s->tr[j] = 0;
    memset(c, 0, sizeof s->c[j]);
    for (i = 0; i < ROWS; i++) {
        if ((i == TURN && !p->has_angle) || (i == MU && row->r[MU] == 0))
            continue;
        add_row(row, i, s);
        s->s[j] += row->t[i] * row->t[i];
        s->tr[j] += row->t[i] * row->r[i];
        for (k = 0; k < FLK_UNKNOWNS; k++)
            c[k] += row->J[i][k] * row->t[i];
    }
    for (k = 0; k < FLK_UNKNOWNS && !p->has_timing; k++) {
        s->h[k] += c[k] * s->tr[j] / s->s[j];
        for (l = 0; l <= k; l++)
            s->G[k][l] += c[k] * c[l] / s->s[j];
    }
}

static int set_sums(const flk_points *p, const flk_trial *at, sums *s)
{
    unsigned long j;
    flk_shape shape;
    rows row, bound[BOUNDS];
    int n;

    memset(s->H, 0, sizeof s->H);
    memset(s->g, 0, sizeof s->g);
    memset(s->G, 0, sizeof s->G);
    memset(s->h, 0, sizeof s->h);
    flk_shape_of(p, at, &shape);
    for (j = 0; j < p->n; j++) {
        if (!set_rows(p, at, &shape, j, 1, &row))
            return 0;
        add_rows(p, &row, j, s);
    }
    for (n = set_bound_rows(p, at, &shape, bound); n > 0; n--)
        add_row(&bound[n - 1], BOUND, s);
    return 1;
}

/* ------------------------------------------------------------------------------------- the descent */

/* Whether an unknown stays at its bound: it is given, or the sum is less beyond. */
static int is_held(const flk_points *p, const flk_trial *at, int k, double downhill)
{
    return p->low[k] == p->high[k] || (at->x[k] <= p->low[k] && downhill <= 0) ||
           (at->x[k] >= p->high[k] && downhill >= 0);
}

/* A step from `at`; 0 if there is none. */
static int damped_step(const flk_points *p, const flk_trial *at, const sums *s, double damping,
                       flk_trial *next)
{
    double A[FLK_UNKNOWNS][FLK_UNKNOWNS], g[FLK_UNKNOWNS], dx[FLK_UNKNOWNS], turn;
    int held[FLK_UNKNOWNS], k, l;
    unsigned long j;

    for (k = 0; k < FLK_UNKNOWNS; k++) {
        g[k] = s->g[k] + s->h[k] / (1 + damping);
        held[k] = is_held(p, at, k, s->g[k] + s->h[k]);
        for (l = 0; l <= k; l++)
            A[k][l] = held[k] || held[l] ? 0 : s->H[k][l] - s->G[k][l] / (1 + damping);
        A[k][k] = held[k] ? 1 : A[k][k] + damping * s->H[k][k] + TINY;
        g[k] = held[k] ? 0 : g[k];
    }
    if (!flk_solve_normal(FLK_UNKNOWNS, A, g, dx))
        return 0;
    for (k = 0; k < FLK_UNKNOWNS; k++) {
        next->x[k] = within_bounds(at->x[k] + dx[k], p->low[k], p->high[k]);
        dx[k] = next->x[k] - at->x[k];
    }
    for (j = 0; j < p->n; j++) {
        if (p->has_timing) {
            next->theta2[j] = next->x[FLK_START] + at->sense * p->timing[j];
            continue;
        }
        turn = -s->tr[j];
        for (k = 0; k < FLK_UNKNOWNS; k++)
            turn -= s->c[j][k] * dx[k];
        next->theta2[j] =
            at->theta2[j] + within_bounds(turn / (s->s[j] * (1 + damping)), -WIDEST, WIDEST);
    }
    next->sign = at->sign;
    next->sense = at->sense;
    next->turns_fully = at->turns_fully;
    return 1;
}

void flk_descend(const flk_points *p, flk_trial *at, int steps, double last_decrease)
{
    double damping = 1e-2, rest;
    flk_trial next;
    sums s;

    at->sum = sum_of_squares(p, at, GSL_POSINF);
    for (; steps > 0 && at->sum > 0 && at->sum < GSL_POSINF; steps--) {
        if (!set_sums(p, at, &s))
            return;
        do {
            next.sum = damped_step(p, at, &s, damping, &next) ? sum_of_squares(p, &next, at->sum)
                                                              : GSL_POSINF;
            damping *= 3;
        } while (!(next.sum < at->sum) && damping < 1e8);
        if (!(next.sum < at->sum))
            return;
        rest = next.sum / at->sum;
        memcpy(at->x, next.x, sizeof at->x);
        memcpy(at->theta2, next.theta2, p->n * sizeof *at->theta2);
        at->sum = next.sum;
        if (rest > 1 - last_decrease)
            return;
        damping = GSL_MAX_DBL(damping / 27, 1e-14);
    }
}

static double square_of(const rows *row)
{
    return row->r[X] * row->r[X] + row->r[Y] * row->r[Y] + row->r[TURN] * row->r[TURN];
}

/* Turn the crank of one position to where the point is nearest: dtheta = -t'r / t't, halved if it is too
** much.  Where the curve bends much that is slow; the second derivative by differences, d(t'r)/dtheta,
** is quick. */
static void settle(const flk_points *p, flk_trial *at, const flk_shape *shape, unsigned long j)
{
    double theta2 = at->theta2[j], turn = 0, square, slope, last = 0, tr, tt;
    rows row;
    int steps, i;

    if (!set_rows(p, at, shape, j, 1, &row))
        return;
    for (steps = 0; steps < SETTLING; steps++) {
        square = square_of(&row);
        for (tr = tt = 0, i = X; i <= TURN; i++) {
            tr += row.t[i] * row.r[i];
            tt += row.t[i] * row.t[i];
        }
        slope = steps > 0 ? (tr - last) / turn : 0;
        if (slope < 0 && tr * turn < 0)
            turn *= 2; /* downhill, ever steeper */
        else
            turn = -tr / (slope > 0 ? slope : tt + TINY);
        last = tr;
        for (turn = within_bounds(turn, -WIDEST, WIDEST); fabs(turn) > SETTLED; turn /= 2) {
            at->theta2[j] = theta2 + turn;
            if (set_rows(p, at, shape, j, 1, &row) && square_of(&row) < square)
                break;
        }
        if (!(fabs(turn) > SETTLED))
            break;
        theta2 = at->theta2[j];
    }
    at->theta2[j] = theta2;
}

void flk_settle(const flk_points *p, flk_trial *at)
{
    unsigned long j;
    flk_shape shape;

    if (p->has_timing || p->most_cosine < 1)
        return;
    flk_shape_of(p, at, &shape);
    for (j = 0; j < p->n; j++)
        settle(p, at, &shape, j);
    at->sum = sum_of_squares(p, at, GSL_POSINF);
}

/* P = A + (D - A) r2 e^(i theta2) + Y e^(i theta3), Y = (D - A) q: linear in A, D and Y. */
int flk_fit_pivots(const flk_points *p, flk_trial *at)
{
    double H[6][FLK_UNKNOWNS], g[6], y[6], row[2][6], rest, ground;
    flk_shape shape;
    flk_pose pose;
    unsigned long j;
    int i, k, l;

    memset(H, 0, sizeof H);
    memset(g, 0, sizeof g);
    flk_shape_of(p, at, &shape);
    for (j = 0; j < p->n; j++) {
        double weight = p->root[j] * p->root[j], mx, my;

        if (!flk_pose_at(&shape, at->theta2[j], &pose))
            return 0;
        mx = shape.ratio[0] * pose.crank.x;
        my = shape.ratio[0] * pose.crank.y;
        row[0][0] = row[1][1] = 1 - mx;
        row[0][1] = my;
        row[1][0] = -my;
        row[0][2] = row[1][3] = mx;
        row[0][3] = -my;
        row[1][2] = my;
        row[0][4] = row[1][5] = pose.coupler.x;
        row[0][5] = -pose.coupler.y;
        row[1][4] = pose.coupler.y;
        for (i = 0; i < 2; i++) {
            rest = i == 0 ? p->point[j].x : p->point[j].y;
            for (k = 0; k < 4; k++)
                if (p->low[k] == p->high[k])
                    rest -= row[i][k] * p->low[k];
            for (k = 0; k < 6; k++) {
                g[k] += weight * row[i][k] * rest;
                for (l = 0; l <= k; l++)
                    H[k][l] += weight * row[i][k] * row[i][l];
            }
        }
    }
    for (k = 0; k < 6; k++) {
        int is_given = k < 4 && p->low[k] == p->high[k];

        for (l = 0; l <= k; l++)
            if (is_given || (l < 4 && p->low[l] == p->high[l]))
                H[k][l] = 0;
        H[k][k] = is_given ? 1 : H[k][k] * (1 + 1e-10) + TINY;
        g[k] = is_given ? p->low[k] : g[k];
    }
    if (!flk_solve_normal(6, H, g, y))
        return 0;
    memcpy(at->x, y, 4 * sizeof *y);
    y[0] = at->x[FLK_DX] - at->x[FLK_AX];
    y[1] = at->x[FLK_DY] - at->x[FLK_AY];
    ground = y[0] * y[0] + y[1] * y[1];
    if (!(ground > 0))
        return 0;
    at->x[FLK_QX] = (y[4] * y[0] + y[5] * y[1]) / ground;
    at->x[FLK_QY] = (y[5] * y[0] - y[4] * y[1]) / ground;
    for (k = 0; k < FLK_SHAPE; k++)
        at->x[k] = within_bounds(at->x[k], p->low[k], p->high[k]);
    return 1;
}
