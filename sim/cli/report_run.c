/* SPDX-License-Identifier: MIT
 *
 * fork() without exec: the child becomes cmd_render() in the report's folder. What it says goes to a file, whose last
 * line is the reason if it fails. */
#include "cli/report_run.h"

#include "base/child.h"
#include "base/ending.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "files/companion.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#define LOG_NAME ".said"
static const char PREFIX[] = "limner: ";

static bool redirect(const char *path, int flags, int descriptor)
{
    const int opened = open(path, flags | O_NOFOLLOW, 0600);
    if (opened < 0 || dup2(opened, descriptor) < 0) return false;
    return close(opened) == 0;
}

/* No core files, and no dumps that the environment asks for. */
_Noreturn static void become(const struct report *report, const struct work_folder *folder, const char *option)
{
    char *argv[REPORT_ARGUMENTS_MAX + 4];
    struct arguments arguments = {.items = argv};
    struct error err;
    char command[] = "render", scene[REPORT_NAME_B + 2], more[REPORT_NAME_B];
    const struct rlimit none = {0, 0};
    snprintf(scene, sizeof scene, "%s", report->scene);
    snprintf(more, sizeof more, "%s", option);
    argv[arguments.count++] = command;
    for (size_t i = 0; i < report->argument_count; i++)
        argv[arguments.count++] = report->arguments[i];
    argv[arguments.count++] = more;
    argv[arguments.count++] = scene;
    argv[arguments.count] = NULL;
    unsetenv("LIMNER_DUMP");
    unsetenv("LIMNER_CHECK");
    setrlimit(RLIMIT_CORE, &none);
    if (chdir(folder->path) != 0 || !redirect("/dev/null", O_RDWR, STDIN_FILENO) ||
        !redirect("/dev/null", O_RDWR, STDOUT_FILENO) ||
        !redirect(LOG_NAME, O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO))
        _exit(EXIT_FAILURE);
    companions_stay_in(REPORT_SCENE_FOLDER);
    if (!model_options_take(&arguments, &err)) {
        fprintf(stderr, "%s%s\n", PREFIX, err.text);
        exit(EXIT_FAILURE);
    }
    exit(cmd_render(arguments.count, argv));
}

/* Of the last line that is an error, without the program's name. */
static void read_reason(const struct work_folder *folder, struct report_result *result)
{
    char path[sizeof folder->path + sizeof LOG_NAME + 1], line[sizeof result->reason + sizeof PREFIX];
    snprintf(path, sizeof path, "%s/%s", folder->path, LOG_NAME);
    snprintf(result->reason, sizeof result->reason, "no reason given");
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\r\n")] = '\0';
        const char *text = line;
        if (strncmp(text, PREFIX, sizeof PREFIX - 1) == 0) text += sizeof PREFIX - 1;
        if (*text) snprintf(result->reason, sizeof result->reason, "%.*s", (int)sizeof result->reason - 1, text);
    }
    if (file) fclose(file);
    unlink(path);
}

bool report_run(const struct report *report, const struct work_folder *folder, const char *option,
                struct report_result *result, struct error *err)
{
    int status = 0;
    fflush(NULL);
    const pid_t pid = ending_fork();
    if (pid == 0) become(report, folder, option);
    if (pid < 0) return error_set(err, "cannot start a process: %s", strerror(errno));
    if (!child_wait(pid, "frames were still drawn", &status, err)) return false;
    *result = (struct report_result){.outcome = REPORT_DRAWN};
    read_reason(folder, result);
    if (WIFSIGNALED(status)) {
        result->outcome = REPORT_CRASHED;
        snprintf(result->reason, sizeof result->reason, "signal %d", WTERMSIG(status));
    } else if (WEXITSTATUS(status) != EXIT_SUCCESS) {
        result->outcome = REPORT_REFUSED;
    } else {
        result->reason[0] = '\0';
    }
    return true;
}
