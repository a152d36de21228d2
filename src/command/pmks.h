/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pmks.h - a link of PMKS+, the page on which linkages are drawn.
*/
#ifndef FOURLINK_PMKS_H
#define FOURLINK_PMKS_H

#include "base/text.h"

#define PMKS_MOST 100 /* joints, links, forces */

typedef struct pmks_joint {
    text name, links; /* names of links, with | between them */
    double x, y;
    int slides, is_fixed, is_input;
    text direction; /* of its slide, rad */
    double angle;   /* the same, deg */
} pmks_joint;

typedef struct pmks_body {
    text name, joints;
    double mass, inertia, x, y;
    int has_mass;
} pmks_body;

typedef struct pmks_force {
    text name, link;
    double x, y, to_x, to_y; /* tail and tip of its arrow */
    int is_fixed;            /* 1: its direction; 0: it turns with the link */
    double size;             /* negative: against the arrow */
} pmks_force;

/* Its units of length, and those of mass, inertia and force that belong to them; null: not known. */
typedef struct pmks_units {
    const char *length, *mass, *inertia, *force;
} pmks_units;

typedef struct pmks_link {
    const char *file;
    long line; /* of the link in the file */
    char *words;
    pmks_joint joints[PMKS_MOST];
    pmks_body bodies[PMKS_MOST];
    pmks_force forces[PMKS_MOST];
    size_t n_joints, n_bodies, n_forces;
    int has_positions, has_friction;
    double speed; /* rpm, positive */
    int is_clockwise, has_gravity;
    const pmks_units *units; /* null: not read */
} pmks_link;

/* Read the first link of a file; `k` is of zeros but for the file's name.  0: it has a mistake, which is
** told, or memory has failed.  pmks_free in either case. */
int pmks_read(pmks_link *k, text t);
void pmks_free(pmks_link *k);

/* Tell a mistake of the link, and return 0; tell what has no place in a deck. */
int pmks_refuse(const pmks_link *k, const char *format, ...);
void pmks_note(const pmks_link *k, const char *format, ...);

/* 1 if a list of names has this one; take the next name off a list; 1 if two names are the same. */
int pmks_has_name(text list, text name);
int pmks_next_name(text *list, text *name);
int pmks_is_same(text a, text b);

#endif
