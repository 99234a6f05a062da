/* The C interface of Lancret: hair grown at render time between guides.
 *
 * Plain C89, so that any renderer, DCC or script can load it; liblancret_procedural.so
 * exports these functions and nothing else.
 *
 *     lancret_context *context;
 *     lancret_groom *groom;
 *     lancret_source source = {sizeof source};
 *     source.path = "head.toml";
 *     lancret_context_create(LANCRET_ABI_VERSION, NULL, &context);
 *     lancret_groom_open(context, &source, &groom, error, sizeof error);
 *     lancret_groom_get_info(groom, &info);
 *     for (i = 0; i < info.chunks; ++i) lancret_groom_expand_chunk(groom, i, &options,
 * sink, user); lancret_groom_close(groom); lancret_context_destroy(context);
 *
 * Rules that hold for every function:
 * - It may be called from any number of threads at once, on the same handles too, except
 *   that a handle is closed once, when no other call uses it.
 * - It returns a status, throws nothing, prints nothing, and keeps no state but in the
 *   handles. Strings are UTF-8. A null pointer where something is needed, or an index out
 *   of range, is LANCRET_BAD_CALL.
 * - Structs begin with their size, to be set by the caller to sizeof: what a newer
 * library knows and an older caller does not is taken as 0, which is always the default.
 * - Lengths are in cm, unless options.unit says otherwise; times are frames, as an artist
 *   counts them; boxes are minimum x y z, maximum x y z.
 * - The same groom, chunk and options give the same bits, for any number of threads, any
 *   order of the chunks, and whether others are expanded or not.
 */
#ifndef LANCRET_PROCEDURAL_H
#define LANCRET_PROCEDURAL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef LANCRET_API
#define LANCRET_API
#endif

/* Raised when an older caller would no longer work. */
#define LANCRET_ABI_VERSION 2

typedef unsigned int lancret_u32; /* 32 bits */

typedef int lancret_status;
enum {
    LANCRET_OK = 0,
    LANCRET_BAD_INPUT = 1,     /* a file or a parameter: the error says which line */
    LANCRET_BAD_CALL = 2,      /* the caller's mistake */
    LANCRET_OUT_OF_MEMORY = 3, /* the host's allocator or the system has none left */
    LANCRET_CANCELLED = 4,     /* the host's cancel callback said so */
    LANCRET_FAILED = 5         /* anything else: a mistake in Lancret */
};

enum { LANCRET_LOG_INFO = 0, LANCRET_LOG_WARNING = 1, LANCRET_LOG_ERROR = 2 };

/* Callbacks come from any thread, several at once. Any of them may be null. The error of
 * a call is logged on the thread that calls, before the call returns. */
typedef struct lancret_host {
    size_t size;
    void* user; /* handed to every callback */
    void (*log)(void* user, int level, const char* text);
    /* Memory of the arrays that are handed to a sink, or pass by on the way to buffers;
     * `alignment` is a power of two up to 64. Null is out of memory. Both or neither. */
    void* (*allocate)(void* user, size_t bytes, size_t alignment);
    void (*release)(void* user, void* memory, size_t bytes);
    /* Asked as a call begins, and every few milliseconds by a thread of the context's
     * own; non-zero: all calls stop soon, with LANCRET_CANCELLED. */
    int (*cancelled)(void* user);
    int threads; /* at most so many at once for one call; 0: as many as the machine has */
} lancret_host;

/* Holds what grooms share: guides that were loaded once are loaded no more, told by their
 * files, parameters and frame. */
typedef struct lancret_context lancret_context;

/* The library's own version, "0.1.0", and the ABI's. */
LANCRET_API const char* lancret_version(void);
LANCRET_API int lancret_abi_version(void);

/* `abi_version` is LANCRET_ABI_VERSION: another one than the library's is
 * LANCRET_BAD_CALL. `host` may be null, and is copied. */
LANCRET_API lancret_status lancret_context_create(int abi_version,
                                                  const lancret_host* host,
                                                  lancret_context** context);
/* Grooms and chunks of the context must be closed before. */
LANCRET_API void lancret_context_destroy(lancret_context* context);

/* A value laid over the groom's own: name "strands.count", "guides.file", ... as in its
 * TOML; text where it is a string, else null and number (booleans 0 and 1; a seed beyond
 * 2^53 is a text of digits). guides.count takes the place of a share that the groom says,
 * and the other way round. Lists can only be said in the TOML. What is wrong is told as
 * of the file, without a line. */
