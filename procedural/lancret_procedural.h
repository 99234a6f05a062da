/* The C interface of Lancret: hair strands grown between guide hairs at render time.
 *
 * Plain C89, for renderers, DCC applications and scripting languages.
 * liblancret_procedural.so exports these functions and nothing else.
 *
 *     lancret_context *context;
 *     lancret_groom *groom;
 *     lancret_source source = {sizeof source};
 *     source.path = "head.toml";
 *     lancret_context_create(LANCRET_ABI_VERSION, NULL, &context);
 *     lancret_groom_open(context, &source, &groom, error, sizeof error);
 *     lancret_groom_get_info(groom, &info);
 *     for (i = 0; i < info.chunks; ++i) {
 *         lancret_groom_expand_chunk(groom, i, &options, sink, user);
 *     }
 *     lancret_groom_close(groom);
 *     lancret_context_destroy(context);
 *
 * Rules for every function:
 * - Threads: any number of threads may call at once, also with the same handles. A handle
 *   is closed once, when no other call uses it.
 * - Errors: the result is a status. No function throws or prints, and all state is in the
 *   handles. A null pointer for a required argument, or an index out of range, is
 *   LANCRET_BAD_CALL.
 * - Structs begin with `size`, which the caller sets to sizeof the struct. A library
 *   newer than its caller takes the fields that the caller lacks as 0, which is always
 *   the default.
 * - Strings are null-terminated UTF-8.
 * - Units: lengths are in cm unless options.unit sets another unit. Times are frame
 *   numbers and may be fractional. Boxes are minimum x y z, maximum x y z.
 * - Determinism: the same groom, chunk and options give the same bits, whatever the
 *   number of threads, the order of the chunks, and which chunks are expanded.
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

/* Incremented when existing callers would break. */
#define LANCRET_ABI_VERSION 2

typedef unsigned int lancret_u32; /* 32 bits */

typedef int lancret_status;
enum {
    LANCRET_OK = 0,
    LANCRET_BAD_INPUT = 1,     /* a file or parameter is invalid; the error names it */
    LANCRET_BAD_CALL = 2,      /* the caller broke a rule of this interface */
    LANCRET_OUT_OF_MEMORY = 3, /* the host's allocator or the system returned none */
    LANCRET_CANCELLED = 4,     /* the host's `cancelled` callback returned non-zero */
    LANCRET_FAILED = 5         /* an internal error of Lancret */
};

enum { LANCRET_LOG_INFO = 0, LANCRET_LOG_WARNING = 1, LANCRET_LOG_ERROR = 2 };

/* Callbacks of the host. Each may be null. They are called from any thread, several at
 * once, and must not throw. */
typedef struct lancret_host {
    size_t size;
    void* user; /* passed to every callback */
    /* One line of text, valid during the callback. The error of a failed call is logged
     * on the calling thread before the call returns. */
    void (*log)(void* user, int level, const char* text);
    /* Memory for arrays that are passed to a sink, and for temporary arrays of
     * lancret_chunk_write. `alignment` is a power of two, at most 64. Null means out of
     * memory. Set both or neither. */
    void* (*allocate)(void* user, size_t bytes, size_t alignment);
    void (*release)(void* user, void* memory, size_t bytes);
    /* Called when a call begins, and every few milliseconds by a thread of the context
     * while calls run. Non-zero ends all running calls soon with LANCRET_CANCELLED. */
    int (*cancelled)(void* user);
    int threads; /* maximum per call; 0: all of the machine */
} lancret_host;

/* Shared by grooms: guides are loaded once and cached by file, parameters and frame. */
typedef struct lancret_context lancret_context;

/* Version of the library, such as "0.1.0"; static. Version of its interface. */
LANCRET_API const char* lancret_version(void);
LANCRET_API int lancret_abi_version(void);

/* Pass LANCRET_ABI_VERSION; LANCRET_BAD_CALL if the library has another version. `host`
 * is copied and may be null. */
LANCRET_API lancret_status lancret_context_create(int abi_version,
                                                  const lancret_host* host,
                                                  lancret_context** context);
/* Requires that all grooms and chunks of the context are closed. No-op for null. */
LANCRET_API void lancret_context_destroy(lancret_context* context);

/* An override of one groom setting. Errors name the parameter instead of a line. */
typedef struct lancret_parameter {
    const char* name; /* dotted TOML key, such as "strands.count" or "guides.file".
                       * guides.count and guides.share replace each other */
    const char* text; /* of a string, or the digits of a seed above 2^53; else null */
    double number;    /* if `text` is null; booleans are 0 or 1. Lists cannot be set */
} lancret_parameter;

