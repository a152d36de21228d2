/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tracks.h - the numbers of a mechanism at an instant, by their names: places, velocities, accelerations,
** forces, torques.
**
** scene.h says what is drawn of them.  Over the motion each is a track.
*/
#ifndef FOURLINK_TRACKS_H
#define FOURLINK_TRACKS_H

#include "view.h"

enum { TRACKS_MOST = 504, TRACKS_NAME = 16 };

/* A vector, or a number, which is x, in SI units. */
typedef struct track {
    char name[TRACKS_NAME];
    quantity q;
    int is_number;
    fourlink_vector v;
} track;

typedef struct tracks {
    const view *v;
    int n;
    track list[TRACKS_MOST];
} tracks;

/* The numbers at an instant; where the linkage cannot be assembled those of the crank alone. */
void tracks_find(tracks *t, const view *v, const fourlink_instant *now, const fourlink_load *loads);

/* The places alone at a position; 1 for those that a drawing needs room for: pins, points, ends of
** springs. */
void tracks_find_places(tracks *t, const view *v, const fourlink_state *state);
int tracks_is_outline(const track *x);

/* The track of a name; null if there is none. */
const track *tracks_get(const tracks *t, const char *name);

/* Its vector; 0 if there is none. */
fourlink_vector tracks_vector(const tracks *t, const char *name);

/* The name of a track with a number: G2, P0. */
char *tracks_name(const char *before, unsigned long i, const char *after, char name[TRACKS_NAME]);

#endif