typedef struct lancret_parameter {
    const char* name;
    const char* text;
    double number;
} lancret_parameter;

/* Strands and scalp that the host has in memory; copied. All in the scene's units. */
enum {
    LANCRET_LINEAR = 0,
    LANCRET_BSPLINE = 1,
    LANCRET_CATMULL_ROM = 2,
    LANCRET_BEZIER = 3,
    LANCRET_HERMITE = 4
};
typedef struct lancret_strands {
    size_t size;
    int basis; /* of the points: LANCRET_BSPLINE, CATMULL_ROM, or LINEAR, which is that */
    lancret_u32 strands;
    const lancret_u32* counts; /* [strands], points of each, >= 2, of B-splines >= 4 */
    const float* points;       /* [sum of counts][3], root first */
} lancret_strands;
typedef struct lancret_mesh {
    size_t size;
    lancret_u32 vertices, triangles;
    const float* positions;     /* [vertices][3] */
    const lancret_u32* corners; /* [triangles][3] */
    const float* uvs;           /* [triangles][3][2], or null */
} lancret_mesh;

/* Where a groom comes from: a file (.toml, .hair, .h5), a TOML's text, or strands. */
typedef struct lancret_source {
    size_t size;
    const char* path;   /* or null */
    const char* text;   /* or null; both: the text, and errors name the path */
    const char* folder; /* that file names in `text` start from; null: that of `path`,
                         * else the current one */
    const lancret_parameter* parameters;
    size_t parameter_count;
    const lancret_strands* strands; /* in place of the groom's file, not of a cache */
    const lancret_mesh* scalp;      /* in place of the scalp's file, or null */
    lancret_u32 chunk_strands;      /* at most, up to a million; 0: 4096 */
} lancret_source;

typedef struct lancret_groom lancret_groom;

/* Loads, fits guides, says where strands stand and cuts them into chunks; expands none.
 * Where it fails, `error` (if not null) has one line with file and place, cut to
 * `error_size` bytes. The TOML's tables [camera], [light], [material], [render],
 * [dynamics] and [[colliders]] belong to others and are left alone. Grooms of a context
 * with the same source, whose files have not changed, are one in memory; those with
 * strands or a scalp of the host's are not. */
LANCRET_API lancret_status lancret_groom_open(lancret_context* context,
                                              const lancret_source* source,
                                              lancret_groom** groom, char* error,
                                              size_t error_size);
LANCRET_API void lancret_groom_close(lancret_groom* groom);

/* How strands are meant to be drawn. */
enum {
    LANCRET_ANY_SHAPE = 0, /* as the host likes */
    LANCRET_FLAT = 1,      /* bands that face the viewer */
    LANCRET_ROUND = 2,
    LANCRET_RIBBON = 3 /* bands with a face of their own: LANCRET_NORMALS */
};
typedef struct lancret_info {
    size_t size;
    lancret_u32 chunks;
    lancret_u32 strands; /* of all chunks at density 1 */
    lancret_u32 guides, segments;
    lancret_u32 intervals;       /* the most a strand has */
    lancret_u32 neighbours;      /* guides a strand */
    int first_frame, last_frame; /* of its cache; both 0 where nothing moves */
    float cm_per_unit;           /* of the scene's unit */
    float up[3];
    double load_seconds, fit_seconds, bind_seconds;
    size_t bytes; /* kept while the groom is open, for all that share it; guides of the 16
                   * times asked for last, or as many as a call had, come to that */
    int frames;   /* of its cache; 0: nothing moves */
    int basis;    /* that the groom asks for: LANCRET_BSPLINE or LANCRET_HERMITE */
    int shape;    /* LANCRET_ANY_SHAPE, ... */
    float box[6]; /* of the guides at rest, cm: what to frame; children may leave it */
} lancret_info;
LANCRET_API lancret_status lancret_groom_get_info(const lancret_groom* groom,
                                                  lancret_info* info);

/* What guides were fitted to, and how well, as JSON: {groom_strands, guides, segments,
 * blend, fit.{rms_over_length_median, _p95, _max}, roots.{snapped, largest_snap_cm}}. */
typedef void (*lancret_text_sink)(void* user, const char* text);
LANCRET_API lancret_status lancret_groom_describe(const lancret_groom* groom,
                                                  lancret_text_sink sink, void* user);

