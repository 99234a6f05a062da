/* A host in C89 that uses only the header: loads the library, opens a groom, expands it in
 * every way, and prints the number of strands and failures as its last line.
 *
 *     host LIBRARY GROOM.toml
 */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "procedural/lancret_procedural.h"

static int failures = 0;

static void expect(int kept, const char *what, int line) {
    if (kept) return;
    printf("host.c:%d: %s\n", line, what);
    ++failures;
}
#define EXPECT(x) expect((x) != 0, #x, __LINE__)

/* ISO C has no conversion from object pointers to function pointers. */
static void load(void *library, const char *name, void *function) {
    void *symbol = dlsym(library, name);
    if (!symbol) {
        printf("no symbol %s\n", name);
        exit(2);
    }
    memcpy(function, &symbol, sizeof symbol);
}

static struct {
    const char *(*version)(void);
    int (*abi_version)(void);
    lancret_status (*create)(int, const lancret_host *, lancret_context **);
    void (*destroy)(lancret_context *);
    lancret_status (*open)(lancret_context *, const lancret_source *, lancret_groom **, char *,
                           size_t);
    void (*close)(lancret_groom *);
    lancret_status (*get_info)(const lancret_groom *, lancret_groom_info *);
    lancret_status (*get_guides)(const lancret_groom *, lancret_guides *);
    lancret_status (*get_chunk_box)(const lancret_groom *, lancret_u32, const lancret_options *,
                                    int, float[6]);
    lancret_status (*expand)(const lancret_groom *, lancret_u32, const lancret_options *,
                             lancret_curves_sink, void *);
    lancret_status (*chunk_open)(const lancret_groom *, lancret_u32, const lancret_options *,
                                 lancret_chunk **);
    lancret_status (*chunk_sizes)(const lancret_chunk *, lancret_curves *);
    lancret_status (*chunk_write)(const lancret_chunk *, const lancret_curves *);
    void (*chunk_close)(lancret_chunk *);
    lancret_status (*describe)(const lancret_groom *, lancret_text_sink, void *);
    lancret_status (*get_head)(const lancret_groom *, double, lancret_mesh_sink, void *);
    lancret_status (*is_still)(const lancret_groom *, const double *, size_t, int *);
    lancret_status (*get_chunk_info)(const lancret_chunk *, lancret_chunk_info *);
    lancret_status (*chunk_figures)(const lancret_chunk *, int, size_t, float *);
} lancret;

static void load_all(void *library) {
    load(library, "lancret_version", &lancret.version);
    load(library, "lancret_abi_version", &lancret.abi_version);
    load(library, "lancret_context_create", &lancret.create);
    load(library, "lancret_context_destroy", &lancret.destroy);
    load(library, "lancret_groom_open", &lancret.open);
    load(library, "lancret_groom_close", &lancret.close);
    load(library, "lancret_groom_get_info", &lancret.get_info);
    load(library, "lancret_groom_get_guides", &lancret.get_guides);
    load(library, "lancret_groom_get_chunk_box", &lancret.get_chunk_box);
    load(library, "lancret_groom_expand_chunk", &lancret.expand);
    load(library, "lancret_chunk_open", &lancret.chunk_open);
    load(library, "lancret_chunk_get_sizes", &lancret.chunk_sizes);
    load(library, "lancret_chunk_write", &lancret.chunk_write);
    load(library, "lancret_chunk_close", &lancret.chunk_close);
    load(library, "lancret_groom_describe", &lancret.describe);
    load(library, "lancret_groom_get_head", &lancret.get_head);
    load(library, "lancret_groom_is_still", &lancret.is_still);
    load(library, "lancret_chunk_get_info", &lancret.get_chunk_info);
    load(library, "lancret_chunk_get_figures", &lancret.chunk_figures);
}

/* What a sink received, to be compared with buffers. */
struct received {
    lancret_u32 strands, points;
    float *positions;
    float box[6];
    int outside;
};

static lancret_status look(void *user, const lancret_curves *curves) {
    struct received *received = user;
    size_t bytes = (size_t)curves->points * 4 * sizeof(float);
    size_t sum = 0;
    lancret_u32 i;
    int axis;
    received->strands = curves->strands;
    received->points = curves->points;
    received->positions = realloc(received->positions, bytes);
    memcpy(received->positions, curves->positions[0], bytes);
    for (i = 0; i < curves->strands; ++i) sum += curves->counts[i];
    EXPECT(sum == curves->points);
    received->outside = 0;
    for (i = 0; i < curves->points; ++i) {
        const float *p = curves->positions[0] + (size_t)4 * i;
        for (axis = 0; axis < 3; ++axis) {
            if (!(p[axis] >= received->box[axis] && p[axis] <= received->box[3 + axis])) {
                ++received->outside;
            }
        }
    }
    return LANCRET_OK;
}

static void look_at_text(void *user, const char *text) {
    (void)user;
    EXPECT(text[0] == '{');
}

static lancret_status look_at_head(void *user, const lancret_mesh *mesh) {
    (void)user;
    EXPECT(mesh->vertices > 0 && mesh->triangles > 0);
    return LANCRET_OK;
}

static lancret_status refuse(void *user, const lancret_curves *curves) {
    (void)user;
    (void)curves;
    return LANCRET_CANCELLED;
}

