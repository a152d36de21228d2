/* SPDX-License-Identifier: GPL-3.0-or-later
**
** linear.c - the linear systems of synthesis, and small things of the plane.
**
** Jacobi's singular value decomposition works in place.  gsl_multifit_linear and GSL's other decompositions
** allocate memory and call GSL's error handler if there is none.
*/
#include <float.h>
#include <math.h>

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>

#include "synthesis.h"

/* With columns of length 1, A = U S V', the shortest x with the smallest |A x - b| is
**
**    x = V S^-1 U' b,   condition = s1 / s3
**
** The columns of U are at right angles to 1e-13 only: the same of b - A x improves x. */
int flk_least_squares(unsigned long n, const double A[][3], const double *b, double x[3],
                      double *condition)
{
    double U[3 * FOURLINK_PRECISION_MAX], V[9], s[3], length[3], along[3], rest;
    gsl_matrix_view u = gsl_matrix_view_array(U, n, 3), v = gsl_matrix_view_array(V, 3, 3);
    gsl_vector_view singular = gsl_vector_view_array(s, 3);
    unsigned long i;
    int j, k, pass;

    for (j = 0; j < 3; j++) {
        for (i = 0, length[j] = 0; i < n; i++)
            length[j] = gsl_hypot(length[j], A[i][j]);
        if (!(length[j] > 0 && length[j] <= DBL_MAX))
            return FOURLINK_DEPENDENT;
        for (i = 0; i < n; i++)
            U[3 * i + (unsigned long)j] = A[i][j] / length[j];
    }
    gsl_linalg_SV_decomp_jacobi(&u.matrix, &v.matrix, &singular.vector);
    if (!(s[2] > FLK_NOTHING * s[0]))
        return FOURLINK_DEPENDENT;
    *condition = s[0] / s[2];
    x[0] = x[1] = x[2] = 0;
    for (pass = 0; pass < 2; pass++) {
        along[0] = along[1] = along[2] = 0;
        for (i = 0; i < n; i++) {
            rest = b[i] - A[i][0] * x[0] - A[i][1] * x[1] - A[i][2] * x[2];
            for (k = 0; k < 3; k++)
                along[k] += U[3 * i + (unsigned long)k] * rest;
        }
        for (j = 0; j < 3; j++)
            for (k = 0; k < 3; k++)
                x[j] += V[3 * j + k] * along[k] / s[k] / length[j];
    }
    return FOURLINK_OK;
}

gsl_complex flk_plane(const fourlink_vector *v)
{
    return gsl_complex_rect(v->x, v->y);
}

fourlink_vector flk_vector_of(gsl_complex z)
{
    fourlink_vector v;

    v.x = GSL_REAL(z);
    v.y = GSL_IMAG(z);
    return v;
}

int flk_are_within(const double *x, unsigned long n, double max)
{
    while (n > 0 && FLK_WITHIN(*x, max)) {
        x++;
        n--;
    }
    return n == 0;
}

int flk_points_within(const fourlink_vector *v, unsigned long n)
{
    unsigned long i;

    for (i = 0; i < n; i++)
        if (!FLK_BOTH_WITHIN(v[i], FOURLINK_LENGTH_MAX))
            return 0;
    return 1;
}

double flk_reduced(double angle)
{
    if (angle > -M_PI && angle <= M_PI)
        return angle;
    angle = fmod(angle, 2 * M_PI);
    return angle > M_PI ? angle - 2 * M_PI : angle <= -M_PI ? angle + 2 * M_PI : angle;
}