/* Takes the head at some time, cm; what it points to is gone when it returns. Another
 * status than LANCRET_OK is passed on. */
typedef lancret_status (*lancret_mesh_sink)(void* user, const lancret_mesh* mesh);
/* What is seen of the head at a time, handed over once; without a head no vertices. */
LANCRET_API lancret_status lancret_groom_get_head(const lancret_groom* groom, double time,
                                                  lancret_mesh_sink sink, void* user);

/* Whether guides and head are at all of these times just where they are at the first: the
 * strands of one time are those of all. */
LANCRET_API lancret_status lancret_groom_is_still(const lancret_groom* groom,
                                                  const double* times, size_t time_count,
                                                  int* still);

/* What a chunk is asked for. Attributes: */
enum {
    LANCRET_TANGENTS = 1, /* a point: along the strand; Hermite curves have them always */
    LANCRET_NORMALS = 2,  /* a point: the face of ribbons, unit */
    LANCRET_IDS = 4,      /* a strand: the same at any density and chunk size */
    LANCRET_ROOT_UV = 8,  /* a strand */
    LANCRET_LENGTHS = 16, /* a strand */
    LANCRET_GUIDES = 32,  /* a strand: guide indices and weights, `neighbours` each */
    LANCRET_ARC_LENGTHS = 64, /* a point: from the root */
    LANCRET_RANDOM = 128      /* a strand: uniform in [0, 1), drawn by its id */
};
typedef struct lancret_options {
    size_t size;
    const double* times; /* [time_count] frames, parts of them too, held before the first
                          * and after the last; 0 of them: the first frame, or rest */
    size_t time_count;   /* at most 256 */
    int basis;           /* LANCRET_BSPLINE, ... */
    float max_error;     /* that the curves may be off the strand, 1e-4 cm at least, as
                          * measured on thousands of strands, or 1024 intervals and a
                          * warning; 0: the groom's own. Strands that need fewer points
                          * have fewer, but for those with normals and where the groom
                          * says strands.adapt = false */
    double density; /* share of strands grown, wider, 1e-6 at least; 0: the groom's own */
    double pixels;  /* that the chunk covers, for: */
    double strands_per_pixel; /* at most so many; 0: no level of detail */
    lancret_u32 attributes;
    float unit; /* cm of a unit of what is given back; 0: 1 */
} lancret_options;

/* A chunk at some times. Pointers are null for what was not asked for. */
typedef struct lancret_curves {
    size_t size;
    int basis;
    lancret_u32 strands, points, times, neighbours;
    const lancret_u32* counts;     /* [strands] points of each */
    const float* const* positions; /* [times] -> [points][4]: x y z radius */
    const float* const* tangents;  /* [times] -> [points][4]: of Hermite curves the
                                    * derivative by the segment, w that of the radius;
                                    * else unit, w 0 */
    const float* const* normals;   /* [times] -> [points][4], w 0; of B-splines and
                                    * Catmull-Rom hardly unit beyond the ends */
    const lancret_u32* ids;        /* [strands] */
    const float* root_uv;          /* [strands][2]; 0 0 without a scalp */
    const float* lengths;          /* [strands] */
    const lancret_u32* guides;     /* [strands][neighbours] */
    const float* weights;          /* [strands][neighbours] */
    const float* arc_lengths;      /* [points], beyond the ends where points are */
    const float* random;           /* [strands] */
} lancret_curves;

/* A box that holds the chunk with its widths at the options' times, and between them as
 * curves whose points go straight from one to the next; minima above maxima where there
 * is nothing. LANCRET_REACH costs next to nothing and is wide; LANCRET_TIGHT synthesises
 * the chunk and forgets it. */
enum { LANCRET_REACH = 0, LANCRET_TIGHT = 1 };
LANCRET_API lancret_status lancret_groom_get_chunk_box(const lancret_groom* groom,
                                                       lancret_u32 chunk,
                                                       const lancret_options* options,
                                                       int kind, float box[6]);

/* Takes what a chunk has become. What it points to is gone when it returns; another
 * status than LANCRET_OK ends the expansion with that status. */
typedef lancret_status (*lancret_sink)(void* user, const lancret_curves* curves);

/* Expands a chunk, hands it to the sink once, on the thread that calls, and forgets it.
 * No strands, where a density leaves none, are handed over too. */