/* Strands and a scalp in the host's memory, in the scene's unit. Both are copied. */
enum {
    LANCRET_LINEAR = 0,
    LANCRET_BSPLINE = 1,
    LANCRET_CATMULL_ROM = 2,
    LANCRET_BEZIER = 3,
    LANCRET_HERMITE = 4
};
typedef struct lancret_strands {
    size_t size;
    int basis; /* LANCRET_BSPLINE or LANCRET_CATMULL_ROM; LANCRET_LINEAR is the latter */
    lancret_u32 strands;
    const lancret_u32* counts; /* [strands] points per strand, >= 2; B-splines >= 4 */
    const float* points;       /* [sum of counts][3], root first */
} lancret_strands;
typedef struct lancret_mesh {
    size_t size;
    lancret_u32 vertices, triangles;
    const float* positions;     /* [vertices][3] */
    const lancret_u32* corners; /* [triangles][3] vertex indices */
    const float* uvs;           /* [triangles][3][2], or null */
} lancret_mesh;

/* Source of a groom: a file (.toml, .hair, .h5), TOML text, or strands. At least one of
 * `path`, `text` and `strands` is required. Read during the call only. */
typedef struct lancret_source {
    size_t size;
    const char* path;   /* or null */
    const char* text;   /* or null. With a path: read in place of that file, and errors
                         * name the path */
    const char* folder; /* base of relative file names in `text`; null: the folder of
                         * `path`, else the current one */
    const lancret_parameter* parameters;
    size_t parameter_count;
    const lancret_strands* strands; /* replace the groom's file, not a cache; or null */
    const lancret_mesh* scalp;      /* replaces the scalp's file; or null */
    lancret_u32 chunk_strands;      /* maximum per chunk, up to 1,000,000; 0: 4096 */
} lancret_source;

typedef struct lancret_groom lancret_groom;

/* Loads a groom, fits its guides, places its strands and divides them into chunks; grows
 * no strand. On failure *groom is null, and `error` (if not null) receives one line with
 * file and place, truncated to `error_size` bytes. The TOML tables [camera], [light],
 * [material], [render], [dynamics] and [[colliders]] are ignored. Grooms of a context
 * with the same source and unchanged files share memory, unless the source has strands or
 * a scalp. */
LANCRET_API lancret_status lancret_groom_open(lancret_context* context,
                                              const lancret_source* source,
                                              lancret_groom** groom, char* error,
                                              size_t error_size);
/* No-op for null. */
LANCRET_API void lancret_groom_close(lancret_groom* groom);

/* The shape that a groom requests for its strands. */
enum {
    LANCRET_ANY_SHAPE = 0, /* the renderer's choice */
    LANCRET_FLAT = 1,      /* bands that face the viewer */
    LANCRET_ROUND = 2,     /* tubes */
    LANCRET_RIBBON = 3     /* bands oriented by LANCRET_NORMALS */
};
typedef struct lancret_groom_info {
    size_t size;
    lancret_u32 chunks;
    lancret_u32 strands; /* in all chunks, at density 1 */
    lancret_u32 guides;
    lancret_u32 segments;        /* helices per guide */
    lancret_u32 intervals;       /* maximum per strand */
    lancret_u32 neighbours;      /* guides per strand */
    int first_frame, last_frame; /* of the cache; 0 if the groom is static */
    float cm_per_unit;           /* of the scene's unit */
    float up[3];                 /* the scene's up direction, unit length */
    double load_seconds, fit_seconds, bind_seconds;
    size_t bytes; /* held by the open groom, counted once for all handles that share it.
                   * Excludes posed guides: those of the last 16 times, or of as many
                   * times as any call had, are kept too */
    int frames;   /* in the cache; 0 if the groom is static */
    int basis;    /* that the groom requests: LANCRET_BSPLINE or LANCRET_HERMITE */
    int shape;    /* LANCRET_ANY_SHAPE, ... */
    float box[6]; /* of the guides at rest, cm, for framing; strands may leave it */
} lancret_groom_info;
LANCRET_API lancret_status lancret_groom_get_info(const lancret_groom* groom,
                                                  lancret_groom_info* info);

/* Passes the quality of the guide fit to `sink` once, as JSON: {groom_strands, guides,
 * segments, blend, fit.{rms_over_length_median, _p95, _max}, roots.{snapped,
 * largest_snap_cm}}. `text` is valid during the callback. */
typedef void (*lancret_text_sink)(void* user, const char* text);
LANCRET_API lancret_status lancret_groom_describe(const lancret_groom* groom,
                                                  lancret_text_sink sink, void* user);

/* Passes the visible head at `time` to `sink` once, in cm; no vertices if the groom has
 * no head. `mesh` is valid during the callback. A status of the sink other than
 * LANCRET_OK is returned. */
