/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.c - [sweep]: the designs that a deck varies its quantities over.
**
** Ranges and lists are combined in all ways, the last one changing fastest; of each combination there are
** as many samples as the deck says if there are tolerances.  What a design is depends on its index alone:
** its random numbers are the first of a generator whose seed is made of the deck's seed and the index.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include "base/number.h"
#include "reader.h"

#define MOST_DESIGNS 4e9 /* an unsigned long holds it on every machine */

/* How one quantity is varied. */
typedef struct variation {
    enum { VARY_LIST, VARY_RANGE, VARY_TOLERANCE } form;
    setting first;     /* the range's first value, or the nominal one */
    double step, size; /* of a range, and the larger of its ends, in the unit of the first value */
    double tolerance;  /* in the unit of the nominal value */
    int is_normal;
    text list;
    double count;        /* of values; 1 for a tolerance */
    unsigned long index; /* of the value that this design has */
} variation;

/* A tab is a blank. */
static int is_at(text t, size_t i, const char *separator)
{
    for (; *separator; separator++, i++)
        if (t.start[i] != *separator && !(t.start[i] == '\t' && *separator == ' '))
            return 0;
    return 1;
}

static void cut(text t, size_t i, size_t n, text *before, text *after)
{
    before->start = t.start;
    before->length = i;
    after->start = t.start + i + n;
    after->length = t.length - i - n;
    *before = flk_text_trim(*before);
    *after = flk_text_trim(*after);
}

/* The words before and after a separator, if it is there: the first one, or the last. */
static int cut_at(text t, const char *separator, text *before, text *after)
{
    size_t n = strlen(separator), i;

    for (i = 0; i + n <= t.length; i++)
        if (is_at(t, i, separator)) {
            cut(t, i, n, before, after);
            return 1;
        }
    return 0;
}

static int cut_at_last(text t, const char *separator, text *before, text *after)
{
    size_t n = strlen(separator), i;

    for (i = t.length; i >= n; i--)
        if (is_at(t, i - n, separator)) {
            cut(t, i - n, n, before, after);
            return 1;
        }
    return 0;
}

static text next_item(text *rest)
{
    text item = {"", 0};

    flk_text_split(rest, ',', &item);
    return flk_text_trim(item);
}

/* A quantity in the unit of another. */
static int read_in_unit_of(parser *p, const setting *first, text t, quantity q, double *number)
{
    setting s = *first;
    double si;

    s.value = t;
    if (!flk_read_quantity(p, &s, t, q, &si))
        return 0;
    *number = s.unit.up == first->unit.up && s.unit.down == first->unit.down
                  ? s.number
                  : flk_unit_from_si(si, first->unit);
    return 1;
}

/* 1 if both have a unit, or neither; else 0 and a mistake: nobody means 100 rad/s to 300 rpm by
** "100 to 300 rpm". */
static int units_agree(parser *p, const variation *v, text x, text y)
{
    double number;

    flk_number_read(&x, &number);
    flk_number_read(&y, &number);
    if ((flk_text_trim(x).length > 0) == (flk_text_trim(y).length > 0))
        return 1;
    flk_mistake_note(&p->d->mistakes, v->first.place,
                     "the values of a quantity have either all a unit or none", (char *)NULL);
    return 0;
}