static void try_chunk(lancret_groom *groom, lancret_u32 chunk, int basis,
                      struct received *received) {
    lancret_options options;
    lancret_chunk *opened = NULL;
    lancret_chunk_info chunk_info;
    lancret_curves curves;
    lancret_u32 i;
    float *points;
    const float *times[1];
    memset(&options, 0, sizeof options);
    options.size = sizeof options;
    options.basis = basis;
    EXPECT(lancret.get_chunk_box(groom, chunk, &options, LANCRET_REACH, received->box) ==
           LANCRET_OK);
    EXPECT(lancret.expand(groom, chunk, &options, look, received) == LANCRET_OK);
    EXPECT(received->outside == 0);
    EXPECT(lancret.get_chunk_box(groom, chunk, &options, LANCRET_TIGHT, received->box) ==
           LANCRET_OK);
    EXPECT(lancret.expand(groom, chunk, &options, look, received) == LANCRET_OK);
    /* The tight box holds the curves, and so the points of bases whose curves pass through
     * all of them. */
    EXPECT(received->outside == 0 || (basis != LANCRET_LINEAR && basis != LANCRET_HERMITE));
    EXPECT(lancret.expand(groom, chunk, &options, refuse, NULL) == LANCRET_CANCELLED);

    EXPECT(lancret.chunk_open(groom, chunk, &options, &opened) == LANCRET_OK);
    memset(&curves, 0, sizeof curves);
    curves.size = sizeof curves;
    EXPECT(lancret.chunk_sizes(opened, &curves) == LANCRET_OK);
    EXPECT(curves.points == received->points && curves.strands == received->strands);
    memset(&chunk_info, 0, sizeof chunk_info);
    chunk_info.size = sizeof chunk_info;
    EXPECT(lancret.get_chunk_info(opened, &chunk_info) == LANCRET_OK);
    EXPECT(chunk_info.strands == curves.strands);
    points = malloc((size_t)curves.strands * sizeof(float));
    EXPECT(lancret.chunk_figures(opened, LANCRET_LENGTH_ERROR, 0, points) == LANCRET_OK);
    for (i = 0; i < curves.strands; ++i) EXPECT(points[i] >= 0 && points[i] <= 1e-5f);
    free(points);
    /* 16 bytes per point, aligned by malloc. */
    points = malloc((size_t)curves.points * 16);
    times[0] = points;
    curves.positions = times;
    EXPECT(lancret.chunk_write(opened, &curves) == LANCRET_OK);
    EXPECT(memcmp(points, received->positions, (size_t)curves.points * 16) == 0);
    free(points);
    lancret.chunk_close(opened);
}

int main(int argc, char **argv) {
    void *library;
    lancret_context *context = NULL;
    lancret_groom *groom = NULL;
    lancret_source source;
    lancret_groom_info info;
    lancret_guides guides;
    const double time = 0;
    int still = 0;
    struct received received;
    char error[256];
    unsigned long strands = 0;
    lancret_u32 i;
    int basis;
    if (argc != 3) return 2;
    library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        printf("%s\n", dlerror());
        return 2;
    }
    load_all(library);
    EXPECT(lancret.abi_version() == LANCRET_ABI_VERSION);
    EXPECT(strlen(lancret.version()) > 0);
    EXPECT(lancret.create(LANCRET_ABI_VERSION + 1, NULL, &context) == LANCRET_BAD_CALL);
    EXPECT(lancret.create(LANCRET_ABI_VERSION, NULL, &context) == LANCRET_OK);

    memset(&source, 0, sizeof source);
    source.size = sizeof source;
    source.path = "nowhere.toml";
    EXPECT(lancret.open(context, &source, &groom, error, sizeof error) == LANCRET_BAD_INPUT);
    EXPECT(strstr(error, "nowhere.toml") != NULL && groom == NULL);
    source.path = argv[2];
    if (lancret.open(context, &source, &groom, error, sizeof error) != LANCRET_OK) {
        printf("%s\n", error);
        return 1;
    }
    memset(&info, 0, sizeof info);
    info.size = sizeof info;
    EXPECT(lancret.get_info(groom, &info) == LANCRET_OK);
    EXPECT(info.chunks > 0 && info.strands > 0 && info.guides > 0);
    memset(&guides, 0, sizeof guides);
    guides.size = sizeof guides;
    EXPECT(lancret.get_guides(groom, &guides) == LANCRET_OK);
    EXPECT(guides.guides == info.guides && guides.segments == info.segments);
    EXPECT(lancret.describe(groom, look_at_text, NULL) == LANCRET_OK);
    EXPECT(lancret.get_head(groom, 0, look_at_head, NULL) == LANCRET_OK);
    EXPECT(lancret.is_still(groom, &time, 1, &still) == LANCRET_OK && still == 1);
    memset(&received, 0, sizeof received);
    for (i = 0; i < info.chunks; ++i) {
        for (basis = LANCRET_BSPLINE; basis <= LANCRET_HERMITE; basis += 3) {
            try_chunk(groom, i, basis, &received);
        }
        strands += received.strands;
    }
    EXPECT(strands == info.strands);
    EXPECT(lancret.expand(groom, info.chunks, NULL, look, &received) == LANCRET_BAD_CALL);
    free(received.positions);
    lancret.close(groom);
    lancret.destroy(context);
    EXPECT(dlclose(library) == 0);
    printf("%lu strands, %d failures\n", strands, failures);
    return failures > 0;
}
