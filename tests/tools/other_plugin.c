/* A plugin without hair: it opens any file as strands.count posts, 10 cm high and 1 cm wide,
 * 2 cm apart along x, with ids from 1000 on, each a chunk. A picture of them can only have come
 * through the plugin. If OTHER_PLUGIN_FAILS is set, chunks cannot be written. */
#include <stdlib.h>
#include <string.h>

#include "procedural/lancret_procedural.h"

enum { kPoints = 5, kSegments = 2, kFirstId = 1000 };

struct lancret_context {
    lancret_host host;
};
struct lancret_groom {
    const lancret_host *host;
    lancret_u32 posts;
};
struct lancret_chunk {
    const lancret_host *host;
    lancret_u32 post;
};

const char *lancret_version(void) { return "other"; }

int lancret_abi_version(void) {
    const char *version = getenv("OTHER_PLUGIN_VERSION");
    return version ? atoi(version) : LANCRET_ABI_VERSION;
}

lancret_status lancret_context_create(int abi_version, const lancret_host *host,
                              lancret_context **context) {
    (void)abi_version;
    *context = calloc(1, sizeof **context);
    (*context)->host = *host;
    return LANCRET_OK;
}

void lancret_context_destroy(lancret_context *context) { free(context); }

lancret_status lancret_groom_open(lancret_context *context, const lancret_source *source,
                            lancret_groom **groom, char *error, size_t error_size) {
    size_t i;
    (void)error;
    (void)error_size;
    *groom = calloc(1, sizeof **groom);
    (*groom)->host = &context->host;
    for (i = 0; i < source->parameter_count; ++i) {
        const lancret_parameter *p = &source->parameters[i];
        if (strcmp(p->name, "strands.count") == 0) (*groom)->posts = (lancret_u32)p->number;
    }
    return LANCRET_OK;
}

void lancret_groom_close(lancret_groom *groom) { free(groom); }

static void put_box(lancret_u32 posts, float box[6]) {
    box[0] = box[2] = -0.5f;
    box[1] = 0;
    box[3] = 2 * (float)posts - 1.5f;
    box[4] = 10;
    box[5] = 0.5f;
}

lancret_status lancret_groom_get_info(const lancret_groom *groom, lancret_groom_info *info) {
    size_t size = info->size;
    memset(info, 0, size);
    info->size = size;
    info->guides = info->segments = info->neighbours = 1;
    info->chunks = info->strands = groom->posts;
    info->intervals = kSegments;
    info->basis = LANCRET_BSPLINE;
    info->shape = LANCRET_FLAT;
    info->cm_per_unit = info->up[1] = 1;
    put_box(groom->posts, info->box);
    return LANCRET_OK;
}

lancret_status lancret_groom_describe(const lancret_groom *groom, lancret_text_sink sink,
                                void *user) {
    (void)groom;
    sink(user, "{\"guides\": 1}");
    return LANCRET_OK;
}

lancret_status lancret_groom_get_head(const lancret_groom *groom, double time,
                                lancret_mesh_sink sink, void *user) {
    lancret_mesh none;
    (void)groom;
    (void)time;
    memset(&none, 0, sizeof none);
    none.size = sizeof none;
    return sink(user, &none);
}

lancret_status lancret_groom_is_still(const lancret_groom *groom, const double *times,
                                size_t time_count, int *still) {
    (void)groom;
    (void)times;
    (void)time_count;
    *still = 1;
    return LANCRET_OK;
}

lancret_status lancret_groom_get_chunk_box(const lancret_groom *groom, lancret_u32 index,
                             const lancret_options *options, int kind, float box[6]) {
    (void)index;
    (void)options;
    (void)kind;
    put_box(groom->posts, box);
    return LANCRET_OK;
}

lancret_status lancret_chunk_open(const lancret_groom *groom, lancret_u32 index,
                                  const lancret_options *options, lancret_chunk **chunk) {
    (void)options;
    *chunk = calloc(1, sizeof **chunk);
    (*chunk)->host = groom->host;
    (*chunk)->post = index;
    return LANCRET_OK;
}

lancret_status lancret_chunk_get_sizes(const lancret_chunk *chunk, lancret_curves *sizes) {
    size_t size = sizes->size;
    (void)chunk;
    memset(sizes, 0, size);
    sizes->size = size;
    sizes->basis = LANCRET_BSPLINE;
    sizes->points = kPoints;
    sizes->strands = sizes->times = sizes->neighbours = 1;
    return LANCRET_OK;
}

lancret_status lancret_chunk_write(const lancret_chunk *chunk, const lancret_curves *to) {
    lancret_u32 j;
    if (getenv("OTHER_PLUGIN_FAILS")) {
        chunk->host->log(chunk->host->user, LANCRET_LOG_ERROR, "the posts are gone");
        return LANCRET_BAD_INPUT;
    }
    *(lancret_u32 *)to->counts = kPoints;
    *(lancret_u32 *)to->ids = kFirstId + chunk->post;
    for (j = 0; j < kPoints; ++j) {
        float *p = (float *)to->positions[0] + 4 * j;
        p[0] = 2 * (float)chunk->post;
        p[1] = 5 * ((float)j - 1); /* from a segment below to one above */
        p[2] = 0;
        p[3] = 0.5f;
    }
    return LANCRET_OK;
}

void lancret_chunk_close(lancret_chunk *chunk) { free(chunk); }

lancret_status lancret_chunk_get_info(const lancret_chunk *chunk, lancret_chunk_info *info) {
    size_t size = info->size;
    (void)chunk;
    memset(info, 0, size);
    info->size = size;
    info->strands = 1;
    return LANCRET_OK;
}

lancret_status lancret_chunk_get_figures(const lancret_chunk *chunk, int figure, size_t time,
                                     float *values) {
    lancret_u32 i;
    (void)figure;
    (void)time;
    for (i = 0; i < kSegments; ++i) values[i] = 0.25f * (float)(1 + chunk->post);
    return LANCRET_OK;
}