typedef lancret_status (*lancret_mesh_sink)(void* user, const lancret_mesh* mesh);
LANCRET_API lancret_status lancret_groom_get_head(const lancret_groom* groom, double time,
                                                  lancret_mesh_sink sink, void* user);

/* Sets *still to 1 if guides and head are the same at all of these times, else to 0. If
 * they are, one time has the strands of all. At least 1 and at most 256 times. */
LANCRET_API lancret_status lancret_groom_is_still(const lancret_groom* groom,
                                                  const double* times, size_t time_count,
                                                  int* still);

/* Attributes of a chunk request, to be combined with |. */
enum {
    LANCRET_TANGENTS = 1,     /* per point; always present for Hermite curves */
    LANCRET_NORMALS = 2,      /* per point: unit normal of a ribbon's face */
    LANCRET_IDS = 4,          /* per strand: independent of density and chunk size */
    LANCRET_ROOT_UV = 8,      /* per strand */
    LANCRET_LENGTHS = 16,     /* per strand */
    LANCRET_GUIDES = 32,      /* per strand: `neighbours` guide indices and weights */
    LANCRET_ARC_LENGTHS = 64, /* per point: distance from the root along the strand */
    LANCRET_RANDOM = 128      /* per strand: uniform in [0, 1), hashed from the id */
};
/* Options of a chunk request. Null options are all defaults. */
typedef struct lancret_options {
    size_t size;
    const double* times; /* [time_count] frame numbers, clamped to the cache's range;
                          * none: the first frame, or rest */
    size_t time_count;   /* at most 256 */
    int basis;           /* LANCRET_LINEAR, ... */
    float max_error;     /* distance from curve to strand, at least 1e-4 cm; 0: the
                          * groom's tolerance. Measured on thousands of strands; logs a
                          * warning if 1024 intervals do not reach it. Strands that need
                          * fewer points have fewer, except with LANCRET_NORMALS or if the
                          * groom sets strands.adapt = false */
    double density; /* fraction of strands to grow, 1e-6 to 1; fewer strands are drawn
                     * wider. 0: the groom's density */
    double pixels;  /* area of the chunk in the image; see strands_per_pixel */
    double strands_per_pixel; /* level of detail: maximum, lowers the density; 0: none */
    lancret_u32 attributes;   /* LANCRET_TANGENTS | ... */
    float unit;               /* output unit, in cm; 0: 1 */
} lancret_options;

/* A chunk at one or more times. Strands are stored one after another, root first. Arrays
 * that were not requested are null. Lengths are in options.unit. */
typedef struct lancret_curves {
    size_t size;
    int basis;
    lancret_u32 strands, points, times, neighbours;
    const lancret_u32* counts; /* [strands] points per strand, the same at all times */
    const float* const* positions; /* [times] -> [points][4]: x y z radius; radii are
                                    * control values of the same spline */
    const float* const* tangents;  /* [times] -> [points][4]. Hermite: derivative by the
                                    * segment's parameter, w that of the radius. Others:
                                    * unit, w 0 */
    const float* const* normals;   /* [times] -> [points][4], w 0; unit, except at points
                                    * beyond the ends of a curve */
    const lancret_u32* ids;        /* [strands] */
    const float* root_uv;          /* [strands][2]; 0 0 without a scalp */
    const float* lengths;          /* [strands] */
    const lancret_u32* guides;     /* [strands][neighbours] */
    const float* weights;          /* [strands][neighbours]; unused ones are 0 */
    const float* arc_lengths;      /* [points]; extrapolated at points beyond the ends */
    const float* random;           /* [strands] */
} lancret_curves;

/* Bounding box of chunk `index`, in options.unit: holds the strands and their widths at
 * all times of the options, and between them if points move linearly from one time to the
 * next. Minima exceed maxima if the chunk grows no strand. LANCRET_REACH is fast and
 * loose: roots and strand lengths. LANCRET_TIGHT synthesises the strands. */
enum { LANCRET_REACH = 0, LANCRET_TIGHT = 1 };
LANCRET_API lancret_status lancret_groom_get_chunk_box(const lancret_groom* groom,
                                                       lancret_u32 index,
                                                       const lancret_options* options,
                                                       int kind, float box[6]);

/* Receives a chunk. `curves` and its arrays are valid during the callback. A status other
 * than LANCRET_OK becomes the result of the call. */
typedef lancret_status (*lancret_curves_sink)(void* user, const lancret_curves* curves);

/* Expands chunk `index`, passes it to `sink` once, on the calling thread, and frees it.
 * The sink is also called for a chunk without strands. */
LANCRET_API lancret_status lancret_groom_expand_chunk(const lancret_groom* groom,
                                                      lancret_u32 index,
                                                      const lancret_options* options,
                                                      lancret_curves_sink sink,
                                                      void* user);