/* A to B step S; A to B in N */
static int read_range(parser *p, text t, quantity q, variation *v)
{
    text to, last, step, number;
    double end, si, steps;
    int in_steps;

    cut_at(t, " to ", &last, &to);
    in_steps = !cut_at(to, " step ", &last, &step);
    if (in_steps && !cut_at_last(to, " in ", &last, &number)) { /* or inches: 1 in to 2 in in 3 */
        flk_mistake_note(&p->d->mistakes, v->first.place,
                         "a range needs its step, '20 mm to 30 mm step 2 mm', or the number of its "
                         "values, '20 mm to 30 mm in 6'",
                         (char *)NULL);
        return 0;
    }
    v->form = VARY_RANGE;
    cut_at(t, " to ", &v->first.value, &to);
    if (!flk_read_quantity(p, &v->first, v->first.value, q, &si) ||
        !units_agree(p, v, v->first.value, last) || !read_in_unit_of(p, &v->first, last, q, &end))
        return 0;
    v->size = fabs(end) > fabs(v->first.number) ? fabs(end) : fabs(v->first.number);
    if (in_steps) {
        if (flk_number_read(&number, &steps) != NUMBER_OK || flk_text_trim(number).length ||
            steps < 2 || steps != floor(steps)) {
            flk_mistake_note(&p->d->mistakes, v->first.place,
                             "the number of values of a range is a whole number from 2 up",
                             (char *)NULL);
            return 0;
        }
        v->count = steps;
        v->step = (end - v->first.number) / (steps - 1);
        if (v->step == 0)
            flk_mistake_note(&p->d->mistakes, v->first.place,
                             "the first value of the range is its last", (char *)NULL);
        return v->step != 0;
    }
    if (!units_agree(p, v, v->first.value, step) ||
        !read_in_unit_of(p, &v->first, step, q, &v->step))
        return 0;
    if (!((end - v->first.number) * v->step > 0)) {
        flk_mistake_note(&p->d->mistakes, v->first.place,
                         "the step of the range does not lead from its first value to its last",
                         (char *)NULL);
        return 0;
    }
    v->count = floor((end - v->first.number) / v->step * (1 + 1e-12) + 1e-9) + 1;
    return 1;
}

static void note_tolerance(parser *p, const variation *v, text t)
{
    char word[WORD_SIZE];

    flk_mistake_note(&p->d->mistakes, v->first.place,
                     "expected a tolerance, such as 0.1 mm or 0.5 %, not '", flk_word_of(t, word),
                     "'", (char *)NULL);
}

/* A +- T, A +- T normal */
static int read_tolerance(parser *p, text nominal, text t, const key_info *key, variation *v)
{
    char a[WORD_SIZE], b[WORD_SIZE];
    text before, after;
    double si;

    v->form = VARY_TOLERANCE;
    v->count = 1;
    v->first.value = nominal;
    if (cut_at_last(t, " ", &before, &after) &&
        (flk_text_equal(after, "normal") || flk_text_equal(after, "uniform"))) {
        v->is_normal = flk_text_equal(after, "normal");
        t = before;
    }
    if (memchr(nominal.start, ',', nominal.length) || cut_at(nominal, " to ", &before, &after)) {
        flk_mistake_note(&p->d->mistakes, v->first.place,
                         "a tolerance is of one value, not of a list or a range", (char *)NULL);
        return 0;
    }
    if (!flk_read_quantity(p, &v->first, nominal, key->q, &si))
        return 0;
    if (!t.length) {
        note_tolerance(p, v, t);
        return 0;
    }
    if (t.start[t.length - 1] == '%') {
        before = t;
        if (flk_number_read(&before, &v->tolerance) != NUMBER_OK ||
            !flk_text_same(flk_text_trim(before), "%")) {
            note_tolerance(p, v, t);
            return 0;
        }
        if (v->first.number == 0) {
            flk_mistake_note(&p->d->mistakes, v->first.place,
                             "a tolerance in per cent is of a value other than 0", (char *)NULL);
            return 0;
        }
        v->tolerance *= fabs(v->first.number) / 100;
    } else if (!units_agree(p, v, nominal, t) ||
               !read_in_unit_of(p, &v->first, t, key->q, &v->tolerance)) {
        return 0;
    }
    if (!(v->tolerance > 0)) {
        flk_mistake_note(&p->d->mistakes, v->first.place, "the tolerance must be positive, not ",
                         flk_word_of(t, a), (char *)NULL);
        return 0;
    }
    if (key->sign != SIGN_ANY && v->tolerance >= v->first.number) {
        flk_mistake_note(&p->d->mistakes, v->first.place, "the tolerance, ", flk_word_of(t, a),
                         ", is not smaller than the ", key->name, ", ", flk_word_of(nominal, b),
                         (char *)NULL);
        return 0;
    }
    return 1;
}

