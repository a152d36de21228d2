/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tracks.h - the numbers of a mechanism at an instant: places, velocities, accelerations, forces, torques.
**
** scene.h says what is drawn of them.  Over the motion each is a track.
*/
#ifndef FOURLINK_TRACKS_H
#define FOURLINK_TRACKS_H

#include "view.h"

/* What a drawing has room for. */
enum { TRACKS_LOADS = 42, TRACKS_POINTS = 24, TRACKS_SPRINGS = TRACKS_LOADS, TRACKS_NAME = 16 };

/* The numbers of the tracks; of some there are several.  A centre of mass, or a tracer point, has its place
** and behind that its velocity and its acceleration. */
enum {
    TRACK_A, /* the joints, by letter */
    TRACK_B,
    TRACK_C,
    TRACK_D,
    TRACK_E1, /* ends of the lever */
    TRACK_E2,
    TRACK_VB,
    TRACK_VC,
    TRACK_VCB,
    TRACK_VB4, /* of the point of the lever at B */
    TRACK_VS,  /* along the slide */
    TRACK_ABN, /* normal and tangential */
    TRACK_ABT,
    TRACK_ACBN,
    TRACK_ACBT,
    TRACK_ACN,
    TRACK_ACT,
    TRACK_AC,
    TRACK_AB4N,
    TRACK_AB4T,
    TRACK_AB4,
    TRACK_AK, /* Coriolis */
    TRACK_AS,
    TRACK_FORCE,                    /* F12, F23, F34, F14: of joint i */
    TRACK_COUPLE = TRACK_FORCE + 4, /* of a slider */
    TRACK_TS = TRACK_COUPLE + 4,
    TRACK_CENTRE,                                        /* of link i, from 0 */
    TRACK_WEIGHT = TRACK_CENTRE + 3 * 5,                 /* of link i */
    TRACK_INERTIA_FORCE = TRACK_WEIGHT + 5,              /* -m a */
    TRACK_INERTIA_TORQUE = TRACK_INERTIA_FORCE + 5,      /* -I alpha */
    TRACK_POINT = TRACK_INERTIA_TORQUE + 5,              /* tracer point i */
    TRACK_LOAD = TRACK_POINT + 3 * TRACKS_POINTS,        /* the place of load i, */
    TRACK_LOAD_FORCE = TRACK_LOAD + TRACKS_LOADS,        /* its force */
    TRACK_LOAD_TORQUE = TRACK_LOAD_FORCE + TRACKS_LOADS, /* and its torque */
    TRACK_SPRING = TRACK_LOAD_TORQUE + TRACKS_LOADS,     /* both ends of spring i */
    TRACK_DRIVE = TRACK_SPRING + 2 * TRACKS_SPRINGS, /* load i of what drives, if not the crank: */
    TRACK_DRIVE_FORCE = TRACK_DRIVE + 2,
    TRACK_DRIVE_TORQUE = TRACK_DRIVE_FORCE + 2,
    TRACK_COUNT = TRACK_DRIVE_TORQUE + 2
};

#define TRACK_OF_CENTRE(link) (TRACK_CENTRE + 3 * (link))
#define TRACK_OF_POINT(i) (TRACK_POINT + 3 * (int)(i))

/* The track of a joint's place. */
#define TRACK_OF_JOINT(joint) (TRACK_A + (joint)->letter[0] - 'A')

/* A vector, or a number, which is x, in SI units. */
typedef struct track {
    int is_there; /* 0: this mechanism has none */
    quantity q;
    fourlink_vector v;
} track;

typedef struct tracks {
    const view *v;
    track list[TRACK_COUNT];
} tracks;

/* The numbers at an instant; where the linkage cannot be assembled those of the crank alone.  The deck has no
** more of anything than there is room for. */
void tracks_find(tracks *t, const view *v, const fourlink_instant *now, const fourlink_load *loads);

/* The places alone at a position; 1 for those that a drawing needs room for: pins, points, ends of
** springs. */
void tracks_find_places(tracks *t, const view *v, const fourlink_state *state);
int tracks_is_outline(const tracks *t, int number);

/* The vector of a track; 0 if there is none. */
fourlink_vector tracks_vector(const tracks *t, int number);

/* What a disc is called in the file: G2, P0. */
char *tracks_name(const char *before, unsigned long i, char name[TRACKS_NAME]);

#endif
