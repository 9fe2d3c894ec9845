/* SPDX-License-Identifier: MIT
 *
 * Transparent parts have whatever colour the file gives to them, and how opaque they are is known. */
#include "files/picture.h"

#include "base/names.h"
#include "files/companion.h"
#include "model/note_words.h"
#include "pictures/picture_size.h"

#include <assimp/material.h>
#include <errno.h>
#include <gd.h>
#include <gd_errors.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST_FILE_B = 64 << 20 };

/* libgd's messages: of a truncated JPEG it makes a picture that is grey below, and says no more than that. */
static bool is_truncated;

static bool leaves_out;      /* --no-textures */
static bool takes_means;     /* --textures flat */
static const char *sky_name; /* --sky, or NULL */

enum { SKY_COLUMNS = 1024 };
static const double SKY_HORIZON = 25.0 / 32; /* 100 of 128 rows: Doom's */

static void take_message(int priority, const char *format, va_list arguments)
{
    char text[256];
    (void)priority;
    vsnprintf(text, sizeof text, format, arguments);
    is_truncated |= strstr(text, "Premature end") != NULL;
}

static gdImagePtr read_jpeg(int size_b, void *bytes)
{
    is_truncated = false;
    gdImagePtr image = gdImageCreateFromJpegPtrEx(size_b, bytes, 0); /* 0: with messages */
    if (!image || !is_truncated) return image;
    gdImageDestroy(image);
    return NULL;
}

typedef gdImagePtr read_picture(int size_b, void *bytes);

static const struct {
    size_t at_b; /* where the magic is */
    const char *magic;
    read_picture *read;
} FORMATS[] = {{0, "\x89PNG", gdImageCreateFromPngPtr},  {0, "\xFF\xD8\xFF", read_jpeg},
               {0, "GIF8", gdImageCreateFromGifPtr},     {0, "BM", gdImageCreateFromBmpPtr},
               {8, "WEBPVP8", gdImageCreateFromWebpPtr}, {4, "ftypavif", gdImageCreateFromAvifPtr}};

/* Known, but not read. */
static const struct {
    const char *magic, *reason;
} FOREIGN[] = {{"\xABKTX", "a KTX texture, which is not read; save it as PNG"},
               {"DDS ", "a DDS texture, which is not read; save it as PNG"},
               {"II*", "a TIFF, which is not read; save it as PNG"},
               {"MM", "a TIFF, which is not read; save it as PNG"}};

static bool has_magic(const void *bytes, size_t size_b, size_t at_b, const char *magic)
{
    const size_t magic_b = strlen(magic);
    return size_b >= at_b + magic_b && memcmp((const char *)bytes + at_b, magic, magic_b) == 0;
}

/* NULL: of no format that is known. */
static read_picture *reader_of(const void *bytes, size_t size_b)
{
    for (size_t i = 0; i < sizeof FORMATS / sizeof *FORMATS; i++)
        if (has_magic(bytes, size_b, FORMATS[i].at_b, FORMATS[i].magic)) return FORMATS[i].read;
    return picture_is_tga(bytes, size_b) ? gdImageCreateFromTgaPtr : NULL;
}

static const char *reason_against(const void *bytes, size_t size_b)
{
    if (size_b == 0) return "the file is empty";
    for (size_t i = 0; i < sizeof FOREIGN / sizeof *FOREIGN; i++)
        if (has_magic(bytes, size_b, 0, FOREIGN[i].magic)) return FOREIGN[i].reason;
    return "neither PNG nor JPEG, WebP, AVIF, GIF, BMP or TGA";
}

static void refuse(struct picture *picture, const char *reason)
{
    snprintf(picture->reason, sizeof picture->reason, "%s", reason);
}

/* What is too large is refused: to draw on without it would hide that. */
static void refuse_import(struct picture *picture, const char *reason)
{
    struct error err;
    error_set(&err, "texture %s: %s", name_end(picture->name).text, reason);
    companions_refuse(&err);
    refuse(picture, "refused");
}