LANCRET_API lancret_status lancret_groom_expand_chunk(const lancret_groom* groom,
                                                      lancret_u32 chunk,
                                                      const lancret_options* options,
                                                      lancret_sink sink, void* user);

/* The same into the host's own memory, in steps: bind a chunk, ask for its sizes, give
 * buffers, free it; its groom may be closed before. Any number of times, in any order,
 * chunks side by side. */
typedef struct lancret_chunk lancret_chunk;
LANCRET_API lancret_status lancret_chunk_open(const lancret_groom* groom,
                                              lancret_u32 chunk,
                                              const lancret_options* options,
                                              lancret_chunk** bound);
/* Everything of lancret_curves but its pointers, which become null. */
LANCRET_API lancret_status lancret_chunk_get_sizes(const lancret_chunk* bound,
                                                   lancret_curves* sizes);
/* Writes to the memory that `buffers` points to (casting away const); what is null is not
 * written. positions, tangents and normals are aligned to 16 bytes. */
LANCRET_API lancret_status lancret_chunk_write(const lancret_chunk* bound,
                                               const lancret_curves* buffers);
LANCRET_API void lancret_chunk_close(lancret_chunk* bound);

/* What binding had to work around: numbers of the chunk's strands. */
typedef struct lancret_chunk_info {
    size_t size;
    lancret_u32 strands;
    size_t bytes; /* kept while the chunk is open */
    lancret_u32 no_facing_guide, no_guide_in_reach, no_guide_in_sight, no_guide_in_region,
        opposed_root_frames, straight_guides;
} lancret_chunk_info;
LANCRET_API lancret_status lancret_chunk_get_info(const lancret_chunk* bound,
                                                  lancret_chunk_info* info);

typedef struct lancret_check {
    size_t size;
    lancret_u32 strands, failed, outside; /* outside: of them, beyond the tight bound */
    double orthogonality;                 /* max |R^T R - 1| of the frames */
    double length_error;                  /* max, relative, of the strand */
    double curve_length_error;            /* max, relative, of the curve as emitted */
    double distance;                      /* max, from the curve to the strand, cm */
} lancret_check;
/* Looks at every strand of a chunk, at the first of the options' times. */
LANCRET_API lancret_status lancret_groom_check_chunk(const lancret_groom* groom,
                                                     lancret_u32 chunk,
                                                     const lancret_options* options,
                                                     lancret_check* check);

/* Figures of a chunk's strands at one of its times, by its place among them, strand after
 * strand: of each strand one; or one at each end of its n curve segments, n + 1; or one
 * in each of these, n. What is not a finite number is the largest float. Frames that are
 * carried without twist have no torsion, and a groom without regions none:
 * LANCRET_BAD_INPUT. */
enum {
    LANCRET_LENGTH_ERROR = 0,  /* a strand: relative, of what was synthesised */
    LANCRET_ORTHOGONALITY = 1, /* an end: |R^T R - 1| of the frame */
    LANCRET_CURVATURE = 2,     /* a segment: 1/cm */
    LANCRET_TORSION = 3,       /* a segment: 1/cm, right-handed above 0 */
    LANCRET_REGION = 4         /* a strand: its region's number */
};
LANCRET_API lancret_status lancret_chunk_get_figures(const lancret_chunk* bound,
                                                     int figure, size_t time,
                                                     float* values);

/* The guides: `segments` helices each, roots first. Pointers live as long as the groom.
 */
typedef struct lancret_guides {
    size_t size;
    lancret_u32 guides, segments;
    const double* root_positions; /* [guides][3] cm */
    const double* root_frames; /* [guides][3][3] columns: tangent, first, second axis */
    const double* segment_lengths; /* [guides][segments] cm */
    const double* curvatures;      /* [guides][segments][3] twist, two bends, 1/cm */
    const double* fit_rms;         /* [guides] cm from the strands that they were fitted
                                    * to; null where the file held guides */
} lancret_guides;
LANCRET_API lancret_status lancret_groom_get_guides(const lancret_groom* groom,
                                                    lancret_guides* guides);

/* Leave-out measurement of the groom's strands, each blend's figures as JSON, in the form
 * of `lancret evaluate --json`. Guides are as many as the groom says, else 5 %. */
LANCRET_API lancret_status lancret_context_evaluate(lancret_context* context,
                                                    const lancret_source* source,
                                                    lancret_text_sink sink, void* user,
                                                    char* error, size_t error_size);

#ifdef __cplusplus
}
#endif

#endif