/* A, B, C */
static int read_list(parser *p, text t, quantity q, variation *v)
{
    text rest = t, first = t;
    setting s = v->first;
    double si;

    v->form = VARY_LIST;
    v->list = t;
    while (rest.start) {
        s.value = next_item(&rest);
        if (!s.value.length && !rest.start && v->count > 0)
            break; /* a comma at the very end */
        if (!flk_read_quantity(p, &s, s.value, q, &si) ||
            (v->count > 0 && !units_agree(p, v, first, s.value)))
            return 0;
        if (v->count == 0)
            first = s.value;
        v->count++;
    }
    return 1;
}

static int read_variation(parser *p, const setting *named, const key_info *key, variation *v)
{
    static const char *const signs[] = {"\302\261", "+/-", "+-"};
    text before, after;
    size_t i;

    memset(v, 0, sizeof *v);
    v->first = *named;
    for (i = 0; i < sizeof signs / sizeof signs[0]; i++)
        if (cut_at(named->value, signs[i], &before, &after))
            return read_tolerance(p, before, after, key, v);
    if (cut_at(named->value, " to ", &before, &after))
        return read_range(p, named->value, key->q, v);
    return read_list(p, named->value, key->q, v);
}

/* The generator of a design, in memory of the caller: GSL's own tells its error handler when there is none. */
#define GENERATOR gsl_rng_mt19937
#define STATE_SIZE 5120

typedef struct generator {
    gsl_rng rng;
    double state[STATE_SIZE / sizeof(double)];
} generator;

#define BITS 0xffffffffUL

/* The last steps of MurmurHash3 (A. Appleby, 2011): a one-to-one map of 32 bits that leaves no pattern. */
static unsigned long mixed(unsigned long x)
{
    x ^= x >> 16;
    x = x * 0x85ebca6bUL & BITS;
    x ^= x >> 13;
    x = x * 0xc2b2ae35UL & BITS;
    return x ^ x >> 16;
}

static int start_generator(generator *g, double seed, unsigned long design)
{
    g->rng.type = GENERATOR;
    g->rng.state = g->state;
    if (g->rng.type->size > sizeof g->state)
        return 0;
    gsl_rng_set(&g->rng,
                mixed((mixed(design & BITS) + mixed(((unsigned long)seed + 1) & BITS)) & BITS));
    return 1;
}

/* Within the tolerance: uniform, or normal with a standard deviation of a third of it, what is outside
** being drawn again. */
static double draw(const variation *v, const gsl_rng *rng)
{
    double x;

    if (!v->is_normal)
        return v->tolerance * (2 * gsl_rng_uniform(rng) - 1);
    do
        x = gsl_ran_gaussian(rng, v->tolerance / 3);
    while (fabs(x) > v->tolerance);
    return x;
}

/* To 15 digits of the range's size: 0.3, where 3 * 0.1 is a little more, and 0, not 5e-17. */
static double rounded(double x, double size)
{
    int digits = 14 - (int)floor(log10(size));
    double power = digits >= 0 && digits <= 22 ? pow(10, digits) : 0;

    return power > 0 && size * power < 1e16 ? floor(x * power + 0.5) / power : x;
}

/* Set a quantity to its value of index `i`. */
static void set_value(const variation *v, unsigned long i, const gsl_rng *rng, setting *s)
{
    s->is_given = v->form != VARY_LIST;
    if (v->form == VARY_LIST) {
        text rest = v->list, item = next_item(&rest);

        while (i-- > 0)
            item = next_item(&rest);
        s->value = item;
        return;
    }
    s->value = v->first.value;
    s->unit = v->first.unit;
    s->number = v->form == VARY_RANGE ? rounded(v->first.number + (double)i * v->step, v->size)
                                      : v->first.number + draw(v, rng);
}

/* 1 for what a range or a list of values can be of; an indicator card is a curve always. */
static int can_vary(const key_info *key)
{
    return key->form == FORM_QUANTITY || (key->form == FORM_CURVE && key->q != QUANTITY_PRESSURE);
}