/* 255 is opaque. */
static uint8_t alpha_at(gdImagePtr image, int x, int y)
{
    const int transparent = gdImageTrueColor(image) ? gdImageGetTransparent(image) : -1;
    const int colour = gdImageGetTrueColorPixel(image, x, y);
    if (colour == transparent) return 0;
    return (uint8_t)((gdAlphaTransparent - gdTrueColorGetAlpha(colour)) * 255 / gdAlphaTransparent);
}

static bool has_alpha(gdImagePtr image)
{
    for (int y = 0; y < gdImageSY(image); y++)
        for (int x = 0; x < gdImageSX(image); x++)
            if (alpha_at(image, x, y) != 255) return true;
    return false;
}

/* Of a picture of this size, by the nearest pixels. */
static void take_alpha(struct picture *picture, gdImagePtr image)
{
    const int w_px = (int)picture->w_px, h_px = (int)picture->h_px;
    picture->alpha = calloc((size_t)w_px * (size_t)h_px, 1);
    for (int y = 0; picture->alpha && y < h_px; y++)
        for (int x = 0; x < w_px; x++)
            picture->alpha[y * w_px + x] = alpha_at(image, (2 * x + 1) * gdImageSX(image) / (2 * w_px),
                                                    (2 * y + 1) * gdImageSY(image) / (2 * h_px));
}

/* Takes the image, shrinks it to the largest size that any scene can have. */
static void take(struct picture *picture, gdImagePtr image)
{
    const int w_px = gdImageSX(image), h_px = gdImageSY(image);
    const int most_px = TEXTURE_SIDE_MAX_PX;
    picture->found_w_px = (uint32_t)w_px;
    picture->found_h_px = (uint32_t)h_px;
    picture->has_alpha |= has_alpha(image);
    const int to_w_px = w_px < most_px ? w_px : most_px, to_h_px = h_px < most_px ? h_px : most_px;
    gdImagePtr small = gdImageCreateTrueColor(to_w_px, to_h_px);
    picture->pixels = small ? calloc((size_t)to_w_px * (size_t)to_h_px, sizeof *picture->pixels) : NULL;
    if (picture->pixels) {
        gdImageAlphaBlending(small, gdEffectReplace);
        if (to_w_px == w_px && to_h_px == h_px)
            gdImageCopy(small, image, 0, 0, 0, 0, w_px, h_px);
        else
            gdImageCopyResampled(small, image, 0, 0, 0, 0, to_w_px, to_h_px, w_px, h_px);
        picture->w_px = (uint32_t)to_w_px;
        picture->h_px = (uint32_t)to_h_px;
        for (int y = 0; y < to_h_px; y++)
            for (int x = 0; x < to_w_px; x++)
                picture->pixels[y * to_w_px + x] = (uint32_t)small->tpixels[y][x] & 0xFFFFFF;
        if (picture->has_alpha) take_alpha(picture, image);
    } else {
        refuse(picture, "out of memory");
    }
    if (small) gdImageDestroy(small);
    gdImageDestroy(image);
}

static void read_bytes(struct picture *picture, void *bytes, size_t size_b)
{
    read_picture *const read = reader_of(bytes, size_b);
    char reason[PICTURE_WORDS_B];
    if (!read) {
        refuse(picture, reason_against(bytes, size_b));
        return;
    }
    if (!picture_size_check(bytes, size_b, reason, sizeof reason)) {
        (strstr(reason, "damaged") ? refuse : refuse_import)(picture, reason);
        return;
    }
    const uint8_t *const header = bytes;
    if (read == gdImageCreateFromTgaPtr && ((header[2] & 0xF7) != 2 || header[16] < 24)) {
        refuse(picture, "a TGA of less than 24 bits a pixel; save it as PNG");
        return;
    }
    gdSetErrorMethod(take_message);
    gdImagePtr image = read((int)size_b, bytes);
    gdClearErrorMethod();
    if (image)
        take(picture, image);
    else
        refuse(picture, "damaged, or too large to be read");
}

