/* SPDX-License-Identifier: MIT
 *
 * Files are hashed one by one, in the order of their first opening. */
#include "measure/result_file.h"

#include "base/grow.h"
#include "base/input_file.h"
#include "base/inputs.h"
#include "base/sha256.h"
#include "base/versions.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { DIGEST_TEXT_B = 2 * SHA256_B + 1, INPUT_MOST_B = 1 << 30, RESULT_MOST_B = 1 << 24 };
static const char HEAD[] = "limner-result 1\n";

/* All of a file with a zero behind it, or NULL. */
static char *read_all(const char *path, size_t most_b, size_t *n_b, struct error *err)
{
    FILE *file = input_open(path, most_b, n_b, err);
    if (!file) return NULL;
    char *bytes = grow_zeroed(*n_b + 1, 1);
    const bool ok = fread(bytes, 1, *n_b, file) == *n_b;
    fclose(file);
    if (ok) return bytes;
    free(bytes);
    error_set(err, "%s: cannot be read", path);
    return NULL;
}

static bool digest_of(const char *path, char text[DIGEST_TEXT_B], struct error *err)
{
    uint8_t digest[SHA256_B];
    size_t n_b;
    char *bytes = read_all(path, INPUT_MOST_B, &n_b, err);
    if (!bytes) return false;
    sha256(digest, (const uint8_t *)bytes, n_b);
    free(bytes);
    for (int i = 0; i < SHA256_B; i++)
        snprintf(text + 2 * i, 3, "%02x", digest[i]);
    return true;
}

/* Writing ------------------------------------------------------------------------------------ */

static bool is_before(size_t index)
{
    for (size_t i = 0; i < index; i++)
        if (strcmp(inputs_path(i), inputs_path(index)) == 0) return true;
    return false;
}

static bool write_inputs(FILE *out, struct error *err)
{
    char digest[DIGEST_TEXT_B];
    for (size_t i = 0; i < inputs_count(); i++) {
        if (is_before(i)) continue;
        if (!digest_of(inputs_path(i), digest, err)) return false;
        fprintf(out, "input %s %s\n", digest, inputs_path(i));
    }
    return true;
}

bool result_file_put(const struct measure_table *table, const char *model, const char *method, const char *path,
                     struct outputs *outputs, struct error *err)
{
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    fprintf(file, "%sversion %s\nmodel %s\nmethod %s\n", HEAD, versions_program(), model, method);
    const bool ok = write_inputs(file, err);
    fputc('\n', file);
    measure_table_csv(table, file);
    return outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
}

/* Reading ------------------------------------------------------------------------------------ */

/* Takes a line `KEY VALUE` and goes behind it. */
static bool take_line(const char **at, const char *key, char *value, size_t value_b)
{
    const size_t key_b = strlen(key), length = strcspn(*at, "\n");
    if (strncmp(*at, key, key_b) != 0 || (*at)[key_b] != ' ' || length < key_b + 1 || !(*at)[length]) return false;
    if (length - key_b - 1 >= value_b) return false;
    memcpy(value, *at + key_b + 1, length - key_b - 1);
    value[length - key_b - 1] = '\0';
    *at += length + 1;
    return true;
}

/* A whole one ends its last line. */
static bool split(struct result_file *out, size_t n_b)
{
    const char *at = out->text;
    if (strncmp(at, HEAD, sizeof HEAD - 1) != 0 || strlen(at) != n_b || at[n_b - 1] != '\n') return false;
    at += sizeof HEAD - 1;
    if (!take_line(&at, "version", out->version, sizeof out->version) ||
        !take_line(&at, "model", out->model, sizeof out->model) ||
        !take_line(&at, "method", out->method, sizeof out->method))
        return false;
    out->inputs = at;
    const char *end = strstr(at - 1, "\n\n"); /* a model may name no files */
    out->csv = end ? end + 2 : NULL;
    return out->csv && *out->csv;
}

bool result_file_read(const char *path, struct result_file *out, struct error *err)
{
    size_t n_b;
    *out = (struct result_file){.text = read_all(path, RESULT_MOST_B, &n_b, err)};
    if (!out->text) return false;
    if (split(out, n_b)) return true;
    result_file_free(out);
    return error_set(err, "%s: is no whole result of a sweep; remove it and run its job again", path);
}

bool result_file_check_inputs(const struct result_file *result, const char *path, struct error *err)
{
    char line[RESULT_TEXT_B], digest[DIGEST_TEXT_B];
    for (const char *at = result->inputs; *at != '\n';) {
        if (!take_line(&at, "input", line, sizeof line) || strlen(line) <= 2 * SHA256_B + 1)
            return error_set(err, "%s: is no whole result of a sweep; remove it and run its job again", path);
        const char *input = line + 2 * SHA256_B + 1;
        if (!digest_of(input, digest, err)) return error_prefix(err, path);
        if (strncmp(line, digest, 2 * SHA256_B) != 0)
            return error_set(err, "%s: %s is not what was measured; run the job again", path, input);
    }
    return true;
}

void result_file_free(struct result_file *result)
{
    free(result->text);
    *result = (struct result_file){0};
}