/* The part that a name such as load F.force.size means; it is taken off. */
static vector_part part_of(text *name)
{
    static const char *const parts[] = {"x", "y", "size", "angle"};
    text rest = *name, section, key, part;
    size_t i;

    /* SECTION.KEY.PART */
    if (!cut_at_last(rest, ".", &key, &part) || !cut_at_last(key, ".", &section, &rest))
        return PART_NONE;
    for (i = 0; i < sizeof parts / sizeof parts[0]; i++)
        if (flk_text_equal(part, parts[i])) {
            *name = key;
            return (vector_part)(PART_X + i);
        }
    return PART_NONE;
}

/* The vector of which a part varies.  A point that the deck does not give is the link's origin; a force
** it has to give. */
static setting *find_vector(parser *p, const named_value *named, text key_name, key_info *key)
{
    static const text nowhere = {NULL, 0};
    size_t before = p->d->mistakes.count;
    setting *s = flk_set_key(p, named->s.place, key_name, nowhere);
    char word[WORD_SIZE];

    if (s)
        *key = flk_key_table[flk_key_of(p, s)];
    if (s && !s->place.source && key->form == FORM_POINT) {
        s->place = named->s.place;
        s->value = flk_text_of("(0, 0)");
    }
    if (s && s->place.source && (key->form == FORM_POINT || key->form == FORM_VECTOR))
        return s;
    if (p->d->mistakes.count == before && !p->out_of_memory)
        flk_mistake_note(&p->d->mistakes, named->s.place, "'", flk_word_of(key_name, word),
                         s && key->form == FORM_VECTOR ? "' is not given: only a part of it varies"
                                                       : "' has no parts that can be varied",
                         (char *)NULL);
    return NULL;
}

/* The key that a name of [sweep] means, as its setting; null and a mistake if it is no quantity. */
static setting *find_quantity(parser *p, text name, text_place place, text value, key_info *key)
{
    size_t before = p->d->mistakes.count;
    char word[WORD_SIZE];
    setting *s = flk_set_key(p, place, name, value);

    if (s)
        *key = flk_key_table[flk_key_of(p, s)];
    if (s && can_vary(key))
        return s;
    if (s)
        s->is_void = 1;
    if (p->d->mistakes.count == before && !p->out_of_memory)
        flk_mistake_note(&p->d->mistakes, place, "'", flk_word_of(name, word),
                         s && (key->form == FORM_POINT || key->form == FORM_VECTOR)
                             ? "' has parts: vary its .x, .y, .size or .angle"
                             : "' is no quantity that can be varied",
                         (char *)NULL);
    return NULL;
}

/* As these two; `part` tells which of them. */
static setting *find_key(parser *p, const named_value *named, key_info *key, vector_part *part)
{
    text name = named->name;
    setting *s;

    if (!memchr(name.start, '.', name.length)) {
        char word[WORD_SIZE];

        flk_mistake_note(&p->d->mistakes, named->s.place, "unknown key '", flk_word_of(name, word),
                         "' in [sweep]; a quantity is named with its section, such as crank.length",
                         (char *)NULL);
        return NULL;
    }
    *part = part_of(&name);
    if (*part == PART_NONE)
        return find_quantity(p, name, named->s.place, named->s.value, key);
    s = find_vector(p, named, name, key);
    key->sign = SIGN_ANY;
    if (*part == PART_ANGLE)
        key->q = QUANTITY_ANGLE;
    return s;
}

/* Samples belong to tolerances. */
static void check_samples(parser *p, const section_use *use, int has_tolerance)
{
    const setting *samples = flk_find(p, KEY_SWEEP_SAMPLES), *seed = flk_find(p, KEY_SWEEP_SEED);

    if (seed && seed->si[0] > (double)BITS)
        flk_mistake_note(&p->d->mistakes, seed->place, "the seed must be less than 4294967296",
                         (char *)NULL);
    if (has_tolerance && !samples)
        flk_mistake_note(&p->d->mistakes, use->place,
                         "a tolerance needs 'samples = NUMBER' in [sweep]", (char *)NULL);
    if (!has_tolerance && samples)
        flk_mistake_note(&p->d->mistakes, samples->place,
                         "samples are of a tolerance, such as 66 mm +- 0.1 mm, and there is none",
                         (char *)NULL);
    if (!p->d->sweep.n_variables)
        flk_mistake_note(&p->d->mistakes, use->place,
                         "[sweep] varies nothing: give it a line such as 'crank.length = 20 mm to "
                         "30 mm step 2 mm'",
                         (char *)NULL);
}