/* Expansion into the host's memory: open a chunk, get its sizes, write to arrays of these
 * sizes any number of times, close it. A chunk may outlive its groom, not its context. */
typedef struct lancret_chunk lancret_chunk;
/* Binds the strands of chunk `index` to their guides. On failure *chunk is null. */
LANCRET_API lancret_status lancret_chunk_open(const lancret_groom* groom,
                                              lancret_u32 index,
                                              const lancret_options* options,
                                              lancret_chunk** chunk);
/* All of lancret_curves except its arrays, which become null. */
LANCRET_API lancret_status lancret_chunk_get_sizes(const lancret_chunk* chunk,
                                                   lancret_curves* sizes);
/* Writes to the arrays of `buffers`, which the host owns (const is cast away); null
 * arrays are skipped. Arrays of positions, tangents and normals must be aligned to 16
 * bytes. */
LANCRET_API lancret_status lancret_chunk_write(const lancret_chunk* chunk,
                                               const lancret_curves* buffers);
/* No-op for null. */
LANCRET_API void lancret_chunk_close(lancret_chunk* chunk);

/* Number of strands for which binding had to fall back. */
typedef struct lancret_chunk_info {
    size_t size;
    lancret_u32 strands;
    size_t bytes; /* held while the chunk is open */
    lancret_u32 no_facing_guide, no_guide_in_reach, no_guide_in_sight, no_guide_in_region,
        opposed_root_frames, straight_guides;
} lancret_chunk_info;
LANCRET_API lancret_status lancret_chunk_get_info(const lancret_chunk* chunk,
                                                  lancret_chunk_info* info);

typedef struct lancret_check {
    size_t size;
    lancret_u32 strands;
    lancret_u32 failed;        /* strands beyond a tolerance */
    lancret_u32 outside;       /* strands that leave the chunk's LANCRET_TIGHT box */
    double orthogonality;      /* max |R^T R - 1| of the frames */
    double length_error;       /* max, relative, of the strand */
    double curve_length_error; /* max, relative, of the emitted curve */
    double distance;           /* max, from the curve to the strand, cm */
} lancret_check;
/* Checks every strand of chunk `index` at the first of the options' times, by
 * measurements that are independent of expansion. */
LANCRET_API lancret_status lancret_groom_check_chunk(const lancret_groom* groom,
                                                     lancret_u32 index,
                                                     const lancret_options* options,
                                                     lancret_check* check);

/* Figures of the strands, for false-colour views. Per strand; per segment: one value for
 * each of the n curve segments; or per end: n + 1 values. */
enum {
    LANCRET_LENGTH_ERROR = 0,  /* per strand: relative, of the synthesised strand */
    LANCRET_ORTHOGONALITY = 1, /* per end: |R^T R - 1| of the frame */
    LANCRET_CURVATURE = 2,     /* per segment: 1/cm */
    LANCRET_TORSION = 3,       /* per segment: 1/cm, positive if right-handed */
    LANCRET_REGION = 4         /* per strand: region number */
};
/* Writes one figure of all strands, one strand after another, at options.times[time]. A
 * value that is not finite becomes the largest float. LANCRET_BAD_INPUT for the torsion
 * of a blend whose frames carry none, and for the region of a groom without regions. */
LANCRET_API lancret_status lancret_chunk_get_figures(const lancret_chunk* chunk,
                                                     int figure, size_t time,
                                                     float* values);

/* The guides at rest: `segments` helices each, root first. The arrays live as long as the
 * groom. */
typedef struct lancret_guides {
    size_t size;
    lancret_u32 guides, segments;
    const double* root_positions;  /* [guides][3] cm */
    const double* root_frames;     /* [guides][3][3] columns: tangent, two axes */
    const double* segment_lengths; /* [guides][segments] cm */
    const double* curvatures;      /* [guides][segments][3] twist and two bends, 1/cm */
    const double* fit_rms;         /* [guides] cm, distance to the fitted strands; null if
                                    * the file holds guides */
} lancret_guides;
LANCRET_API lancret_status lancret_groom_get_guides(const lancret_groom* groom,
                                                    lancret_guides* guides);

/* Measures each blend on held-out strands of the groom and passes the figures to `sink`
 * once, in the JSON form of `lancret evaluate --json`. Uses the groom's number of guides,
 * else 5 % of its strands. `error` as for lancret_groom_open. */
LANCRET_API lancret_status lancret_context_evaluate(lancret_context* context,
                                                    const lancret_source* source,
                                                    lancret_text_sink sink, void* user,
                                                    char* error, size_t error_size);

#ifdef __cplusplus
}
#endif

#endif
