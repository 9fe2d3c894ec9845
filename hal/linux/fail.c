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

int linux_fail_denied(struct port *port, int err_no, const char *path, const char *group)
{
    return linux_fail(port, err_no, "%s: %s; join group %s (`ls -l` shows whose it is), or add the udev rule of README",
                      path, strerror(err_no), group);
}
