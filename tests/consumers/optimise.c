/* SPDX-License-Identifier: GPL-3.0-or-later
**
** optimise.c - a deck in, the coupler and the rocker with the best transmission angle out, in strict
** C90: GSL's simplex method sets two lengths and asks for mu_min.
*/
#include <stdio.h>
#include <fourlink.h>
#include <gsl/gsl_multimin.h>

typedef struct machine {
    fourlink_results *results;
    int lengths[2], mu_min; /* handles */
} machine;

static double minus_mu_min(const gsl_vector *x, void *data)
{
    const machine *m = data;
    fourlink_value v;

    if (fourlink_results_put(m->results, 2, m->lengths, x->data, NULL) != FOURLINK_OK ||
        fourlink_results_get(m->results, m->mu_min, FOURLINK_OPEN, 0, &v) != FOURLINK_OK)
        return 0; /* not a linkage */
    return -v.value;
}

/* The handle of a number, with the value that the deck has, in the unit of its line. */
static int handle_of(fourlink_results *results, const char *name, double *value)
{
    fourlink_value v;

    if (fourlink_results_input(results, name, &v) != FOURLINK_OK)
        return 0;
    *value = v.value;
    return v.handle;
}

static void minimise(machine *m, const double *start)
{
    gsl_multimin_fminimizer *simplex =
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2);
    gsl_vector *x = gsl_vector_alloc(2), *steps = gsl_vector_alloc(2);
    gsl_multimin_function f;
    int i;

    f.n = 2;
    f.f = minus_mu_min;
    f.params = m;
    for (i = 0; i < 2; i++) {
        gsl_vector_set(x, (size_t)i, start[i]);
        gsl_vector_set(steps, (size_t)i, 0.02 * start[i]);
    }
    gsl_multimin_fminimizer_set(simplex, &f, x, steps);
    for (i = 0; i < 400 && gsl_multimin_fminimizer_size(simplex) > 1e-9; i++)
        gsl_multimin_fminimizer_iterate(simplex);
    printf("coupler %.3f mm, rocker %.3f mm: mu_min = %.3f deg\n", gsl_vector_get(simplex->x, 0),
           gsl_vector_get(simplex->x, 1), -simplex->fval);
    gsl_multimin_fminimizer_free(simplex);
    gsl_vector_free(x);
    gsl_vector_free(steps);
}

int main(void)
{
    static char text[10000];
    static fourlink_source source;
    double start[2]; /* mm, as the deck has them */
    fourlink_value mu_min;
    machine m;

    source.text = text;
    source.length = (unsigned long)fread(text, 1, sizeof text, stdin);
    if (fourlink_results_open(&source, 0, &m.results, NULL, NULL) != FOURLINK_OK)
        return 1;
    m.lengths[0] = handle_of(m.results, "coupler.length", &start[0]);
    m.lengths[1] = handle_of(m.results, "rocker.length", &start[1]);
    if (fourlink_results_find(m.results, "mu_min", &mu_min) != FOURLINK_OK)
        return 1;
    m.mu_min = mu_min.handle;
    minimise(&m, start);
    fourlink_results_free(m.results);
    return 0;
}