/* A value that gives rise to no other mistake. */
static void set_placeholder(parser *p, const key_info *key, setting *s)
{
    s->is_given = 1;
    s->number = 1;
    s->unit = p->d->units[key->q].unit;
}

/* 1, and a mistake, if the setting is varied already: the same part of it, or one that another depends
** on. */
static int is_twice(parser *p, const named_value *named, size_t place, vector_part part)
{
    char word[WORD_SIZE];
    size_t i;

    for (i = 0; i < p->d->sweep.n_variables; i++) {
        const deck_variable *v = &p->d->sweep.variables[i];

        if (v->setting != place)
            continue;
        if (v->part == (int)part)
            flk_mistake_note(&p->d->mistakes, named->s.place, "'", flk_word_of(named->name, word),
                             "' is varied a second time", (char *)NULL);
        else if ((v->part >= PART_SIZE) != (part >= PART_SIZE))
            flk_mistake_note(&p->d->mistakes, named->s.place, "'", flk_word_of(named->name, word),
                             "' and another part: vary x and y, or size and angle", (char *)NULL);
        else
            continue;
        return 1;
    }
    return 0;
}

/* Where the value of a variable is set. */
static setting *place_of(parser *p, size_t i)
{
    const deck_variable *v = &p->d->sweep.variables[i];

    return v->part == PART_NONE ? &p->settings[v->setting] : &p->parts[i];
}

static void set_values(parser *p, variation *list, double samples, unsigned long design)
{
    const setting *seed = flk_find(p, KEY_SWEEP_SEED);
    deck_sweep *sweep = &p->d->sweep;
    unsigned long rest = design / (unsigned long)samples;
    size_t i;
    generator g;

    if (!start_generator(&g, seed ? seed->si[0] : 1, design)) {
        p->out_of_memory = 1;
        return;
    }
    /* digits of the design's number: from the last, which changes fastest */
    for (i = sweep->n_variables; i-- > 0;) {
        list[i].index = rest % (unsigned long)list[i].count;
        rest /= (unsigned long)list[i].count;
    }
    for (i = 0; i < sweep->n_variables; i++)
        set_value(&list[i], list[i].index, &g.rng, place_of(p, i));
}

/* Read the variables of [sweep]; how many designs, 0 and mistakes if something is wrong. */
static double read_variables(parser *p, variation *list, double samples, int *has_tolerance)
{
    size_t before = p->d->mistakes.count, n = p->n_named, i;
    double designs = samples;

    for (i = 0; i < n && !p->out_of_memory; i++) {
        deck_sweep *sweep = &p->d->sweep;
        named_value named = p->named[i]; /* a name such as expect.x moves the list */
        vector_part part;
        deck_variable *new;
        key_info key;
        setting *s;

        if (p->uses[named.use].section != SECTION_SWEEP)
            continue;
        s = find_key(p, &named, &key, &part);
        if (!s)
            continue;
        if (part == PART_NONE)
            set_placeholder(p, &key, s);
        if (is_twice(p, &named, (size_t)(s - p->settings), part) ||
            !read_variation(p, &named.s, &key, &list[sweep->n_variables]))
            continue;
        designs *= list[sweep->n_variables].count;
        *has_tolerance |= list[sweep->n_variables].form == VARY_TOLERANCE;
        p->parts[sweep->n_variables].place = named.s.place;
        p->parts[sweep->n_variables].value = named.s.value;
        new = &sweep->variables[sweep->n_variables++];
        new->name = named.name;
        new->q = key.q;
        new->part = (int)part;
        new->setting = (size_t)(s - p->settings);
    }
    return p->d->mistakes.count == before ? designs : 0;
}