static void read_stream(struct picture *picture, FILE *file, size_t size_b)
{
    char *bytes = malloc(size_b + 1);
    const size_t got_b = bytes ? fread(bytes, 1, size_b, file) : 0;
    if (!bytes)
        refuse(picture, "out of memory");
    else if (ferror(file))
        refuse(picture, "it cannot be read");
    else
        read_bytes(picture, bytes, got_b);
    free(bytes);
}

static void read_file(struct picture *picture, const char *name)
{
    struct error err;
    size_t size_b = 0;
    FILE *file = companion_open(name, LARGEST_FILE_B, &size_b, &err);
    if (!file && (errno == ENOENT || errno == ENOTDIR))
        refuse(picture, WORDS_NO_FILE);
    else if (!file && errno == EISDIR)
        refuse(picture, "it is a folder");
    else if (!file && errno == ENAMETOOLONG)
        refuse(picture, "its path is too long");
    else if (!file)
        refuse_import(picture, err.text);
    if (!file) return;
    read_stream(picture, file, size_b);
    fclose(file);
}

/* Uncompressed: texels of four bytes. */
static void read_raw(struct picture *picture, const struct aiTexture *texture)
{
    if (texture->mWidth == 0 || texture->mHeight > PICTURE_MOST_PX / texture->mWidth) {
        if (texture->mWidth)
            refuse_import(picture, "too many pixels");
        else
            refuse(picture, "it has no pixels");
        return;
    }
    gdImagePtr image = gdImageCreateTrueColor((int)texture->mWidth, (int)texture->mHeight);
    const struct aiTexel *texel = texture->pcData;
    for (unsigned y = 0; image && y < texture->mHeight; y++)
        for (unsigned x = 0; x < texture->mWidth; x++, texel++) {
            image->tpixels[y][x] =
                (gdAlphaTransparent - texel->a / 2) << 24 | texel->r << 16 | texel->g << 8 | texel->b;
            picture->has_alpha |= texel->a < 255;
        }
    if (image)
        take(picture, image);
    else
        refuse(picture, "out of memory");
}

/* "*3" is the fourth one inside the model; others go by name. */
static const struct aiTexture *embedded(const struct aiScene *scene, const char *name)
{
    if (name[0] == '*') {
        const unsigned long index = strtoul(name + 1, NULL, 10);
        return index < scene->mNumTextures ? scene->mTextures[index] : NULL;
    }
    for (unsigned i = 0; i < scene->mNumTextures; i++)
        if (strcmp(scene->mTextures[i]->mFilename.data, name) == 0) return scene->mTextures[i];
    return NULL;
}

void pictures_leave_out(void)
{
    leaves_out = true;
}

bool pictures_are_left_out(void)
{
    return leaves_out;
}

void pictures_take_means(void)
{
    takes_means = true;
}

bool pictures_are_means(void)
{
    return takes_means || leaves_out;
}

void pictures_set_sky(const char *material)
{
    sky_name = material;
}

const char *pictures_sky(void)
{
    return sky_name;
}

bool picture_copy_as_sky(const struct picture *from, struct picture *out)
{
    const size_t count = (size_t)from->w_px * from->h_px;
    if (!from->pixels) return false;
    *out = *from;
    out->faces = out->clear_faces = 0;
    out->alpha = NULL;
    out->pixels = malloc(count * sizeof *out->pixels);
    if (!out->pixels) return false;
    memcpy(out->pixels, from->pixels, count * sizeof *out->pixels);
    const double times = floor((double)SKY_COLUMNS / from->w_px + 0.5);
    out->sky = (struct sky_look){(unsigned)fmin(fmax(times, 1), SKY_TIMES_MAX), SKY_HORIZON};
    return true;
}

static void begin(struct picture *picture, const char *name)
{
    memset(picture, 0, sizeof *picture);
    snprintf(picture->name, sizeof picture->name, "%s", name);
}

/* --no-textures does without what cannot be read, or must not be. */
static void end(struct picture *picture, bool was_refused)
{
    if (!leaves_out || picture->pixels) return;
    picture->left_out = true;
    if (!was_refused) companions_pardon();
}

