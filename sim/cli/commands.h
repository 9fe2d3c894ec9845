/* SPDX-License-Identifier: MIT
 *
 * The subcommands of `limner`. argv[0] is the subcommand's name, its arguments follow; the result
 * is the exit status of the program. Each prints its own errors: one line on stderr. */
#ifndef SIM_COMMANDS_H
#define SIM_COMMANDS_H

int cmd_compile(int argc, char **argv);
int cmd_render(int argc, char **argv);
int cmd_view(int argc, char **argv);
int cmd_compare(int argc, char **argv);
int cmd_measure(int argc, char **argv);
int cmd_sweep(int argc, char **argv);
int cmd_splitters(int argc, char **argv);
int cmd_play(int argc, char **argv);
int cmd_devices(int argc, char **argv);
int cmd_bridge(int argc, char **argv);
int cmd_module(int argc, char **argv);
int cmd_card(int argc, char **argv);
int cmd_decode(int argc, char **argv);
int cmd_hashes(int argc, char **argv);
int cmd_uf2(int argc, char **argv);
int cmd_espimage(int argc, char **argv);
int cmd_boot2(int argc, char **argv);
int cmd_report_bug(int argc, char **argv);
int cmd_replay(int argc, char **argv);
int cmd_export(int argc, char **argv);
int cmd_worst(int argc, char **argv);
int cmd_report(int argc, char **argv);
int cmd_walk(int argc, char **argv);
int cmd_formats(int argc, char **argv);
int cmd_wad(int argc, char **argv);

#endif