void flk_read_sweep(parser *p, unsigned long design)
{
    section_use *use = flk_find_use(p, SECTION_SWEEP);
    const setting *s;
    text_place place;
    double designs, samples;
    int has_tolerance = 0;
    variation *list;
    size_t before = p->d->mistakes.count;

    if (!use)
        return;
    place = use->place;
    flk_read_section(p, use);
    s = flk_find(p, KEY_SWEEP_SAMPLES);
    samples = s && s->si[0] > 0 ? s->si[0] : 1;
    list = malloc((p->n_named + 1) * sizeof *list);
    p->parts = calloc(p->n_named + 1, sizeof *p->parts);
    p->d->sweep.variables = calloc(p->n_named + 1, sizeof *p->d->sweep.variables);
    if (!list || !p->parts || !p->d->sweep.variables) {
        free(list);
        p->out_of_memory = 1;
        return;
    }
    designs = read_variables(p, list, samples, &has_tolerance);
    if (designs > 0)
        check_samples(p, flk_find_use(p, SECTION_SWEEP), has_tolerance);
    if (designs > MOST_DESIGNS)
        flk_mistake_note(&p->d->mistakes, place, "more than 4e9 designs", (char *)NULL);
    if (designs > 0 && p->d->mistakes.count == before && !p->out_of_memory) {
        p->d->sweep.n_designs = (unsigned long)designs;
        set_values(p, list, samples, design);
    }
    if ((s = flk_find(p, KEY_SWEEP_OUTPUT)) != NULL) {
        p->d->sweep.output.names = s->value;
        p->d->sweep.output.place = s->place;
    }
    free(list);
}

/* Put the parts that vary into a vector: x and y, or size and angle, each from the deck where it does not
** vary. */
static void set_parts_of(parser *p, size_t place)
{
    const deck_sweep *sweep = &p->d->sweep;
    double *v = p->settings[place].si, x, y;
    double part[PART_ANGLE + 1];
    int is_polar = 0;
    size_t i;

    part[PART_X] = v[0];
    part[PART_Y] = v[1];
    part[PART_SIZE] = gsl_hypot(v[0], v[1]);
    part[PART_ANGLE] = atan2(v[1], v[0]);
    for (i = 0; i < sweep->n_variables; i++)
        if (sweep->variables[i].part != PART_NONE && sweep->variables[i].setting == place) {
            part[sweep->variables[i].part] = p->parts[i].si[0];
            is_polar = sweep->variables[i].part >= PART_SIZE;
        }
    flk_direction_of(part[PART_ANGLE], &x, &y);
    v[0] = is_polar ? part[PART_SIZE] * x : part[PART_X];
    v[1] = is_polar ? part[PART_SIZE] * y : part[PART_Y];
}

void flk_set_parts(parser *p)
{
    const deck_sweep *sweep = &p->d->sweep;
    size_t i, k;

    for (i = 0; i < sweep->n_variables && sweep->n_designs; i++) {
        setting *s = &p->parts[i];
        const deck_variable *v = &sweep->variables[i];

        if (v->part != PART_NONE && s->is_given)
            flk_read_given(p, s, v->q);
        else if (v->part != PART_NONE)
            flk_read_quantity(p, s, s->value, v->q, &s->si[0]);
    }
    for (i = 0; i < sweep->n_variables && sweep->n_designs; i++) {
        for (k = 0; k < i && sweep->variables[k].setting != sweep->variables[i].setting; k++)
            ;
        if (k == i && sweep->variables[i].part != PART_NONE) /* the first of its vector */
            set_parts_of(p, sweep->variables[i].setting);
    }
}

void flk_build_sweep(parser *p)
{
    size_t i;

    for (i = 0; i < p->d->sweep.n_variables; i++) {
        deck_variable *v = &p->d->sweep.variables[i];

        v->value = flk_in_deck_unit(p, place_of(p, i), v->q);
    }
}
