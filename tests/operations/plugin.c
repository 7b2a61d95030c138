// A plugin of qemu-user: counts the instructions that run, by mnemonic and operands. At each call of getppid() (the
// number of the system call is the argument `call`) it prints the counts since the last one, a line each, and "END".
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The part of qemu-plugin.h that is used, which Debian has no package of.
typedef uint64_t qemu_plugin_id_t;
typedef struct qemu_info_t qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };
extern void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, void (*)(qemu_plugin_id_t, struct qemu_plugin_tb*));
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb*);
extern struct qemu_plugin_insn* qemu_plugin_tb_get_insn(const struct qemu_plugin_tb*, size_t);
extern char* qemu_plugin_insn_disas(const struct qemu_plugin_insn*);
extern void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb*, enum qemu_plugin_op, void*, uint64_t);
extern void qemu_plugin_register_vcpu_syscall_cb(qemu_plugin_id_t,
                                                 void (*)(qemu_plugin_id_t, unsigned, int64_t, uint64_t, uint64_t,
                                                          uint64_t, uint64_t, uint64_t, uint64_t, uint64_t, uint64_t));
#define EXPORT __attribute__((visibility("default")))
EXPORT int qemu_plugin_version = 1;

enum { KINDS = 4096 };
static struct {
    char name[80];
    uint64_t ran;
} kinds[KINDS];
static int64_t mark_call;

static int kind_of(const char* name) {
    for (int i = 0; i < KINDS; ++i) {
        if (!kinds[i].name[0]) strncpy(kinds[i].name, name, sizeof kinds[i].name - 1);
        if (!strcmp(kinds[i].name, name)) return i;
    }
    fprintf(stderr, "plugin: too many kinds of instructions\n");
    exit(1);
}

// "addl 4(%eax,%ebx), %ecx" to "addl mr": a letter for each operand, i immediate, r register, m memory.
static void shorten(char* text) {
    char* to = strchr(text, ' ');
    if (!to) return;
    int depth = 0;
    char letter = 0;
    for (const char* c = ++to; *c; ++c) {
        depth += (*c == '(') - (*c == ')');
        if (!letter && *c != ' ') letter = *c == '$' ? 'i' : *c == '%' ? 'r' : 'm';
        if (*c == ':') letter = 'm';  // %gs:8
        if (c[1] && (c[1] != ',' || depth)) continue;
        *to++ = letter;
        letter = 0;
        if (c[1]) ++c;
    }
    *to = 0;
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb* tb) {
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(tb); ++i) {
        char* text = qemu_plugin_insn_disas(qemu_plugin_tb_get_insn(tb, i));
        shorten(text);
        qemu_plugin_register_vcpu_tb_exec_inline(tb, QEMU_PLUGIN_INLINE_ADD_U64, &kinds[kind_of(text)].ran, 1);
        free(text);
    }
}

static void called(qemu_plugin_id_t id, unsigned cpu, int64_t call, uint64_t a, uint64_t b, uint64_t c, uint64_t d,
                   uint64_t e, uint64_t f, uint64_t g, uint64_t h) {
    (void)id, (void)cpu, (void)a, (void)b, (void)c, (void)d, (void)e, (void)f, (void)g, (void)h;
    if (call != mark_call) return;
    for (int i = 0; i < KINDS && kinds[i].name[0]; ++i) {
        if (kinds[i].ran) fprintf(stderr, "%" PRIu64 " %s\n", kinds[i].ran, kinds[i].name);
        kinds[i].ran = 0;
    }
    fprintf(stderr, "END\n");
}

EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* info, int argc, char** argv) {
    (void)info;
    if (argc != 1 || strncmp(argv[0], "call=", 5)) return 1;
    mark_call = atoll(argv[0] + 5);
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_vcpu_syscall_cb(id, called);
    return 0;
}