static bool is_refused(void)
{
    struct error err;
    return companions_refused(&err);
}

void picture_read_file(const char *name, struct picture *out)
{
    const bool was_refused = is_refused();
    begin(out, name);
    read_file(out, name);
    end(out, was_refused);
}

void picture_read_bytes(const char *name, void *bytes, size_t size_b, struct picture *out)
{
    const bool was_refused = is_refused();
    begin(out, name);
    read_bytes(out, bytes, size_b);
    end(out, was_refused);
}

void picture_label(const struct aiScene *scene, const char *name, char label[PICTURE_NAME_B])
{
    const struct aiTexture *texture = name[0] == '*' ? embedded(scene, name) : NULL;
    if (texture && texture->mFilename.length)
        snprintf(label, PICTURE_NAME_B, "%.*s (%.9s)", PICTURE_NAME_B / 2, texture->mFilename.data, name);
    else
        snprintf(label, PICTURE_NAME_B, "%s", name);
}

void picture_read(const struct aiScene *scene, const char *name, struct picture *out)
{
    const struct aiTexture *texture = embedded(scene, name);
    const bool was_refused = is_refused();
    begin(out, name);
    if (texture && texture->mHeight)
        read_raw(out, texture);
    else if (texture)
        read_bytes(out, texture->pcData, texture->mWidth);
    else if (name[0] == '*')
        refuse(out, "the model holds no such picture");
    else
        read_file(out, name);
    end(out, was_refused);
}

static void note_pictures_of(const struct aiMaterial *material)
{
    struct aiString name;
    for (unsigned i = 0; i < material->mNumProperties; i++) {
        const struct aiMaterialProperty *property = material->mProperties[i];
        if (strcmp(property->mKey.data, _AI_MATKEY_TEXTURE_BASE) != 0) continue;
        if (aiGetMaterialString(material, _AI_MATKEY_TEXTURE_BASE, property->mSemantic, property->mIndex, &name) ==
                aiReturn_SUCCESS &&
            name.length > 0 && name.data[0] != '*')
            companion_note(name.data);
    }
}

void pictures_note(const struct aiScene *scene)
{
    for (unsigned i = 0; i < scene->mNumMaterials; i++)
        note_pictures_of(scene->mMaterials[i]);
}

void picture_free(struct picture *picture)
{
    free(picture->pixels);
    free(picture->alpha);
    picture->pixels = NULL;
    picture->alpha = NULL;
}

bool picture_mask_of(const struct aiMaterial *material, struct aiString *name)
{
    return aiGetMaterialTexture(material, aiTextureType_OPACITY, 0, name, NULL, NULL, NULL, NULL, NULL, NULL) ==
               aiReturn_SUCCESS &&
           name->length > 0;
}

/* "Decal" is clear beyond the borders, which no format that is read here says of a colour. */
static uint8_t wrap_of(enum aiTextureMapMode mode)
{
    return mode == aiTextureMapMode_Mirror                                    ? PICTURE_MIRRORS
           : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? PICTURE_CLAMPS
                                                                              : PICTURE_REPEATS;
}

static bool picture_of_type(const struct aiMaterial *material, enum aiTextureType type, struct picture_use *use)
{
    enum aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    *use = (struct picture_use){.uv_set = 0};
    if (aiGetMaterialTexture(material, type, 0, &use->name, NULL, &use->uv_set, NULL, NULL, modes, NULL) !=
        aiReturn_SUCCESS)
        return false;
    for (int i = 0; i < 2; i++)
        use->wrap[i] = wrap_of(modes[i]);
    return use->name.length > 0;
}

bool picture_of_light(const struct aiMaterial *material, struct picture_use *use)
{
    return picture_of_type(material, aiTextureType_EMISSIVE, use) ||
           picture_of_type(material, aiTextureType_EMISSION_COLOR, use);
}

bool picture_of_colour(const struct aiMaterial *material, struct picture_use *use)
{
    return picture_of_type(material, aiTextureType_BASE_COLOR, use) ||
           picture_of_type(material, aiTextureType_DIFFUSE, use);
}
