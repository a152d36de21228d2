/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene.h - what a drawing of a mechanism consists of: polygons, forces and torques, by the numbers of
** their tracks.
**
** Pictures draw it at one instant, those of a report at each step of a motion.
*/
#ifndef FOURLINK_SCENE_H
#define FOURLINK_SCENE_H

#include "tracks.h"

/* ------------------------------------------------------------------------------------------ polygons */

/* A side from one corner to another. */
typedef struct scene_side {
    const char *name, *sub, *super; /* v_CB, a_B^n */
    int from, to;                   /* 0: the pole */
    int of;                         /* its track */
    int link;                       /* whose vector it is; 0: of none */
} scene_side;

enum { SCENE_SIDES = 8 }; /* at most */

/* The links of an output's sides. */
enum { SCENE_CARRYING = -1, SCENE_FLOATING = -2, SCENE_ROD = -3, SCENE_END = -4 };

typedef struct scene_polygon {
    const char *title; /* without "polygon" */
    quantity q;
    const char *zero; /* if all sides are 0 */
    const scene_side
        *sides; /* the last has no name; those without a track are not of this mechanism */
    const char *const *letters; /* of the corners; null: it has none */
    int lines[2][2];            /* from corner to corner; 0 and 0: none */
    const char *mark;           /* on the letters of the images, */
    int derivative;             /* and by how much their tracks are behind those of the places */
    int output;                 /* of a polygon of output i, i + 1; 0: of the four links */
    int first;                  /* the tracks of its sides are behind this one */
} scene_polygon;

/* Polygon k: of the four links and then of each output, of velocities and of accelerations. */
int scene_count_polygons(const view *v);
void scene_find_polygon(const view *v, int k, scene_polygon *found);

#define SCENE_NAME 40

/* The name of a side as notation.h marks it, the letter of a corner; the number of the link whose vector
** it is. */
const char *scene_name_of_side(const view *v, const scene_polygon *d, const scene_side *side,
                               char out[SCENE_NAME]);
const char *scene_letter(const view *v, const scene_polygon *d, int corner, char out[SCENE_NAME]);
int scene_link_of_side(const view *v, const scene_polygon *d, const scene_side *side);

/* The links that are drawn as free bodies, by number from 0: all but blocks of outputs; 0: there are no
** more. */
int scene_body(const view *v, int k);

/* ----------------------------------------------------------------------------------- forces, torques */

/* What a force or a torque is. */
typedef enum scene_sort { SCENE_PIN, SCENE_LOAD, SCENE_INERTIA } scene_sort;

/* A force, or a torque, on a link. */
typedef struct scene_force {
    const char *name; /* F_12, - m a_G2; that of a load is the deck's */
    char sub[TRACKS_NAME];
    int of, at; /* tracks of its values and of its place */
    int sign;   /* -1: a reaction to them */
    int on;     /* the link */
    scene_sort sort;
    int is_inner; /* 1: it is not in the drawing of the whole mechanism */
    int load;     /* FOURLINK_LOAD_OWN ...; 0: none */
} scene_force;

/* The image of a centre of mass, g_2, or of a tracer point in a polygon. */
typedef struct scene_image {
    const char *name;
    int link;   /* below its letter; 0: none */
    int of;     /* the track of its place */
    int output; /* i + 1 for a point of output i, in whose polygons it is; 0 */
} scene_image;

/* Pins with both directions, couples, weight and inertia of three links, loads, what drives; of an
** output the forces of three pins with both directions, and weight and inertia of two links. */
enum {
    SCENE_FORCES = 8 + 8 + 6 + TRACKS_LOADS + 2 + (6 + 4) * FOURLINK_MOST_GROUPS,
    SCENE_IMAGES = 3 + TRACKS_POINTS + 2 * FOURLINK_MOST_GROUPS
};

typedef struct scene {
    scene_image images[SCENE_IMAGES];
    int n_images;
    scene_force forces[SCENE_FORCES], torques[SCENE_FORCES];
    int n_forces, n_torques;
} scene;

/* The scene of a deck with at most so many loads and points as a drawing shows. */
void scene_find(scene *s, const view *v);

/* Its name: F and its links as subscripts; -m a with the subscript G, without the link; as notation.h marks
** it. */
char *scene_words(const scene_force *f, char *out, size_t size);

/* ------------------------------------------------------------------------------------------- springs */

/* 1 for a spring that has a coil, or a damper; it has one of them at least. */
int scene_has_coil(const fourlink_spring *spring);
int scene_has_damper(const fourlink_spring *spring);

/* The number of the joint at which a torsional spring is: that of its links, or of the ground and one of
** them. */
int scene_joint_of(const fourlink_spring *spring);

#endif
