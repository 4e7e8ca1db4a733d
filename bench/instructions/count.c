/* SPDX-License-Identifier: BSD-3-Clause */
// A plugin of QEMU that counts the instructions of a program and writes their number to stderr when
// the program ends. instructions.py compiles it. Debian has no header for plugins of QEMU, so the
// necessary part of the interface (version 1) is declared here.
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef uint64_t Id;
typedef struct qemu_plugin_tb Block; // instructions that are translated together

#define EXPORTED __attribute__((visibility("default")))

extern size_t qemu_plugin_tb_n_insns(Block const *);
extern void qemu_plugin_register_vcpu_tb_trans_cb(Id, void (*)(Id, Block *));
extern void qemu_plugin_register_vcpu_tb_exec_inline(Block *, int operation, void *, uint64_t);
extern void qemu_plugin_register_atexit_cb(Id, void (*)(Id, void *), void *);

EXPORTED int qemu_plugin_version = 1;
EXPORTED int qemu_plugin_install(Id, void const *info, int argc, char **argv);

static uint64_t count;

static void add_block(Id id, Block *block)
{
    (void)id;
    int const add_to_number = 0;
    qemu_plugin_register_vcpu_tb_exec_inline(block, add_to_number, &count,
                                             qemu_plugin_tb_n_insns(block));
}

static void report(Id id, void *data)
{
    (void)id;
    (void)data;
    fprintf(stderr, "%llu\n", (unsigned long long)count);
}

int qemu_plugin_install(Id id, void const *info, int argc, char **argv)
{
    (void)info;
    (void)argc;
    (void)argv;
    qemu_plugin_register_vcpu_tb_trans_cb(id, add_block);
    qemu_plugin_register_atexit_cb(id, report, NULL);
    return 0;
}
