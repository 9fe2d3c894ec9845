/* SPDX-License-Identifier: MIT */
#include "fail.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int linux_fail(struct port *port, int err_no, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(port->error, sizeof port->error, format, arguments);
    va_end(arguments);
    return -err_no;
}

void linux_note(struct port *port, const char *format, ...)
{
    const size_t used = strlen(port->notice);
    const int joint = used ? snprintf(port->notice + used, sizeof port->notice - used, "; ") : 0;
    const size_t at = used + (size_t)joint;
    va_list arguments;
    if (at >= sizeof port->notice) return;
    va_start(arguments, format);
    vsnprintf(port->notice + at, sizeof port->notice - at, format, arguments);
    va_end(arguments);
}

int linux_fail_denied(struct port *port, int err_no, const char *path, const char *group)
{
    return linux_fail(port, err_no,
                      "%s: %s; join group %s (`ls -l` shows whose it is), or add the udev rule of hal/linux/README.md",
                      path, strerror(err_no), group);
}
